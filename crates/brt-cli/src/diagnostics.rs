//! Draws what an importer has to say: file, line, the line itself, what was expected.

use std::ops::Range;

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};
use brt::{Diagnostic, Report, Severity};

use crate::output;

/// A line longer than this many bytes is cut around its place: meshes may stand on one line.
const LONG_LINE: usize = 120;
/// What is kept of a long line before the place, and from it on.
const KEPT: [usize; 2] = [40, 70];

/// The report as text for standard error.
pub(crate) fn draw(report: &Report, name: &str, text: &str) -> String {
    let renderer = if output::errors_have_color() { Renderer::styled() } else { Renderer::plain() };
    draw_with(&renderer.decor_style(DecorStyle::Ascii), report, name, text)
}

fn draw_with(renderer: &Renderer, report: &Report, name: &str, text: &str) -> String {
    let draw_one = |diagnostic: &Diagnostic| renderer.render(&[group(diagnostic, name, text)]);
    report.diagnostics.iter().map(draw_one).collect::<Vec<_>>().join("\n\n")
}

fn group<'a>(diagnostic: &'a Diagnostic, name: &'a str, text: &'a str) -> Group<'a> {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let Some(span) = diagnostic.span.as_ref().filter(|span| span.start <= text.len()) else {
        let expected = diagnostic.expected.iter().map(|e| Level::NOTE.message(format!("expected {e}")));
        return level.primary_title(&diagnostic.message).element(Origin::path(name)).elements(expected);
    };
    let place = Place::of(span, text);
    let label = diagnostic.expected.as_ref().map(|expected| format!("expected {expected}"));
    let mark = AnnotationKind::Primary.span(place.mark.clone()).label(label);
    let snippet = Snippet::source(place.excerpt).line_start(place.line).annotation(mark);
    let title = level.primary_title(&diagnostic.message);
    if place.is_cut {
        // The snippet alone would count the column from where it was cut.
        let origin = Origin::path(name).line(place.line).char_column(place.column);
        return title.element(origin).element(snippet);
    }
    title.element(snippet.path(name))
}

/// Where a span is, and what is shown of its first line.
#[derive(Debug, PartialEq)]
struct Place {
    /// Counted from 1.
    line: usize,
    /// In characters, counted from 1.
    column: usize,
    excerpt: String,
    is_cut: bool,
    /// In the excerpt.
    mark: Range<usize>,
}

impl Place {
    fn of(span: &Range<usize>, text: &str) -> Self {
        let start = text.floor_char_boundary(span.start);
        let line_start = text[..start].rfind('\n').map_or(0, |i| i + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |i| start + i);
        let line_end = line_start + text[line_start..line_end].trim_end_matches('\r').len();
        let start = start.min(line_end);
        let end = text.ceil_char_boundary(span.end.min(line_end)).max(start);

        let (mut from, mut to) = (line_start, line_end);
        if line_end - line_start > LONG_LINE {
            from = text.floor_char_boundary(start.saturating_sub(KEPT[0])).max(line_start);
            to = text.ceil_char_boundary((start + KEPT[1]).min(line_end));
        }
        let before = if from > line_start { "…" } else { "" };
        let after = if to < line_end { "…" } else { "" };
        let shift = |i: usize| i.min(to) - from + before.len();
        Self {
            line: text[..line_start].bytes().filter(|&b| b == b'\n').count() + 1,
            column: text[line_start..start].chars().count() + 1,
            excerpt: format!("{before}{}{after}", &text[from..to]),
            is_cut: from > line_start,
            mark: shift(start)..shift(end),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(diagnostic: Diagnostic, text: &str) -> String {
        let report = Report { diagnostics: vec![diagnostic] };
        draw_with(&Renderer::plain().decor_style(DecorStyle::Ascii), &report, "a.toml", text)
    }

    #[test]
    fn the_line_itself_and_what_was_expected_are_shown() {
        let text = "size = [1, 1]\nradius = -1\nx = 2\n";
        let diagnostic = Diagnostic::error("`radius` is -1", Some(23..25)).expecting("a number above 0");
        let drawn = drawn(diagnostic, text);
        for part in
            ["error: `radius` is -1", "a.toml:2:10", "2 | radius = -1", "^^ expected a number above 0"]
        {
            assert!(drawn.contains(part), "{part:?} is missing:\n{drawn}");
        }
        assert!(!drawn.contains("x = 2"));
    }

    #[test]
    fn huge_lines_are_cut_around_the_place() {
        let text = format!("first\np = [{}oops, {}]\n", "1, ".repeat(100_000), "2, ".repeat(100_000));
        let at = text.find("oops").unwrap();
        let place = Place::of(&(at..at + 4), &text);
        assert_eq!((place.line, place.column), (2, at - 5));
        assert_eq!(&place.excerpt[place.mark.clone()], "oops");
        assert!(place.excerpt.len() < 130);
        let drawn = drawn(Diagnostic::error("bad", Some(at..at + 4)), &text);
        assert!(
            drawn.lines().all(|l| l.len() < 200) && drawn.contains(&format!("a.toml:2:{}", at - 5)),
            "{drawn}"
        );
    }

    #[test]
    fn spans_over_lines_ends_and_characters_do_no_harm() {
        let text = "ä = 1\r\nö\n";
        for start in 0..=text.len() + 2 {
            for end in start..=text.len() + 3 {
                drawn(Diagnostic::warning("odd", Some(start..end)).expecting("less"), text);
            }
        }
        drawn(Diagnostic::error("empty", Some(0..0)), "");
        drawn(Diagnostic::error("nowhere", None).expecting("a place"), text);
    }

    #[test]
    fn control_characters_of_the_file_are_not_drawn() {
        let drawn = drawn(Diagnostic::error("bad\u{1b}[2J", Some(0..1)), "\u{1b}[31m = 1\n");
        assert!(!drawn.contains('\u{1b}'), "{drawn:?}");
    }
}
