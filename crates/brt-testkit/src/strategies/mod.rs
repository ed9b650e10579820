//! Random scenes, views and settings for property tests.

mod materials;
mod meshes;
mod scenes;
mod settings;
mod shapes;
mod slivers;
mod solids;

pub use materials::any_material;
pub use meshes::any_mesh_scene;
pub use scenes::{AnyScene, any_scene};
pub use settings::{any_border, any_judge, seeded};
pub use shapes::any_shape;
pub use slivers::any_scene_of_slivers;
pub use solids::any_scene_of_solids;

use brt_geometry::{Vec3, vec3};
use proptest::prelude::*;

/// A coordinate; often a multiple of ½, so that things touch, lie in one plane and are met at the same distance.
fn coordinate(half: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => -half..half,
        1 => (-half..half).prop_map(|x| (2.0 * x).round() * 0.5),
    ]
}

fn point(half: f64) -> impl Strategy<Value = Vec3> {
    (coordinate(half), coordinate(half), coordinate(half)).prop_map(|(x, y, z)| vec3(x, y, z))
}

/// A direction of some length, often along an axis.
fn direction() -> impl Strategy<Value = Vec3> {
    prop_oneof![
        2 => point(1.0).prop_filter("a direction has a length", |d| d.length() > 0.05),
        1 => (0_usize..3, any::<bool>()).prop_map(|(axis, back)| {
            let mut unit = Vec3::ZERO;
            unit[axis] = if back { -1.0 } else { 1.0 };
            unit
        }),
    ]
}
