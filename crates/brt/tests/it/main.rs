//! All integration tests of the crate in one program: each would be linked with everything else.

mod far_models;
mod transfer;
