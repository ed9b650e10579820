//! The page: one file that needs nothing from outside.

use super::experiments::Figure;
use super::findings::Findings;
use super::lab::Lab;
use super::subjects::Subjects;
use super::verdicts::{Outcome, Verdict};
use crate::plot::escape;

const STYLE: &str = include_str!("page.css");

/// The page as text.
pub(crate) fn html(
    lab: &Lab,
    subjects: &Subjects,
    findings: &Findings,
    figures: &[Figure],
    verdicts: &[Verdict],
) -> String {
    let mut html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>Border ray tracing, 1987: measured again</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n"
    );
    html.push_str(&introduction(lab, subjects));
    html.push_str(&verdict_section(verdicts));
    for figure in figures {
        html.push_str(&section(figure));
    }
    html.push_str(&remarks(findings));
    html.push_str("</body>\n</html>\n");
    html
}

fn introduction(lab: &Lab, subjects: &Subjects) -> String {
    let sizes: Vec<String> = lab.sizes.iter().map(u32::to_string).collect();
    let scenes: String = subjects
        .main
        .iter()
        .map(|s| format!("<b>{}</b>: {}", escape(&s.name), s.title))
        .collect::<Vec<_>>()
        .join("; ");
    let quick = if lab.quick { " This is a quick look: smaller pictures, fewer repetitions." } else { "" };
    format!(
        "<h1>Border ray tracing, 1987: measured again</h1>\n\
         <p>A. Hashimoto and Y. Suenaga, <i>Border Ray-tracing: picture quality and acceleration rate</i> (NTT, 1987). \
         Every table and figure of the paper, measured on this machine by <code>brt paper</code> {}.{quick}</p>\n\
         <p>RT: standard ray tracing. BRT: border ray tracing. PSRT: pixel-selected ray tracing. Scenes: {scenes}. \
         N = {}; times are processor times of one thread, medians of {} or more (fewer for pictures that take long), the \
         methods taking turns, and gains are medians of the ratios within a turn; each file of times has the counts of rays and tests beside them. Colours are \
         judged and compared proportional to light, and shown as sRGB.</p>\n",
        env!("CARGO_PKG_VERSION"),
        sizes.join(", "),
        lab.repeat
    )
}

fn verdict_section(verdicts: &[Verdict]) -> String {
    let all = [Outcome::Holds, Outcome::Partly, Outcome::DoesNotHold, Outcome::NotMeasured];
    let counts = all.iter().filter_map(|&outcome| {
        let count = verdicts.iter().filter(|v| v.outcome == outcome).count();
        (count > 0)
            .then(|| format!("<li class=\"{}\"><b>{count}</b> {}</li>", class(outcome), outcome.name()))
    });
    let rows = verdicts.iter().map(|v| {
        format!(
            "<tr id=\"{}\"><th>{}</th><td>{}</td><td class=\"verdict {}\">{}</td><td>{} <a href=\"#{}\">figure</a></td></tr>\n",
            v.claim,
            v.claim,
            escape(v.says),
            class(v.outcome),
            v.outcome.name(),
            v.why,
            v.figure
        )
    });
    format!(
        "<h2 id=\"verdicts\">Verdicts</h2>\n<ul class=\"counts\">{}</ul>\n\
         <div class=\"scroll\"><table><thead><tr><th></th><th>the paper says</th><th>here</th><th>because</th></tr></thead>\
         <tbody>\n{}</tbody></table></div>\n\
         <p class=\"says\">By fixed rules over the measured numbers, see <a href=\"verdicts.csv\">verdicts.csv</a> and \
         <a href=\"numbers.csv\">numbers.csv</a>. Claims are numbered as in <code>docs/paper/claims.md</code>.</p>\n",
        counts.collect::<String>(),
        rows.collect::<String>()
    )
}

fn class(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Holds => "holds",
        Outcome::Partly => "partly",
        Outcome::DoesNotHold => "fails",
        Outcome::NotMeasured => "open",
    }
}

fn section(figure: &Figure) -> String {
    // Tables and sheets take the width they need; charts share it.
    let layout =
        if figure.parts.iter().all(|part| part.starts_with("<div")) { "parts wide" } else { "parts" };
    format!(
        "<h2 id=\"{}\">{}</h2>\n<p class=\"says\"><b>The paper:</b> {}</p>\n<div class=\"{layout}\">\n{}</div>\n\
         <p>{}</p>\n<p class=\"says\">Numbers: <a href=\"{table}.csv\">{table}.csv</a></p>\n",
        figure.id,
        figure.heading,
        figure.paper,
        figure.parts.join("\n"),
        figure.caption,
        table = figure.table
    )
}

fn remarks(findings: &Findings) -> String {
    if findings.remarks.is_empty() {
        return String::new();
    }
    let items: String = findings.remarks.iter().map(|r| format!("<li>{}</li>\n", escape(r))).collect();
    format!("<h2 id=\"remarks\">Left out</h2>\n<ul>\n{items}</ul>\n")
}
