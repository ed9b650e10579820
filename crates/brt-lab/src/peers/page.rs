//! The findings as a page that needs nothing from outside.

use super::entrant::Class;
use super::findings::{Findings, Row, Strip};
use super::history_charts;
use super::table::{TITLES, cells};
use crate::plot::escape;

/// The laboratory's pages look alike.
const STYLE: &str = include_str!("../paper/page.css");
/// What this page has beyond.
const OWN_STYLE: &str = "th.n { text-align: right; white-space: nowrap; } tbody th { font-weight: 400; white-space: nowrap; }
td.n { white-space: nowrap; } tr.ours th, tr.ours td { background: var(--band); } tr.group th { font-weight: 600; }
.strip { display: flex; flex-wrap: wrap; gap: .8rem; margin: .8rem 0 1.6rem; }
.strip figure { margin: 0; width: 208px; } .strip figcaption { font-size: .88rem; color: var(--soft); }
.strip img { display: block; width: 208px; height: auto; }
";

/// The page as text.
pub(super) fn html(findings: &Findings) -> String {
    let mut html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>brt and its peers</title>\n<style>\n{STYLE}{OWN_STYLE}</style>\n</head>\n<body>\n\
         <h1>The same scenes, side by side</h1>\n"
    );
    html.push_str(&explanation(findings.repeat));
    html.push_str(&list("Conditions", &findings.conditions));
    for scene in scenes(findings) {
        html.push_str(&section(findings, scene));
    }
    html.push_str(&history_charts::section(&findings.history, &findings.processor));
    html.push_str(&list("Remarks", &findings.notes));
    html.push_str("</body>\n</html>\n");
    html
}

fn explanation(repeat: u32) -> String {
    let runs = if repeat == 1 { "one run".to_owned() } else { format!("medians of {repeat} runs") };
    format!(
        "<p>Each program renders each scene with one thread and writes no picture. Times are processor time in user mode \
         without the start-up (a picture of 16×16), per pixel: {runs}, the programs taking turns; runs of more than five \
         seconds are not repeated. <b>×&nbsp;full</b> and <b>×&nbsp;certified</b>: how many times as long as our \
         <code>--method full</code> (every pixel traced) and <code>--method certified</code> (every pixel within 1 level of that) in the same group. \
         <b>Mean / RMS</b>: difference in levels of 255 of linear values, over all pixels and channels, and the same <b>in \
         sRGB</b>; <b>over 2</b>: share of the pixels where a channel differs by more than 2 levels (linear). With one sample \
         the difference is from our <code>full</code>, anti-aliased from <code>full</code> with 256 samples per pixel, measured \
         at the first size. In pictures of differences black is none, violet 1 level, red \
         to yellow more. All numbers: <a href=\"peers.csv\">peers.csv</a>.</p>\n"
    )
}

fn list(title: &str, lines: &[String]) -> String {
    if lines.is_empty() {
        return String::new();
    }
    let items: String = lines.iter().map(|line| format!("<li>{}</li>\n", escape(line))).collect();
    format!("<h2>{title}</h2>\n<ul>\n{items}</ul>\n")
}

fn scenes(findings: &Findings) -> Vec<&str> {
    let mut scenes: Vec<&str> = findings.rows.iter().map(|row| row.scene.as_str()).collect();
    scenes.dedup();
    scenes
}

fn section(findings: &Findings, scene: &str) -> String {
    let titles: String = TITLES.iter().map(|title| format!("<th class=\"n\">{title}</th>")).collect();
    let mut html = format!(
        "<h2>{}</h2>\n<div class=\"scroll\"><table>\n<thead><tr><th>program</th>{titles}</tr></thead>\n<tbody>\n",
        escape(scene)
    );
    for class in Class::ALL {
        for task in findings.tasks().into_iter().filter(|(name, _)| *name == scene) {
            let [width, height] = task.1;
            let rows: String = findings.rows_of(task, class).map(|row| table_row(findings, row)).collect();
            if !rows.is_empty() {
                html.push_str(&format!(
                    "<tr class=\"group\"><th colspan=\"8\">{width} × {height}, {}</th></tr>\n{rows}",
                    class.name()
                ));
            }
        }
    }
    html.push_str("</tbody></table></div>\n");
    for strip in findings.pictures.iter().filter(|strip| strip.scene == scene) {
        html.push_str(&pictures(strip));
    }
    html
}

fn table_row(findings: &Findings, row: &Row) -> String {
    let ours = if row.entrant.name.starts_with("brt") { " class=\"ours\"" } else { "" };
    let cells: String =
        cells(findings, row).iter().map(|cell| format!("<td class=\"n\">{cell}</td>")).collect();
    format!("<tr{ours}><th>{}</th>{cells}</tr>\n", escape(row.entrant.name))
}

fn pictures(strip: &Strip) -> String {
    let figures: String = strip
        .pictures
        .iter()
        .map(|(caption, image)| {
            format!("<figure>{image}<figcaption>{}</figcaption></figure>\n", escape(caption))
        })
        .collect();
    format!("<div class=\"strip\">\n{figures}</div>\n")
}

#[cfg(test)]
mod tests {
    use super::super::findings::tests::example;
    use super::*;

    #[test]
    fn the_page_shows_everything_and_escapes_it() {
        let page = html(&example());
        for part in ["Processor &lt;1&gt;", "a &amp; b", "POV-Ray +A0.1 +AM2", ">2.50</td>", "<img alt=\"\">"]
        {
            assert!(page.contains(part), "{part}");
        }
        assert!(!page.contains("http"), "needs nothing from outside");
        assert_eq!(page.matches("<tr").count(), 1 + 2 + 10);
    }
}
