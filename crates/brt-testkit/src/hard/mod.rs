//! Scenes at the limits of what can be computed: few primitives, tiny or far away, coincident or touching, far from the origin.
//!
//! A scene is a function of bytes ([`Choices`]), so that a property test shrinks it, a fuzzer mutates it, and a seed
//! makes millions of them. It is first built around the origin, about a unit large, then turned, scaled and moved as a whole.

mod choices;
mod coincident;
mod far;
mod gaps;
mod long;
mod materials;
mod things;

use brt_geometry::{Affine, SimdLevel, Vec3, vec3};
use brt_image::Transfer;
use brt_render::{Accelerator, CertifiedSettings};
use brt_scene::{Camera, Material, Projection, Scene, Shape};
use proptest::prelude::*;

pub use self::choices::Choices;
use crate::moves::{scaled, shifted, turned};
use crate::{AnyScene, Random, Trial};

/// What makes a scene hard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HardKind {
    /// Something down to a billionth of its distance from the eye, which is up to a million units away.
    Tiny,
    /// The same, seen in a flat mirror.
    Mirrored,
    /// The same, seen by the shadow that it throws.
    Shadow,
    /// Things that are there twice, touch, or overlap in one plane.
    Coincident,
    /// A scene up to 10¹³ of its sizes from the origin.
    Offset,
    /// Faces a billionth of the scene apart, so far away that some of them are one.
    Gaps,
    /// Needles: cones and cylinders up to a million times as long as they are wide.
    Long,
    /// Anything anywhere, at any scale, by any camera.
    Mixed,
}

impl HardKind {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Tiny,
        Self::Mirrored,
        Self::Shadow,
        Self::Coincident,
        Self::Offset,
        Self::Long,
        Self::Mixed,
        Self::Gaps,
    ];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tiny => "tiny",
            Self::Mirrored => "mirrored",
            Self::Shadow => "shadow",
            Self::Coincident => "coincident",
            Self::Offset => "offset",
            Self::Gaps => "gaps",
            Self::Long => "long",
            Self::Mixed => "mixed",
        }
    }

    /// The kind of this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// As many bytes as a scene reads at most, nearly always.
const HARD_BYTES: usize = 256;

/// A scene of this kind; `None` where its numbers come out as something that is not fit to be rendered.
pub fn hard_scene(kind: HardKind, choices: &mut Choices) -> Option<Scene> {
    let scene = match kind {
        HardKind::Tiny => far::tiny(choices),
        HardKind::Mirrored => far::mirrored(choices),
        HardKind::Shadow => far::shadow(choices),
        HardKind::Coincident => coincident::coincident(choices),
        HardKind::Offset => {
            let scene = match choices.below(3) {
                0 => mixed(choices),
                1 => coincident::coincident(choices),
                _ => far::shadow(choices),
            };
            return moved(choices, &scene, Some([0.0, 13.0]));
        }
        HardKind::Gaps => {
            let scene = gaps::gaps(choices);
            return moved(choices, &scene, Some(gaps::OFFSETS));
        }
        HardKind::Long => long::long(choices),
        HardKind::Mixed => mixed(choices),
    };
    moved(choices, &scene, None)
}

/// A scene of opaque things and the same with some of them given twice, which must not be seen.
pub fn doubled_scene(choices: &mut Choices) -> Option<[Scene; 2]> {
    let [once, twice] = coincident::doubled(choices);
    let axis = choices.direction();
    let [once, twice] = [once, twice].map(|scene| finished(&turned(&scene, &turn_to(axis))));
    Some([once?, twice?])
}

/// A strategy for [`hard_scene`].
pub fn any_hard_scene(kind: HardKind) -> impl Strategy<Value = AnyScene> {
    prop::collection::vec(any::<u8>(), 0..HARD_BYTES).prop_filter_map("fit to be rendered", move |bytes| {
        hard_scene(kind, &mut Choices::new(&bytes)).map(AnyScene)
    })
}

/// A strategy for [`doubled_scene`].
pub fn any_doubled_scene() -> impl Strategy<Value = [AnyScene; 2]> {
    prop::collection::vec(any::<u8>(), 0..HARD_BYTES).prop_filter_map("fit to be rendered", |bytes| {
        doubled_scene(&mut Choices::new(&bytes)).map(|scenes| scenes.map(AnyScene))
    })
}

/// Any bytes as a scene and a trial in a picture of a few pixels: what the fuzz target `render_tiny` tries.
pub fn tiny_trial(bytes: &[u8]) -> Option<(Scene, Trial)> {
    let mut choices = Choices::new(bytes);
    let kind = choices.pick(&HardKind::ALL);
    // Fewer samples than 48 are traced whatever is known of them.
    let size = [choices.pick(&[12, 9, 4, 11]), choices.pick(&[12, 9, 4, 10])];
    let transfer = choices.pick(&[Transfer::Linear, Transfer::Srgb]);
    let certified = CertifiedSettings { tolerance: choices.pick(&[1.0, 1.0, 0.1]) };
    let accelerator =
        choices.pick(&[Accelerator::Bvh, Accelerator::None, Accelerator::Extents, Accelerator::Grid]);
    let simd = choices.pick(&[SimdLevel::Widest, SimdLevel::Baseline, SimdLevel::Avx2]);
    let scene = hard_scene(kind, &mut choices)?;
    Some((scene, Trial { size, accelerator, simd, certified, transfer }))
}

/// Random bytes for [`hard_scene`].
pub fn hard_bytes(random: &mut Random) -> Vec<u8> {
    (0..HARD_BYTES).map(|_| random.below(256) as u8).collect()
}

/// Up to five things of any size, by any camera.
fn mixed(choices: &mut Choices) -> Scene {
    let eye = choices.direction() * choices.magnitude(-1.0, 2.0);
    let projection = if choices.one_in(4) {
        Projection::Orthographic { extent: choices.magnitude(-3.0, 2.0) }
    } else {
        Projection::Perspective { fov_deg: choices.pick(&[45.0, 1.0, 120.0, 1e-6, 179.9]) }
    };
    let up = if choices.one_in(3) { choices.direction() } else { vec3(0.3, 0.5, 0.8) };
    let camera = Camera { eye, look_at: choices.point(1.0), up, projection };
    let mut scene = Scene::new(camera);
    for _ in 0..=choices.below(5) {
        let (center, radius) = (choices.point(1.0), choices.magnitude(-4.0, 1.0));
        let shape = if choices.one_in(5) {
            Shape::Plane { normal: choices.direction(), distance: choices.coordinate(2.0) }
        } else {
            things::any(choices, center, radius)
        };
        let material = materials::any(choices);
        add(&mut scene, shape, material);
    }
    if choices.one_in(4) {
        let object = scene.objects[0].clone();
        scene.objects.push(object);
    }
    for _ in 0..choices.below(4) {
        far::add_light(choices, &mut scene);
    }
    scene
}

/// Adds an object of a material of its own.
fn add(scene: &mut Scene, shape: Shape, material: Material) {
    let name = format!("m{}", scene.materials.len());
    let material = scene.add_material(Material { name, ..material });
    scene.add(shape, material);
}

/// The scene turned, scaled and moved, or not; `None` if it cannot be rendered. It is moved at any rate if powers of ten are
/// given, between which it will be away.
fn moved(choices: &mut Choices, scene: &Scene, away: Option<[f64; 2]>) -> Option<Scene> {
    let mut scene = scene.clone();
    scene.background = choices.pick(&[brt_image::rgb(0.2, 0.3, 0.4), brt_image::Rgb::BLACK]);
    scene.max_depth = choices.pick(&[3, 0, 1, 6]);
    // Six mirrors that are partly there, one in another, show each other in a hundred thousand rays for each sample.
    if scene.materials.iter().any(|m| m.opacity < 1.0 && m.reflection > 0.0) {
        scene.max_depth = scene.max_depth.min(3);
    }
    if choices.one_in(2) {
        scene = turned(&scene, &turn_to(choices.direction()));
    }
    if away.is_some() || choices.one_in(4) {
        let [nearest, farthest] = away.unwrap_or([0.0, 3.0]);
        let offset = choices.direction() * choices.magnitude(nearest, farthest);
        scene = shifted(&scene, offset);
    }
    if choices.one_in(2) {
        scene = scaled(&scene, choices.magnitude(-6.0, 6.0));
    }
    finished(&scene)
}

fn finished(scene: &Scene) -> Option<Scene> {
    scene.check().is_empty().then(|| scene.clone())
}

/// What turns y into this direction.
fn turn_to(axis: Vec3) -> Affine {
    let (u, v) = axis.tangents();
    Affine { axes: [u, axis, v], offset: Vec3::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt_scene::Light;

    /// The generator is worth what it makes: most bytes are a scene, and of every kind there are many.
    #[test]
    fn most_bytes_are_a_scene_that_can_be_rendered() {
        let mut random = Random::new(1);
        for kind in HardKind::ALL {
            let made = (0..400)
                .filter_map(|_| hard_scene(kind, &mut Choices::new(&hard_bytes(&mut random))))
                .inspect(|scene| assert!(scene.check().is_empty()))
                .count();
            assert!(made > 200, "{}: {made} of 400", kind.name());
        }
        assert!(HardKind::ALL.iter().all(|&kind| hard_scene(kind, &mut Choices::new(&[])).is_some()));
    }

    #[test]
    fn the_extremes_are_reached() {
        let mut random = Random::new(2);
        let mut scenes = |kind| {
            let made =
                (0..2000).filter_map(|_| hard_scene(kind, &mut Choices::new(&hard_bytes(&mut random))));
            made.collect::<Vec<Scene>>()
        };
        let narrowest = |scenes: &[Scene]| {
            let fov = |scene: &Scene| match scene.camera.projection {
                Projection::Perspective { fov_deg } => fov_deg,
                Projection::Orthographic { .. } => 180.0,
            };
            scenes.iter().map(fov).fold(180.0, f64::min)
        };
        for kind in [HardKind::Tiny, HardKind::Mirrored] {
            assert!(narrowest(&scenes(kind)) < 1e-6, "{}", kind.name());
        }
        let is_far = |scene: &Scene| {
            let is_far =
                |light: &Light| matches!(light, Light::Point { position, .. } if position.length() > 1e4);
            scene.lights.iter().any(is_far)
        };
        assert!(scenes(HardKind::Shadow).iter().filter(|scene| is_far(scene)).count() > 20);
        let offset = |scene: &Scene| {
            let [lo, hi] = scene.bounds()?;
            Some((lo + hi).length() / (hi - lo).length())
        };
        assert!(scenes(HardKind::Offset).iter().filter_map(offset).fold(0.0, f64::max) > 1e10);
    }
}
