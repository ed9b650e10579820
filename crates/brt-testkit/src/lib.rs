//! What the tests of several crates share: random scenes, named scenes, pictures in memory, golden images.
//!
//! A dev-dependency only. Everything is a function of its arguments and seeds: a failing test fails again. Scenes
//! that strategies make have passed [`Scene::check`](brt_scene::Scene::check).

mod golden;
mod hard;
mod levels;
mod moves;
mod named;
mod pictures;
mod promise;
mod random;
mod strategies;

pub use golden::{Golden, GoldenError};
pub use hard::{
    Choices, HardKind, any_doubled_scene, any_hard_scene, doubled_scene, hard_bytes, hard_scene, tiny_trial,
};
pub use levels::{
    render_at_every_level, render_at_levels, render_stored_at_every_level, render_stored_at_levels,
};
pub use moves::{scaled, shifted, turned};
pub use named::{all_shapes, looking, seed_scene};
pub use pictures::{
    Difference, Rendered, SameBits, checked, first_difference, render_stored, render_to_image, render_window,
    render_with_layers, replay_hint,
};
pub use promise::{Trial, broken_promise, greatest_error};
pub use random::Random;
pub use strategies::{
    AnyScene, any_border, any_judge, any_material, any_mesh_scene, any_scene, any_scene_of_slivers,
    any_scene_of_solids, any_shape, seeded,
};
