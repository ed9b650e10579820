//! The findings as text: a table for people, and a file for programs.

use super::deviation::Amount;
use super::entrant::Class;
use super::findings::{Findings, Row};
use crate::csv_text;

/// What the columns of the file are called.
pub(super) const COLUMNS: &str = "scene,width,height,entrant,class,runs,start_up_ms,ns_per_pixel,ns_per_pixel_min,\
                                  ns_per_pixel_max,ratio_to_full,ratio_to_certified,mean_error,percent_over_2,\
                                  rms_error,mean_error_srgb,rms_error_srgb";

/// The file.
pub(super) fn csv(findings: &Findings) -> String {
    let fields = |row: &Row| {
        let [min, max] = row.range().map_or([None; 2], |range| range.map(Some));
        let number = |x: Option<f64>| x.map_or(String::new(), |x| format!("{x:.6}"));
        [
            row.scene.clone(),
            row.size[0].to_string(),
            row.size[1].to_string(),
            row.entrant.name.to_owned(),
            row.entrant.class.name().to_owned(),
            row.ns_per_pixel.len().to_string(),
            number(Some(1e3 * row.start_up)),
            number(row.median()),
            number(min),
            number(max),
            number(findings.ratio(row, "brt full")),
            number(findings.ratio(row, "brt certified")),
            number(row.deviation.map(|d| d.linear.mean)),
            number(row.deviation.map(|d| d.percent_over_2)),
            number(row.deviation.map(|d| d.linear.rms)),
            number(row.deviation.map(|d| d.srgb.mean)),
            number(row.deviation.map(|d| d.srgb.rms)),
        ]
    };
    format!("{COLUMNS}\n{}", csv_text::lines(findings.rows.iter().map(fields)))
}

/// What a row shows to people: time, its range, ratios, errors.
pub(super) fn cells(findings: &Findings, row: &Row) -> [String; 7] {
    let amount = |x: Option<Amount>| x.map_or(String::new(), |x| format!("{:.3} / {:.2}", x.mean, x.rms));
    let ratio = |x: Option<f64>| x.map_or(String::new(), |x| format!("{x:.2}"));
    let range = row.range().map_or(String::new(), |[min, max]| format!("{min:.0}–{max:.0}"));
    [
        row.median().map_or("–".to_owned(), |x| format!("{x:.0}")),
        range,
        ratio(findings.ratio(row, "brt full")),
        ratio(findings.ratio(row, "brt certified")),
        amount(row.deviation.map(|d| d.linear)),
        amount(row.deviation.map(|d| d.srgb)),
        row.deviation.map_or(String::new(), |d| format!("{:.2} %", d.percent_over_2)),
    ]
}

/// Titles of the cells.
pub(super) const TITLES: [&str; 7] =
    ["ns/pixel", "min–max", "× full", "× certified", "mean / RMS", "in sRGB", "over 2"];

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

fn line(name: &str, cells: &[String; 7]) -> String {
    let [time, range, full, certified, error, srgb, over] = cells;
    format!("{name:<42}{time:>9}{range:>14}{full:>9}{certified:>13}{error:>16}{srgb:>16}{over:>10}\n")
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
             0.250000,0.500000,0.750000,0.500000,1.500000"
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
