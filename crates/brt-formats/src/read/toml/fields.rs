//! Reads the fields of one table by name, and says what is missing, wrong or unknown.

use std::ops::Range;

use brt_scene::Diagnostic;
use toml::de::{DeTable, DeValue};

use super::value::{Value, mismatch};
use crate::common::{Problems, excerpt};

/// One table of the file under reading.
pub(super) struct Fields<'v, 'a, 'p> {
    table: &'v DeTable<'a>,
    span: Option<Range<usize>>,
    /// What the table describes, for messages.
    what: &'static str,
    pub(super) problems: &'p mut Problems,
}

impl<'v, 'a, 'p> Fields<'v, 'a, 'p> {
    /// The fields of the whole file.
    pub(super) fn of_file(table: &'v DeTable<'a>, problems: &'p mut Problems) -> Self {
        Self { table, span: None, what: "the file", problems }
    }

    /// The fields of a value that must be a table.
    pub(super) fn of_value(
        value: &'v Value<'a>,
        what: &'static str,
        problems: &'p mut Problems,
    ) -> Option<Self> {
        let DeValue::Table(table) = value.get_ref() else {
            problems.push(mismatch(value, &format!("a table that describes {what}")));
            return None;
        };
        Some(Self { table, span: Some(value.span()), what, problems })
    }

    /// Says more precisely what the table describes.
    pub(super) fn now_called(&mut self, what: &'static str) {
        self.what = what;
    }

    /// The field's value, if it is there.
    pub(super) fn value(&self, key: &str) -> Option<&'v Value<'a>> {
        self.table.get(key)
    }

    /// A field that must be there. `None`: it is not or is wrong, and that was said.
    pub(super) fn required<T>(
        &mut self,
        key: &str,
        read: impl FnOnce(&Value) -> Result<T, Diagnostic>,
    ) -> Option<T> {
        match self.value(key) {
            Some(value) => self.accept(read(value)),
            None => self.missing(key),
        }
    }

    /// A field that may be left out. `None`: it is wrong, and that was said.
    pub(super) fn or<T>(
        &mut self,
        key: &str,
        default: T,
        read: impl FnOnce(&Value) -> Result<T, Diagnostic>,
    ) -> Option<T> {
        match self.value(key) {
            Some(value) => self.accept(read(value)),
            None => Some(default),
        }
    }

    /// Says that a field is missing.
    pub(super) fn missing<T>(&mut self, key: &str) -> Option<T> {
        let message = format!("{} has no `{key}`", self.what);
        self.problems.push(Diagnostic::error(message, self.span.clone()).expecting(format!("`{key} = ...`")));
        None
    }

    /// Says that every field other than these is unknown, until there are enough errors.
    pub(super) fn only(&mut self, known: &[&[&str]]) {
        for key in self.table.keys() {
            let name = key.get_ref().as_ref();
            let mut names = known.iter().flat_map(|group| group.iter().copied());
            if names.clone().any(|k| k == name) {
                continue;
            }
            if self.problems.is_full() {
                return;
            }
            let guess = did_you_mean(name, names.clone());
            let message = format!("{} has no field `{}`{guess}", self.what, excerpt(name));
            let list = names.by_ref().map(|k| format!("`{k}`")).collect::<Vec<_>>().join(", ");
            self.problems
                .push(Diagnostic::error(message, Some(key.span())).expecting(format!("one of {list}")));
        }
    }

    fn accept<T>(&mut self, read: Result<T, Diagnostic>) -> Option<T> {
        read.map_err(|diagnostic| self.problems.push(diagnostic)).ok()
    }
}

/// ", did you mean `radius`?" where one of the words is close, else nothing.
pub(super) fn did_you_mean<'w>(found: &str, words: impl Iterator<Item = &'w str>) -> String {
    /// Longer words are no slips of the pen, and the comparison costs the product of both lengths.
    const LONGEST: usize = 40;
    /// Similarity of Jaro and Winkler, from which a word counts as meant.
    const CLOSE: f64 = 0.8;
    if found.len() > LONGEST {
        return String::new();
    }
    let closeness = |word: &'w str| (strsim::jaro_winkler(&found.to_lowercase(), word), word);
    let best = words.map(closeness).max_by(|(a, _), (b, _)| a.total_cmp(b));
    match best {
        Some((close, word)) if close >= CLOSE => format!(", did you mean `{word}`?"),
        _ => String::new(),
    }
}
