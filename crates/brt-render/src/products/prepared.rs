//! The scene as the tracers want it.

use brt_geometry::{Aabb, Exponent, Primitive, Real, SpatialIndex, Start, Vec3};
use brt_image::Rgb;
use brt_scene::{Axis, Checker, Highlight};

use super::{Carrier, PreparedTexture};
use crate::margins::LIGHT_MARGIN;

/// A scene flattened to primitives, with an index over them.
#[derive(Clone, Debug)]
pub struct PreparedScene {
    /// Those of objects that are partly there first, then what ends the view, then glass; each in the order of the scene. The
    /// index is the primitive's id. Of equally near hits the lowest wins.
    pub(crate) primitives: Vec<Primitive>,
    /// One for each primitive.
    pub(crate) infos: Vec<PrimitiveInfo>,
    /// One for each primitive.
    pub(crate) carriers: Vec<Carrier>,
    /// Planes on which faces of glass lie that look to both sides, in their order.
    pub(crate) contacts: Vec<Carrier>,
    /// Carriers of several primitives of which one is only partly there, in their order.
    pub(crate) layered: Vec<Carrier>,
    /// What may be interpolated across.
    pub(crate) surfaces: Vec<Surface>,
    /// Shading normals of smooth triangles.
    pub(crate) normals: Vec<[Vec3; 3]>,
    /// Primitives outside the index: those without a box, or all of a tiny scene.
    pub(crate) outside: Vec<u32>,
    /// Items are primitive ids.
    pub(crate) index: SpatialIndex,
    /// What holds all primitives that have a box, wherever they are kept; a point where there are none.
    pub(crate) bounds: Aabb,
    /// The point of the scene that is the origin here: everything, eye and lights included, was moved by it.
    pub(crate) origin: Vec3,
    pub(crate) lights: Vec<PreparedLight>,
    pub(crate) materials: Vec<PreparedMaterial>,
    pub(crate) background: Rgb,
    /// No colour that is seen is darker: 0 where no colour of the scene is negative.
    pub(crate) darkest: f32,
    /// Does anything dim lights instead of hiding them?
    pub(crate) has_dimmers: bool,
    /// Colours of the corners of triangles.
    pub(crate) colors: Vec<[Rgb; 3]>,
    /// Texture coordinates of the corners of triangles.
    pub(crate) texcoords: Vec<[[f64; 2]; 3]>,
}

impl PreparedScene {
    /// The point of the scene that is the origin of prepared coordinates, for [`PreparedCamera`](crate::PreparedCamera).
    pub fn origin(&self) -> Vec3 {
        self.origin
    }

    /// Number of primitives.
    pub fn primitive_count(&self) -> usize {
        self.primitives.len()
    }

    /// Does a ray that leaves `from` start on a primitive?
    #[inline(always)]
    pub(crate) fn start(&self, id: u32, from: Carrier) -> Start {
        if self.carriers[id as usize] == from { Start::OnPrimitive } else { Start::Elsewhere }
    }

    /// What rays leave that start on a primitive.
    #[inline(always)]
    pub(crate) fn carrier(&self, id: u32) -> Carrier {
        self.carriers[id as usize]
    }

    /// What a primitive is made of.
    pub(crate) fn material_of(&self, id: u32) -> &PreparedMaterial {
        &self.materials[self.infos[id as usize].material as usize]
    }

    /// Do faces lie in one plane, of which the first is what all rays meet that meet both?
    pub(crate) fn hides_coincident(&self, first: u32, second: u32) -> bool {
        first < second
            && self.carrier(first) == self.carrier(second)
            && self.primitives[first as usize].is_flat()
    }

    /// Does a primitive, if it casts shadows, only dim the lights behind it?
    pub(crate) fn dims(&self, id: u32) -> bool {
        self.material_of(id).dims()
    }

    /// All surfaces; ray histories and surface layers name them by position.
    pub fn surfaces(&self) -> &[Surface] {
        &self.surfaces
    }
}

/// What may be interpolated across: a sphere, a flat face, the side of a cylinder, a smooth group of a mesh.
#[doc(alias = "patch")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Surface {
    /// The object of the scene that it belongs to.
    pub object: usize,
}

/// No shading normals: the geometric normal is used.
pub(crate) const NO_NORMALS: u32 = u32::MAX;

/// No colours of corners.
pub(crate) const NO_COLORS: u32 = u32::MAX;

/// No texture coordinates of corners, or no texture.
pub(crate) const NO_TEXCOORDS: u32 = u32::MAX;

/// What else there is to know of a primitive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PrimitiveInfo {
    pub(crate) surface: u32,
    pub(crate) material: u32,
    /// Index into [`PreparedScene::normals`] or [`NO_NORMALS`].
    pub(crate) normals: u32,
    /// Index into [`PreparedScene::colors`] or [`NO_COLORS`].
    pub(crate) colors: u32,
    /// Index into [`PreparedScene::texcoords`] or [`NO_TEXCOORDS`].
    pub(crate) texcoords: u32,
    /// Does it hide lights?
    pub(crate) casts_shadow: bool,
}

impl PrimitiveInfo {
    /// Is nothing interpolated between corners? Bounds and lanes know nothing else.
    #[inline(always)]
    pub(crate) fn is_plain(&self) -> bool {
        self.normals == NO_NORMALS && self.colors == NO_COLORS && self.texcoords == NO_TEXCOORDS
    }
}

/// Nothing hides a light from this share of the way to it on.
pub(crate) const LIGHT_END: f64 = 1.0 - LIGHT_MARGIN;

/// A light with its direction normalised.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PreparedLight {
    /// A point, with a beam if it does not shine in all directions.
    Point {
        position: Vec3,
        color: Rgb,
        beam: Option<Beam>,
    },
    Directional {
        towards: Vec3,
        color: Rgb,
    },
}

/// The cone that a point shines in.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beam {
    /// Unit vector away from the light.
    pub(crate) axis: Vec3,
    /// Cosine of the angle to the axis where the light ends.
    pub(crate) outer: f64,
    /// One over the difference of the cosines where the strength begins to fall and where it ends.
    pub(crate) steepness: f64,
}

/// A chequered pattern, in prepared coordinates.
#[derive(Clone, Debug)]
pub(crate) struct PreparedChecker {
    /// The colour of every other square.
    pub(crate) color: Rgb,
    /// Side of the squares.
    pub(crate) size: f64,
    axis: Axis,
    origin: Vec3,
}

impl PreparedChecker {
    pub(crate) fn new(checker: &Checker, origin: Vec3) -> Self {
        Self { color: checker.color, size: checker.size, axis: checker.axis, origin }
    }

    /// Where the pattern sees a point, in the scene's own coordinates.
    #[inline(always)]
    pub(crate) fn place<R: Real>(&self, point: &Vec3<R>) -> (R, R) {
        let Vec3 { x, y, z } = *point + self.origin.lift();
        match self.axis {
            Axis::X => (y, z),
            Axis::Y => (x, z),
            Axis::Z => (x, y),
        }
    }
}

/// A material without its name; fields as in [`brt_scene::Material`].
#[derive(Clone, Debug)]
pub(crate) struct PreparedMaterial {
    pub(crate) color: Rgb,
    pub(crate) checker: Option<PreparedChecker>,
    pub(crate) texture: Option<PreparedTexture>,
    pub(crate) emission: Rgb,
    pub(crate) opacity: f64,
    pub(crate) ambient: f64,
    pub(crate) diffuse: f64,
    pub(crate) specular: f64,
    pub(crate) exponent: Exponent,
    pub(crate) highlight: Highlight,
    pub(crate) reflection: f64,
    pub(crate) transmission: f64,
    pub(crate) index_of_refraction: f64,
}

impl PreparedMaterial {
    /// Does no ray go on behind the surface? Bounds and lanes know nothing else.
    #[inline(always)]
    pub(crate) fn ends_view(&self) -> bool {
        self.transmission == 0.0 && !self.dims()
    }

    /// May it let some of what lies straight behind it through?
    #[inline(always)]
    pub(crate) fn dims(&self) -> bool {
        self.opacity < 1.0 || self.texture.as_ref().is_some_and(PreparedTexture::has_holes)
    }

    /// Does a ray end here?
    pub(crate) fn is_dull(&self) -> bool {
        self.reflection == 0.0 && self.transmission == 0.0
    }
}
