//! All integration tests of the crate in one program: each would be linked with everything else.

mod block_hits;
mod bvh_search;
mod common;
mod first_hits;
mod hits_of_round_things;
mod lanes;
mod slivers;
mod taylor_encloses;
mod watertight;
