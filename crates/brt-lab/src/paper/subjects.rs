//! The scenes of the experiments.

use brt::{Camera, Light, Material, Projection, Rgb, Scene, Shape, library, rgb, vec3};

use super::{Options, PaperError};

/// A scene and what it is called.
#[derive(Clone, Debug)]
pub(crate) struct Subject {
    /// In tables and legends.
    pub(crate) name: String,
    /// What it shows.
    pub(crate) title: &'static str,
    pub(crate) scene: Scene,
}

/// All of them.
#[derive(Clone, Debug)]
pub(crate) struct Subjects {
    /// A, B and C, or the user's own.
    pub(crate) main: Vec<Subject>,
    /// Are they the paper's?
    pub(crate) are_papers: bool,
    /// Matte planar faces.
    pub(crate) blocks: Subject,
    /// One smooth mesh.
    pub(crate) torus: Subject,
    /// What probing overlooks.
    pub(crate) adversary: Subject,
}

impl Subjects {
    pub(crate) fn new(options: &Options) -> Result<Self, PaperError> {
        let main = match &options.scene {
            Some((name, scene)) => {
                vec![Subject { name: plain(name), title: "your scene", scene: scene.clone() }]
            }
            None => vec![
                named("A", "two mirror planes, a mirror ball, a matte ball", "seed-a", None)?,
                named("B", "49 mirror balls on a matte plane", "seed-b", None)?,
                named("C", "71 polygons, 57 of them mirrors", "seed-c", None)?,
            ],
        };
        // A small mesh does in a quick look.
        let triangles = if options.quick { 5_000 } else { 100_000 };
        Ok(Self {
            main,
            are_papers: options.scene.is_none(),
            blocks: named("blocks", "333 matte boxes: 1999 planar faces", "blocks", None)?,
            torus: named("torus", "a smooth mesh, one surface", "torus", Some(triangles))?,
            adversary: named("adversary", "tiny shiny balls and hidden things", "adversary", None)?,
        })
    }

    pub(crate) fn names(&self) -> Vec<String> {
        self.main.iter().map(|s| s.name.clone()).collect()
    }

    /// The scene of this name among the main ones, or the last of them where the user brought an own one.
    pub(crate) fn papers(&self, name: &str) -> &Subject {
        let last = self.main.len() - 1;
        self.main.iter().find(|s| s.name == name).unwrap_or(&self.main[last])
    }

    /// The main scenes and `blocks`.
    pub(crate) fn with_blocks(&self) -> impl Iterator<Item = &Subject> {
        self.main.iter().chain([&self.blocks])
    }
}

/// A name that can stand in tables and pages as it is, and is none of ours.
fn plain(name: &str) -> String {
    let letter = |c: char| if c.is_alphanumeric() || " -_.".contains(c) { c } else { '_' };
    let plain: String = name.chars().map(letter).collect();
    if ["blocks", "torus", "adversary"].contains(&plain.as_str()) { plain + "-own" } else { plain }
}

fn named(name: &str, title: &'static str, scene: &str, size: Option<u32>) -> Result<Subject, PaperError> {
    let unknown = || PaperError::Scene(format!("there is no scene `{scene}`"));
    let built = library::find(scene).ok_or_else(unknown)?.build(size);
    let scene = built.map_err(|error| PaperError::Scene(error.to_string()))?;
    Ok(Subject { name: name.to_owned(), title, scene })
}

/// Balls a few pixels wide over a dull background, seen along parallel rays and lit from the viewer. Paper: P17.
///
/// Pixels are scene units when the picture is [`SMALL_BALLS_SIDE`] pixels wide. Each ball sits in the middle of a block
/// of 8 samples; columns grow, rows shift the centre by quarters of a pixel.
pub(crate) fn small_balls() -> (Scene, Vec<SmallBall>) {
    let half = f64::from(SMALL_BALLS_SIDE) / 2.0;
    let mut scene = Scene::new(Camera {
        eye: vec3(0.0, 0.0, 100.0),
        look_at: vec3(0.0, 0.0, 0.0),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Orthographic { extent: 2.0 * half },
    });
    scene.background = rgb(0.03, 0.04, 0.09);
    scene.lights.push(Light::Directional { direction: vec3(0.0, 0.0, -1.0), color: Rgb::WHITE });
    let shiny = Material {
        ambient: 0.25,
        diffuse: 0.0,
        specular: 0.75,
        exponent: 24.0,
        ..Material::matte("shiny", rgb(0.5, 0.62, 0.9))
    };
    let shiny = scene.add_material(shiny);
    let mut balls = Vec::new();
    for row in 0..BALLS_ALONG {
        for column in 0..BALLS_ALONG {
            let (x, y) = (f64::from(16 * column + 4), f64::from(16 * row + 4));
            let shift = 0.25 * f64::from(row);
            let radius = 1.5 + 0.75 * f64::from(column);
            let center = vec3(x + 0.5 + shift - half, half - (y + 0.5), 0.0);
            scene.add(Shape::Sphere { center, radius }, shiny);
            balls.push(SmallBall { radius, shift });
        }
    }
    (scene, balls)
}

/// Side of the picture of [`small_balls`] in pixels.
pub(crate) const SMALL_BALLS_SIDE: u32 = 64;
/// Balls in a row.
const BALLS_ALONG: u32 = 4;

/// One of the small balls; the position in the list is its surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SmallBall {
    /// In pixels.
    pub(crate) radius: f64,
    /// Of its centre from a sample, in pixels.
    pub(crate) shift: f64,
}

/// `count` balls in a square over a matte floor under one light; with or without shadows. Paper: P10.
pub(crate) fn counted_balls(count: u32, has_shadows: bool) -> Scene {
    let side = f64::from(count).sqrt().ceil() as u32;
    let across = f64::from(side.max(1));
    let mut scene = Scene::new(Camera {
        eye: vec3(0.0, 1.1 * across + 1.0, 1.2 * across + 1.0),
        look_at: vec3(0.0, 0.0, 0.1 * across),
        up: vec3(0.0, 1.0, 0.0),
        projection: Projection::Perspective { fov_deg: 42.0 },
    });
    scene.background = rgb(0.2, 0.3, 0.5);
    if has_shadows {
        let position = vec3(-0.8 * across, 2.5 * across, 0.7 * across);
        scene.lights.push(Light::Point { position, color: Rgb::WHITE });
    }
    let floor = scene.add_material(Material::matte("floor", rgb(0.7, 0.7, 0.65)));
    let ball = scene.add_material(Material::matte("ball", rgb(0.8, 0.4, 0.25)));
    scene.add(Shape::Plane { normal: vec3(0.0, 1.0, 0.0), distance: 0.0 }, floor);
    for i in 0..count {
        let place = |k: u32| f64::from(k) + 0.5 - 0.5 * across;
        let center = vec3(place(i % side), 0.4, place(i / side));
        scene.add(Shape::Sphere { center, radius: 0.4 }, ball);
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_own_scenes_need_no_escaping() {
        assert_eq!(plain("a <b>, 2.1"), "a _b__ 2.1");
        assert_eq!(plain("blocks"), "blocks-own");
    }

    #[test]
    fn built_scenes_are_fit_to_be_rendered() {
        let (balls, list) = small_balls();
        assert_eq!((balls.check().len(), balls.objects.len()), (0, list.len()));
        for count in [1, 5, 64] {
            let scene = counted_balls(count, true);
            assert_eq!((scene.check().len(), scene.objects.len()), (0, count as usize + 1));
        }
    }
}
