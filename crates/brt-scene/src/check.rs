//! Is a scene fit to be rendered? Answers with places, which importers turn into positions in the file.

use std::ops::Deref;

use brt_geometry::{Affine, SMALLEST_LENGTH, Vec3, polygon_plane};
use thiserror::Error;

use crate::{Camera, Light, Object, Projection, Scene, Shape};

mod material;
mod mesh;

use material::check_material;
use mesh::check_mesh;

/// Coordinates beyond this cannot be traced: their fourth powers must stay far from overflow.
pub(crate) const GREATEST_COORDINATE: f64 = 1e30;

/// A part of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A field of the scene itself.
    Scene(&'static str),
    /// A field of the camera.
    Camera(&'static str),
    /// A field of the light with this index.
    Light(usize, &'static str),
    /// A field of the material with this index.
    Material(usize, &'static str),
    /// A field of the object with this index.
    Object(usize, &'static str),
}

/// Something that keeps a scene from being rendered.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{message}, expected {expected}")]
pub struct Problem {
    /// Where it is.
    pub place: Place,
    /// What is wrong.
    pub message: String,
    /// What was expected.
    pub expected: &'static str,
}

/// A scene that is fit to be rendered: only [`Scene::checked`] makes one.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckedScene(Scene);

impl CheckedScene {
    /// The scene, to be changed; it must be checked again.
    pub fn into_inner(self) -> Scene {
        self.0
    }
}

impl Deref for CheckedScene {
    type Target = Scene;

    fn deref(&self) -> &Scene {
        &self.0
    }
}

impl PartialEq<Scene> for CheckedScene {
    fn eq(&self, other: &Scene) -> bool {
        self.0 == *other
    }
}

impl Camera {
    /// What keeps it from taking a picture; nothing: it can.
    pub fn check(&self) -> Vec<Problem> {
        let mut problems = Vec::new();
        check_camera(self, &mut |field, Fault(message, expected)| {
            problems.push(Problem { place: Place::Camera(field), message, expected });
        });
        problems
    }
}

impl Scene {
    /// The scene, if nothing keeps it from being rendered.
    ///
    /// # Errors
    /// All problems, in the order of the scene.
    pub fn checked(self) -> Result<CheckedScene, Vec<Problem>> {
        let problems = self.check();
        if problems.is_empty() { Ok(CheckedScene(self)) } else { Err(problems) }
    }

    /// All problems, in the order of the scene; none: the scene can be rendered.
    pub fn check(&self) -> Vec<Problem> {
        let mut problems = Vec::new();
        let mut found = |place: Place, fault: Fault| {
            problems.push(Problem { place, message: fault.0, expected: fault.1 });
        };
        if let Some([width, height]) = self.size
            && (width == 0 || height == 0)
        {
            found(
                Place::Scene("size"),
                fault("the picture has no pixels", "a width and height of at least 1"),
            );
        }
        if !self.background.is_finite() {
            found(
                Place::Scene("background"),
                fault("a channel is not a finite number", "three finite numbers"),
            );
        }
        if self.max_depth > Self::GREATEST_MAX_DEPTH {
            let message = format!("{} bounces are too many", self.max_depth);
            found(Place::Scene("max_depth"), fault(message, "a number from 0 to 1000"));
        }
        check_camera(&self.camera, &mut |field, f| found(Place::Camera(field), f));
        for (i, light) in self.lights.iter().enumerate() {
            check_light(light, &mut |field, f| found(Place::Light(i, field), f));
        }
        for (i, material) in self.materials.iter().enumerate() {
            check_material(material, &mut |field, f| found(Place::Material(i, field), f));
        }
        for (i, object) in self.objects.iter().enumerate() {
            if object.material.0 as usize >= self.materials.len() {
                found(
                    Place::Object(i, "material"),
                    fault("there is no such material", "a material of the scene"),
                );
            }
            check_object(object, &mut |field, f| found(Place::Object(i, field), f));
        }
        problems
    }
}

struct Fault(String, &'static str);
type Found<'a> = &'a mut dyn FnMut(&'static str, Fault);

fn fault(message: impl Into<String>, expected: &'static str) -> Fault {
    Fault(message.into(), expected)
}

fn check_camera(camera: &Camera, found: Found) {
    check_point("eye", camera.eye, found);
    check_point("look_at", camera.look_at, found);
    let forward = camera.look_at - camera.eye;
    match (forward.try_normalize(), camera.up.try_normalize()) {
        (None, _) => found("look_at", fault("the eye looks at itself", "a point other than the eye")),
        (_, None) => found("up", fault("the up direction has no length", "a direction other than 0")),
        (Some(f), Some(u)) if f.cross(u).length() < brt_geometry::SMALLEST_ANGLE => {
            found(
                "up",
                fault("up points along the view", "a direction that is not parallel to look_at - eye"),
            );
        }
        _ => {}
    }
    match camera.projection {
        Projection::Perspective { fov_deg } => {
            if !(fov_deg > 0.0 && fov_deg < 180.0) {
                found(
                    "fov_deg",
                    fault(format!("the field of view is {fov_deg}°"), "an angle above 0 and below 180"),
                );
            }
        }
        Projection::Orthographic { extent } => check_length("extent", extent, found),
    }
}

fn check_light(light: &Light, found: Found) {
    let color = match light {
        Light::Point { position, color } => {
            check_point("position", *position, found);
            color
        }
        Light::Spot { position, direction, color, inner_deg, outer_deg } => {
            check_point("position", *position, found);
            check_direction("direction", *direction, found);
            check_cone(*inner_deg, *outer_deg, found);
            color
        }
        Light::Directional { direction, color } => {
            check_direction("direction", *direction, found);
            color
        }
    };
    if !color.is_finite() || color.r < 0.0 || color.g < 0.0 || color.b < 0.0 {
        found("color", fault("a channel is negative or not finite", "three finite numbers of at least 0"));
    }
}

fn check_cone(inner_deg: f64, outer_deg: f64, found: Found) {
    if !(outer_deg > 0.0 && outer_deg <= 180.0) {
        found("outer_deg", fault(format!("the cone's angle is {outer_deg}°"), "an angle above 0, up to 180"));
    } else if !(inner_deg >= 0.0 && inner_deg < outer_deg) {
        let message = format!("the strength falls from {inner_deg}° on, the cone ends at {outer_deg}°");
        found("inner_deg", fault(message, "an angle from 0, below `outer_deg`"));
    }
}

fn check_object(object: &Object, found: Found) {
    check_shape(&object.shape, found);
    let map = &object.transform;
    let Shape::Mesh(mesh) = &object.shape else {
        if *map != Affine::IDENTITY {
            found("transform", fault("only meshes are transformed", "no `transform`"));
        }
        return;
    };
    if !map.is_finite() {
        found("transform", fault("a number is not finite", FINITE));
    } else if map.determinant() == 0.0 {
        found("transform", fault("the transform leaves nothing of a volume", "three rows that differ"));
    } else if mesh.positions.iter().any(|&p| in_range(p) && !in_range(map.point(p))) {
        found("transform", fault("a transformed coordinate is too large", FINITE));
    } else if let Some(f) = too_small(mesh.positions.iter().map(|&p| map.point(p))) {
        found("positions", f);
    }
}

fn check_shape(shape: &Shape, found: Found) {
    match shape {
        Shape::Sphere { center, radius } => {
            check_point("center", *center, found);
            check_length("radius", *radius, found);
        }
        Shape::Plane { normal, distance } => {
            check_direction("normal", *normal, found);
            if distance.abs() > GREATEST_COORDINATE || !distance.is_finite() {
                found("distance", fault(format!("the distance is {distance}"), FINITE));
            }
        }
        Shape::Polygon { outline, holes } => check_polygon(outline, holes, found),
        Shape::Disc { center, normal, radius } => {
            check_point("center", *center, found);
            check_direction("normal", *normal, found);
            check_length("radius", *radius, found);
        }
        Shape::Cylinder { base, top, radius, .. } => {
            check_axis(*base, *top, found);
            check_length("radius", *radius, found);
        }
        Shape::Cone { base, base_radius, top, top_radius, .. } => {
            check_axis(*base, *top, found);
            for (field, r) in [("base_radius", *base_radius), ("top_radius", *top_radius)] {
                if !(0.0..=GREATEST_COORDINATE).contains(&r) {
                    found(field, fault(format!("the radius is {r}"), "a finite number of at least 0"));
                }
            }
            check_steepness((*top - *base).length(), [*base_radius, *top_radius], found);
            if *base_radius == 0.0 && *top_radius == 0.0 {
                found("base_radius", fault("both radii are 0", "one radius above 0"));
            }
        }
        Shape::Mesh(mesh) => check_mesh(mesh, found),
    }
}

fn check_axis(base: Vec3, top: Vec3, found: Found) {
    check_point("base", base, found);
    check_point("top", top, found);
    if (top - base).try_normalize().is_none() {
        found("top", fault("base and top are the same point", "an axis of some length"));
    } else if let Some(f) = too_small([base, top].into_iter()) {
        found("top", f);
    }
}

/// A cone's radius may change by this many times its height: where rays meet its side rounds by as many times their own
/// rounding.
const STEEPEST_CONE: f64 = 1e6;

fn check_steepness(height: f64, radii: [f64; 2], found: Found) {
    let change = (radii[1] - radii[0]).abs();
    if change > STEEPEST_CONE * height {
        let message = format!("the radius changes by {change:e} over a height of {height:e}");
        found("top", fault(message, "a cone at least a millionth as high as wide, or a disc"));
    }
}

fn check_polygon(outline: &[Vec3], holes: &[Vec<Vec3>], found: Found) {
    for (field, ring) in
        std::iter::once(("outline", outline)).chain(holes.iter().map(|h| ("holes", h.as_slice())))
    {
        if ring.len() < 3 {
            found(field, fault(format!("a loop of {} points", ring.len()), "at least 3 points"));
            return;
        }
        if ring.iter().any(|p| !in_range(*p)) {
            found(field, fault("a coordinate is not finite or too large", FINITE));
            return;
        }
    }
    if let Some(f) = too_small(outline.iter().copied()) {
        found("outline", f);
        return;
    }
    let Some(plane) = polygon_plane(outline) else {
        found("outline", fault("the polygon has no area", "points that are not all on one line"));
        return;
    };
    for (field, ring) in
        std::iter::once(("outline", outline)).chain(holes.iter().map(|h| ("holes", h.as_slice())))
    {
        if let Some(distance) = plane.greatest_distance(ring) {
            let message = format!("a point is {distance:.3} of the polygon's size off its plane");
            found(field, fault(message, "points in one plane"));
        }
    }
}

fn check_point(field: &'static str, p: Vec3, found: Found) {
    if !in_range(p) {
        found(field, fault("a coordinate is not finite or too large", FINITE));
    }
}

fn check_direction(field: &'static str, d: Vec3, found: Found) {
    if d.try_normalize().is_none() || !in_range(d) {
        found(
            field,
            fault("the direction has no length or is not finite", "three finite numbers, not all 0"),
        );
    }
}

fn check_length(field: &'static str, length: f64, found: Found) {
    if !(SMALLEST_LENGTH..=GREATEST_COORDINATE).contains(&length) {
        found(field, fault(format!("`{field}` is {length}"), "a finite number above 0, from 1e-30 to 1e30"));
    }
}

/// What is wrong with points that are not all the same but too near to each other.
fn too_small(points: impl Iterator<Item = Vec3>) -> Option<Fault> {
    let nothing = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    let (lo, hi) = points.fold(nothing, |(lo, hi), p| (lo.min(p), hi.max(p)));
    let size = hi - lo;
    let size = size.x.max(size.y).max(size.z);
    let is_too_small = size > 0.0 && size < SMALLEST_LENGTH;
    is_too_small
        .then(|| fault(format!("the points lie within {size:e} of each other"), "a size of at least 1e-30"))
}

fn in_range(p: Vec3) -> bool {
    [p.x, p.y, p.z].iter().all(|&c| is_in_range(c))
}

fn is_in_range(coordinate: f64) -> bool {
    coordinate.abs() <= GREATEST_COORDINATE
}

const FINITE: &str = "finite numbers up to 1e30";
