//! What is lost when a scene is written for a program that knows less or other things.

use std::collections::HashSet;

use brt_scene::{Diagnostic, Report};

/// Names in a message beyond this number are only counted.
const MOST_NAMES: usize = 3;

/// Losses, each with the names of all that it is about.
#[derive(Default)]
pub(crate) struct Losses(Vec<Loss>);

struct Loss {
    what: &'static str,
    /// In the scene's order.
    first_names: Vec<String>,
    names: HashSet<String>,
}

impl Losses {
    /// Something about the whole scene.
    pub(crate) fn note(&mut self, what: &'static str) {
        self.of(what);
    }

    /// The same loss for one more thing of a name.
    pub(crate) fn note_for(&mut self, what: &'static str, name: String) {
        let loss = self.of(what);
        if loss.names.contains(&name) {
            return;
        }
        if loss.names.len() < MOST_NAMES {
            loss.first_names.push(name.clone());
        }
        loss.names.insert(name);
    }

    fn of(&mut self, what: &'static str) -> &mut Loss {
        let index = self.0.iter().position(|loss| loss.what == what).unwrap_or_else(|| {
            self.0.push(Loss { what, first_names: Vec::new(), names: HashSet::new() });
            self.0.len() - 1
        });
        &mut self.0[index]
    }

    pub(crate) fn into_report(self) -> Report {
        let warning = |loss: Loss| Diagnostic::warning(loss.message(), None);
        Report { diagnostics: self.0.into_iter().map(warning).collect() }
    }
}

impl Loss {
    fn message(&self) -> String {
        let listed = self.first_names.join(", ");
        match self.names.len() {
            0 => self.what.to_owned(),
            n if n <= MOST_NAMES => format!("{}: {listed}", self.what),
            n => format!("{}: {listed} and {} more", self.what, n - MOST_NAMES),
        }
    }
}
