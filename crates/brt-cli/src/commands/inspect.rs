//! `brt inspect`: what is in a scene, and what was not understood.

use std::collections::BTreeMap;
use std::path::PathBuf;

use brt::{Camera, CheckedScene, Diagnostic, Given, Light, Projection, Renderer, Run, Vec3};
use clap::Args;
use serde::Serialize;

use crate::context::Context;
use crate::exit::{Failure, Outcome};
use crate::scene_input::{self, InputOptions};
use crate::{json, output};

/// Options of `brt inspect`.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Scene file; `-` reads standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Print it as JSON
    #[arg(long)]
    json: bool,
    /// Leave out warnings
    #[arg(short, long)]
    quiet: bool,
    /// Options for reading the scene
    #[command(flatten)]
    reading: InputOptions,
}

/// What files of models lack, so that it is added.
const CAMERA: &str = "camera";
const LIGHTS: &str = "lights";

/// What there is to say about a scene.
#[derive(Debug, Serialize)]
struct Inspection {
    objects: BTreeMap<&'static str, usize>,
    primitives: usize,
    surfaces: usize,
    /// Of all bounded objects.
    bounds: Option<[[f64; 3]; 2]>,
    unbounded: usize,
    /// Not the file's: what `render` adds to see it by.
    added: Vec<&'static str>,
    lights: Vec<LightJson>,
    materials: Vec<String>,
    camera: CameraJson,
    size: Option<[u32; 2]>,
    max_depth: u32,
    background: [f64; 3],
    warnings: Vec<String>,
}

#[derive(Debug, Serialize)]
#[serde(tag = "type", rename_all = "kebab-case")]
enum LightJson {
    Point { position: [f64; 3], color: [f64; 3] },
    Spot { position: [f64; 3], direction: [f64; 3], color: [f64; 3], inner_deg: f64, outer_deg: f64 },
    Directional { direction: [f64; 3], color: [f64; 3] },
}

#[derive(Debug, Serialize)]
struct CameraJson {
    eye: [f64; 3],
    look_at: [f64; 3],
    up: [f64; 3],
    #[serde(flatten)]
    projection: ProjectionJson,
}

#[derive(Debug, Serialize)]
#[serde(tag = "projection", rename_all = "kebab-case")]
enum ProjectionJson {
    Perspective { fov_deg: f64 },
    Orthographic { extent: f64 },
}

/// Shows what is in a scene.
pub(crate) fn run(options: &Options, context: &Context) -> Result<Outcome, Failure> {
    let input = scene_input::read(&options.scene, &options.reading, &context.interrupt)?;
    let run = Run { cancel: Some(context.interrupt.flag()), ..Run::default() };
    let inspection = Inspection::of(&input.scene, &input.given, &input.report.diagnostics, &run)?;
    if options.json {
        output::line(&json::text(&inspection)?)?;
    } else {
        if !options.quiet {
            input.show_warnings();
        }
        output::line(&inspection.text())?;
    }
    Ok(Outcome::Done)
}

impl Inspection {
    fn of(
        scene: &CheckedScene,
        given: &Given,
        diagnostics: &[Diagnostic],
        run: &Run,
    ) -> Result<Self, Failure> {
        // The plainest index: only what lies in it is counted.
        let renderer = Renderer::new(scene.clone());
        let prepared = renderer.prepared(brt::Accelerator::None, run)?;
        let mut objects = BTreeMap::new();
        for object in &scene.objects {
            *objects.entry(object.shape.kind()).or_default() += 1;
        }
        Ok(Self {
            objects,
            primitives: prepared.primitive_count(),
            surfaces: prepared.surfaces().len(),
            bounds: scene.bounds().map(|corners| corners.map(triple)),
            unbounded: scene.objects.iter().filter(|object| object.bounds().is_none()).count(),
            added: [(given.camera, CAMERA), (given.lights, LIGHTS)]
                .into_iter()
                .filter_map(|(is_given, what)| (!is_given).then_some(what))
                .collect(),
            lights: scene.lights.iter().map(LightJson::of).collect(),
            materials: scene.materials.iter().map(|material| material.name.clone()).collect(),
            camera: CameraJson::of(&scene.camera),
            size: scene.size,
            max_depth: scene.max_depth,
            background: scene.background.into(),
            warnings: diagnostics.iter().map(|diagnostic| diagnostic.message.clone()).collect(),
        })
    }

    fn text(&self) -> String {
        let kinds: Vec<String> = self.objects.iter().map(|(kind, count)| format!("{count} {kind}")).collect();
        let bounds = match self.bounds {
            Some([lo, hi]) => format!("{} to {}", spaced(lo), spaced(hi)),
            None => "none".to_owned(),
        };
        let size = self.size.map_or("none".to_owned(), |[width, height]| format!("{width}×{height}"));
        let mut lines = vec![
            format!("objects     {}", if kinds.is_empty() { "none".to_owned() } else { kinds.join(", ") }),
            format!("primitives  {}", self.primitives),
            format!("surfaces    {}", self.surfaces),
            format!("bounds      {bounds}{}", unbounded_note(self.unbounded)),
            format!("lights      {}{}", self.lights.len(), self.added_note(LIGHTS)),
        ];
        lines.extend(self.lights.iter().map(|light| format!("            {}", light.text())));
        lines.extend([
            format!("materials   {}: {}", self.materials.len(), shortened(&self.materials)),
            format!("camera      {}{}", self.camera.text(), self.added_note(CAMERA)),
            format!("size        {size}"),
            format!("max depth   {}", self.max_depth),
            format!("background  {}", spaced(self.background)),
            format!("warnings    {}", self.warnings.len()),
        ]);
        lines.join("\n")
    }

    fn added_note(&self, what: &str) -> &'static str {
        if self.added.contains(&what) { " (not from the file)" } else { "" }
    }
}

impl LightJson {
    fn of(light: &Light) -> Self {
        match light {
            Light::Point { position, color } => {
                Self::Point { position: triple(*position), color: (*color).into() }
            }
            Light::Spot { position, direction, color, inner_deg, outer_deg } => Self::Spot {
                position: triple(*position),
                direction: triple(*direction),
                color: (*color).into(),
                inner_deg: *inner_deg,
                outer_deg: *outer_deg,
            },
            Light::Directional { direction, color } => {
                Self::Directional { direction: triple(*direction), color: (*color).into() }
            }
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Point { position, color } => {
                format!("point at {}, color {}", spaced(*position), spaced(*color))
            }
            Self::Spot { position, direction, color, outer_deg, .. } => format!(
                "spot at {}, direction {}, color {}, up to {}°",
                spaced(*position),
                spaced(*direction),
                spaced(*color),
                short(*outer_deg)
            ),
            Self::Directional { direction, color } => {
                format!("directional along {}, color {}", spaced(*direction), spaced(*color))
            }
        }
    }
}

impl CameraJson {
    fn of(camera: &Camera) -> Self {
        Self {
            eye: triple(camera.eye),
            look_at: triple(camera.look_at),
            up: triple(camera.up),
            projection: match camera.projection {
                Projection::Perspective { fov_deg } => ProjectionJson::Perspective { fov_deg },
                Projection::Orthographic { extent } => ProjectionJson::Orthographic { extent },
            },
        }
    }

    fn text(&self) -> String {
        let projection = match self.projection {
            ProjectionJson::Perspective { fov_deg } => {
                format!("perspective, {}°", short(fov_deg))
            }
            ProjectionJson::Orthographic { extent } => format!("orthographic, extent {}", short(extent)),
        };
        format!("at {} towards {}, {projection}", spaced(self.eye), spaced(self.look_at))
    }
}

fn unbounded_note(count: usize) -> String {
    if count == 0 { String::new() } else { format!(", and {count} without bounds") }
}

/// The first few of many names.
fn shortened(names: &[String]) -> String {
    const MOST: usize = 8;
    let shown = names.iter().take(MOST).map(String::as_str).collect::<Vec<_>>().join(", ");
    if names.len() > MOST { format!("{shown}, …") } else { shown }
}

fn triple(v: Vec3) -> [f64; 3] {
    [v.x, v.y, v.z]
}

fn spaced([x, y, z]: [f64; 3]) -> String {
    let [x, y, z] = [x, y, z].map(short);
    format!("({x}, {y}, {z})")
}

/// As many digits as people read; slopes and angles come back as 29.999999999999996.
fn short(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
}
