//! The header, and what is wrong with it in plain words.

use std::io::ErrorKind;
use std::ops::Range;

use brt_scene::Diagnostic;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::Header;

use super::element::Ignored;
use crate::common::excerpt;
use crate::import::{Stop, fault};

/// The header, and where it ends.
pub(super) fn read(bytes: &[u8]) -> Result<(Header, usize), Stop> {
    let mut reader = Reader::new(bytes);
    match Parser::<Ignored>::new().read_header(&mut reader) {
        Ok(header) => Ok((header, bytes.len() - reader.into_inner().len())),
        Err(error) => Err(broken(&error, bytes)),
    }
}

/// The crate tells the line; what was expected there follows from its first word.
fn broken(error: &ParseError, bytes: &[u8]) -> Stop {
    let end = Diagnostic::error("the file ends within its header", None);
    match (error.kind(), error.line()) {
        (ErrorKind::UnexpectedEof, _) => end.expecting("`end_header`").into(),
        (_, Some(line)) => odd_line(line, bytes),
        (ErrorKind::InvalidData, None) => fault("the header is not text", None),
        (_, None) => fault("the header has no line such as `format ascii 1.0`", None),
    }
}

fn odd_line(number: usize, bytes: &[u8]) -> Stop {
    let span = line(number, bytes);
    let text = String::from_utf8_lossy(&bytes[span.clone()]);
    let expected = match text.split_whitespace().next() {
        _ if number == 1 => "`ply`",
        Some("format") => {
            "one line `format ascii 1.0`, `format binary_little_endian 1.0` or `format binary_big_endian 1.0`"
        }
        Some("element") => "`element NAME COUNT`",
        Some("property") => "`property TYPE NAME` or `property list TYPE TYPE NAME`, after an `element`",
        _ => "`format`, `comment`, `element`, `property` or `end_header`",
    };
    Diagnostic::error(format!("found `{}`", excerpt(&text)), Some(span)).expecting(expected).into()
}

/// Where a line is that has this number, counted from 1, without blanks at its ends.
fn line(number: usize, bytes: &[u8]) -> Range<usize> {
    let ends = bytes.iter().enumerate().filter(|(_, b)| **b == b'\n').map(|(i, _)| i);
    let start = ends.clone().nth(number.wrapping_sub(2)).map_or(0, |end| end + 1);
    let end = ends.clone().find(|end| *end >= start).unwrap_or(bytes.len());
    let line = bytes[start..end].trim_ascii_start();
    let start = end - line.len();
    start..start + line.trim_ascii_end().len()
}
