//! Materials (MTL).
//!
//! How they become ours: colours are sRGB. `Kd` is the body's colour; `Ks` (its mean) with `Ns` is the highlight, at half
//! its strength, since exporters write 1 for anything; with `illum` 3 and more `Ks` is the mirror's share, too. `d` or
//! `Tr` is transparency, which refracts (`Ni`) with `illum` 6 and 7 only.

use std::collections::HashMap;

use brt_image::Rgb;
use brt_scene::{Material, MaterialId};

use crate::import::{Beside, Draft, srgb};
use crate::words::Words;

/// Materials by name.
#[derive(Default)]
pub(super) struct Materials(HashMap<String, MaterialId>);

/// A material as the file has it.
struct Entry {
    name: String,
    diffuse: Rgb,
    specular: f64,
    exponent: f64,
    opacity: f64,
    index: f64,
    illumination: f64,
}

impl Materials {
    pub(super) fn find(&self, name: &str) -> Option<MaterialId> {
        self.0.get(name).copied()
    }

    /// Reads a library beside the OBJ file. The error says why it could not be read.
    pub(super) fn read(&mut self, name: &str, beside: &mut Beside, draft: &mut Draft) -> Result<(), String> {
        let bytes = beside.read(name)?;
        let mut words = Words::new(&bytes);
        let mut entry: Option<Entry> = None;
        while let Some(word) = words.next() {
            if word.is("newmtl") {
                self.add(entry.take(), draft);
                entry = Some(Entry::new(String::from_utf8_lossy(words.rest_of_line()).trim()));
                continue;
            }
            let what = word.excerpt();
            let numbers: Vec<f64> =
                std::iter::from_fn(|| words.next_on_line()).take(4).map_while(|w| w.finite()).collect();
            let known = entry.as_mut().is_none_or(|entry| entry.set(&what, &numbers));
            if !known {
                draft.notices.note(&format!("`{what}` of materials ignored"), format!("`{name}`"));
            }
            words.skip_line();
        }
        self.add(entry, draft);
        Ok(())
    }

    fn add(&mut self, entry: Option<Entry>, draft: &mut Draft) {
        if let Some(entry) = entry {
            let name = entry.name.clone();
            let id = draft.scene.add_material(entry.into_material());
            self.0.insert(name, id);
        }
    }
}

impl Entry {
    fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            diffuse: srgb([0.8, 0.8, 0.8]),
            specular: 0.0,
            exponent: 20.0,
            opacity: 1.0,
            index: 1.0,
            illumination: 2.0,
        }
    }

    /// Takes a line; is it understood?
    fn set(&mut self, what: &str, numbers: &[f64]) -> bool {
        let Some(&first) = numbers.first() else { return false };
        // One number stands for all three.
        let three = || [first, *numbers.get(1).unwrap_or(&first), *numbers.get(2).unwrap_or(&first)];
        match what {
            "Kd" => self.diffuse = srgb(three()),
            "Ks" => self.specular = three().iter().sum::<f64>() / 3.0,
            "Ns" => self.exponent = first,
            "d" => self.opacity = first,
            "Tr" => self.opacity = 1.0 - first,
            "Ni" => self.index = first,
            "illum" => self.illumination = first,
            // The ambient colour is the body's here; a filter of 1 and no emission change nothing.
            "Ka" => {}
            "Tf" => return three() == [1.0; 3],
            "Ke" => return three() == [0.0; 3],
            _ => return false,
        }
        true
    }

    fn into_material(self) -> Material {
        let mut material = Material::matte(self.name, self.diffuse);
        let shine = self.specular.clamp(0.0, 1.0);
        if self.illumination >= 2.0 {
            material.specular = 0.5 * shine;
            material.exponent = self.exponent.clamp(1.0, 1000.0);
        }
        if self.illumination >= 3.0 && self.illumination <= 8.0 {
            material.reflection = 0.5 * shine;
        }
        // Nobody models what cannot be seen: `Tr 1` is meant as opaque by programs that took it for `d`.
        let opacity = if self.opacity > 0.0 { self.opacity.min(1.0) } else { 1.0 };
        if opacity < 1.0 {
            material.transmission = 1.0 - opacity;
            material.diffuse *= opacity;
            material.ambient *= opacity;
            material.casts_shadow = opacity > 0.5;
            let refracts = self.illumination == 6.0 || self.illumination == 7.0;
            material.index_of_refraction = if refracts { self.index.clamp(0.1, 10.0) } else { 1.0 };
        }
        material
    }
}
