//! Objects become primitives, each on a surface.

use brt_geometry::{
    Affine, Cone, Cylinder, Disc, Plane, Polygon, Primitive, Sphere, Triangle, Vec3, area_share, is_convex,
    polygon_plane, triangulate,
};
use brt_image::Rgb;
use brt_scene::{Object, Scene, Shape};

use super::mesh::flatten_mesh;
use crate::products::{
    Carrier, NO_COLORS, NO_NORMALS, NO_TEXCOORDS, PreparedMaterial, PrimitiveInfo, Surface,
};
use crate::run::Cancel;

/// Primitives of a scene and what is known of them.
#[derive(Default)]
pub(super) struct Flattened {
    /// The point of the scene that becomes the origin.
    pub(super) origin: Vec3,
    pub(super) primitives: Vec<Primitive>,
    pub(super) infos: Vec<PrimitiveInfo>,
    pub(super) surfaces: Vec<Surface>,
    pub(super) normals: Vec<[Vec3; 3]>,
    pub(super) colors: Vec<[Rgb; 3]>,
    pub(super) texcoords: Vec<[[f64; 2]; 3]>,
}

/// What is interpolated between the corners of a triangle.
#[derive(Clone, Copy, Default)]
pub(super) struct Corners {
    pub(super) normals: Option<[Vec3; 3]>,
    pub(super) colors: Option<[Rgb; 3]>,
    pub(super) texcoords: Option<[[f64; 2]; 3]>,
}

/// Adds an item, if there is one; returns its index.
fn keep<T>(items: &mut Vec<T>, item: Option<T>) -> Option<u32> {
    items.push(item?);
    Some((items.len() - 1) as u32)
}

/// The object that is being flattened.
#[derive(Clone, Copy)]
pub(super) struct Owner {
    object: usize,
    material: u32,
    casts_shadow: bool,
    pub(super) has_texture: bool,
}

impl Flattened {
    /// All primitives; some of them if it is cancelled.
    ///
    /// Of primitives that lie upon each other the first counts. So what is only partly there comes first, for the others are
    /// seen behind it; then what ends the view, and glass last: where it stands on a floor it is not to hide the floor.
    pub(super) fn of(scene: &Scene, origin: Vec3, materials: &[PreparedMaterial], cancel: Cancel) -> Self {
        let mut flat = Self { origin, ..Self::default() };
        let rank = |object: &Object| {
            let material = &materials[object.material.0 as usize];
            (!material.dims(), !material.ends_view())
        };
        let mut objects: Vec<(usize, &Object)> = scene.objects.iter().enumerate().collect();
        objects.sort_by_key(|(_, object)| rank(object));
        for (index, object) in objects {
            if cancel.is_set() {
                break;
            }
            let material = &scene.materials[object.material.0 as usize];
            let owner = Owner {
                object: index,
                material: object.material.0,
                casts_shadow: material.casts_shadow,
                has_texture: material.texture.is_some(),
            };
            flat.add_object(object, owner);
        }
        flat
    }

    /// A new surface of an object.
    pub(super) fn add_surface(&mut self, owner: Owner) -> u32 {
        self.surfaces.push(Surface { object: owner.object });
        (self.surfaces.len() - 1) as u32
    }

    /// A primitive on a surface, with what is interpolated between its corners.
    pub(super) fn add(&mut self, primitive: Primitive, owner: Owner, surface: u32, corners: Corners) {
        let normals = keep(&mut self.normals, corners.normals).unwrap_or(NO_NORMALS);
        let colors = keep(&mut self.colors, corners.colors).unwrap_or(NO_COLORS);
        let texcoords = keep(&mut self.texcoords, corners.texcoords).unwrap_or(NO_TEXCOORDS);
        self.primitives.push(primitive);
        self.infos.push(PrimitiveInfo {
            surface,
            material: owner.material,
            normals,
            colors,
            texcoords,
            casts_shadow: owner.casts_shadow,
        });
    }

    /// Makes room for so many primitives more.
    pub(super) fn reserve(&mut self, count: usize) {
        self.primitives.reserve(count);
        self.infos.reserve(count);
    }

    /// Removes primitives, together with their carriers.
    pub(super) fn remove(&mut self, is_removed: &[bool], carriers: &mut Vec<Carrier>) {
        let keeps = || is_removed.iter().map(|removed| !removed);
        let mut keep = keeps();
        self.primitives.retain(|_| keep.next().unwrap_or(true));
        let mut keep = keeps();
        self.infos.retain(|_| keep.next().unwrap_or(true));
        let mut keep = keeps();
        carriers.retain(|_| keep.next().unwrap_or(true));
    }

    fn add_alone(&mut self, primitive: Primitive, owner: Owner) {
        let surface = self.add_surface(owner);
        self.add(primitive, owner, surface, Corners::default());
    }

    fn add_object(&mut self, object: &Object, owner: Owner) {
        let origin = self.origin;
        let here = |p: &Vec3| *p - origin;
        match &object.shape {
            Shape::Sphere { center, radius } => {
                self.add_alone(Primitive::Sphere(Sphere { center: here(center), radius: *radius }), owner);
            }
            Shape::Plane { normal, distance } => {
                let length = normal.length();
                let unit = normal.try_normalize().unwrap_or_default();
                let plane = Plane::new(unit, distance / length - unit.dot(origin));
                self.add_alone(Primitive::Plane(plane), owner);
            }
            Shape::Polygon { outline, holes } => {
                let holes: Vec<Vec<Vec3>> =
                    holes.iter().map(|hole| hole.iter().map(here).collect()).collect();
                self.add_polygon(&outline.iter().map(here).collect::<Vec<_>>(), &holes, owner);
            }
            Shape::Disc { center, normal, radius } => {
                let unit = normal.try_normalize().unwrap_or_default();
                self.add_alone(Primitive::Disc(Disc::new(here(center), unit, *radius)), owner);
            }
            Shape::Cylinder { base, top, radius, capped } => {
                self.add_round([here(base), here(top)], [*radius, *radius], *capped, owner);
            }
            Shape::Cone { base, base_radius, top, top_radius, capped } => {
                self.add_round([here(base), here(top)], [*base_radius, *top_radius], *capped, owner);
            }
            Shape::Mesh(mesh) => {
                let map = Affine { offset: object.transform.offset - origin, ..object.transform };
                flatten_mesh(mesh, &map, owner, self);
            }
        }
    }

    fn add_polygon(&mut self, outline: &[Vec3], holes: &[Vec<Vec3>], owner: Owner) {
        let Some(fit) = polygon_plane(outline) else { return };
        let plane = fit.plane();
        let surface = self.add_surface(owner);
        let corners: Vec<Vec3> = outline.iter().chain(holes.iter().flatten()).copied().collect();
        let is_face = fit.is_face(&corners);
        if is_face && holes.is_empty() && is_convex(outline, fit.normal) {
            let primitive = match *outline {
                [a, b, c] => Primitive::Triangle(Triangle { plane, corners: [a, b, c] }),
                _ => Primitive::Polygon(Polygon { plane, corners: outline.into() }),
            };
            self.add(primitive, owner, surface, Corners::default());
            return;
        }
        for triangle in triangulate(outline, holes, fit.normal) {
            let corners = triangle.map(|i| corners[i as usize]);
            // Parts of a face keep its plane, so they are hit at one distance, and are kept however thin.
            let of_face = || Triangle { plane: plane.for_area_share(area_share(&corners)), corners };
            let part = if is_face { Some(of_face()) } else { Triangle::new(corners) };
            if let Some(part) = part {
                self.add(Primitive::Triangle(part), owner, surface, Corners::default());
            }
        }
    }

    /// A cylinder or cone, and discs that close it.
    fn add_round(
        &mut self,
        [base, top]: [Vec3; 2],
        [base_radius, top_radius]: [f64; 2],
        capped: bool,
        owner: Owner,
    ) {
        let axis = (top - base).try_normalize().unwrap_or_default();
        let height = (top - base).length();
        let side = if base_radius == top_radius {
            Primitive::Cylinder(Cylinder { base, axis, low: 0.0, high: height, radius: base_radius })
        } else {
            let slope = (top_radius - base_radius) / height;
            Primitive::Cone(Cone { base, axis, low: 0.0, high: height, base_radius, slope })
        };
        self.add_alone(side, owner);
        if capped {
            for (center, normal, radius) in [(base, -axis, base_radius), (top, axis, top_radius)] {
                if radius > 0.0 {
                    self.add_alone(Primitive::Disc(Disc::new(center, normal, radius)), owner);
                }
            }
        }
    }
}
