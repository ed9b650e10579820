//! Writes model files of the Tachyon ray tracer 0.99, so that its picture is as near to ours as it can be.
//!
//! Tachyon is left-handed: every z changes its sign. Its pixels are seen through their upper right corner, so the
//! window is shifted by half a pixel. It reads numbers in single precision.

mod material;
mod shape;

use std::fmt::{self, Write as _};

use brt_geometry::{Vec3, vec3};
use brt_image::Rgb;
use brt_scene::{Highlight, Light, Material, Scene};

use crate::write::losses::Losses;
use crate::write::numerals::{joined, number};
use crate::write::view::View;
use crate::write::{Written, alone};

/// The scene as Tachyon reads it.
pub(crate) fn write(scene: &Scene) -> Written {
    let mut out = Writer::default();
    out.head(scene);
    for light in &scene.lights {
        out.light(light);
    }
    for (index, material) in scene.materials.iter().enumerate() {
        out.material(index, material);
    }
    for object in &scene.objects {
        out.object(object, scene);
    }
    out.line(format_args!("END_SCENE"));
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

    fn head(&mut self, scene: &Scene) {
        let view = View::of(scene);
        let [width, height] = view.size;
        self.line(format_args!("BEGIN_SCENE\nRESOLUTION {width} {height}"));
        self.highlights(scene);
        self.shadows(scene);
        self.depth_end(scene);
        self.camera(&view, scene.max_depth);
        let background = <[f64; 3]>::from(scene.background);
        self.line(format_args!("BACKGROUND {}", joined(background.into(), " ")));
    }

    /// One formula for all highlights, chosen on Tachyon's command line; its own default is Blinn's.
    fn highlights(&mut self, scene: &Scene) {
        let shiny = |h: Highlight| scene.materials.iter().any(|m| m.specular > 0.0 && m.highlight == h);
        if shiny(Highlight::Phong) && shiny(Highlight::Blinn) {
            self.losses.note("Tachyon has one formula for all highlights, Phong's or Blinn's");
        }
        if shiny(Highlight::Phong) {
            self.line(format_args!("# Highlights after Phong need the option -shade_phong"));
        }
    }

    /// After its last bounce a ray shows the background to Tachyon, nothing to us.
    fn depth_end(&mut self, scene: &Scene) {
        let bounces = scene.materials.iter().any(|m| m.reflection > 0.0 || m.transmission > 0.0);
        if bounces && scene.background != Rgb::BLACK {
            self.losses.note("Tachyon shows the background where `max_depth` ends a path");
        }
    }

    /// Whether transparent things cast shadows can only be said for all together.
    fn shadows(&mut self, scene: &Scene) {
        let is_glass = |m: &&Material| m.transmission > 0.0;
        let dark_glass = scene.materials.iter().filter(is_glass).any(|m| m.casts_shadow);
        let filter = if dark_glass { "ON" } else { "OFF" };
        if scene.materials.iter().any(|m| is_glass(&m)) {
            self.line(format_args!("SHADER_MODE FULL SHADOW_FILTER_{filter} END_SHADER_MODE"));
        }
        for m in &scene.materials {
            let name = || format!("material `{}`", m.name);
            if is_glass(&m) && m.casts_shadow {
                self.losses.note_for("Tachyon lets light through what is transparent", name());
            } else if !m.casts_shadow && (!is_glass(&m) || dark_glass) {
                self.losses
                    .note_for("Tachyon lets everything cast shadows, or all but transparent things", name());
            }
        }
    }

    fn camera(&mut self, view: &View, max_depth: u32) {
        let projection = if view.is_perspective { "PERSPECTIVE" } else { "ORTHOGRAPHIC" };
        let zoom = number(0.5 / view.half_extent[1]);
        let depth = max_depth.saturating_add(1);
        let window = |axis: usize| {
            let half_pixel = view.half_extent[axis] / f64::from(view.size[axis]);
            [-view.half_extent[axis] - half_pixel, view.half_extent[axis] - half_pixel].map(number)
        };
        let ([left, right], [bottom, top]) = (window(0), window(1));
        self.line(format_args!(
            "CAMERA\n  PROJECTION {projection}\n  ZOOM {zoom}\n  ASPECTRATIO 1\n  ANTIALIASING 0\n  RAYDEPTH {depth}\n  \
             CENTER {}\n  VIEWDIR {}\n  UPDIR {}\n  FRUSTUM {left} {right} {bottom} {top}\nEND_CAMERA",
            vector(view.eye),
            vector(view.forward),
            vector(view.up),
        ));
    }

    fn light(&mut self, light: &Light) {
        match light {
            Light::Point { position, color: c } => {
                self.line(format_args!("LIGHT CENTER {} RAD 0.001 COLOR {}", vector(*position), color(*c)));
            }
            Light::Spot { position, direction, color: c, inner_deg, outer_deg } => {
                self.losses.note("Tachyon's cones of light fall off differently");
                self.line(format_args!(
                    "SPOTLIGHT CENTER {} RAD 0.001 DIRECTION {} FALLOFF_START {} FALLOFF_END {} COLOR {}",
                    vector(*position),
                    vector(*direction),
                    number(*inner_deg),
                    number(*outer_deg),
                    color(*c),
                ));
            }
            Light::Directional { direction, color: c } => self.line(format_args!(
                "DIRECTIONAL_LIGHT DIRECTION {} COLOR {}",
                vector(*direction),
                color(*c)
            )),
        }
    }
}

/// A point or direction in Tachyon's left-handed axes.
fn vector(v: Vec3) -> String {
    // Plain 0 instead of -0.
    joined(vec3(v.x, v.y, if v.z == 0.0 { 0.0 } else { -v.z }), " ")
}

fn color(c: Rgb) -> String {
    joined(<[f64; 3]>::from(c).into(), " ")
}
