//! What the JSON reader says, for people who do not know its types.

use std::ops::Range;

use crate::common::excerpt;

/// Which bytes a line and column mean, both counted from 1: a word, a text in quotes, or a sign.
pub(super) fn place(json: &[u8], line: usize, column: usize) -> Range<usize> {
    let line_start =
        json.split_inclusive(|&b| b == b'\n').take(line.saturating_sub(1)).map(<[u8]>::len).sum::<usize>();
    let at = (line_start + column).saturating_sub(1).min(json.len().saturating_sub(1));
    // Before lists and objects the reader has not moved on yet.
    let skipped = json[at..].iter().position(|b| !b.is_ascii_whitespace() && *b != b':').unwrap_or(0);
    let at = at + skipped;
    let is_word = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'+' | b'-' | b'.' | b'_');
    match json.get(at) {
        Some(b'"') => {
            let length = json[..at].iter().rev().position(|b| matches!(b, b'"' | b'\n')).unwrap_or(0);
            at - length - usize::from(length < at)..at + 1
        }
        Some(word) if is_word(word) => {
            let before = json[..at].iter().rev().take_while(|b| is_word(b)).count();
            at - before..at + json[at..].iter().take_while(|b| is_word(b)).count()
        }
        _ => at..(at + 1).min(json.len()),
    }
}

/// A message and what was expected; `found` is what stands there.
pub(super) fn plain(text: &str, found: &[u8]) -> (String, Option<String>) {
    if let Some(kind) =
        ["invalid type: ", "invalid value: ", "invalid length "].iter().find_map(|k| text.strip_prefix(k))
    {
        return mismatch(kind);
    }
    if let Some(wanted) = text.strip_prefix("expected ") {
        return (
            format!("found `{}`", shown(found)),
            Some(wanted.replace("value", "a value").replace("ident", "a word of JSON")),
        );
    }
    let named = |start: &str| text.strip_prefix(start).map(|name| name.trim_end_matches('`'));
    if let Some(name) = named("missing field `") {
        return (format!("the property `{}` is missing", excerpt(name)), None);
    }
    if let Some(name) = named("duplicate field `") {
        return (format!("the property `{}` is given twice", excerpt(name)), None);
    }
    let message = match text {
        "key must be a string" => {
            return (format!("found `{}`", shown(found)), Some("a name in quotes".into()));
        }
        "trailing comma" => "nothing follows the comma",
        "trailing characters" => "something follows the end of the JSON",
        "invalid number" => "this is not a number",
        "recursion limit exceeded" => "lists and objects nest too deeply",
        _ if text.starts_with("EOF") => "the text ends too early",
        _ if text.starts_with("control character") => "a line or control character within quotes",
        _ if text.contains("escape") || text.contains("code point") => "a `\\` that stands for no character",
        other => other,
    };
    (message.to_owned(), None)
}

/// `integer `3`, expected a sequence`
fn mismatch(text: &str) -> (String, Option<String>) {
    let (found, expected) = text.split_once(", expected ").unwrap_or((text, ""));
    let quoted = found.split_once('`').map_or(found, |(_, value)| value.trim_end_matches('`'));
    let found = match found.split_whitespace().next() {
        Some("integer" | "floating") => format!("the number {quoted}"),
        Some("boolean") => quoted.to_owned(),
        Some("string") => format!("the text {}", excerpt(found.trim_start_matches("string "))),
        Some("map") => "an object".to_owned(),
        Some("sequence") => "a list".to_owned(),
        Some(count) if count.parse::<u64>().is_ok() => format!("a list of length {count}"),
        _ => found.to_owned(),
    };
    let expected = match expected {
        "u8" | "u16" | "u32" | "u64" | "usize" | "index into child of root" => {
            "a whole number, at least 0".to_owned()
        }
        "f32" | "f64" => "a number".to_owned(),
        "a boolean" => "true or false".to_owned(),
        "a sequence" => "a list".to_owned(),
        "a string" => "a text in quotes".to_owned(),
        "a map" => "an object".to_owned(),
        "fewer elements in array" => "a shorter one".to_owned(),
        other if other.starts_with("struct ") => "an object".to_owned(),
        other => match other.strip_prefix("any of: [").and_then(|list| list.strip_suffix(']')) {
            Some(list) => format!("one of {list}"),
            None => other.replace("an array of", "a list of"),
        },
    };
    (format!("found {found}"), (!expected.is_empty()).then_some(expected))
}

fn shown(found: &[u8]) -> String {
    excerpt(&found.escape_ascii().to_string())
}
