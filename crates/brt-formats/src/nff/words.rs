//! Words of an NFF file and their places.

use std::ops::Range;

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::Diagnostic;

/// A word and its place.
#[derive(Clone, Debug)]
pub(super) struct Word<'b> {
    pub(super) bytes: &'b [u8],
    pub(super) span: Range<usize>,
}

impl Word<'_> {
    /// The start of the word, fit for a message.
    pub(super) fn excerpt(&self) -> String {
        const LONGEST: usize = 40;
        let shown = &self.bytes[..self.bytes.len().min(LONGEST)];
        let dots = if shown.len() < self.bytes.len() { "..." } else { "" };
        format!("{}{dots}", shown.escape_ascii())
    }

    pub(super) fn is_number(&self) -> bool {
        self.number().is_some()
    }

    fn number(&self) -> Option<f64> {
        std::str::from_utf8(self.bytes).ok()?.parse().ok()
    }
}

/// Walks over the words; `#` starts a comment up to the end of the line.
pub(super) struct Words<'b> {
    bytes: &'b [u8],
    at: usize,
}

impl<'b> Words<'b> {
    pub(super) fn new(bytes: &'b [u8]) -> Self {
        Self { bytes, at: if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 } }
    }

    pub(super) fn next(&mut self) -> Option<Word<'b>> {
        let word = self.peek()?;
        self.at = word.span.end;
        Some(word)
    }

    pub(super) fn peek(&mut self) -> Option<Word<'b>> {
        loop {
            let rest = &self.bytes[self.at..];
            self.at += rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(rest.len());
            match self.bytes.get(self.at)? {
                b'#' => self.skip_line(),
                _ => break,
            }
        }
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        Some(Word { bytes: &rest[..length], span: self.at..self.at + length })
    }

    /// Goes to the end of the line.
    pub(super) fn skip_line(&mut self) {
        let rest = &self.bytes[self.at..];
        let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
        self.at += rest.iter().position(is_end).unwrap_or(rest.len());
    }

    /// Is there another word on this line?
    pub(super) fn line_goes_on(&self) -> bool {
        let rest = self.bytes[self.at..].iter();
        let mut rest = rest.skip_while(|b| matches!(b, b' ' | b'\t'));
        !matches!(rest.next(), None | Some(b'\n' | b'\r' | b'#'))
    }

    /// End of the last word read.
    pub(super) fn position(&self) -> usize {
        self.at
    }

    /// The next word as a finite number, `what` in messages.
    pub(super) fn number(&mut self, what: &str) -> Result<f64, Diagnostic> {
        let end = self.bytes.len();
        let Some(word) = self.peek() else {
            return Err(Diagnostic::error("the file ends too early", Some(end..end)).expecting(what));
        };
        match word.number() {
            Some(n) if n.is_finite() => {
                self.at = word.span.end;
                Ok(n)
            }
            Some(_) => {
                let message = format!("`{}` is no finite number", word.excerpt());
                Err(Diagnostic::error(message, Some(word.span)).expecting(what))
            }
            None => {
                let message = format!("found `{}`", word.excerpt());
                Err(Diagnostic::error(message, Some(word.span)).expecting(what))
            }
        }
    }

    pub(super) fn vector(&mut self, what: &str) -> Result<Vec3, Diagnostic> {
        Ok(vec3(self.number(what)?, self.number(what)?, self.number(what)?))
    }

    pub(super) fn color(&mut self, what: &str) -> Result<Rgb, Diagnostic> {
        Ok(rgb(self.number(what)?, self.number(what)?, self.number(what)?))
    }

    /// The next word as a whole number from 0 to 2³² - 1.
    pub(super) fn whole(&mut self, what: &str) -> Result<u32, Diagnostic> {
        let before = self.peek();
        let n = self.number(what)?;
        if (0.0..=f64::from(u32::MAX)).contains(&n) && n.fract() == 0.0 {
            return Ok(n as u32);
        }
        Err(Diagnostic::error(format!("{n} is out of range"), before.map(|w| w.span)).expecting(what))
    }
}
