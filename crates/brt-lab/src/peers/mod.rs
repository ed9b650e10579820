//! The same scenes through other ray tracers, side by side with ours.
