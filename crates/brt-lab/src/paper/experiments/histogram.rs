//! Fig. 6: how the error of the red channel is distributed. Paper: P16.

use brt::Method;

use super::{Figure, drawn, look_of};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTA, Selection};
use crate::paper::findings::Findings;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::levels;
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Line};

const SHOWN: [Selection; 2] = [Selection::Deviation, Selection::Psrt];

pub(super) fn fig6(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let size = lab.picture_size(512);
    let subject = subjects.papers("B");
    lab.doing(&format!("Fig. 6: {}", subject.name));
    let full = lab.picture(&subject.scene, &square(size, Method::Full))?;
    let mut table =
        Table::new("fig6", &["method", "from_level", "to_level", "middle", "pixels", "pixels_per_level"]);
    for selection in SHOWN {
        let picture = lab.picture(&subject.scene, &square(size, selection.method(DELTA)))?;
        let mut counts = [0_u64; 256];
        for (a, b) in picture.colors.iter().zip(&full.colors) {
            counts[(levels(*a)[0] - levels(*b)[0]).abs() as usize] += 1;
        }
        for (from, to) in bins() {
            let pixels = counts[from..=to].iter().sum::<u64>();
            let (middle, width) = (0.5 * (from + to) as f64, (to - from + 1) as f64);
            let density = pixels as f64 / width;
            table.push([
                selection.key().into(),
                from.into(),
                to.into(),
                middle.into(),
                pixels.into(),
                density.into(),
            ]);
        }
        let pixels = picture.colors.len() as f64;
        let over = counts[11..].iter().sum::<u64>() as f64;
        findings.note("fig6", format!("red-over-10/{}", selection.key()), Some(over));
        findings.note(
            "fig6",
            format!("red-over-10-percent/{}", selection.key()),
            Some(100.0 * over / pixels),
        );
    }
    findings.add(table);
    let chart = Chart {
        title: format!("{}, N = {size}: red channel", subject.name),
        x: Axis::linear("absolute error in levels of 255"),
        y: Axis::logarithmic("pixels per level"),
        lines: SHOWN
            .iter()
            .map(|&s| Line {
                name: s.label().to_owned(),
                points: findings.points("fig6", &[("method", s.key())], "middle", "pixels_per_level"),
                look: look_of(s),
            })
            .collect(),
    };
    Ok(Figure {
        id: "fig6",
        heading: format!(
            "Fig. 6: distribution of the error, red channel of {} (N = {size}, Δ = 16)",
            subject.name
        ),
        paper: "A few pixels are off by more than 10 levels.",
        parts: drawn(&[chart]),
        caption: format!(
            "Each level alone up to 10, then tens of levels together. More than 10 levels off: {} pixels by BRT ({} %), {} by PSRT ({} %).",
            findings.show("red-over-10/border-deviation", 0),
            findings.show("red-over-10-percent/border-deviation", 2),
            findings.show("red-over-10/pixel-selected", 0),
            findings.show("red-over-10-percent/pixel-selected", 2)
        ),
        table: "fig6",
    })
}

/// Levels 0 to 10 alone, then tens.
fn bins() -> impl Iterator<Item = (usize, usize)> {
    (0..=10).map(|level| (level, level)).chain((11..=251).step_by(10).map(|from| (from, (from + 9).min(255))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_cover_all_levels_once() {
        let levels: Vec<usize> = bins().flat_map(|(from, to)| from..=to).collect();
        assert_eq!(levels, (0..256).collect::<Vec<_>>());
    }
}
