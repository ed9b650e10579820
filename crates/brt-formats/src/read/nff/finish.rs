//! From what an NFF file says to a whole scene: what it leaves out is chosen here.

use std::ops::Range;

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::{Camera, Diagnostic, Light, Projection, Scene};

use super::reader::{PlainLight, Reader, View};
use crate::common::Problems;

/// Field of view where the file gives none, in degrees: that of the Standard Procedural Databases.
const FOV_DEG: f64 = 45.0;

/// Places of the scene's parts in the file.
pub(super) struct Places {
    pub(super) size: Option<Range<usize>>,
    pub(super) view: Option<Range<usize>>,
    pub(super) lights: Vec<Range<usize>>,
    pub(super) materials: Vec<Range<usize>>,
    pub(super) objects: Vec<Range<usize>>,
}

/// Completes the scene.
pub(super) fn finish(reader: Reader) -> (Scene, Places, Problems) {
    let Reader { mut problems, view, background, lights, fills, objects, spans, .. } = reader;
    let mut scene = Scene::new(Camera {
        eye: Vec3::ZERO,
        look_at: Vec3::ZERO,
        up: view.up.unwrap_or(vec3(0.0, 1.0, 0.0)),
        projection: Projection::Perspective { fov_deg: view.angle.unwrap_or(FOV_DEG) },
    });
    scene.background = background;
    scene.size = view.size;
    scene.materials = fills.materials;
    scene.objects = objects;
    let (center, radius) = ball_around(&scene);
    match (view.from, view.at) {
        (Some(eye), Some(look_at)) => (scene.camera.eye, scene.camera.look_at) = (eye, look_at),
        _ => frame(&mut scene.camera, center, radius, &view, &mut problems),
    }
    let places = Places {
        size: view.size_span,
        view: view.span,
        lights: lights.iter().map(|light| light.span.clone()).collect(),
        materials: fills.spans,
        objects: spans,
    };
    scene.lights = finish_lights(&lights);
    if scene.lights.is_empty() {
        let message = "the file has no light: one is put beside the eye";
        problems.push(Diagnostic::warning(message, None));
        let position = scene.camera.eye + vec3(radius, radius, radius);
        scene.lights.push(Light::Point { position, color: Rgb::WHITE });
    }
    (scene, places, problems)
}

/// A ball around all objects.
fn ball_around(scene: &Scene) -> (Vec3, f64) {
    let Some([lo, hi]) = scene.bounds() else {
        return (Vec3::ZERO, 1.0);
    };
    let radius = (hi - lo).length() * 0.5;
    (lo + (hi - lo) * 0.5, if radius > 0.0 { radius } else { 1.0 })
}

/// Looks at everything from the front, the right, and above.
fn frame(camera: &mut Camera, center: Vec3, radius: f64, view: &View, problems: &mut Problems) {
    /// Distance of the eye in radii: a ball fills a field of view of 45° from 2.6 radii on.
    const DISTANCE: f64 = 3.0;
    let missing =
        if view.span.is_some() { "the view has no `from` or `at`" } else { "the file has no view `v`" };
    let message = format!("{missing}: everything is shown from the front, the right and above");
    problems.push(Diagnostic::warning(message, view.span.clone()));
    camera.look_at = center;
    camera.eye = center + vec3(0.5, 0.5, 1.0).normalize() * (radius * DISTANCE);
    camera.up = vec3(0.0, 1.0, 0.0);
    camera.projection = Projection::Perspective { fov_deg: FOV_DEG };
}

fn finish_lights(lights: &[PlainLight]) -> Vec<Light> {
    let n = lights.len() as f64;
    let share = n.sqrt() / n;
    let finished = |light: &PlainLight| Light::Point {
        position: light.position,
        color: light.color.unwrap_or(rgb(share, share, share)),
    };
    lights.iter().map(finished).collect()
}
