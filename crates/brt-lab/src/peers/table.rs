//! The findings as text: a table for people, and a file for programs.

use super::entrant::Class;
use super::findings::{Findings, Row, percent_over_2};

/// What the columns of the file are called.
pub(super) const COLUMNS: &str = "scene,width,height,entrant,class,runs,start_up_ms,ns_per_pixel,ns_per_pixel_min,\
                                  ns_per_pixel_max,ratio_to_full,ratio_to_certified,mean_error,percent_over_2";

/// The file.
pub(super) fn csv(findings: &Findings) -> String {
    let mut text = format!("{COLUMNS}\n");
    for row in &findings.rows {
        let [min, max] = row.range().map_or([None; 2], |range| range.map(Some));
        let number = |x: Option<f64>| x.map_or(String::new(), |x| format!("{x:.6}"));
        let fields = [
            quoted(&row.scene),
            row.size[0].to_string(),
            row.size[1].to_string(),
            quoted(row.entrant.name),
            quoted(row.entrant.class.name()),
            row.ns_per_pixel.len().to_string(),
            number(Some(1e3 * row.start_up)),
            number(row.median()),
            number(min),
            number(max),
            number(findings.ratio(row, "brt full")),
            number(findings.ratio(row, "brt certified")),
            number(row.error.map(|e| e.mean_error)),
            number(row.error.map(|e| percent_over_2(&e))),
        ];
        text.push_str(&fields.join(","));
        text.push('\n');
    }
    text
}

/// A field of the file.
fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// What a row shows to people: time, its range, ratios, errors.
pub(super) fn cells(findings: &Findings, row: &Row) -> [String; 6] {
    let ratio = |x: Option<f64>| x.map_or(String::new(), |x| format!("{x:.2}"));
    let range = row.range().map_or(String::new(), |[min, max]| format!("{min:.0}–{max:.0}"));
    [
        row.median().map_or("–".to_owned(), |x| format!("{x:.0}")),
        range,
        ratio(findings.ratio(row, "brt full")),
        ratio(findings.ratio(row, "brt certified")),
        row.error.map_or(String::new(), |e| format!("{:.3}", e.mean_error)),
        row.error.map_or(String::new(), |e| format!("{:.2} %", percent_over_2(&e))),
    ]
}

/// Titles of the cells.
pub(super) const TITLES: [&str; 6] =
    ["ns/pixel", "min–max", "× full", "× certified", "mean error", "over 2 levels"];

/// The table for a terminal.
pub(super) fn text(findings: &Findings) -> String {
    let mut text = String::new();
    for task in findings.tasks() {
        let (scene, [width, height]) = task;
        for class in Class::ALL {
            let rows: Vec<&Row> = findings.rows_of(task, class).collect();
            if rows.is_empty() {
                continue;
            }
            text.push_str(&line(
                &format!("{scene} {width}×{height}, {}", class.name()),
                &TITLES.map(str::to_owned),
            ));
            for row in rows {
                text.push_str(&line(&format!("  {}", row.entrant.name), &cells(findings, row)));
            }
            text.push('\n');
        }
    }
    text.trim_end().to_owned()
}

fn line(name: &str, cells: &[String; 6]) -> String {
    let [time, range, full, certified, error, over] = cells;
    format!("{name:<44}{time:>10}{range:>15}{full:>10}{certified:>13}{error:>12}{over:>15}\n")
}

#[cfg(test)]
mod tests {
    use super::super::findings::tests::example;
    use super::*;

    #[test]
    fn the_file_has_a_field_for_each_column() {
        let text = csv(&example());
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], COLUMNS);
        assert_eq!(lines.len(), 1 + 10);
        assert_eq!(
            lines[4],
            "\"a,b\",32,32,POV-Ray,one sample per pixel,3,2.000000,250.000000,225.000000,275.000000,2.500000,1.250000,\
             0.250000,0.500000"
        );
    }

    #[test]
    fn the_table_has_a_part_for_each_class() {
        let text = text(&example());
        assert!(text.starts_with("a,b 32×32, one sample per pixel"));
        assert!(text.lines().any(|line| line.contains("Tachyon -aasamples 12") && line.contains("495–605")));
        let widths: Vec<usize> = text.lines().filter(|l| !l.is_empty()).map(|l| l.chars().count()).collect();
        assert!(widths.iter().all(|width| *width == widths[0]), "{widths:?}");
    }
}
