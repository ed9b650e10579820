//! Figs. 1, 2 and 4: time over the picture's side, under the paper's conditions and with a hierarchy. Paper: P8, P9, P11.

use brt::{Accelerator, Method, Settings};

use super::{Figure, drawn, size_steps};
use crate::paper::PaperError;
use crate::paper::contenders::{CONDITIONS, DELTA, Selection};
use crate::paper::findings::Findings;
use crate::paper::fit::exponent;
use crate::paper::lab::{Lab, Timing, square};
use crate::paper::picture::traced_percent;
use crate::paper::subjects::{Subject, Subjects};
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Dash, Line, Look, Marker, power_of_n};

/// The methods of Figs. 1 and 2 in tables and in the paper's words.
const METHODS: [(&str, &str); 3] = [("full", "RT"), ("border", "BRT"), ("pixel-selected", "PSRT")];
/// In the table of Fig. 2: how many times as fast as PSRT.
const AGAINST_PSRT: &str = "border against pixel-selected";
/// The size at which the paper reads Fig. 4.
const PAPERS_LARGEST: u32 = 1024;

fn settings(index: usize, size: u32, accelerator: Accelerator) -> Settings {
    let method = match index {
        0 => Method::Full,
        1 => Selection::Deviation.method(DELTA),
        _ => Selection::Psrt.method(DELTA),
    };
    Settings { accelerator, ..square(size, method) }
}

/// Fig. 1. Its measurements are those of Figs. 2 and 4 too.
pub(super) fn fig1(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    measure(lab, subjects, findings)?;
    let charts = CONDITIONS.map(|(accelerator, _)| {
        let lines = subjects
            .main
            .iter()
            .enumerate()
            .flat_map(|(i, subject)| METHODS[..2].iter().map(move |method| (i, subject, method)));
        let line = |(color, subject, (method, short)): (usize, &Subject, &(&str, &str))| {
            let k = findings.number(&format!("time-exponent/{method}/{}/{accelerator}", subject.name));
            Line {
                name: format!(
                    "{} {short}{}",
                    subject.name,
                    k.map_or(String::new(), |k| format!(", {}", power_of_n(k)))
                ),
                points: points(findings, "fig1", subject, accelerator, method, "relative_time"),
                look: look(color, method),
            }
        };
        Chart {
            title: title(accelerator),
            x: Axis::steps("N, side of the picture in pixels", &size_steps(lab)),
            y: Axis::logarithmic("processor time, RT at the smallest N = 1"),
            lines: lines.map(line).collect(),
        }
    });
    let names = |method: &str, accelerator: &str| {
        subjects
            .names()
            .iter()
            .map(|s| format!("time-exponent/{method}/{s}/{accelerator}"))
            .collect::<Vec<_>>()
    };
    let plain = [names("full", "none"), names("border", "none")];
    let caption = if findings.knows_any(&plain[0]) {
        format!(
            "Exponents fitted over all sizes shown. Without acceleration RT grows as N to the power {}, BRT to the \
             power {}; with the hierarchy {} and {}.",
            findings.show_range(&plain[0], 2),
            findings.show_range(&plain[1], 2),
            findings.show_range(&names("full", "bvh"), 2),
            findings.show_range(&names("border", "bvh"), 2),
        )
    } else {
        "Too few sizes for exponents.".to_owned()
    };
    Ok(Figure {
        id: "fig1",
        heading: "Fig. 1: relative CPU time (Δ = 16)".to_owned(),
        paper: "The time of standard ray tracing (RT) grows as N², that of border ray tracing (BRT) as N.",
        parts: drawn(&charts),
        caption,
        table: "fig1",
    })
}

/// Fig. 2, from the measurements of Fig. 1.
pub(super) fn fig2(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let charts = CONDITIONS.map(|(accelerator, _)| {
        let pairs = subjects
            .main
            .iter()
            .enumerate()
            .flat_map(|(i, subject)| METHODS[1..].iter().map(move |method| (i, subject, method)));
        let line = |(color, subject, (method, short)): (usize, &Subject, &(&str, &str))| Line {
            name: format!("{} {short}", subject.name),
            points: points(findings, "fig2", subject, accelerator, method, "acceleration"),
            look: look(color, method),
        };
        let mut lines: Vec<Line> = pairs.map(line).collect();
        let first = f64::from(lab.sizes[0]);
        let slope = lab.sizes.iter().map(|&n| (f64::from(n), f64::from(n) / first)).collect();
        lines.push(Line { name: "proportional to N".to_owned(), points: slope, look: Look::GUIDE });
        Chart {
            title: title(accelerator),
            x: Axis::steps("N, side of the picture in pixels", &size_steps(lab)),
            y: Axis::logarithmic("times as fast as RT"),
            lines,
        }
    });
    let at = lab.size_up_to(PAPERS_LARGEST);
    let names = |accelerator: &str| {
        subjects.names().iter().map(|s| format!("psrt-time-over-brt/{s}/{accelerator}")).collect::<Vec<_>>()
    };
    Ok(Figure {
        id: "fig2",
        heading: "Fig. 2: acceleration over standard ray tracing (Δ = 16)".to_owned(),
        paper: "Acceleration grows in proportion to N, for every pixel-interpolation method. BRT is 1.4 to 5 times as fast as PSRT.",
        parts: drawn(&charts),
        caption: format!(
            "At N = {at} BRT is {} times as fast as PSRT without acceleration, {} times with the hierarchy. Equal Δ, \
             not equal error: see <a href=\"#equal-error\">below</a>.",
            findings.show_range(&names("none"), 2),
            findings.show_range(&names("bvh"), 2)
        ),
        table: "fig2",
    })
}

/// Fig. 4, from the measurements of Fig. 1.
pub(super) fn fig4(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let chart = |accelerator: &str| Chart {
        title: title(accelerator),
        x: Axis::steps("N, side of the picture in pixels", &size_steps(lab)),
        y: Axis::linear("perspective image, % of BRT's time"),
        lines: subjects
            .main
            .iter()
            .enumerate()
            .map(|(i, subject)| Line {
                name: subject.name.clone(),
                points: points(findings, "fig4", subject, accelerator, "border", "share_percent"),
                look: look(i, "border"),
            })
            .collect(),
    };
    let names = |accelerator: &str| {
        subjects.names().iter().map(|s| format!("perspective-share/{s}/{accelerator}")).collect::<Vec<_>>()
    };
    Ok(Figure {
        id: "fig4",
        heading: "Fig. 4: share of the perspective image in BRT's time (Δ = 16)".to_owned(),
        paper: "The share grows with N, but is only 1 to 5 % even at N = 1024.",
        parts: drawn(&[chart("none"), chart("bvh")]),
        caption: format!(
            "At N = {} it is {} % without acceleration, {} % with the hierarchy: what makes rays cheaper makes the \
             perspective image dearer beside them.",
            lab.size_up_to(PAPERS_LARGEST),
            findings.show_range(&names("none"), 1),
            findings.show_range(&names("bvh"), 1)
        ),
        table: "fig4",
    })
}

fn measure(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<(), PaperError> {
    let counted = ["repetitions", "traced_percent", "rays", "primitive_tests"];
    let mut columns = vec!["scene", "accelerator", "method", "size", "relative_time", "seconds"];
    columns.extend(counted);
    let mut fig1 = Table::new("fig1", &columns);
    let mut fig2 = Table::new("fig2", &["scene", "accelerator", "method", "size", "acceleration"]);
    let mut fig4 = Table::new("fig4", &["scene", "accelerator", "method", "size", "share_percent"]);
    for subject in &subjects.main {
        for (name, accelerator) in CONDITIONS {
            let mut unit = None;
            for &size in &lab.sizes {
                let contenders = [0, 1, 2].map(|i| settings(i, size, accelerator));
                let foreseen = lab.foreseen(&subject.scene, &contenders[0])?;
                if !lab.affords(foreseen) {
                    findings.remarks.push(format!(
                        "Figs. 1, 2, 4: {} at N = {size} with acceleration “{name}” is left out, as RT alone would take \
                         about {foreseen:.0} s.",
                        subject.name
                    ));
                    continue;
                }
                lab.doing(&format!("Figs. 1, 2, 4: {}, acceleration {name}, N = {size}", subject.name));
                let timings = lab.time(&subject.scene, &contenders)?;
                let unit = *unit.get_or_insert(timings[0].seconds);
                for ((method, _), timing) in METHODS.iter().zip(&timings) {
                    let head = || [(&subject.name).into(), name.into(), (*method).into(), size.into()];
                    fig1.push(row(head(), timing, unit));
                    let [a, b, c, d] = head();
                    fig2.push([a, b, c, d, timing.gain_over(&timings[0]).into()]);
                }
                let against_psrt = timings[1].gain_over(&timings[2]).into();
                let scene = || (&subject.name).into();
                fig2.push([scene(), name.into(), AGAINST_PSRT.into(), size.into(), against_psrt]);
                let share = 100.0 * timings[1].perspective_share;
                fig4.push([(&subject.name).into(), name.into(), "border".into(), size.into(), share.into()]);
            }
        }
    }
    [fig1, fig2, fig4].into_iter().for_each(|table| findings.add(table));
    note(lab, subjects, findings);
    Ok(())
}

type Cell = crate::paper::table::Cell;

fn row([scene, accelerator, method, size]: [Cell; 4], timing: &Timing, unit: f64) -> [Cell; 10] {
    let stats = &timing.stats;
    let (relative, repetitions) = ((timing.seconds / unit).into(), timing.repetitions().into());
    let (traced, rays) = (traced_percent(stats).into(), stats.rays.total().into());
    let tests = stats.primitive_tests.into();
    let seconds = timing.seconds.into();
    [scene, accelerator, method, size, relative, seconds, repetitions, traced, rays, tests]
}

/// Exponents, and what the paper reads at its greatest size.
fn note(lab: &Lab, subjects: &Subjects, findings: &mut Findings) {
    let papers = lab.size_up_to(PAPERS_LARGEST).to_string();
    for subject in &subjects.main {
        let scene = &subject.name;
        for (name, _) in CONDITIONS {
            for (method, _) in METHODS {
                let times = points(findings, "fig1", subject, name, method, "seconds");
                findings.note("fig1", format!("time-exponent/{method}/{scene}/{name}"), exponent(&times));
                let gains = points(findings, "fig2", subject, name, method, "acceleration");
                findings.note(
                    "fig2",
                    format!("acceleration-exponent/{method}/{scene}/{name}"),
                    exponent(&gains),
                );
                let last = gains.iter().find(|p| p.0.to_string() == papers).map(|p| p.1);
                findings.note("fig2", format!("acceleration/{method}/{scene}/{name}"), last);
            }
            let ratios = points(findings, "fig2", subject, name, AGAINST_PSRT, "acceleration");
            let ratio = ratios.iter().find(|p| p.0.to_string() == papers).map(|p| p.1);
            findings.note("fig2", format!("psrt-time-over-brt/{scene}/{name}"), ratio);
            let shares = points(findings, "fig4", subject, name, "border", "share_percent");
            let share = shares.iter().find(|p| p.0.to_string() == papers).map(|p| p.1);
            findings.note("fig4", format!("perspective-share/{scene}/{name}"), share);
        }
    }
}

fn points(
    findings: &Findings,
    table: &'static str,
    subject: &Subject,
    accelerator: &str,
    method: &str,
    y: &str,
) -> Vec<(f64, f64)> {
    let fields = [("scene", subject.name.as_str()), ("accelerator", accelerator), ("method", method)];
    findings.points(table, &fields, "size", y)
}

fn look(color: usize, method: &str) -> Look {
    match method {
        "border" => {
            Look::new(color, Dash::Solid, [Marker::Disc, Marker::Triangle, Marker::Diamond][color % 3])
        }
        "full" => Look::new(color, Dash::Broken, Marker::Square),
        _ => Look::new(color, Dash::Broken, Marker::Ring),
    }
}

fn title(accelerator: &str) -> String {
    match accelerator {
        "none" => "The paper's conditions: no acceleration".to_owned(),
        _ => "Today: with a bounding volume hierarchy".to_owned(),
    }
}
