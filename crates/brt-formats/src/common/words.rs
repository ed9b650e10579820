//! Words of a text file and their places; `#` starts a comment.

use std::ops::Range;

use brt_geometry::{Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::Diagnostic;

/// The start of a text from the file, short enough for a message.
pub(crate) fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// So many points, for a message.
pub(crate) fn counted_points(count: usize) -> String {
    if count == 1 { "1 point".to_owned() } else { format!("{count} points") }
}

/// A word and its place.
#[derive(Clone, Debug)]
pub(crate) struct Word<'b> {
    pub(crate) bytes: &'b [u8],
    pub(crate) span: Range<usize>,
}

impl Word<'_> {
    /// The start of the word, fit for a message.
    pub(crate) fn excerpt(&self) -> String {
        const LONGEST: usize = 40;
        let shown = &self.bytes[..self.bytes.len().min(LONGEST)];
        let dots = if shown.len() < self.bytes.len() { "..." } else { "" };
        format!("{}{dots}", shown.escape_ascii())
    }

    /// Is it this word, in any case?
    pub(crate) fn is(&self, word: &str) -> bool {
        self.bytes.eq_ignore_ascii_case(word.as_bytes())
    }

    pub(crate) fn is_number(&self) -> bool {
        self.number().is_some()
    }

    /// The word as a finite number.
    pub(crate) fn finite(&self) -> Option<f64> {
        self.number().filter(|n| n.is_finite())
    }

    fn number(&self) -> Option<f64> {
        std::str::from_utf8(self.bytes).ok()?.parse().ok()
    }
}

/// Walks over the words; `#` starts a comment up to the end of the line.
pub(crate) struct Words<'b> {
    bytes: &'b [u8],
    at: usize,
}

impl<'b> Words<'b> {
    pub(crate) fn new(bytes: &'b [u8]) -> Self {
        Self { bytes, at: if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 } }
    }

    pub(crate) fn next(&mut self) -> Option<Word<'b>> {
        let word = self.peek()?;
        self.at = word.span.end;
        Some(word)
    }

    pub(crate) fn peek(&mut self) -> Option<Word<'b>> {
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
    pub(crate) fn skip_line(&mut self) {
        let rest = &self.bytes[self.at..];
        let is_end = |b: &u8| matches!(b, b'\n' | b'\r');
        self.at += rest.iter().position(is_end).unwrap_or(rest.len());
    }

    /// The next word, if it is on this line.
    pub(crate) fn next_on_line(&mut self) -> Option<Word<'b>> {
        if self.line_goes_on() { self.next() } else { None }
    }

    /// What is left of the line, comments and all.
    pub(crate) fn rest_of_line(&mut self) -> &'b [u8] {
        let start = self.at;
        self.skip_line();
        &self.bytes[start..self.at]
    }

    /// Is there another word on this line?
    pub(crate) fn line_goes_on(&self) -> bool {
        let rest = self.bytes[self.at..].iter();
        let mut rest = rest.skip_while(|b| matches!(b, b' ' | b'\t'));
        !matches!(rest.next(), None | Some(b'\n' | b'\r' | b'#'))
    }

    /// End of the last word read.
    pub(crate) fn position(&self) -> usize {
        self.at
    }

    /// The next word as a finite number, `what` in messages.
    pub(crate) fn number(&mut self, what: &str) -> Result<f64, Diagnostic> {
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
                let message = format!("`{}` is not a finite number", word.excerpt());
                Err(Diagnostic::error(message, Some(word.span)).expecting(what))
            }
            None => {
                let message = format!("found `{}`", word.excerpt());
                Err(Diagnostic::error(message, Some(word.span)).expecting(what))
            }
        }
    }

    pub(crate) fn vector(&mut self, what: &str) -> Result<Vec3, Diagnostic> {
        Ok(vec3(self.number(what)?, self.number(what)?, self.number(what)?))
    }

    pub(crate) fn color(&mut self, what: &str) -> Result<Rgb, Diagnostic> {
        Ok(rgb(self.number(what)?, self.number(what)?, self.number(what)?))
    }

    /// The next word as a whole number from 0 to 2³² - 1.
    pub(crate) fn whole(&mut self, what: &str) -> Result<u32, Diagnostic> {
        let before = self.peek();
        let n = self.number(what)?;
        if (0.0..=f64::from(u32::MAX)).contains(&n) && n.fract() == 0.0 {
            return Ok(n as u32);
        }
        Err(Diagnostic::error(format!("{n} is out of range"), before.map(|w| w.span)).expecting(what))
    }
}
