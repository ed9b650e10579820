//! Fig. 5: error and traced pixels over Δ. Paper: P13–P16.

use super::{Figure, drawn, look_of};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTAS, Selection};
use crate::paper::findings::Findings;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::{error, papers_error, unrounded_error};
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Line};
use brt::Method;

const COLUMNS: [&str; 8] = [
    "scene",
    "method",
    "delta",
    "traced_percent",
    "mean_error",
    "mean_error_unrounded",
    "max_error",
    "pixels_over_10",
];

pub(super) fn fig5(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let size = lab.picture_size(512);
    let mut table = Table::new("fig5", &COLUMNS);
    let mut formula_differs = 0.0_f64;
    for subject in &subjects.main {
        let full = lab.picture(&subject.scene, &square(size, Method::Full))?;
        for selection in Selection::ALL {
            lab.doing(&format!("Fig. 5: {}, {}", subject.name, selection.label()));
            for delta in DELTAS {
                let picture = lab.picture(&subject.scene, &square(size, selection.method(delta)))?;
                let measured = error(&picture.colors, &full.colors);
                let by_hand = papers_error(&picture.colors, &full.colors);
                formula_differs = formula_differs.max((by_hand - measured.mean_error).abs());
                let unrounded = unrounded_error(&picture.colors, &full.colors).mean_error;
                table.push([
                    (&subject.name).into(),
                    selection.key().into(),
                    delta.into(),
                    picture.traced_percent().into(),
                    measured.mean_error.into(),
                    unrounded.into(),
                    measured.max_error.into(),
                    measured.over_10.into(),
                ]);
            }
        }
    }
    findings.add(table);
    findings.note("fig5", "error-formula/greatest-difference", Some(formula_differs));
    note(&subjects.names(), findings);
    Ok(figure(&subjects.names(), size, findings))
}

fn points(findings: &Findings, scene: &str, selection: Selection, y: &str) -> Vec<(f64, f64)> {
    findings.points("fig5", &[("scene", scene), ("method", selection.key())], "delta", y)
}

fn note(names: &[String], findings: &mut Findings) {
    for scene in names {
        for selection in Selection::ALL {
            let key = selection.key();
            let errors = points(findings, scene, selection, "mean_error");
            let traced = points(findings, scene, selection, "traced_percent");
            let at = |points: &[(f64, f64)], delta: f64| points.iter().find(|p| p.0 == delta).map(|p| p.1);
            let ratio =
                |points: &[(f64, f64)], a: f64, b: f64| at(points, a).zip(at(points, b)).map(|(a, b)| a / b);
            findings.note("fig5", format!("error-at-16/{key}/{scene}"), at(&errors, 16.0));
            findings.note("fig5", format!("traced-at-16/{key}/{scene}"), at(&traced, 16.0));
            // Two equal pictures without error have saturated.
            let last_step = ratio(&errors, 128.0, 64.0).or(Some(1.0));
            findings.note("fig5", format!("error-128-over-64/{key}/{scene}"), last_step);
            findings.note("fig5", format!("error-4-over-128/{key}/{scene}"), ratio(&errors, 4.0, 128.0));
            findings.note("fig5", format!("traced-128-over-64/{key}/{scene}"), ratio(&traced, 128.0, 64.0));
            findings.note("fig5", format!("traced-128-over-4/{key}/{scene}"), ratio(&traced, 128.0, 4.0));
            findings.note("fig5", format!("best-delta/{key}/{scene}"), best_delta(&errors, &traced));
            let over = points(findings, scene, selection, "pixels_over_10");
            findings.note("fig5", format!("over-10-at-16/{key}/{scene}"), at(&over, 16.0));
        }
        for reading in Selection::READINGS {
            let error = |s: Selection| findings.number(&format!("error-at-16/{}/{scene}", s.key()));
            let ratio = error(reading).zip(error(Selection::Psrt)).map(|(brt, psrt)| brt / psrt);
            findings.note("fig5", format!("brt-error-over-psrt/{}/{scene}", reading.key()), ratio);
        }
    }
}

/// The Δ whose error and traced share, each from 0 (least on the curve) to 1 (greatest), have the least sum.
fn best_delta(errors: &[(f64, f64)], traced: &[(f64, f64)]) -> Option<f64> {
    let normal = |points: &[(f64, f64)]| {
        let (lo, hi) = points.iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), p| (lo.min(p.1), hi.max(p.1)));
        points.iter().map(|p| if hi > lo { (p.1 - lo) / (hi - lo) } else { 0.0 }).collect::<Vec<_>>()
    };
    let sums = normal(errors).into_iter().zip(normal(traced)).map(|(e, t)| e + t);
    let (_, delta) = sums.zip(errors).map(|(sum, p)| (sum, p.0)).min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(delta)
}

fn figure(names: &[String], size: u32, findings: &Findings) -> Figure {
    let chart = |scene: &str, what: &str, column: &str, label: &str| Chart {
        title: format!("{scene}: {what}, N = {size}"),
        x: Axis::steps("Δ in levels (variance: levels²)", &DELTAS),
        y: Axis::linear(label),
        lines: Selection::ALL
            .iter()
            .map(|&s| Line {
                name: s.label().to_owned(),
                points: points(findings, scene, s, column),
                look: look_of(s),
            })
            .collect(),
    };
    let charts: Vec<Chart> = names
        .iter()
        .flat_map(|scene| {
            [
                chart(scene, "traced pixels", "traced_percent", "traced pixels, %"),
                chart(scene, "error", "mean_error", "mean error in levels of 255"),
            ]
        })
        .collect();
    let errors = |s: Selection| {
        let names: Vec<_> = names.iter().map(|n| format!("error-at-16/{}/{n}", s.key())).collect();
        findings.show_range(&names, 2)
    };
    Figure {
        id: "fig5",
        heading: format!("Fig. 5: traced pixels and error over Δ (N = {size})"),
        paper: "With growing Δ the error rises from some level on, then saturates, for the judgement is then decided by the \
                histories alone; the traced share falls fast, then slowly to a constant.",
        parts: drawn(&charts),
        caption: format!(
            "Error: P12's mean of (|r − r₀| + |g − g₀| + |b − b₀|) / 3 over 8-bit values proportional to light. At Δ = 16 \
             it is {} levels for BRT by deviation, {} by variance, {} for PSRT.",
            errors(Selection::Deviation),
            errors(Selection::Variance),
            errors(Selection::Psrt)
        ),
        table: "fig5",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_best_delta_balances_error_and_traced_share() {
        let errors = [(4.0, 0.0), (16.0, 0.1), (64.0, 1.0)];
        let traced = [(4.0, 30.0), (16.0, 12.0), (64.0, 10.0)];
        // Sums: 0 + 1, 0.1 + 0.1, 1 + 0.
        assert_eq!(best_delta(&errors, &traced), Some(16.0));
        assert_eq!(best_delta(&[], &[]), None);
    }
}
