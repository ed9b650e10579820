//! Tools that turn outlines into solids of the scene.

use core::f64::consts::TAU;

use brt_geometry::{Vec3, vec3};
use brt_scene::{MaterialId, Mesh, Scene, Shape};

use super::metals::Metals;
use super::outline::{Outline, direction};

/// The scene under construction.
pub(super) struct Workshop {
    pub(super) scene: Scene,
    pub(super) metals: Metals,
    /// Segments of a full turn.
    pub(super) segments: u32,
}

/// From one height to a greater one.
pub(super) type Heights = [f64; 2];

impl Workshop {
    /// A plate cut from an outline with holes; where the bevel is not 0, its upper borders are cut at 45°.
    pub(super) fn cut(
        &mut self,
        body: MaterialId,
        outline: &Outline,
        holes: &[Outline],
        z: Heights,
        bevel: f64,
    ) {
        self.cut_open(body, outline, holes, z, bevel);
        let inner: Vec<_> = holes.iter().map(|hole| hole.as_hole().inset(bevel).at_height(z[1])).collect();
        self.scene.add(Shape::Polygon { outline: outline.inset(bevel).at_height(z[1]), holes: inner }, body);
    }

    /// The same without the upper face.
    pub(super) fn cut_open(
        &mut self,
        body: MaterialId,
        outline: &Outline,
        holes: &[Outline],
        z: Heights,
        bevel: f64,
    ) {
        let [low, high] = z;
        let holes: Vec<Outline> = holes.iter().map(Outline::as_hole).collect();
        for curve in std::iter::once(outline).chain(&holes) {
            self.scene.add(wall(curve, low, curve, high - bevel), body);
            if bevel > 0.0 {
                self.scene.add(wall(curve, high - bevel, &curve.inset(bevel), high), self.metals.edge);
            }
        }
        let holes = holes.iter().map(|hole| hole.at_height(low)).collect();
        self.scene.add(Shape::Polygon { outline: outline.at_height(low), holes }, body);
    }

    /// A convex face divided into stripes at right angles to `across`, of two materials in turn.
    pub(super) fn stripes(&mut self, bodies: [MaterialId; 2], face: &[Vec3], across: Vec3, width: f64) {
        let reach = |p: &Vec3| p.dot(across);
        let first = face.iter().map(reach).fold(f64::INFINITY, f64::min);
        let last = face.iter().map(reach).fold(f64::NEG_INFINITY, f64::max);
        let count = libm::ceil((last - first) / width) as u32;
        for i in 0..count {
            let from = first + width * f64::from(i);
            let beyond = clip(face, across, from);
            let outline = clip(&beyond, -across, -(from + width));
            self.scene.add(Shape::Polygon { outline, holes: Vec::new() }, bodies[i as usize % 2]);
        }
    }

    /// A prism with flat sides over a counter-clockwise outline (z = 0) with clockwise holes.
    pub(super) fn prism(
        &mut self,
        body: MaterialId,
        outline: &[Vec3],
        holes: &[Vec<Vec3>],
        [low, high]: Heights,
    ) {
        let (down, up) = (vec3(0.0, 0.0, low), vec3(0.0, 0.0, high));
        let lift = |points: &[Vec3], by: Vec3| points.iter().map(|&p| p + by).collect::<Vec<_>>();
        for height in [up, down] {
            let holes = holes.iter().map(|hole| lift(hole, height)).collect();
            self.scene.add(Shape::Polygon { outline: lift(outline, height), holes }, body);
        }
        for points in std::iter::once(outline).chain(holes.iter().map(Vec::as_slice)) {
            for (i, &a) in points.iter().enumerate() {
                let b = points[(i + 1) % points.len()];
                let outline = vec![a + down, b + down, b + up, a + up];
                self.scene.add(Shape::Polygon { outline, holes: Vec::new() }, body);
            }
        }
    }

    /// An upright round body that narrows at its upper border; closed above, open below.
    pub(super) fn stud(&mut self, body: MaterialId, center: Vec3, radius: f64, z: Heights, bevel: f64) {
        let at = |height: f64| vec3(center.x, center.y, height);
        let [low, high] = z;
        let shoulder = at(high - bevel);
        self.scene.add(Shape::Cylinder { base: at(low), top: shoulder, radius, capped: false }, body);
        if bevel > 0.0 {
            let cone = Shape::Cone {
                base: shoulder,
                base_radius: radius,
                top: at(high),
                top_radius: radius - bevel,
                capped: false,
            };
            self.scene.add(cone, body);
        }
        let top = Shape::Disc { center: at(high), normal: vec3(0.0, 0.0, 1.0), radius: radius - bevel };
        self.scene.add(top, body);
    }

    /// A smooth tube of constant thickness along a curve given by points and unit tangents.
    pub(super) fn tube(&mut self, body: MaterialId, path: &[(Vec3, Vec3)], radius: f64) {
        let around = (self.segments / 16).max(6);
        let mut mesh = Mesh::default();
        for &(center, along) in path {
            let up = vec3(0.0, 0.0, 1.0);
            let side = along.cross(up).normalize();
            let rise = side.cross(along);
            for i in 0..around {
                let turn = direction(TAU * f64::from(i) / f64::from(around));
                let out = side * turn.x + rise * turn.y;
                mesh.positions.push(center + out * radius);
                mesh.normals.push(out);
            }
        }
        for i in 1..path.len() as u32 {
            for j in 0..around {
                let next = (j + 1) % around;
                let [a, b] = [j, next].map(|j| (i - 1) * around + j);
                let [d, c] = [j, next].map(|j| i * around + j);
                mesh.triangles.extend([[a, d, c], [a, c, b]]);
            }
        }
        self.scene.add(Shape::from(mesh), body);
        for &(center, _) in [path.first(), path.last()].into_iter().flatten() {
            self.scene.add(Shape::Sphere { center, radius }, body);
        }
    }
}

/// The smooth side between two curves of as many points, the lower one first.
fn wall(lower: &Outline, low: f64, upper: &Outline, high: f64) -> Shape {
    let mut mesh = Mesh::default();
    let n = lower.0.len() as u32;
    for (below, above) in lower.0.iter().zip(&upper.0) {
        let (a, b) = (below.at + vec3(0.0, 0.0, low), above.at + vec3(0.0, 0.0, high));
        // Normal to the step from curve to curve, in the plane of `out` and z.
        let step = b - a;
        let normal = (below.out * step.z - vec3(0.0, 0.0, step.dot(below.out))).normalize();
        mesh.positions.extend([a, b]);
        mesh.normals.extend([normal, normal]);
    }
    for i in 0..n {
        let next = (i + 1) % n;
        let [a, b, c, d] = [2 * i, 2 * next, 2 * next + 1, 2 * i + 1];
        mesh.triangles.extend([[a, b, c], [a, c, d]]);
    }
    mesh.into()
}

/// The part of a convex face where `p·across` is at least `from`.
fn clip(face: &[Vec3], across: Vec3, from: f64) -> Vec<Vec3> {
    let mut kept = Vec::new();
    for (i, &a) in face.iter().enumerate() {
        let b = face[(i + 1) % face.len()];
        let (da, db) = (a.dot(across) - from, b.dot(across) - from);
        if da >= 0.0 {
            kept.push(a);
        }
        if (da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0) {
            kept.push(a + (b - a) * (da / (da - db)));
        }
    }
    kept
}
