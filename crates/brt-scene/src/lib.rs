//! The scene as pure data.
//!
//! A [`Scene`] says what is seen and how it is lit; it knows no file format and no method. Importers build one,
//! [`check`](Scene::check) it, and hand it on with a [`Report`] of what they did not understand. After a check that
//! finds nothing the renderer may rely on: every number finite, every radius and size positive, every polygon
//! planar with an area, every index in range.

mod camera;
mod check;
pub mod framing;
mod light;
mod material;
mod object;
mod report;
mod texture;

pub use camera::{Camera, Projection};
pub use check::{CheckedScene, Place, Problem};
pub use light::Light;
pub use material::{Axis, Checker, Highlight, Material};
pub use object::{Mesh, Object, Shape};
pub use report::{Diagnostic, Report, Severity};
pub use texture::{Texels, Texture, TextureAlpha, TextureFilter, Wrap};

use brt_geometry::Vec3;
use brt_image::Rgb;

/// Index of a material in [`Scene::materials`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct MaterialId(pub u32);

/// Everything that a picture shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The eye.
    pub camera: Camera,
    /// Width and height in pixels that the file asks for; the command line overrides it.
    pub size: Option<[u32; 2]>,
    /// Colour of rays that hit nothing.
    pub background: Rgb,
    /// Greatest number of mirror and refraction bounces after the camera ray.
    pub max_depth: u32,
    /// Lights, in the order that ray histories name them.
    pub lights: Vec<Light>,
    /// Materials, named by objects through [`MaterialId`].
    pub materials: Vec<Material>,
    /// Objects; where two are hit at the same distance, the earlier one is seen, but what lets the view through last.
    pub objects: Vec<Object>,
}

impl Scene {
    /// Bounce limit of a scene that names none: that of the seed scenes.
    pub const DEFAULT_MAX_DEPTH: u32 = 5;

    /// Greatest bounce limit: bounces nest on a thread's stack.
    pub const GREATEST_MAX_DEPTH: u32 = 1000;

    /// An empty scene before a black background.
    pub fn new(camera: Camera) -> Self {
        Self {
            camera,
            size: None,
            background: Rgb::BLACK,
            max_depth: Self::DEFAULT_MAX_DEPTH,
            lights: Vec::new(),
            materials: Vec::new(),
            objects: Vec::new(),
        }
    }

    /// Adds a material and returns its id.
    pub fn add_material(&mut self, material: Material) -> MaterialId {
        self.materials.push(material);
        MaterialId((self.materials.len() - 1) as u32)
    }

    /// Adds an object without a name.
    pub fn add(&mut self, shape: Shape, material: MaterialId) {
        self.objects.push(Object::new(shape, material));
    }

    /// Smallest box around all bounded objects; `None` where there is none.
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        self.objects.iter().filter_map(Object::bounds).reduce(|[lo, hi], [l, h]| [lo.min(l), hi.max(h)])
    }
}
