//! Acceleration by kind of primitive. Paper: P2, P18.

use brt::Method;

use super::{Figure, drawn, size_steps};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTA, Selection};
use crate::paper::findings::Findings;
use crate::paper::fit::exponent;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::traced_percent;
use crate::paper::subjects::{Subject, Subjects};
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Dash, Line, Look, Marker};

/// The table's name.
const KINDS_TABLE: &str = "kinds";
/// Sizes are compared up to this one.
const LARGEST: u32 = 1024;

pub(super) fn kinds(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let sizes: Vec<u32> = lab.sizes.iter().copied().filter(|s| *s <= lab.size_up_to(LARGEST)).collect();
    let mut table = Table::new(
        KINDS_TABLE,
        &["scene", "size", "acceleration", "seconds_full", "seconds_border", "traced_percent"],
    );
    let all: Vec<&Subject> = subjects.with_blocks().chain([&subjects.torus]).collect();
    for subject in &all {
        for &size in &sizes {
            lab.doing(&format!("Kinds of primitives: {}, N = {size}", subject.name));
            let methods = [Method::Full, Selection::Deviation.method(DELTA)];
            let timings = lab.time(&subject.scene, &methods.map(|method| square(size, method)))?;
            let (full, border) = (timings[0].seconds, timings[1].seconds);
            let traced = traced_percent(&timings[1].stats);
            let gain = timings[1].gain_over(&timings[0]);
            table.push([
                (&subject.name).into(),
                size.into(),
                gain.into(),
                full.into(),
                border.into(),
                traced.into(),
            ]);
        }
        let gains = table.points(&[("scene", &subject.name)], "size", "acceleration");
        findings.note(KINDS_TABLE, format!("kind-gain/{}", subject.name), gains.last().map(|p| p.1));
        findings.note(KINDS_TABLE, format!("kind-gain-exponent/{}", subject.name), exponent(&gains));
    }
    findings.add(table);
    Ok(figure(lab, &all, findings))
}

fn figure(lab: &Lab, all: &[&Subject], findings: &Findings) -> Figure {
    let markers = [Marker::Disc, Marker::Triangle, Marker::Diamond, Marker::Square, Marker::Ring];
    let dashes = [Dash::Solid, Dash::Solid, Dash::Solid, Dash::Broken, Dash::Dotted];
    let line = |(i, subject): (usize, &&Subject)| Line {
        name: format!("{}: {}", subject.name, subject.title),
        points: findings.points(KINDS_TABLE, &[("scene", &subject.name)], "size", "acceleration"),
        look: Look::new(i, dashes[i % 5], markers[i % 5]),
    };
    let sizes: Vec<f64> =
        size_steps(lab).into_iter().filter(|s| *s <= f64::from(lab.size_up_to(LARGEST))).collect();
    let chart = Chart {
        title: "BRT over RT, both with a hierarchy (Δ = 16)".to_owned(),
        x: Axis::steps("N, side of the picture in pixels", &sizes),
        y: Axis::logarithmic("times as fast as RT"),
        lines: all.iter().enumerate().map(line).collect(),
    };
    let gain = |subject: &&Subject| {
        format!("{} {}", subject.name, findings.show(&format!("kind-gain/{}", subject.name), 1))
    };
    Figure {
        id: "kinds",
        heading: "Acceleration by kind of primitive".to_owned(),
        paper: "Acceleration depends strongly on the kind of primitive and is largest on planes.",
        parts: drawn(&[chart]),
        caption: format!(
            "At N = {}: {} times as fast as RT.",
            lab.size_up_to(LARGEST),
            all.iter().map(gain).collect::<Vec<_>>().join(", ")
        ),
        table: KINDS_TABLE,
    }
}
