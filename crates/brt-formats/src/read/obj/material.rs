//! Materials (MTL).
//!
//! How they become ours: colours are sRGB. `Kd` is the body's colour; `Ks` (its mean) with `Ns` is the highlight, at half
//! its strength, since exporters write 1 for anything; with `illum` 3 and more `Ks` is the mirror's share, too. `d` or
//! `Tr` is opacity, with `illum` 6 and 7 glass that refracts (`Ni`). `Ke` is emission. `Kd` is multiplied with `map_Kd`;
//! a black one is taken for white, since exporters write it where the map alone is meant.

use std::collections::HashMap;

use brt_image::Rgb;
use brt_scene::{Material, MaterialId};

use super::map::Map;
use crate::common::{Budget, Cost, Word, Words};
use crate::import::{Beside, Draft, Pictures, srgb};

/// Materials by name.
pub(super) struct Materials<'b> {
    ids: HashMap<String, MaterialId>,
    pictures: Pictures<'b>,
}

/// A material as the file has it.
struct Entry {
    name: String,
    diffuse: Option<Rgb>,
    map: Option<Map>,
    emission: Rgb,
    specular: f64,
    exponent: f64,
    opacity: f64,
    index: f64,
    illumination: f64,
    glows: bool,
}

impl<'b> Materials<'b> {
    pub(super) fn new(budget: &'b Budget<'b>) -> Self {
        Self { ids: HashMap::new(), pictures: Pictures::new(budget) }
    }

    pub(super) fn find(&self, name: &str) -> Option<MaterialId> {
        self.ids.get(name).copied()
    }

    /// Reads a library beside the OBJ file. The error says why it could not be read.
    pub(super) fn read(
        &mut self,
        name: &str,
        beside: &mut Beside<'b>,
        draft: &mut Draft<'b>,
    ) -> Result<(), String> {
        let bytes = beside.read(name)?;
        let count = bytes.windows(6).filter(|word| word == b"newmtl").count() as u64;
        draft.budget.spend(Cost::Material, count).map_err(|halt| halt.text())?;
        let slash = name.rfind(['/', '\\']).map_or(0, |at| at + 1);
        let mut library = Library { folder: &name[..slash], materials: self, beside, draft };
        let mut words = Words::new(&bytes);
        let mut entry: Option<Entry> = None;
        while let Some(word) = words.next() {
            if word.is("newmtl") {
                library.add(entry.take());
                entry = Some(Entry::new(&text(words.rest_of_line())));
                continue;
            }
            if let Some(entry) = &mut entry {
                library.line(&word, &mut words, entry);
            }
            words.skip_line();
        }
        library.add(entry);
        Ok(())
    }
}

/// A library that is read.
struct Library<'l, 'b> {
    /// With a slash at its end, if it is another than that of the OBJ file.
    folder: &'l str,
    materials: &'l mut Materials<'b>,
    beside: &'l mut Beside<'b>,
    draft: &'l mut Draft<'b>,
}

impl Library<'_, '_> {
    fn line(&mut self, word: &Word, words: &mut Words, entry: &mut Entry) {
        let what = word.excerpt();
        let known = match what.as_str() {
            "map_Kd" => {
                entry.map = Map::parse(&text(words.rest_of_line()));
                entry.map.is_some()
            }
            map if is_map(map) => {
                // Where the picture is dark nothing glows: without it the factor says nothing.
                entry.glows &= map != "map_Ke";
                if let Some(map) = Map::parse(&text(words.rest_of_line())) {
                    map.leave(self.folder, self.beside);
                }
                false
            }
            _ => {
                let numbers = std::iter::from_fn(|| words.next_on_line());
                let numbers: Vec<f64> = numbers.take(4).map_while(|w| w.finite()).collect();
                entry.set(&what, &numbers)
            }
        };
        if !known {
            self.draft.notices.note(&format!("`{what}` of materials ignored"), format!("`{}`", entry.name));
        }
    }

    fn add(&mut self, entry: Option<Entry>) {
        let Some(mut entry) = entry else { return };
        let name = entry.name.clone();
        let map = entry.map.take();
        let mut material = entry.into_material(map.is_some());
        if let Some(map) = map {
            match map.read(self.folder, self.beside, &mut self.materials.pictures) {
                Ok(texture) => material.texture = Some(texture),
                Err(why) => {
                    let what = format!("picture {} of a material cannot be read: {why}", map.quoted());
                    self.draft.notices.note(&what, format!("`{name}`"));
                }
            }
        }
        let id = self.draft.scene.add_material(material);
        self.materials.ids.insert(name, id);
    }
}

/// Does a statement name a picture?
fn is_map(what: &str) -> bool {
    what.starts_with("map_") || ["bump", "disp", "decal", "refl", "norm"].contains(&what)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim().to_owned()
}

impl Entry {
    fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            diffuse: None,
            map: None,
            emission: Rgb::BLACK,
            specular: 0.0,
            exponent: 20.0,
            opacity: 1.0,
            index: 1.0,
            illumination: 2.0,
            glows: true,
        }
    }

    /// Takes a line; is it understood?
    fn set(&mut self, what: &str, numbers: &[f64]) -> bool {
        let Some(&first) = numbers.first() else { return false };
        // One number stands for all three.
        let three = || [first, *numbers.get(1).unwrap_or(&first), *numbers.get(2).unwrap_or(&first)];
        match what {
            "Kd" => self.diffuse = Some(srgb(three())),
            "Ke" => self.emission = light(three()),
            "Ks" => self.specular = three().iter().sum::<f64>() / 3.0,
            "Ns" => self.exponent = first,
            "d" => self.opacity = first,
            "Tr" => self.opacity = 1.0 - first,
            "Ni" => self.index = first,
            "illum" => self.illumination = first,
            // The ambient colour is the body's here; a filter of 1 changes nothing.
            "Ka" => {}
            "Tf" => return three() == [1.0; 3],
            _ => return false,
        }
        true
    }

    fn into_material(self, has_map: bool) -> Material {
        let color = match self.diffuse {
            Some(black) if has_map && black == Rgb::BLACK => Rgb::WHITE,
            Some(color) => color,
            None if has_map => Rgb::WHITE,
            None => srgb([0.8, 0.8, 0.8]),
        };
        let mut material = Material::matte(self.name, color);
        if self.glows {
            material.emission = self.emission;
        }
        let shine = self.specular.clamp(0.0, 1.0);
        // An exponent of 0 is that of programs that write no shine: it would be a veil of white over everything.
        if self.illumination >= 2.0 && self.exponent > 0.0 {
            material.specular = 0.5 * shine;
            material.exponent = self.exponent.clamp(1.0, 1000.0);
        }
        if self.illumination >= 3.0 && self.illumination <= 8.0 {
            material.reflection = 0.5 * shine;
        }
        // Nobody models what cannot be seen: `Tr 1` is meant as opaque by programs that took it for `d`.
        let opacity = if self.opacity > 0.0 { self.opacity.min(1.0) } else { 1.0 };
        let refracts = self.illumination == 6.0 || self.illumination == 7.0;
        if opacity < 1.0 && refracts {
            material.transmission = 1.0 - opacity;
            material.diffuse *= opacity;
            material.ambient *= opacity;
            material.casts_shadow = opacity > 0.5;
            material.index_of_refraction = self.index.clamp(0.1, 10.0);
        } else {
            material.opacity = opacity;
        }
        material
    }
}

/// A colour that may be brighter than white.
fn light(channels: [f64; 3]) -> Rgb {
    let [r, g, b] = channels;
    let strength = r.max(g).max(b).clamp(1.0, 1e9);
    srgb(channels.map(|c| c / strength)) * strength
}
