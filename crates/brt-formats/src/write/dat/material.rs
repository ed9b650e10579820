//! Materials of Tachyon.

use brt_image::Rgb;
use brt_scene::Material;

use super::{Writer, color, number};

impl Writer {
    /// Defines the material of an index. What Tachyon calls specular is the mirror.
    pub(super) fn material(&mut self, index: usize, m: &Material) {
        let name = || format!("material `{}`", m.name);
        if m.transmission > 0.0 && m.index_of_refraction != 1.0 {
            self.losses.note_for("Tachyon refracts nothing; rays go straight through", name());
        }
        if m.emission != Rgb::BLACK {
            self.losses.note_for("Tachyon knows no emission; it is left out", name());
        }
        if m.texture.is_some() {
            self.losses.note_for("pictures on surfaces are left out", name());
        }
        let mut body = m.color;
        if let Some(checker) = &m.checker {
            self.losses
                .note_for("Tachyon's checkers have colours of their own; the mean colour is used", name());
            body = mean(m.color, checker.color);
        }
        let phong = if m.specular > 0.0 {
            format!(" PHONG PLASTIC {} PHONG_SIZE {}", number(m.specular), number(m.exponent))
        } else {
            String::new()
        };
        self.line(format_args!(
            "TEXDEF M{index} AMBIENT {} DIFFUSE {} SPECULAR {} OPACITY {}{phong} COLOR {} TEXFUNC 0",
            number(m.ambient),
            number(m.diffuse),
            number(m.reflection),
            number(m.opacity * (1.0 - m.transmission).max(0.0)),
            color(body),
        ));
    }
}

fn mean(a: Rgb, b: Rgb) -> Rgb {
    (a + b) * 0.5
}
