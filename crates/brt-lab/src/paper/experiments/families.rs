//! All families of speed-ups side by side: every method with every acceleration structure. Paper: P1, P2, P8.

use brt::{Method, Settings};

use super::{Figure, drawn, shown_table};
use crate::paper::PaperError;
use crate::paper::contenders::{ACCELERATORS, Family, FamilyMethod, METHODS};
use crate::paper::findings::Findings;
use crate::paper::fit::exponent;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::{traced_percent, unrounded_error};
use crate::paper::subjects::{Subject, Subjects};
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Dash, Line, Look, Marker};

/// The families are compared up to this size.
const LARGEST: u32 = 1024;
const QUICK_LARGEST: u32 = 256;

struct Contender {
    method: &'static str,
    accelerator: &'static str,
    settings: Settings,
}

pub(super) fn families(
    lab: &Lab,
    subjects: &Subjects,
    findings: &mut Findings,
) -> Result<Figure, PaperError> {
    let largest = lab.size_up_to(if lab.quick { QUICK_LARGEST } else { LARGEST });
    let sizes: Vec<u32> = lab.sizes.iter().copied().filter(|s| *s <= largest).collect();
    let columns = [
        "scene",
        "method",
        "accelerator",
        "size",
        "acceleration",
        "seconds",
        "repetitions",
        "traced_percent",
        "primitive_tests",
    ];
    let mut table = Table::new("families", &columns);
    for subject in &subjects.main {
        for &size in &sizes {
            lab.doing(&format!("Families: {}, N = {size}", subject.name));
            let contenders = affordable(lab, subject, size)?;
            let settings: Vec<Settings> = contenders.iter().map(|c| c.settings.clone()).collect();
            let timings = lab.time(&subject.scene, &settings)?;
            let is_base = |c: &Contender| c.method == "full" && c.accelerator == "none";
            let base = contenders.iter().position(is_base).map(|i| &timings[i]);
            for (c, timing) in contenders.iter().zip(&timings) {
                let gain = base.map_or("–".into(), |base| timing.gain_over(base).into());
                table.push([
                    (&subject.name).into(),
                    c.method.into(),
                    c.accelerator.into(),
                    size.into(),
                    gain,
                    timing.seconds.into(),
                    timing.repetitions().into(),
                    traced_percent(&timing.stats).into(),
                    timing.stats.primitive_tests.into(),
                ]);
            }
        }
    }
    findings.add(table);
    note(&subjects.names(), largest, findings);
    exactness(lab, subjects, findings)?;
    Ok(figure(subjects, &sizes, findings))
}

/// All pairs that are built and do not take too long.
fn affordable(lab: &Lab, subject: &Subject, size: u32) -> Result<Vec<Contender>, PaperError> {
    let mut contenders = Vec::new();
    for (name, accelerator) in ACCELERATORS {
        let Some(accelerator) = accelerator else { continue };
        let base = Settings { accelerator, ..square(size, Method::Full) };
        if !lab.affords(lab.foreseen(&subject.scene, &base)?) {
            continue;
        }
        contenders.extend(built().map(|(m, method)| Contender {
            method: m.name,
            accelerator: name,
            settings: Settings { method, ..base.clone() },
        }));
    }
    Ok(contenders)
}

fn built() -> impl Iterator<Item = (FamilyMethod, Method)> {
    METHODS.into_iter().filter_map(|m| m.method.map(|method| (m, method())))
}

fn note(names: &[String], largest: u32, findings: &mut Findings) {
    let size = largest.to_string();
    for scene in names {
        for (accelerator, _) in ACCELERATORS {
            for method in METHODS {
                let fields =
                    [("scene", scene.as_str()), ("method", method.name), ("accelerator", accelerator)];
                let key = format!("{}/{accelerator}/{scene}", method.name);
                let times = findings.points("families", &fields, "size", "seconds");
                findings.note("families", format!("family-exponent/{key}"), exponent(&times));
                let gains = findings.points("families", &fields, "size", "acceleration");
                findings.note("families", format!("family-gain-exponent/{key}"), exponent(&gains));
                let last = gains.iter().find(|p| p.0.to_string() == size).map(|p| p.1);
                findings.note("families", format!("family-gain/{key}"), last);
            }
        }
    }
}

/// Space divisions and hybrids must give the very picture of full ray tracing, pencils one within their tolerance.
fn exactness(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<(), PaperError> {
    let size = lab.size_up_to(256);
    let columns = ["scene", "method", "accelerator", "differing_pixels", "greatest_error_levels"];
    let mut table = Table::new("exactness", &columns);
    let (mut differing_pixels, mut pencil_error) = (0, 0.0_f64);
    for subject in subjects.with_blocks() {
        let full = lab.picture(&subject.scene, &square(size, Method::Full))?;
        for (name, accelerator) in ACCELERATORS {
            let Some(accelerator) = accelerator else { continue };
            for (m, method) in built() {
                let picture =
                    lab.picture(&subject.scene, &Settings { accelerator, ..square(size, method) })?;
                let bits = |c: &[f32; 3]| c.map(f32::to_bits);
                let differing =
                    full.colors.iter().zip(&picture.colors).filter(|(a, b)| bits(a) != bits(b)).count();
                let greatest = unrounded_error(&picture.colors, &full.colors).max_error;
                if m.family != Family::Interpolation {
                    differing_pixels += differing;
                } else if m.name == "pencil" {
                    pencil_error = pencil_error.max(greatest);
                }
                table.push([
                    (&subject.name).into(),
                    m.name.into(),
                    name.into(),
                    differing.into(),
                    greatest.into(),
                ]);
            }
        }
    }
    findings.add(table);
    findings.note("exactness", "exact-families/differing-pixels", Some(differing_pixels as f64));
    findings.note("exactness", "pencil/greatest-error", Some(pencil_error));
    Ok(())
}

fn figure(subjects: &Subjects, sizes: &[u32], findings: &Findings) -> Figure {
    let sizes: Vec<f64> = sizes.iter().map(|&s| f64::from(s)).collect();
    let chart = |scene: &String| Chart {
        title: format!("{scene}: gain over RT without acceleration"),
        x: Axis::steps("N, side of the picture in pixels", &sizes),
        y: Axis::logarithmic("times as fast"),
        lines: shown_lines(scene, findings),
    };
    let missing: Vec<&str> = METHODS
        .iter()
        .filter(|m| m.method.is_none())
        .map(|m| m.name)
        .chain(ACCELERATORS.iter().filter(|a| a.1.is_none()).map(|a| a.0))
        .collect();
    let missing =
        if missing.is_empty() { String::new() } else { format!(" Not yet built: {}.", missing.join(", ")) };
    let mut parts = drawn(&subjects.names().iter().map(chart).collect::<Vec<_>>());
    parts.push(shown_table(&exponents(&subjects.names(), findings), 2));
    Figure {
        id: "families",
        heading: "All families of speed-ups side by side".to_owned(),
        paper: "Speed-ups are by space division, by pixel interpolation, or hybrids with a Z-buffer or scan lines. Only \
                interpolation gains with N.",
        parts,
        caption: format!(
            "Charts show each method without acceleration and each structure under RT; the table has the exponents of \
             time of all pairs. Space divisions and hybrids differ from RT in {} pixels; \
             pencils, with a tolerance of 1 level, by {} levels at most.{missing}",
            findings.show("exact-families/differing-pixels", 0),
            findings.show("pencil/greatest-error", 2)
        ),
        table: "families",
    }
}

/// Every method without acceleration, and every structure under RT.
fn shown_lines(scene: &str, findings: &Findings) -> Vec<Line> {
    let markers =
        [Marker::Disc, Marker::Ring, Marker::Triangle, Marker::Diamond, Marker::Square, Marker::Cross];
    let methods = METHODS.iter().skip(1).map(|m| (m.name, "none", m.name, m.family));
    let structures = ACCELERATORS.iter().skip(1).map(|a| ("full", a.0, a.0, Family::Standard));
    let lines = methods.chain(structures).enumerate().map(|(i, (method, accelerator, name, family))| {
        let (color, dash) = match family {
            Family::Interpolation => (0, Dash::Solid),
            Family::Hybrid => (1, Dash::Broken),
            Family::Standard => (2, Dash::Dotted),
        };
        let fields = [("scene", scene), ("method", method), ("accelerator", accelerator)];
        let points = findings.points("families", &fields, "size", "acceleration");
        Line { name: name.to_owned(), points, look: Look::new(color, dash, markers[i % markers.len()]) }
    });
    lines.filter(|line| !line.points.is_empty()).collect()
}

/// Exponents of time: a row for each method and scene, a column for each structure.
fn exponents(names: &[String], findings: &Findings) -> Table {
    let mut table =
        Table::new("exponents", &["time grows as N to the power", "scene", "none", "extents", "grid", "bvh"]);
    for method in METHODS {
        for scene in names {
            let [none, extents, grid, bvh] = ACCELERATORS.map(|(accelerator, _)| {
                let name = format!("family-exponent/{}/{accelerator}/{scene}", method.name);
                findings.number(&name).map_or("–".into(), Into::into)
            });
            table.push([method.name.into(), scene.into(), none, extents, grid, bvh]);
        }
    }
    table
}
