//! What is promised of a picture holds for the values that its file has, whatever its transfer function.

use brt::{
    Camera, CertifiedSettings, CheckedPixels, Light, Material, Method, Output, Projection, Run, Scene,
    Settings, Shape, Transfer, rgb, vec3,
};

/// A matte ball in light so strong that most of it is brighter than white, where the sRGB curve is flat.
fn glaring_ball() -> Scene {
    let mut scene = Scene::new(Camera {
        eye: vec3(0.0, 0.0, 6.0),
        look_at: vec3(0.0, 0.0, 0.0),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 30.0 },
    });
    scene.lights.push(Light::Point { position: vec3(-3.0, 4.0, 6.0), color: rgb(30.0, 30.0, 30.0) });
    let chalk = scene.add_material(Material::matte("chalk", rgb(1.0, 1.0, 1.0)));
    scene.add(Shape::Sphere { center: vec3(0.0, 0.0, 0.0), radius: 1.0 }, chalk);
    scene
}

/// The greatest error against full ray tracing of the picture in a file of this name, in levels.
fn greatest_error(file: &str, transfer: Transfer, tolerance: f64) -> f64 {
    let folder = tempfile::tempdir().unwrap();
    let mut output = Output::to_file(&folder.path().join(file)).unwrap();
    output.encoding.transfer = transfer;
    let method = Method::Certified(CertifiedSettings { tolerance });
    let settings = Settings { method, checked: CheckedPixels::All, ..Settings::new([256, 256]) };
    let rendered =
        brt::render_to_files(&glaring_ball().checked().unwrap(), &settings, &Run::default(), &output)
            .unwrap();
    assert!(rendered.stats.pixels.filled > 0, "nothing was filled, so nothing is tested");
    rendered.verification.unwrap().comparison.max_error
}

#[test]
fn a_certified_picture_keeps_its_promise_in_every_format() {
    for (file, transfer) in [
        ("a.exr", Transfer::Srgb),
        ("a.exr", Transfer::Linear),
        ("a.png", Transfer::Linear),
        ("a.png", Transfer::Srgb),
    ] {
        for tolerance in [1.0, 4.0, 16.0] {
            let error = greatest_error(file, transfer, tolerance);
            assert!(error <= tolerance, "{file}, {transfer:?}: {error} levels, promised {tolerance}");
        }
    }
}
