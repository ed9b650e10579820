//! The known flaw of every method that judges by brightness and history alone.
//!
//! Asserted as present: the day that `border` keeps the highlight, this test asks to be rewritten.

use brt_geometry::vec3;
use brt_image::{Rgb, rgb};
use brt_render::{BorderSettings, CheckedPixels, Layer, Method, Run, SampleState, Settings};
use brt_scene::{Light, Material, Scene, Shape};
use brt_testkit::{looking, render_with_layers};

const SIDE: u32 = 9;
const MIDDLE: u32 = 4;

/// A very small ball in the middle of the only block, lit from the eye: bright in its middle, evenly dark around.
fn small_shiny_ball() -> Scene {
    let mut scene = Scene::new(looking([0.0, 0.0, 9.0], [0.0, 0.0, 0.0], 45.0));
    scene.background = rgb(0.1, 0.1, 0.15);
    let material = Material {
        ambient: 0.2,
        diffuse: 0.0,
        specular: 0.8,
        exponent: 60.0,
        ..Material::matte("shiny", Rgb::WHITE)
    };
    let material = scene.add_material(material);
    scene.add(Shape::Sphere { center: vec3(0.0, 0.0, 0.0), radius: 2.5 }, material);
    scene.lights.push(Light::Point { position: vec3(0.0, 0.0, 9.0), color: Rgb::WHITE });
    scene
}

/// Paper: P17. "Four rays hit one very small ball, happen to be equally bright, histories agree, and the highlight
/// between them is lost."
#[test]
fn border_loses_the_highlight_between_four_equal_points() {
    let scene = small_shiny_ball();
    let settings = Settings {
        method: Method::Border(BorderSettings::default()),
        layers: vec![Layer::Surface, Layer::State],
        checked: CheckedPixels::All,
        ..Settings::new([SIDE, SIDE])
    };
    let picture = render_with_layers(&scene, &settings, &Run::default());
    let middle = picture.index(MIDDLE, MIDDLE);
    assert_eq!(picture.surface[middle], 0, "the ball is in the middle");
    assert_ne!(picture.surface[picture.index(0, 0)], 0, "and fits into the block");
    // Specular 0.8 on ambient 0.2.
    assert!(picture.full[middle][0] > 0.95, "full shows it: {:?}", picture.full[middle]);
    assert_eq!(picture.state[middle], SampleState::Filled);
    assert!(picture.colors[middle][0] < 0.25, "border lost it: {:?}", picture.colors[middle]);
    // The ball itself is not lost: it is seen in the perspective image. Paper: P4 (1).
    assert!(picture.colors[middle][0] > 0.15);
}
