//! The elements after the header, one by one: so it is known which of them is broken.

use std::ops::Range;

use brt_scene::Diagnostic;
use ply_rs_bw::parser::{ParseError, Parser};
use ply_rs_bw::ply::{ElementDef, Encoding, PropertyAccess, PropertyType};

use crate::common::{Budget, excerpt};
use crate::import::{Stop, fault};

/// What follows the header.
pub(super) struct Body<'b> {
    bytes: &'b [u8],
    /// Where the next element begins.
    at: usize,
    encoding: Encoding,
}

impl<'b> Body<'b> {
    /// The elements of a file begin at a byte of it.
    pub(super) fn new(bytes: &'b [u8], at: usize, encoding: Encoding) -> Self {
        Self { bytes, at, encoding }
    }

    /// Reads all elements of a kind.
    pub(super) fn elements<E: PropertyAccess>(
        &mut self,
        kind: &ElementDef,
        budget: &Budget,
    ) -> Result<Vec<E>, Stop> {
        /// A file may say that there are more than there are.
        const MOST_RESERVED: usize = 1 << 16;
        let parser = Parser::new();
        let mut elements = Vec::with_capacity(kind.count.min(MOST_RESERVED));
        for i in 0..kind.count {
            budget.go_on()?;
            elements.push(match self.encoding {
                Encoding::Ascii => self.line(&parser, kind, i)?,
                Encoding::BinaryBigEndian | Encoding::BinaryLittleEndian => self.record(&parser, kind, i)?,
            });
        }
        Ok(elements)
    }

    /// An element that is a line of text.
    fn line<E: PropertyAccess>(
        &mut self,
        parser: &Parser<E>,
        kind: &ElementDef,
        i: usize,
    ) -> Result<E, Stop> {
        let start = self.at;
        let rest = &self.bytes[start..];
        if rest.is_empty() {
            return Err(ends_early(kind, i));
        }
        let length = rest.iter().position(|&b| b == b'\n').map_or(rest.len(), |end| end + 1);
        self.at += length;
        let line = String::from_utf8_lossy(&rest[..length]);
        parser.read_ascii_element(&line, kind).map_err(|_| odd_line(&line, start..self.at, kind))
    }

    /// An element in bytes.
    fn record<E: PropertyAccess>(
        &mut self,
        parser: &Parser<E>,
        kind: &ElementDef,
        i: usize,
    ) -> Result<E, Stop> {
        let mut rest = &self.bytes[self.at..];
        let element = match self.encoding {
            Encoding::BinaryBigEndian => parser.read_big_endian_element(&mut rest, kind),
            _ => parser.read_little_endian_element(&mut rest, kind),
        };
        self.at = self.bytes.len() - rest.len();
        element.map_err(|error| odd_record(&error, kind, i))
    }
}

fn ends_early(kind: &ElementDef, i: usize) -> Stop {
    fault(format!("the file ends after {i} of {} {}", kind.count, plural(&kind.name)), None)
}

fn odd_line(line: &str, span: Range<usize>, kind: &ElementDef) -> Stop {
    let line = line.trim();
    let found = if line.is_empty() { "an empty line".to_owned() } else { format!("`{}`", excerpt(line)) };
    let end = span.end.min(span.start + line.len().max(1));
    Diagnostic::error(format!("found {found}"), Some(span.start..end)).expecting(described(kind)).into()
}

fn odd_record(error: &ParseError, kind: &ElementDef, i: usize) -> Stop {
    match error.kind() {
        std::io::ErrorKind::UnexpectedEof => ends_early(kind, i),
        _ => Diagnostic::error(format!("element {i} of {} is broken", plural(&kind.name)), None)
            .expecting(described(kind))
            .into(),
    }
}

/// What an element consists of, as its header says.
fn described(kind: &ElementDef) -> String {
    let values = kind.properties.iter().map(|(name, property)| match property.data_type {
        PropertyType::Scalar(_) => name.clone(),
        PropertyType::List(..) => format!("COUNT {name}..."),
    });
    format!("a {}, `{}`", excerpt(&kind.name), excerpt(&values.collect::<Vec<_>>().join(" ")))
}

fn plural(name: &str) -> String {
    match name {
        "vertex" => "vertices".to_owned(),
        "face" => "faces".to_owned(),
        other => format!("elements `{}`", excerpt(other)),
    }
}
