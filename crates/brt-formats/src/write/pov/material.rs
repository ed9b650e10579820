//! Materials of POV-Ray.

use brt_image::Rgb;
use brt_scene::{Axis, Highlight, Material};

use super::{Writer, color, comment, number};

/// Half the length of a checker's bars along the axis that the pattern does not change in, in squares. POV-Ray's
/// checkers are cubes; far from the origin a longer one would lose digits.
const HALF_BAR: f64 = 1e6;

impl Writer {
    /// Declares the material of an index.
    pub(super) fn material(&mut self, index: usize, m: &Material) {
        let shown = self.opaque_share(m);
        let mut finish =
            format!("ambient {} diffuse {}", number(m.ambient / shown), number(m.diffuse / shown));
        if m.specular > 0.0 {
            finish.push_str(&highlight(m));
        }
        if m.reflection > 0.0 {
            finish.push_str(&format!(" reflection {{ rgb {} }}", number(m.reflection)));
        }
        if m.emission != Rgb::BLACK {
            self.losses.note_for(
                "POV-Ray tints emission with the body's colour; it is left out",
                format!("material `{}`", m.name),
            );
        }
        if m.texture.is_some() {
            self.losses.note_for("pictures on surfaces are left out", format!("material `{}`", m.name));
        }
        if m.opacity < 1.0 && (m.transmission > 0.0 || m.specular > 0.0 || m.reflection > 0.0) {
            self.losses.note_for(
                "POV-Ray shows highlights, mirrors and glass in full on what is partly there",
                format!("material `{}`", m.name),
            );
        }
        let interior = if m.transmission > 0.0 {
            format!(" interior {{ ior {} }}", number(m.index_of_refraction))
        } else {
            String::new()
        };
        self.line(format_args!("// {}", comment(&m.name)));
        self.line(format_args!(
            "#declare M{index} = material {{ texture {{ pigment {{ {} }} finish {{ {finish} }} }}{interior} }}",
            pigment(m),
        ));
    }

    /// The share of its own light that POV-Ray leaves a transparent body, which the factors must make up for.
    fn opaque_share(&mut self, m: &Material) -> f64 {
        let is_lit = m.ambient > 0.0 || m.diffuse > 0.0;
        match 1.0 - m.transmission {
            share if share > 0.0 => share,
            _ => {
                if is_lit {
                    let what = "POV-Ray shows no light of its own on what is wholly transparent";
                    self.losses.note_for(what, format!("material `{}`", m.name));
                }
                1.0
            }
        }
    }
}

fn highlight(m: &Material) -> String {
    match m.highlight {
        Highlight::Phong => {
            format!(" phong {} phong_size {}", number(m.specular), number(m.exponent))
        }
        // The exponent of POV-Ray's `specular` is 1 / roughness; 0 has none.
        Highlight::Blinn => {
            let roughness = 1.0 / m.exponent.max(1e-9);
            format!(" specular {} roughness {}", number(m.specular), number(roughness))
        }
    }
}

fn pigment(m: &Material) -> String {
    let share = if m.transmission > 0.0 { m.transmission } else { 1.0 - m.opacity };
    let through = if share > 0.0 { format!(" transmit {}", number(share)) } else { String::new() };
    let Some(checker) = &m.checker else {
        return format!("color rgb {}{through}", color(m.color));
    };
    let bar = 2.0 * HALF_BAR * checker.size;
    let sides = |along: f64, across: f64| match checker.axis {
        Axis::X => [along, across, across],
        Axis::Y => [across, along, across],
        Axis::Z => [across, across, along],
    };
    let listed = |[x, y, z]: [f64; 3]| format!("<{}, {}, {}>", number(x), number(y), number(z));
    format!(
        "checker color rgb {}{through} color rgb {}{through} scale {} translate {}",
        color(m.color),
        color(checker.color),
        listed(sides(bar, checker.size)),
        listed(sides(-0.5 * bar, 0.0)),
    )
}
