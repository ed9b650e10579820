//! Collects what there is to say about a file, and stops when it is enough.

use brt_scene::{Diagnostic, Report, Severity};

/// Errors, and warnings, beyond this number are only counted.
const MOST: usize = 20;

/// The report under construction.
#[derive(Default)]
pub(crate) struct Problems {
    diagnostics: Vec<Diagnostic>,
    errors: usize,
    warnings: usize,
}

impl Problems {
    pub(crate) fn push(&mut self, diagnostic: Diagnostic) {
        let count = match diagnostic.severity {
            Severity::Error => &mut self.errors,
            Severity::Warning => &mut self.warnings,
        };
        *count += 1;
        if *count <= MOST {
            self.diagnostics.push(diagnostic);
        }
    }

    pub(crate) fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// Enough errors to stop looking for more.
    pub(crate) fn is_full(&self) -> bool {
        self.errors >= MOST
    }

    /// The report in the file's order; what is about the whole file comes first.
    pub(crate) fn into_report(mut self) -> Report {
        self.diagnostics.sort_by_key(|d| d.span.as_ref().map(|span| span.start));
        if self.errors > MOST {
            self.diagnostics.push(Diagnostic::error(format!("{} more errors", self.errors - MOST), None));
        }
        if self.warnings > MOST {
            let more = format!("{} more warnings", self.warnings - MOST);
            self.diagnostics.push(Diagnostic::warning(more, None));
        }
        Report { diagnostics: self.diagnostics }
    }
}
