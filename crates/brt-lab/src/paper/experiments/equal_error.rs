//! Beyond the paper: how many pixels are traced for the same error. Paper: P9, P15.

use brt::Method;

use super::{Figure, drawn, look_of};
use crate::paper::PaperError;
use crate::paper::contenders::Selection;
use crate::paper::findings::Findings;
use crate::paper::fit::at;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::error;
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Line};

/// From nearly everything traced to judgement by history alone, in levels.
pub(super) const SWEEP: [f64; 14] =
    [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 11.0, 16.0, 23.0, 32.0, 64.0, 128.0];
/// The mean error at which methods are compared, unless one never reaches it.
const TARGET: f64 = 0.2;
/// Share of the lesser of the greatest errors that serves then.
const OF_REACHED: f64 = 0.9;
/// Deviation by the paper's figures; variance is the same curve at other Δ.
const SHOWN: [Selection; 3] = [Selection::Deviation, Selection::Difference, Selection::Psrt];

pub(super) fn equal_error(
    lab: &Lab,
    subjects: &Subjects,
    findings: &mut Findings,
) -> Result<Figure, PaperError> {
    let size = lab.picture_size(512);
    let mut table = Table::new("equal_error", &["scene", "method", "delta", "mean_error", "traced_percent"]);
    for subject in &subjects.main {
        lab.doing(&format!("Equal error: {}", subject.name));
        let full = lab.picture(&subject.scene, &square(size, Method::Full))?;
        for selection in SHOWN {
            for delta in SWEEP {
                let picture = lab.picture(&subject.scene, &square(size, selection.method(delta)))?;
                let mean = error(&picture.colors, &full.colors).mean_error;
                let traced = picture.traced_percent();
                table.push([
                    (&subject.name).into(),
                    selection.key().into(),
                    delta.into(),
                    mean.into(),
                    traced.into(),
                ]);
            }
        }
    }
    findings.add(table);
    note(&subjects.names(), findings);
    Ok(figure(&subjects.names(), size, findings))
}

fn points(findings: &Findings, scene: &str, selection: Selection) -> Vec<(f64, f64)> {
    let fields = [("scene", scene), ("method", selection.key())];
    findings.points("equal_error", &fields, "mean_error", "traced_percent")
}

fn note(names: &[String], findings: &mut Findings) {
    for scene in names {
        let curves = SHOWN.map(|s| points(findings, scene, s));
        let target = target(&curves);
        findings.note("equal_error", format!("equal-error/{scene}"), Some(target));
        let traced = curves.map(|curve| at(&curve, target));
        for (selection, traced) in SHOWN.iter().zip(traced) {
            findings.note(
                "equal_error",
                format!("traced-at-equal-error/{}/{scene}", selection.key()),
                traced,
            );
        }
        let ratio = traced[0].zip(traced[2]).map(|(brt, psrt)| brt / psrt);
        findings.note("equal_error", format!("brt-traced-over-psrt-at-equal-error/{scene}"), ratio);
    }
}

/// An error that all curves reach.
pub(super) fn target(curves: &[Vec<(f64, f64)>]) -> f64 {
    let greatest = |curve: &Vec<(f64, f64)>| curve.iter().map(|p| p.0).fold(0.0, f64::max);
    let reached = curves.iter().map(greatest).fold(f64::INFINITY, f64::min);
    TARGET.min(OF_REACHED * reached)
}

fn figure(names: &[String], size: u32, findings: &Findings) -> Figure {
    let chart = |scene: &String| Chart {
        title: format!("{scene}, N = {size}"),
        x: Axis::linear("mean error in levels of 255"),
        y: Axis::linear("traced pixels, %"),
        lines: SHOWN
            .iter()
            .map(|&s| {
                let name = if s == Selection::Deviation { "BRT, deviation or variance" } else { s.label() };
                Line { name: name.to_owned(), points: points(findings, scene, s), look: look_of(s) }
            })
            .collect(),
    };
    let sentence = |scene: &String| {
        format!(
            "{scene} at error {}: BRT {} %, PSRT {} % (ratio {})",
            findings.show(&format!("equal-error/{scene}"), 2),
            findings.show(&format!("traced-at-equal-error/border-deviation/{scene}"), 1),
            findings.show(&format!("traced-at-equal-error/pixel-selected/{scene}"), 1),
            findings.show(&format!("brt-traced-over-psrt-at-equal-error/{scene}"), 2)
        )
    };
    Figure {
        id: "equal-error",
        heading: format!("At equal error instead of equal Δ (N = {size})"),
        paper: "Not in the paper, which compares at equal Δ. A Δ means something else to each method, so this is the fair \
                comparison: further left and lower is better.",
        parts: drawn(&names.iter().map(chart).collect::<Vec<_>>()),
        caption: format!(
            "Δ from 0.5 to 128. {}. Error {TARGET} is read off between the points, or {OF_REACHED} of what the least \
             wrong method reaches at most.",
            names.iter().map(sentence).collect::<Vec<_>>().join("; ")
        ),
        table: "equal_error",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_compared_where_all_methods_reach_them() {
        assert_eq!(target(&[vec![(0.1, 9.0), (0.5, 7.0)], vec![(0.4, 8.0)]]), TARGET);
        assert_eq!(target(&[vec![(0.5, 7.0)], vec![(0.1, 8.0)]]), 0.9 * 0.1);
    }
}
