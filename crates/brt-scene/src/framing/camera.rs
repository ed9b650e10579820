//! The camera that has everything in its picture.

use brt_geometry::Vec3;

use super::Framing;
use super::support::Reach;
use crate::{Camera, Projection, Scene};

/// Field of view across the shorter side, degrees: narrow enough for parts to look like parts.
const FOV_DEG: f64 = 30.0;

/// Share of the picture's half side that is used; the rest is margin.
const USED: f64 = 0.92;

/// The camera for a scene. Unbounded objects do not count; a scene without bounded ones is seen as if it were a point.
pub fn framed_camera(scene: &Scene, framing: &Framing) -> Camera {
    let axes = framing.view.axes(framing.up);
    let reach = &Reach::of(scene);
    let shorter = f64::from(framing.size[0].min(framing.size[1]).max(1));
    let sides = framing.size.map(|side| f64::from(side.max(1)) / shorter);
    if framing.parallel {
        parallel(reach, axes, sides, framing)
    } else {
        perspective(reach, axes, sides, framing)
    }
}

/// Each of the picture's four edges is a plane through the eye that no point may be beyond, for which only the
/// scene's reach in one direction counts: so the smallest distance is exact.
fn perspective(reach: &Reach, [right, up, towards]: [Vec3; 3], sides: [f64; 2], framing: &Framing) -> Camera {
    let slope = libm::tan(0.5 * FOV_DEG.to_radians());
    let along = |direction: Vec3| reach.along(direction).unwrap_or(0.0);
    let fit = |axis: Vec3, side: f64| {
        let slope = slope * side * USED;
        let plus = along(axis + towards * slope);
        let minus = along(towards * slope - axis);
        (0.5 * (plus - minus), (plus + minus) / (2.0 * slope))
    };
    let [(x, depth_x), (y, depth_y)] = [fit(right, sides[0]), fit(up, sides[1])];
    let [near, far] = [along(towards), -along(-towards)];
    // A scene without extent is seen from some distance all the same.
    let depth = depth_x.max(depth_y).max(near + reach.smallest_distance());
    let eye = right * x + up * y + towards * depth;
    let look_at = eye - towards * (depth - 0.5 * (near + far));
    let [eye, look_at] = [eye, look_at].map(|p| reach.origin + p);
    let fov_deg = 2.0 * libm::atan(slope / framing.zoom).to_degrees();
    Camera { eye, look_at, up, projection: Projection::Perspective { fov_deg } }
}

fn parallel(reach: &Reach, [right, up, towards]: [Vec3; 3], sides: [f64; 2], framing: &Framing) -> Camera {
    let along = |direction: Vec3| reach.along(direction).unwrap_or(0.0);
    let extent = |axis: Vec3| [-along(-axis), along(axis)];
    let [width, height, depth] = [extent(right), extent(up), extent(towards)];
    let center = |[lo, hi]: [f64; 2]| 0.5 * (lo + hi);
    let length = |[lo, hi]: [f64; 2]| hi - lo;
    let widest = (length(width) / sides[0]).max(length(height) / sides[1]).max(reach.smallest_distance());
    let look_at = right * center(width) + up * center(height) + towards * center(depth);
    // Rays start on the eye's plane: before everything.
    let eye = look_at + towards * (0.5 * length(depth) + widest);
    let [eye, look_at] = [eye, look_at].map(|p| reach.origin + p);
    let extent = widest / (USED * framing.zoom);
    Camera { eye, look_at, up, projection: Projection::Orthographic { extent } }
}

#[cfg(test)]
mod tests {
    use brt_geometry::vec3;
    use brt_image::Rgb;

    use super::*;
    use crate::framing::{Up, View};
    use crate::{Material, Shape};

    /// Where a point is in the picture; the picture's shorter side reaches from −1 to 1.
    fn projected(camera: &Camera, p: Vec3) -> [f64; 2] {
        let forward = (camera.look_at - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let (up, way) = (right.cross(forward), p - camera.eye);
        let half = match camera.projection {
            Projection::Perspective { fov_deg } => way.dot(forward) * libm::tan(0.5 * fov_deg.to_radians()),
            Projection::Orthographic { extent } => 0.5 * extent,
        };
        [way.dot(right) / half, way.dot(up) / half]
    }

    fn bar() -> Scene {
        let mut scene = Scene::new(framed_camera(&empty(), &Framing::new(Up::PlusY)));
        let id = scene.add_material(Material::matte("m", Rgb::WHITE));
        for x in [100.0, 110.0] {
            scene.add(Shape::Sphere { center: vec3(x, -5.0, 3.0), radius: 1.0 }, id);
        }
        scene
    }

    fn empty() -> Scene {
        Scene::new(Camera {
            eye: Vec3::ZERO,
            look_at: vec3(0.0, 0.0, -1.0),
            up: vec3(0.0, 1.0, 0.0),
            projection: Projection::Perspective { fov_deg: 45.0 },
        })
    }

    #[test]
    fn everything_is_in_the_picture_and_touches_its_margin() {
        for (_, view) in View::NAMED {
            for (_, up) in Up::ALL {
                for parallel in [false, true] {
                    let framing = Framing { view, parallel, size: [200, 100], ..Framing::new(up) };
                    let mut scene = bar();
                    scene.camera = framed_camera(&scene, &framing);
                    assert_eq!(scene.check(), []);
                    let mut greatest: f64 = 0.0;
                    // Points of the balls' hull, by directions of a fine grid.
                    for i in 0..40 * 80 {
                        let (a, b) = (f64::from(i % 40) * 0.08, f64::from(i / 40) * 0.08);
                        let n = vec3(libm::sin(a) * libm::cos(b), libm::sin(a) * libm::sin(b), libm::cos(a));
                        for x in [100.0, 110.0] {
                            let [px, py] = projected(&scene.camera, vec3(x, -5.0, 3.0) + n);
                            greatest = greatest.max((px / 2.0).abs()).max(py.abs());
                        }
                    }
                    assert!((0.9..=0.921).contains(&greatest), "{view:?} {up:?} {parallel}: {greatest}");
                }
            }
        }
    }

    #[test]
    fn zoom_enlarges_around_the_middle() {
        let scene = bar();
        let [a, b] =
            [1.0, 2.0].map(|zoom| framed_camera(&scene, &Framing { zoom, ..Framing::new(Up::PlusZ) }));
        let p = vec3(110.0, -5.0, 3.0);
        assert!((projected(&b, p)[0] - 2.0 * projected(&a, p)[0]).abs() < 1e-9);
    }

    /// Maps and sites have coordinates millions of times as large as what stands there.
    #[test]
    fn a_scene_is_framed_alike_wherever_it_stands() {
        for distance in [1e3, 1e5, 1e7, 1e10] {
            let offset = vec3(distance, -2.0 * distance, 0.5 * distance);
            for (view, parallel) in [(View::Iso, false), (View::Front, true), (View::Top, false)] {
                let framing = Framing { view, parallel, size: [200, 100], ..Framing::new(Up::PlusZ) };
                let [here, there] =
                    [Vec3::ZERO, offset].map(|offset| framed_camera(&moved_bar(offset), &framing));
                let close = |p: Vec3, q: Vec3| (p + offset - q).length() <= 4.0 * f64::EPSILON * distance;
                assert!(close(here.eye, there.eye), "{distance}: {here:?} {there:?}");
                assert!(close(here.look_at, there.look_at), "{distance}: {here:?} {there:?}");
            }
        }
    }

    /// Two balls, and a mesh with a space of its own.
    fn moved_bar(offset: Vec3) -> Scene {
        let mut scene = empty();
        let id = scene.add_material(Material::matte("m", Rgb::WHITE));
        for x in [1.0, 3.0] {
            scene.add(Shape::Sphere { center: vec3(x, 0.5, 0.0) + offset, radius: 1.0 }, id);
        }
        let positions = [vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, 4.0)].map(|p| p + offset);
        let mesh =
            crate::Mesh { positions: positions.into(), triangles: vec![[0, 1, 2]], ..crate::Mesh::default() };
        let mut object = crate::Object::new(mesh.into(), id);
        object.transform.offset = vec3(0.25, 0.0, 0.0);
        scene.objects.push(object);
        scene
    }

    #[test]
    fn nothing_and_a_point_have_a_camera_too() {
        let mut scene = empty();
        scene.camera = framed_camera(&scene, &Framing::new(Up::PlusY));
        assert_eq!(scene.check(), []);
        let id = scene.add_material(Material::matte("m", Rgb::WHITE));
        let p = vec3(1e6, 2e6, 3e6);
        let mesh =
            crate::Mesh { positions: vec![p, p, p], triangles: vec![[0, 1, 2]], ..crate::Mesh::default() };
        scene.add(mesh.into(), id);
        for parallel in [false, true] {
            scene.camera = framed_camera(&scene, &Framing { parallel, ..Framing::new(Up::PlusY) });
            assert_eq!(scene.check(), []);
        }
    }
}
