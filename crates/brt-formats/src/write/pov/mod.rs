//! Writes the scene description language of POV-Ray 3.7, so that its picture is ours.
//!
//! POV-Ray is told to work as we do: linear values (`assumed_gamma 1`), mirrors followed however little they show
//! (`adc_bailout 0`), and as deep (`max_trace_level` counts the camera ray). Coordinates stay as they are: the
//! camera's three axes are written out, which makes it right-handed.

mod material;
mod shape;

use std::fmt::{self, Write as _};

use brt_geometry::Vec3;
use brt_image::Rgb;
use brt_scene::{Light, Scene};

use crate::write::losses::Losses;
use crate::write::numerals::{joined, number};
use crate::write::view::View;
use crate::write::{Written, alone};

/// POV-Ray 3.7 goes no deeper.
const DEEPEST: u32 = 256;
/// POV-Ray's own limit on distances is 1e7.
const FARTHEST_LIGHT: f64 = 1e6;

/// The scene as POV-Ray reads it.
pub(crate) fn write(scene: &Scene) -> Written {
    let mut out = Writer::default();
    out.settings(scene);
    out.camera(&View::of(scene));
    for light in &scene.lights {
        out.light(light, scene);
    }
    for (index, material) in scene.materials.iter().enumerate() {
        out.material(index, material);
    }
    for object in &scene.objects {
        out.object(object, scene);
    }
    alone(out.text, out.losses.into_report())
}

/// The text under construction.
#[derive(Default)]
struct Writer {
    text: String,
    losses: Losses,
}

impl Writer {
    fn line(&mut self, line: fmt::Arguments) {
        // Writing to a text cannot fail.
        let _ = self.text.write_fmt(line);
        self.text.push('\n');
    }

    fn settings(&mut self, scene: &Scene) {
        let [width, height] = View::of(scene).size;
        self.line(format_args!(
            "// povray -D -A +W{width} +H{height} -UA File_Gamma=1.0 +I<this file> renders it with linear values."
        ));
        self.line(format_args!("#version 3.7;"));
        if scene.max_depth >= DEEPEST {
            self.losses.note("POV-Ray follows at most 255 bounces");
        }
        let level = scene.max_depth.min(DEEPEST - 1) + 1;
        self.line(format_args!(
            "global_settings {{ assumed_gamma 1 adc_bailout 0 max_trace_level {level} ambient_light rgb 1 }}"
        ));
        self.line(format_args!("background {{ color rgb {} }}", color(scene.background)));
    }

    fn camera(&mut self, view: &View) {
        let kind = if view.is_perspective { "perspective" } else { "orthographic" };
        let [right, up] = [view.right * (2.0 * view.half_extent[0]), view.up * (2.0 * view.half_extent[1])];
        self.line(format_args!(
            "camera {{ {kind} location {} direction {} right {} up {} }}",
            vector(view.eye),
            vector(view.forward),
            vector(right),
            vector(up),
        ));
    }

    fn light(&mut self, light: &Light, scene: &Scene) {
        match light {
            Light::Point { position, color: c } => {
                self.line(format_args!("light_source {{ {} color rgb {} }}", vector(*position), color(*c)));
            }
            Light::Spot { position, direction, color: c, inner_deg, outer_deg } => {
                self.losses.note("POV-Ray's cones of light end at 90°, and fall off a little differently");
                self.line(format_args!(
                    "light_source {{ {} color rgb {} spotlight point_at {} radius {} falloff {} }}",
                    vector(*position),
                    color(*c),
                    vector(*position + direction.try_normalize().unwrap_or_default()),
                    number(inner_deg.min(89.0)),
                    number(outer_deg.min(90.0)),
                ));
            }
            Light::Directional { direction, color: c } => {
                let [lo, hi] = scene.bounds().unwrap_or([scene.camera.eye; 2]);
                let middle = (lo + hi) * 0.5;
                // What stands behind a parallel light casts no shadow, so it stands well behind everything.
                let distance = (1.0 + 100.0 * (hi - lo).length()).min(FARTHEST_LIGHT);
                let from = middle - direction.try_normalize().unwrap_or_default() * distance;
                self.line(format_args!(
                    "light_source {{ {} color rgb {} parallel point_at {} }}",
                    vector(from),
                    color(*c),
                    vector(middle)
                ));
            }
        }
    }
}

fn vector(v: Vec3) -> String {
    format!("<{}>", joined(v, ", "))
}

fn color(c: Rgb) -> String {
    vector(<[f64; 3]>::from(c).into())
}

/// A name for people, in a comment of one line.
fn comment(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
