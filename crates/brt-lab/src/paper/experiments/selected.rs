//! Fig. 3: the share of traced pixels over the picture's side, by every reading of the judgement. Paper: P9, P5.

use super::{Figure, drawn, look_of, size_steps};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTA, Selection};
use crate::paper::findings::Findings;
use crate::paper::fit::exponent;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::traced_percent;
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Line, power_of_n};

/// Exponents of counts are fitted from here on: below, blocks of 16 pixels are too coarse for the scenes.
const FIT_FROM: f64 = 512.0;
/// The size at which the paper's methods are compared.
const PAPERS_LARGEST: u32 = 1024;

pub(super) fn fig3(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let mut table = Table::new("fig3", &["scene", "method", "size", "traced_percent", "traced", "samples"]);
    for subject in subjects.with_blocks() {
        for &size in &lab.sizes {
            lab.doing(&format!("Fig. 3: {}, N = {size}", subject.name));
            for selection in Selection::ALL {
                let stats = lab.count(&subject.scene, &square(size, selection.method(DELTA)))?;
                let (traced, total) = (stats.pixels.traced, stats.pixels.total);
                let share = traced_percent(&stats).into();
                table.push([
                    (&subject.name).into(),
                    selection.key().into(),
                    size.into(),
                    share,
                    traced.into(),
                    total.into(),
                ]);
            }
        }
    }
    findings.add(table);
    let names: Vec<String> = subjects.with_blocks().map(|s| s.name.clone()).collect();
    note(lab, &names, findings);
    Ok(figure(lab, &names, findings))
}

fn points(findings: &Findings, scene: &str, selection: Selection, y: &str) -> Vec<(f64, f64)> {
    findings.points("fig3", &[("scene", scene), ("method", selection.key())], "size", y)
}

fn note(lab: &Lab, names: &[String], findings: &mut Findings) {
    let papers = f64::from(lab.size_up_to(PAPERS_LARGEST));
    for scene in names {
        for selection in Selection::ALL {
            let traced = points(findings, scene, selection, "traced");
            let large: Vec<_> = traced.iter().copied().filter(|p| p.0 >= FIT_FROM).collect();
            let fitted = if large.len() > 1 { &large } else { &traced };
            findings.note("fig3", format!("traced-exponent/{}/{scene}", selection.key()), exponent(fitted));
            let share = points(findings, scene, selection, "traced_percent");
            let share = share.iter().find(|p| p.0 == papers).map(|p| p.1);
            findings.note("fig3", format!("traced-percent/{}/{scene}", selection.key()), share);
        }
        for reading in Selection::READINGS {
            let share = |s: Selection| findings.number(&format!("traced-percent/{}/{scene}", s.key()));
            let ratio = share(reading).zip(share(Selection::Psrt)).map(|(brt, psrt)| brt / psrt);
            findings.note("fig3", format!("brt-traced-over-psrt/{}/{scene}", reading.key()), ratio);
        }
    }
}

/// The sizes over which exponents are fitted: all, where fewer than two are large.
fn fitted_sizes(lab: &Lab) -> String {
    let large: Vec<u32> = lab.sizes.iter().copied().filter(|s| f64::from(*s) >= FIT_FROM).collect();
    let fitted = if large.len() > 1 { &large } else { &lab.sizes };
    fitted.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

fn figure(lab: &Lab, names: &[String], findings: &Findings) -> Figure {
    let charts: Vec<Chart> = names
        .iter()
        .map(|scene| Chart {
            title: format!("{scene}: traced at Δ = 16"),
            x: Axis::steps("N, side of the picture in pixels", &size_steps(lab)),
            y: Axis::logarithmic("traced pixels, %"),
            lines: Selection::ALL
                .iter()
                .map(|&s| {
                    let k = findings.number(&format!("traced-exponent/{}/{scene}", s.key()));
                    let k = k.map_or(String::new(), |k| format!(", {}", power_of_n(k)));
                    let points = points(findings, scene, s, "traced_percent");
                    Line { name: format!("{}{k}", s.label()), points, look: look_of(s) }
                })
                .collect(),
        })
        .collect();
    let exponents = |s: Selection| {
        let names: Vec<_> = names.iter().map(|n| format!("traced-exponent/{}/{n}", s.key())).collect();
        findings.show_range(&names, 2)
    };
    Figure {
        id: "fig3",
        heading: "Fig. 3: traced pixels (Δ = 16), by all readings of “variance”".to_owned(),
        paper: "BRT (solid line) traces fewer pixels than PSRT (broken line).",
        parts: drawn(&charts),
        caption: format!(
            "Exponents are those of the <em>number</em> of traced pixels over N = {}: {} for BRT by deviation, {} for \
             PSRT. Δ = 16 means 16 levels of deviation or difference, but 16 levels² of variance, which is a deviation \
             of 4 levels. All acceleration structures trace the same pixels.",
            fitted_sizes(lab),
            exponents(Selection::Deviation),
            exponents(Selection::Psrt)
        ),
        table: "fig3",
    }
}
