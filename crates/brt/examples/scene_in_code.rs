//! A scene made in code, to a PNG: `cargo run --release -p brt --example scene_in_code`.

use std::error::Error;
use std::path::Path;

use brt::{
    Camera, CertifiedSettings, Light, Material, Method, Output, Projection, Rgb, Run, Samples, Scene,
    Settings, Shape, render_to_files, rgb, vec3,
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut scene = Scene::new(Camera {
        eye: vec3(0.0, 2.5, 8.0),
        look_at: vec3(0.0, 0.8, 0.0),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 40.0 },
    });
    scene.background = rgb(0.6, 0.75, 0.9);
    scene.lights.push(Light::Point { position: vec3(4.0, 6.0, 5.0), color: Rgb::WHITE });
    let floor = scene.add_material(Material::matte("floor", rgb(0.7, 0.7, 0.7)));
    let mirror = Material { reflection: 0.7, diffuse: 0.2, ..Material::matte("mirror", rgb(0.9, 0.9, 0.9)) };
    let mirror = scene.add_material(mirror);
    let clay = scene.add_material(Material::matte("clay", rgb(0.9, 0.35, 0.2)));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    scene.add(Shape::Sphere { center: vec3(-1.2, 1.0, 0.0), radius: 1.0 }, mirror);
    let (base, top) = (vec3(1.3, 0.0, 0.5), vec3(1.3, 1.6, 0.5));
    scene.add(Shape::Cylinder { base, top, radius: 0.6, capped: true }, clay);

    // Only a scene that was checked can be rendered; what is wrong with it is told all at once.
    let scene = scene.checked().map_err(|problems| problems[0].clone())?;
    let method = Method::Certified(CertifiedSettings::default());
    let settings = Settings { method, samples: Samples::Sixteen, ..Settings::new([800, 600]) };
    let output = Output::to_file(Path::new("scene_in_code.png"))?;
    render_to_files(&scene, &settings, &Run::default(), &output)?;
    Ok(())
}
