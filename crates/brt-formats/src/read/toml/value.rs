//! Values of a TOML file as numbers, vectors, colours and lists; each error names the exact place.

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::Diagnostic;
use toml::Spanned;
use toml::de::DeValue;

use super::fields::did_you_mean;
use crate::common::excerpt;

/// A value with its place.
pub(super) type Value<'a> = Spanned<DeValue<'a>>;

/// A finite number; integers count as numbers.
pub(super) fn number(value: &Value) -> Result<f64, Diagnostic> {
    match value.get_ref() {
        DeValue::Integer(i) if i.radix() == 10 => finite(i.as_str(), value),
        DeValue::Integer(i) => match i64::from_str_radix(i.as_str(), i.radix()) {
            Ok(n) => Ok(n as f64),
            Err(_) => Err(error("this number is too large", value, "a number of at most 63 bits")),
        },
        DeValue::Float(f) => finite(f.as_str(), value),
        _ => Err(mismatch(value, "a number")),
    }
}

/// A whole number from 0 to `greatest`.
pub(super) fn whole(value: &Value, greatest: u32, expected: &str) -> Result<u32, Diagnostic> {
    let DeValue::Integer(i) = value.get_ref() else {
        return Err(mismatch(value, expected));
    };
    match u32::from_str_radix(i.as_str(), i.radix()) {
        Ok(n) if n <= greatest => Ok(n),
        _ => Err(error(format!("{} is out of range", excerpt(i.as_str())), value, expected)),
    }
}

/// Three finite numbers.
pub(super) fn vector(value: &Value) -> Result<Vec3, Diagnostic> {
    three(value, number, "three numbers, [x, y, z]").map(|[x, y, z]| vec3(x, y, z))
}

/// A linear RGB colour.
pub(super) fn color(value: &Value) -> Result<Rgb, Diagnostic> {
    three(value, number, "a colour of three numbers, [r, g, b]").map(|[r, g, b]| rgb(r, g, b))
}

/// `true` or `false`.
pub(super) fn boolean(value: &Value) -> Result<bool, Diagnostic> {
    value.get_ref().as_bool().ok_or_else(|| mismatch(value, "true or false"))
}

/// Any text.
pub(super) fn text(value: &Value) -> Result<String, Diagnostic> {
    value.get_ref().as_str().map(str::to_owned).ok_or_else(|| mismatch(value, "a text in quotes"))
}

/// Points or directions.
pub(super) fn vectors(value: &Value) -> Result<Vec<Vec3>, Diagnostic> {
    list(value, "a list of points, [[x, y, z], ...]")?.iter().map(vector).collect()
}

/// Linear RGB colours.
pub(super) fn colors(value: &Value) -> Result<Vec<Rgb>, Diagnostic> {
    list(value, "a list of colours, [[r, g, b], ...]")?.iter().map(color).collect()
}

/// Places in a picture.
pub(super) fn pairs(value: &Value) -> Result<Vec<[f64; 2]>, Diagnostic> {
    let pair = |v: &Value| numbers(v, "two numbers, [u, v]");
    list(value, "a list of pairs, [[u, v], ...]")?.iter().map(pair).collect()
}

/// Three rows of four numbers.
pub(super) fn matrix(value: &Value) -> Result<[[f64; 4]; 3], Diagnostic> {
    three(value, |row| numbers(row, "a row of four numbers"), "three rows of four numbers")
}

/// So many numbers.
pub(super) fn numbers<const N: usize>(value: &Value, expected: &str) -> Result<[f64; N], Diagnostic> {
    let items = list(value, expected)?;
    if items.len() != N {
        return Err(wrong_count(items, value, expected));
    }
    let mut numbers = [0.0; N];
    for (slot, item) in numbers.iter_mut().zip(items) {
        *slot = number(item)?;
    }
    Ok(numbers)
}

/// Loops of points.
pub(super) fn loops(value: &Value) -> Result<Vec<Vec<Vec3>>, Diagnostic> {
    list(value, "a list of loops, [[[x, y, z], ...], ...]")?.iter().map(vectors).collect()
}

/// Triples of indices.
pub(super) fn triangles(value: &Value) -> Result<Vec<[u32; 3]>, Diagnostic> {
    let index = |v: &Value| whole(v, u32::MAX, "the index of a point, counted from 0");
    let triple = |v: &Value| three(v, index, "three indices of points, [a, b, c]");
    list(value, "a list of triangles, [[a, b, c], ...]")?.iter().map(triple).collect()
}

/// Width and height in pixels.
pub(super) fn size(value: &Value) -> Result<[u32; 2], Diagnostic> {
    const EXPECTED: &str = "width and height in pixels, [w, h]";
    match list(value, EXPECTED)? {
        [w, h] => Ok([whole(w, u32::MAX, "a number of pixels")?, whole(h, u32::MAX, "a number of pixels")?]),
        other => Err(wrong_count(other, value, EXPECTED)),
    }
}

/// One of these words, which say `what`.
pub(super) fn one_of<T: Copy>(what: &str, value: &Value, words: &[(&str, T)]) -> Result<T, Diagnostic> {
    let expected = || {
        let names: Vec<_> = words.iter().map(|(word, _)| format!("\"{word}\"")).collect();
        format!("one of {}", names.join(", "))
    };
    let Some(found) = value.get_ref().as_str() else {
        return Err(mismatch(value, &expected()));
    };
    match words.iter().find(|(word, _)| *word == found) {
        Some((_, meaning)) => Ok(*meaning),
        None => {
            let guess = did_you_mean(found, words.iter().map(|(word, _)| *word));
            Err(error(format!("unknown {what} \"{}\"{guess}", excerpt(found)), value, &expected()))
        }
    }
}

/// An error at a value.
pub(super) fn error(message: impl Into<String>, value: &Value, expected: &str) -> Diagnostic {
    Diagnostic::error(message, Some(value.span())).expecting(expected)
}

/// An error that says how many values the list has instead.
pub(super) fn wrong_count(items: &[Value], value: &Value, expected: &str) -> Diagnostic {
    let values = if items.len() == 1 { "value" } else { "values" };
    error(format!("found a list of {} {values}", items.len()), value, expected)
}

/// An error that says what kind of value stands there instead.
pub(super) fn mismatch(value: &Value, expected: &str) -> Diagnostic {
    let found = match value.get_ref() {
        DeValue::String(_) => "text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date or time",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    };
    error(format!("found {found}"), value, expected)
}

fn finite(digits: &str, value: &Value) -> Result<f64, Diagnostic> {
    match digits.parse::<f64>() {
        Ok(n) if n.is_finite() => Ok(n),
        Ok(_) if digits.contains(|c: char| c.is_ascii_digit()) => {
            Err(error("this number is too large", value, "a finite number"))
        }
        _ => Err(error(format!("{} is not a finite number", excerpt(digits)), value, "a finite number")),
    }
}

fn list<'v, 'a>(value: &'v Value<'a>, expected: &str) -> Result<&'v [Value<'a>], Diagnostic> {
    match value.get_ref() {
        DeValue::Array(items) => Ok(items),
        _ => Err(mismatch(value, expected)),
    }
}

fn three<T>(
    value: &Value,
    read: impl Fn(&Value) -> Result<T, Diagnostic>,
    expected: &str,
) -> Result<[T; 3], Diagnostic> {
    match list(value, expected)? {
        [a, b, c] => Ok([read(a)?, read(b)?, read(c)?]),
        other => Err(wrong_count(other, value, expected)),
    }
}
