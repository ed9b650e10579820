//! The field `texture` of a material.

use std::sync::Arc;

use brt_scene::{Diagnostic, Texels, Texture, TextureAlpha, TextureFilter, Wrap};
use toml::de::DeValue;

use super::fields::Fields;
use super::files::Files;
use super::value::{Value, error, number, numbers, one_of, text, wrong_count};
use crate::common::Problems;

const WRAPS: [(&str, Wrap); 3] = [("repeat", Wrap::Repeat), ("mirror", Wrap::Mirror), ("clamp", Wrap::Clamp)];
const FILTERS: [(&str, TextureFilter); 2] =
    [("linear", TextureFilter::Linear), ("nearest", TextureFilter::Nearest)];
const ALPHAS: [(&str, TextureAlpha); 2] =
    [("ignored", TextureAlpha::Ignored), ("blend", TextureAlpha::Blend)];

/// Reads a texture; what is left out is that of [`Texture::new`].
pub(super) fn read_texture(value: &Value, files: &mut Files, problems: &mut Problems) -> Option<Texture> {
    let mut fields = Fields::of_value(value, "the texture", problems)?;
    fields.only(&[&["file", "data", "name", "wrap", "filter", "transform", "alpha", "mask"]]);
    let picture = picture(&mut fields, files);
    let wrap = fields.or("wrap", [Wrap::default(); 2], wraps);
    let filter = fields.or("filter", TextureFilter::default(), |v| one_of("filter", v, &FILTERS));
    let transform = fields.or("transform", Texture::PLAIN, matrix);
    let alpha = alpha(&mut fields);
    Some(Texture { picture: picture?, wrap: wrap?, filter: filter?, transform: transform?, alpha: alpha? })
}

fn picture(fields: &mut Fields, files: &mut Files) -> Option<Arc<Texels>> {
    let Some(data) = fields.value("data") else {
        if let Some(name) = fields.value("name") {
            fields.problems.push(error("only `data` has a name", name, "`file` alone"));
            return None;
        }
        return fields.required("file", |v| files.picture(v));
    };
    if let Some(file) = fields.value("file") {
        fields.problems.push(error("the texture has both `file` and `data`", file, "one of them"));
        return None;
    }
    let name = fields.or("name", "picture".to_owned(), text)?;
    fields.required("data", |_| text(data).and_then(|_| files.inline_picture(data, &name)))
}

/// One word for both directions, or one for each.
fn wraps(value: &Value) -> Result<[Wrap; 2], Diagnostic> {
    match value.get_ref() {
        DeValue::Array(items) => match &items[..] {
            [u, v] => Ok([one_of("wrap", u, &WRAPS)?, one_of("wrap", v, &WRAPS)?]),
            other => Err(wrong_count(other, value, "a word, or one for u and one for v")),
        },
        _ => one_of("wrap", value, &WRAPS).map(|wrap| [wrap; 2]),
    }
}

fn matrix(value: &Value) -> Result<[[f64; 3]; 2], Diagnostic> {
    const EXPECTED: &str = "two rows of three numbers";
    match value.get_ref() {
        DeValue::Array(rows) if rows.len() == 2 => {
            Ok([numbers(&rows[0], "a row of three numbers")?, numbers(&rows[1], "a row of three numbers")?])
        }
        DeValue::Array(rows) => Err(wrong_count(rows, value, EXPECTED)),
        _ => Err(super::value::mismatch(value, EXPECTED)),
    }
}

fn alpha(fields: &mut Fields) -> Option<TextureAlpha> {
    let Some(mask) = fields.value("mask") else {
        return fields.or("alpha", TextureAlpha::default(), |v| one_of("alpha", v, &ALPHAS));
    };
    if fields.value("alpha").is_some() {
        fields.problems.push(error("the texture has both `alpha` and `mask`", mask, "one of them"));
        return None;
    }
    fields.required("mask", number).map(TextureAlpha::Mask)
}
