//! All integration tests of the crate in one program: each would be linked with everything else.

mod alpha;
mod bundles;
mod certified;
mod certified_regressions;
mod coincident;
mod common;
mod counters;
mod exact_methods;
mod far_and_tiny;
mod far_carriers;
mod first_hits;
mod golden;
mod hard_scenes;
mod known_colors;
mod known_surfaces;
mod lost_highlight;
mod many_lights;
mod pencils;
mod regressions;
mod run_and_settings;
mod samples_and_filters;
mod simd_levels;
mod traced_and_filled;
mod windows;
