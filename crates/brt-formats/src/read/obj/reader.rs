//! The lines of an OBJ file.

use std::ops::Range;

use brt_geometry::Vec3;
use brt_scene::{Diagnostic, MaterialId};

use super::face::{Chunk, Corner, Lists};
use super::material::Materials;
use crate::common::{Cost, Word, Words};
use crate::import::{Beside, Draft, Stop, fault, srgb};

/// Reads a file into a model.
pub(crate) fn read<'b>(bytes: &'b [u8], beside: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
    let mut reader = Reader {
        words: Words::new(bytes),
        lists: Lists::default(),
        chunk: Chunk::default(),
        materials: Materials::new(draft.budget),
        material: None,
        name: None,
        group: 0,
        has_groups: false,
    };
    while let Some(word) = reader.words.next() {
        reader.line(&word, beside, draft)?;
    }
    reader.end_chunk(draft)
}

struct Reader<'b> {
    words: Words<'b>,
    lists: Lists,
    chunk: Chunk,
    materials: Materials<'b>,
    material: Option<MaterialId>,
    name: Option<String>,
    group: u32,
    has_groups: bool,
}

impl<'b> Reader<'b> {
    fn line(&mut self, word: &Word, beside: &mut Beside<'b>, draft: &mut Draft<'b>) -> Result<(), Stop> {
        match word.bytes {
            b"v" => self.point(word, draft)?,
            b"vn" => {
                draft.budget.spend(Cost::Number, 3)?;
                let normal = self.vector(word, "a normal, `vn x y z`")?;
                self.lists.normals.push(normal);
            }
            b"vt" => {
                draft.budget.spend(Cost::Number, 2)?;
                self.texcoord();
            }
            b"f" => self.face(word, draft)?,
            b"s" => self.smoothing(),
            b"o" | b"g" => {
                self.end_chunk(draft)?;
                let name = self.text();
                self.name = (!name.is_empty()).then_some(name);
            }
            b"usemtl" | b"mtllib" if draft.is_bare() => {}
            b"usemtl" => {
                self.end_chunk(draft)?;
                let name = self.text();
                self.material = self.materials.find(&name);
                if self.material.is_none() {
                    let what = format!("material `{}` is not known: the default is used", short(&name));
                    draft.notices.note(&what, word.span.clone());
                }
            }
            b"mtllib" => {
                let name = self.text();
                if let Err(why) = self.materials.read(&name, beside, draft) {
                    draft
                        .notices
                        .note(&format!("cannot read materials `{}`: {why}", short(&name)), word.span.clone());
                }
            }
            b"l" | b"p" => draft.notices.note("lines and points ignored", word.span.clone()),
            b"\\" => {}
            _ => {
                let what = format!("`{}` ignored", word.excerpt());
                draft.notices.note(&what, word.span.clone());
            }
        }
        self.words.skip_line();
        Ok(())
    }

    /// A point, and its colour where three more numbers follow.
    fn point(&mut self, word: &Word, draft: &mut Draft) -> Result<(), Stop> {
        draft.budget.spend(Cost::Number, 3)?;
        let position = self.vector(word, "a point, `v x y z`")?;
        self.lists.positions.push(position);
        let more: Vec<f64> =
            std::iter::from_fn(|| self.words.next_on_line()).take(4).map_while(|w| w.finite()).collect();
        if let &[r, g, b] = &more[..] {
            // Points before this one had none.
            let white = brt_image::Rgb::WHITE;
            self.lists.colors.resize(self.lists.positions.len() - 1, white);
            self.lists.colors.push(srgb([r, g, b]));
        }
        Ok(())
    }

    /// Three numbers that stand on one line.
    fn vector(&mut self, word: &Word, expected: &str) -> Result<Vec3, Stop> {
        let mut numbers = [0.0; 3];
        for (count, number) in numbers.iter_mut().enumerate() {
            if !self.words.line_goes_on() {
                let found = if count == 1 { "1 number".to_owned() } else { format!("{count} numbers") };
                let span = word.span.start..self.words.position();
                return Err(Diagnostic::error(format!("found {found}"), Some(span))
                    .expecting(expected)
                    .into());
            }
            *number = self.words.number(expected)?;
        }
        Ok(numbers.into())
    }

    /// The third number is for pictures with depth. What is missing is 0.
    fn texcoord(&mut self) {
        let mut number = || self.words.next_on_line().and_then(|word| word.finite()).unwrap_or(0.0);
        let (u, v) = (number(), number());
        self.lists.texcoords.push([u, 1.0 - v]);
    }

    fn face(&mut self, word: &Word, draft: &mut Draft) -> Result<(), Stop> {
        let mut corners = Vec::new();
        while let Some(text) = self.words.next_on_line() {
            if text.bytes == b"\\" {
                self.words.skip_line();
                continue;
            }
            corners.push(self.corner(&text, draft)?);
        }
        if corners.len() < 3 {
            let message = format!("a face needs at least 3 points, found {}", corners.len());
            return Err(fault(message, Some(word.span.clone())));
        }
        draft.expect(0, corners.len() - 2)?;
        if !self.is_textured(draft) {
            // Points need not be split where only their places in a picture differ.
            corners.iter_mut().for_each(|corner| corner.texcoord = None);
        } else if !draft.is_bare() && corners.iter().any(|corner| corner.texcoord.is_none()) {
            draft.notices.note("face without the coordinates of its texture", word.span.clone());
        }
        self.chunk.add(&corners, self.group, &self.lists);
        Ok(())
    }

    fn is_textured(&self, draft: &Draft) -> bool {
        if draft.is_bare() {
            return true;
        }
        let material = self.material.and_then(|id| draft.scene.materials.get(id.0 as usize));
        material.is_some_and(|material| material.texture.is_some())
    }

    /// `point/texture/normal`, counted from 1, or from −1 backwards.
    fn corner(&self, word: &Word, draft: &mut Draft) -> Result<Corner, Stop> {
        let text = String::from_utf8_lossy(word.bytes);
        let mut parts = text.split('/');
        let lists = &self.lists;
        let position = index(parts.next(), lists.positions.len(), "point", word)?;
        // Some programs number what they never write.
        let mut optional = |count, what| {
            let part = parts.next();
            if count > 0 || part.is_none_or(|number| number.parse::<i64>().is_err()) {
                return index(part, count, what, word);
            }
            draft
                .notices
                .note(&format!("corners name a {what}, but the file has none before"), word.span.clone());
            Ok(None)
        };
        let texcoord = optional(lists.texcoords.len(), "texture coordinate")?;
        let normal = optional(lists.normals.len(), "normal")?;
        match (position, parts.next()) {
            (Some(point), None) => Ok(Corner { point, texcoord, normal }),
            _ => Err(corner_fault(
                format!("`{}` is not a corner of a face", word.excerpt()),
                word.span.clone(),
            )),
        }
    }

    fn smoothing(&mut self) {
        self.has_groups = true;
        self.group = self.words.next_on_line().and_then(|w| w.finite()).map_or(0, |n| n as u32);
    }

    fn text(&mut self) -> String {
        String::from_utf8_lossy(self.words.rest_of_line()).trim().to_owned()
    }

    fn end_chunk(&mut self, draft: &mut Draft) -> Result<(), Stop> {
        let material = match self.material {
            Some(material) => material,
            None if self.chunk.is_empty() => return Ok(()),
            None => draft.plain(),
        };
        self.chunk.add_to(draft, material, self.name.as_deref(), self.has_groups)
    }
}

fn index(text: Option<&str>, count: usize, what: &str, word: &Word) -> Result<Option<u32>, Stop> {
    let Some(text) = text.filter(|text| !text.is_empty()) else { return Ok(None) };
    let Ok(number) = text.parse::<i64>() else {
        return Err(corner_fault(
            format!("`{}` is not a corner of a face", word.excerpt()),
            word.span.clone(),
        ));
    };
    let count = count as i64;
    let found = if number < 0 { count + number } else { number - 1 };
    if (0..count).contains(&found) {
        return Ok(Some(found as u32));
    }
    let why = match (number, count) {
        (0, _) => "indices count from 1".to_owned(),
        (_, 0) => "none is defined before it".to_owned(),
        (_, 1) => "only 1 is defined before it".to_owned(),
        _ => format!("only {count} are defined before it"),
    };
    Err(corner_fault(format!("{what} {number} does not exist: {why}"), word.span.clone()))
}

fn corner_fault(message: String, span: Range<usize>) -> Stop {
    let error = Diagnostic::error(message, Some(span));
    Stop::Fault(error.expecting("`point/texture/normal`, counted from 1"))
}

fn short(name: &str) -> String {
    name.chars().take(60).collect()
}
