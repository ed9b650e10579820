//! `map_Kd`: a picture, and how it is laid.

use std::borrow::Cow;

use brt_scene::{Texture, TextureAlpha, TextureFilter, Wrap};

use crate::common::excerpt;
use crate::import::{Beside, Picture, Pictures};

/// A map as the file has it.
#[derive(Debug, PartialEq)]
pub(super) struct Map {
    file: String,
    offset: [f64; 2],
    scale: [f64; 2],
    clamps: bool,
}

impl Map {
    /// The file's name for messages.
    pub(super) fn quoted(&self) -> String {
        format!("`{}`", excerpt(&self.file))
    }

    /// Reads `[options] file`. Options that say nothing about where the picture lies are read over.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let mut map = Self { file: String::new(), offset: [0.0; 2], scale: [1.0; 2], clamps: false };
        let mut rest = text.trim();
        while let Some((option, after)) = first_word(rest).filter(|(word, _)| word.starts_with('-')) {
            rest = match option {
                "-o" => pair(after, &mut map.offset),
                "-s" => pair(after, &mut map.scale),
                "-t" => pair(after, &mut [0.0; 2]),
                "-clamp" => {
                    let (word, after) = first_word(after)?;
                    map.clamps = word.eq_ignore_ascii_case("on");
                    after
                }
                "-mm" => pair(after, &mut [0.0; 2]),
                "-blendu" | "-blendv" | "-cc" | "-boost" | "-texres" | "-bm" | "-imfchan" | "-type"
                | "-colorspace" => first_word(after)?.1,
                _ => break,
            };
        }
        // Windows' exporters write `\`.
        map.file = rest.trim_matches('"').replace('\\', "/");
        (!map.file.is_empty()).then_some(map)
    }

    /// The map's picture, in the folder of the library or where that leads.
    pub(super) fn read(
        &self,
        folder: &str,
        beside: &mut Beside,
        pictures: &mut Pictures,
    ) -> Result<Texture, String> {
        let wrap = if self.clamps { Wrap::Clamp } else { Wrap::Repeat };
        Ok(Texture {
            picture: self.picture(folder, beside, pictures)?,
            transform: self.transform(),
            wrap: [wrap; 2],
            filter: TextureFilter::Linear,
            alpha: TextureAlpha::Ignored,
        })
    }

    /// The picture is not read, but belongs to the scene.
    pub(super) fn leave(&self, folder: &str, beside: &mut Beside) {
        beside.leave(&format!("{folder}{}", self.file));
        if let Some((_, bare)) = self.file.rsplit_once('/') {
            beside.leave(&format!("{folder}{bare}"));
        }
    }

    /// Many files name a folder of the machine that they were made on: then the picture beside is meant.
    fn picture(&self, folder: &str, beside: &mut Beside, pictures: &mut Pictures) -> Picture {
        let mut get = |file: &str| {
            let name = format!("{folder}{file}");
            pictures.get(&name, || beside.read(&name).map(Cow::Owned))
        };
        let as_named = get(&self.file);
        match (as_named, self.file.rsplit_once('/')) {
            (Err(why), Some((_, bare))) => get(bare).map_err(|_| why),
            (picture, _) => picture,
        }
    }

    /// Coordinates are scaled, then moved, in a space whose v points up; our meshes have 1 − v.
    fn transform(&self) -> [[f64; 3]; 2] {
        let ([across, up], [x, y]) = (self.scale, self.offset);
        [[across, 0.0, x], [0.0, up, 1.0 - up - y]]
    }
}

fn first_word(text: &str) -> Option<(&str, &str)> {
    let text = text.trim_start();
    let end = text.find(char::is_whitespace).unwrap_or(text.len());
    (end > 0).then(|| (&text[..end], text[end..].trim_start()))
}

/// One to three numbers, of which the first two count, and what follows them.
fn pair<'t>(text: &'t str, into: &mut [f64; 2]) -> &'t str {
    /// Beyond this nothing of a picture is told apart.
    const GREATEST: f64 = 1e9;
    let mut rest = text;
    for i in 0..3 {
        let Some((word, after)) = first_word(rest) else { break };
        let Some(number) = word.parse::<f64>().ok().filter(|n| n.abs() <= GREATEST) else { break };
        if let Some(slot) = into.get_mut(i) {
            *slot = number;
        }
        rest = after;
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_come_before_a_name_with_blanks() {
        let map = Map::parse(" -s 2 3 -o 0.5 -clamp on -mm 0 1 -bm 0.3 -blendu off my\\wood 2.png ").unwrap();
        assert_eq!((map.file.as_str(), map.scale, map.offset), ("my/wood 2.png", [2.0, 3.0], [0.5, 0.0]));
        assert!(map.clamps);
        assert_eq!(map.transform(), [[2.0, 0.0, 0.5], [0.0, 3.0, -2.0]]);
        assert_eq!(Map::parse("-odd.png").unwrap().file, "-odd.png");
        assert_eq!(Map::parse("2.png").unwrap().transform(), Texture::PLAIN);
        for nothing in ["", " ", "-s 1 1 1", "-clamp"] {
            assert_eq!(Map::parse(nothing), None, "{nothing}");
        }
    }
}
