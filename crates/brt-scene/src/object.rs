//! What stands in a scene.

use std::borrow::Cow;
use std::sync::Arc;

use brt_geometry::{Affine, Vec3};
use brt_image::Rgb;

use crate::MaterialId;

/// A shape made of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Optional name, for messages and `inspect`.
    pub name: Option<String>,
    /// Where and what it is.
    pub shape: Shape,
    /// What it is made of.
    pub material: MaterialId,
    /// Where the shape's own space lies in the scene. Only meshes have a space of their own.
    pub transform: Affine,
}

impl Object {
    /// A shape where it stands, without a name.
    pub fn new(shape: Shape, material: MaterialId) -> Self {
        Self { name: None, shape, material, transform: Affine::IDENTITY }
    }

    /// Corners of a box around it (not always the smallest); `None` for a plane and for an empty mesh.
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        match &self.shape {
            Shape::Mesh(mesh) if self.transform != Affine::IDENTITY => {
                hull_of(mesh.positions.iter().map(|&p| self.transform.point(p)))
            }
            shape => shape.bounds(),
        }
    }
}

/// The shapes that can be traced exactly. Lengths in scene units.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// All points at distance `radius` from `center`.
    Sphere {
        /// Centre.
        center: Vec3,
        /// Radius, > 0.
        radius: f64,
    },
    /// All points p with `normal·p = distance` (for a unit normal; longer ones are normalised, `distance` with them).
    Plane {
        /// Normal of any length but 0; behind it is the inside of refracting material.
        normal: Vec3,
        /// Signed distance from the origin, times the normal's length.
        distance: f64,
    },
    /// A flat polygon, convex or concave, with holes. Counter-clockwise seen from its front.
    Polygon {
        /// Outer loop, at least three points in one plane.
        outline: Vec<Vec3>,
        /// Inner loops in the same plane, inside the outline, not touching each other.
        holes: Vec<Vec<Vec3>>,
    },
    /// A flat disc.
    Disc {
        /// Centre.
        center: Vec3,
        /// Normal of any length but 0.
        normal: Vec3,
        /// Radius, > 0.
        radius: f64,
    },
    /// A circular cylinder between two points of its axis.
    Cylinder {
        /// One end of the axis.
        base: Vec3,
        /// The other end.
        top: Vec3,
        /// Radius, > 0.
        radius: f64,
        /// Closed by discs at both ends?
        capped: bool,
    },
    /// A circular cone or frustum between two points of its axis.
    Cone {
        /// One end of the axis.
        base: Vec3,
        /// Radius there, ≥ 0.
        base_radius: f64,
        /// The other end.
        top: Vec3,
        /// Radius there, ≥ 0; not both 0.
        top_radius: f64,
        /// Closed by discs at ends with a radius?
        capped: bool,
    },
    /// Triangles that share points. Objects may share a mesh.
    Mesh(Arc<Mesh>),
}

/// A triangle mesh.
///
/// Triangles that share an edge through the same two point *indices* and have normals form one smooth group: one
/// surface. A crease is made by giving a point twice.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Points.
    pub positions: Vec<Vec3>,
    /// A shading normal per point (any length but 0), or empty for flat facets.
    pub normals: Vec<Vec3>,
    /// A colour per point, linear RGB, that the material's colour is multiplied with; interpolated over triangles.
    /// Empty: none.
    pub colors: Vec<Rgb>,
    /// Where each point lies in the picture of the material's [texture](crate::Texture), or empty.
    pub texcoords: Vec<[f64; 2]>,
    /// Three indices a triangle, counter-clockwise seen from its front.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh where a map puts it. One that mirrors turns triangles around, so that fronts stay fronts.
    pub fn placed(&self, map: &Affine) -> Cow<'_, Self> {
        if *map == Affine::IDENTITY {
            return Cow::Borrowed(self);
        }
        let mut placed = self.clone();
        placed.positions.iter_mut().for_each(|p| *p = map.point(*p));
        placed.normals.iter_mut().for_each(|n| *n = map.normal(*n));
        if map.mirrors() {
            placed.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        Cow::Owned(placed)
    }
}

impl From<Mesh> for Shape {
    fn from(mesh: Mesh) -> Self {
        Self::Mesh(Arc::new(mesh))
    }
}

impl Shape {
    /// The kind's name as scene files spell it.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Plane { .. } => "plane",
            Self::Polygon { .. } => "polygon",
            Self::Disc { .. } => "disc",
            Self::Cylinder { .. } => "cylinder",
            Self::Cone { .. } => "cone",
            Self::Mesh(_) => "mesh",
        }
    }

    /// Corners of a box around it (not always the smallest); `None` for a plane.
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        let around = |center: Vec3, radius: f64| {
            let r = Vec3::splat(radius);
            [center - r, center + r]
        };
        let hull = |[a, b]: [Vec3; 2], [c, d]: [Vec3; 2]| [a.min(c), b.max(d)];
        match self {
            Self::Sphere { center, radius } => Some(around(*center, *radius)),
            Self::Plane { .. } => None,
            Self::Polygon { outline, .. } => hull_of(outline.iter().copied()),
            Self::Disc { center, radius, .. } => Some(around(*center, *radius)),
            Self::Cylinder { base, top, radius, .. } => {
                Some(hull(around(*base, *radius), around(*top, *radius)))
            }
            Self::Cone { base, base_radius, top, top_radius, .. } => {
                Some(hull(around(*base, *base_radius), around(*top, *top_radius)))
            }
            Self::Mesh(mesh) => hull_of(mesh.positions.iter().copied()),
        }
    }
}

fn hull_of(points: impl Iterator<Item = Vec3>) -> Option<[Vec3; 2]> {
    let nothing = [Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY)];
    let [lo, hi] = points.fold(nothing, |[lo, hi], p| [lo.min(p), hi.max(p)]);
    (lo.x <= hi.x).then_some([lo, hi])
}
