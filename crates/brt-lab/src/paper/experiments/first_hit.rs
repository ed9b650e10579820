//! What knowing the first hit gains, over the number of primitives. Paper: P4 (3), P10.

use brt::{Accelerator, BorderSettings, Method, Settings};

use super::{Figure, drawn};
use crate::paper::PaperError;
use crate::paper::contenders::METHODS;
use crate::paper::findings::Findings;
use crate::paper::lab::{Lab, square};
use crate::paper::subjects::Subjects;
use crate::paper::subjects::counted_balls;
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Dash, Line, Look, Marker};

const COUNTS: [u32; 6] = [1, 4, 16, 64, 256, 1024];
const QUICK_COUNTS: [u32; 4] = [1, 4, 16, 64];

/// Every sample is traced, its first hit taken from the perspective image.
fn known_first_hit() -> Method {
    let item_buffer = METHODS.iter().find(|m| m.name == "item-buffer").and_then(|m| m.method);
    // Blocks of one sample have nothing between their corners: `border` traces them all.
    item_buffer.map_or(Method::Border(BorderSettings { block: 1, ..Default::default() }), |method| method())
}

pub(super) fn first_hit(lab: &Lab, _: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let size = lab.picture_size(256);
    let columns = [
        "shading",
        "balls",
        "gain",
        "seconds_full",
        "seconds_known",
        "tests_per_pixel_full",
        "tests_per_pixel_known",
    ];
    let mut table = Table::new("first_hit", &columns);
    let counts: &[u32] = if lab.quick { &QUICK_COUNTS } else { &COUNTS };
    for (name, has_shadows) in [("one light with shadows", true), ("no light", false)] {
        for &count in counts {
            lab.doing(&format!("First hit known: {count} balls, {name}"));
            let scene = counted_balls(count, has_shadows);
            let settings = |method| Settings { accelerator: Accelerator::None, ..square(size, method) };
            let timings = lab.time(&scene, &[settings(Method::Full), settings(known_first_hit())])?;
            let tests = |i: usize| timings[i].stats.primitive_tests as f64 / f64::from(size * size);
            let (full, known) = (timings[0].seconds, timings[1].seconds);
            let gain = timings[1].gain_over(&timings[0]);
            table.push([
                name.into(),
                count.into(),
                gain.into(),
                full.into(),
                known.into(),
                tests(0).into(),
                tests(1).into(),
            ]);
            let kind = if has_shadows { "shadows" } else { "ambient" };
            let is_last = Some(&count) == counts.last();
            findings.note("first_hit", format!("first-hit-gain/{kind}/{count}"), Some(gain));
            findings.note("first_hit", format!("first-hit-gain/{kind}/most"), is_last.then_some(gain));
            findings.note("first_hit", format!("first-hit-gain/{kind}/fewest"), (count == 1).then_some(gain));
            findings.note("first_hit", format!("first-hit-tests/{kind}/most"), is_last.then(|| tests(1)));
        }
    }
    findings.add(table);
    let counts: Vec<f64> = counts.iter().map(|&c| f64::from(c)).collect();
    Ok(figure(findings, size, &counts))
}

fn figure(findings: &Findings, size: u32, counts: &[f64]) -> Figure {
    let line = |name: &str, look| Line {
        name: name.to_owned(),
        points: findings.points("first_hit", &[("shading", name)], "balls", "gain"),
        look,
    };
    let twice = Line {
        name: "2 ×".to_owned(),
        points: counts.iter().map(|&c| (c, 2.0)).collect(),
        look: Look::GUIDE,
    };
    let chart = Chart {
        title: format!("First hit known, N = {size}, no acceleration"),
        x: Axis::steps("number of balls", counts),
        y: Axis::logarithmic("times as fast as RT"),
        lines: vec![
            line("one light with shadows", Look::new(0, Dash::Solid, Marker::Disc)),
            line("no light", Look::new(1, Dash::Broken, Marker::Ring)),
            twice,
        ],
    };
    Figure {
        id: "first-hit",
        heading: "Gain by knowing the first hit".to_owned(),
        paper: "Where only shading is computed, knowing the first object gains up to 2×, most with many primitives.",
        parts: drawn(&[chart]),
        caption: format!(
            "Balls on a floor, all pixels traced. With one light a pixel costs a ray to the object and one to the light, so \
             knowing the first halves the work at best: {} times as fast with most balls. Without a light nothing is left \
             but {} test per pixel, and the gain, {} times, has no bound but the perspective image's own cost.",
            findings.show("first-hit-gain/shadows/most", 2),
            findings.show("first-hit-tests/ambient/most", 2),
            findings.show("first-hit-gain/ambient/most", 1)
        ),
        table: "first_hit",
    }
}
