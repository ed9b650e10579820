//! Fill colours (`f`) as materials.

use std::collections::HashMap;
use std::ops::Range;

use brt_image::Rgb;
use brt_scene::{Diagnostic, Material, MaterialId};

use crate::common::{Problems, Words};

/// The materials of a file; equal fills share one.
#[derive(Default)]
pub(super) struct Fills {
    pub(super) materials: Vec<Material>,
    pub(super) spans: Vec<Range<usize>>,
    ids: HashMap<[u64; 8], MaterialId>,
    current: Option<MaterialId>,
}

impl Fills {
    /// Reads the numbers of an `f` that starts at `start`.
    pub(super) fn read(
        &mut self,
        words: &mut Words,
        start: usize,
        problems: &mut Problems,
    ) -> Result<(), Diagnostic> {
        const WHAT: &str = "the fill's numbers: red, green, blue, Kd, Ks, Shine, T, index of refraction";
        let mut numbers = [0.0; 8];
        for number in &mut numbers {
            *number = words.number(WHAT)?;
        }
        let span = start..words.position();
        for factor in &mut numbers[3..7] {
            if *factor < 0.0 {
                let message = format!("the factor {factor} is negative: taken as 0");
                problems.push(Diagnostic::warning(message, Some(span.clone())));
                *factor = 0.0;
            }
        }
        if numbers[7] <= 0.0 {
            // Opaque fills are often written with an index of 0.
            if numbers[6] > 0.0 {
                let message = format!("the index of refraction is {}: taken as 1", numbers[7]);
                problems.push(Diagnostic::warning(message, Some(span.clone())));
            }
            numbers[7] = 1.0;
        }
        self.use_fill(numbers, span);
        Ok(())
    }

    /// The material of the next object; white and matte where the file names none.
    pub(super) fn current(&mut self, span: &Range<usize>, problems: &mut Problems) -> MaterialId {
        if let Some(id) = self.current {
            return id;
        }
        problems.push(Diagnostic::warning("no fill `f` before this: white and matte", Some(span.clone())));
        self.use_fill([1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0], span.clone())
    }

    fn use_fill(&mut self, numbers: [f64; 8], span: Range<usize>) -> MaterialId {
        // Adding 0 makes -0 the same fill as 0.
        let bits = numbers.map(|n| (n + 0.0).to_bits());
        let id = match self.ids.get(&bits) {
            Some(id) => *id,
            None => {
                let id = MaterialId(self.materials.len() as u32);
                self.materials.push(material(format!("fill{}", id.0 + 1), numbers));
                self.spans.push(span);
                self.ids.insert(bits, id);
                id
            }
        };
        self.current = Some(id);
        id
    }
}

fn material(name: String, numbers: [f64; 8]) -> Material {
    let [r, g, b, kd, ks, shine, t, index_of_refraction] = numbers;
    Material {
        ambient: 0.0,
        diffuse: kd,
        specular: ks,
        exponent: shine,
        reflection: ks,
        transmission: t,
        index_of_refraction,
        casts_shadow: t == 0.0,
        ..Material::matte(name, Rgb { r, g, b })
    }
}
