//! What a file says and we leave out, once per kind: how often, and where first.

use std::collections::HashMap;
use std::ops::Range;

use brt_scene::{Diagnostic, Report};

/// Kinds beyond this number are only counted: a hostile file may have a new one in every line.
const MOST_KINDS: usize = 50;

/// The notices under construction, in the order of their first place.
#[derive(Default)]
pub(crate) struct Notices {
    kinds: Vec<Kind>,
    index: HashMap<String, usize>,
    beyond: u64,
}

struct Kind {
    what: String,
    count: u64,
    place: Place,
}

/// Where something is.
#[derive(Clone, Debug)]
pub(crate) enum Place {
    /// A part of the file that has a name, such as `node 3`.
    Part(String),
    /// Bytes of the file's text.
    Text(Range<usize>),
    /// Nowhere in particular.
    Whole,
}

impl From<String> for Place {
    fn from(part: String) -> Self {
        Self::Part(part)
    }
}

impl From<Range<usize>> for Place {
    fn from(span: Range<usize>) -> Self {
        Self::Text(span)
    }
}

impl Notices {
    /// One more of a kind. `what` is a sentence without a full stop that fits behind `12 ×`.
    pub(crate) fn note(&mut self, what: &str, place: impl Into<Place>) {
        self.note_many(what, 1, place);
    }

    /// So many more of a kind.
    pub(crate) fn note_many(&mut self, what: &str, count: u64, place: impl Into<Place>) {
        if count == 0 {
            return;
        }
        if let Some(&i) = self.index.get(what) {
            self.kinds[i].count += count;
        } else if self.kinds.len() < MOST_KINDS {
            self.index.insert(what.to_owned(), self.kinds.len());
            self.kinds.push(Kind { what: what.to_owned(), count, place: place.into() });
        } else {
            self.beyond += count;
        }
    }

    /// Something about the whole file.
    pub(crate) fn say(&mut self, what: &str) {
        self.note_many(what, 1, Place::Whole);
    }

    pub(crate) fn into_report(self) -> Report {
        let mut diagnostics: Vec<Diagnostic> = self.kinds.into_iter().map(Kind::into_warning).collect();
        if self.beyond > 0 {
            diagnostics.push(Diagnostic::warning(format!("{} × other things ignored", self.beyond), None));
        }
        Report { diagnostics }
    }
}

impl Kind {
    fn into_warning(self) -> Diagnostic {
        let Self { what, count, place } = self;
        let counted = if count == 1 { what } else { format!("{count} × {what}") };
        match (place, count) {
            (Place::Whole, _) => Diagnostic::warning(counted, None),
            (Place::Part(part), 1) => Diagnostic::warning(format!("{counted}, at {part}"), None),
            (Place::Part(part), _) => Diagnostic::warning(format!("{counted}, first at {part}"), None),
            (Place::Text(span), _) => Diagnostic::warning(counted, Some(span)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_is_said_once_with_its_count_and_first_place() {
        let mut notices = Notices::default();
        for node in 3..15 {
            notices.note("KHR_materials_clearcoat ignored", format!("node {node}"));
        }
        notices.note("no `mtllib` is read", 5..9);
        notices.say("odd");
        let report = notices.into_report();
        let messages: Vec<&str> = report.diagnostics.iter().map(|d| d.message.as_str()).collect();
        assert_eq!(
            messages,
            ["12 × KHR_materials_clearcoat ignored, first at node 3", "no `mtllib` is read", "odd"]
        );
        assert_eq!(report.diagnostics[1].span, Some(5..9));
    }

    #[test]
    fn a_new_kind_in_every_line_does_not_fill_the_memory() {
        let mut notices = Notices::default();
        for i in 0..1000 {
            notices.note(&format!("kind {i}"), i..i + 1);
        }
        let report = notices.into_report();
        assert_eq!(report.diagnostics.len(), MOST_KINDS + 1);
        assert_eq!(report.diagnostics[MOST_KINDS].message, "950 × other things ignored");
    }
}
