//! Fig. 7: the lost highlight on very small balls, and objects that are lost as a whole. Paper: P4 (1), P17.

use brt::{Layer, Method, Settings};

use super::{Figure, shown_table};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTA, Selection, certified};
use crate::paper::findings::Findings;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::{Picture, difference_map, image_element, levels};
use crate::paper::subjects::{SMALL_BALLS_SIDE, Subjects, small_balls};
use crate::paper::table::Table;

const SHOWN: [Selection; 2] = [Selection::Deviation, Selection::Psrt];

/// The methods of Fig. 7: in tables, on the page.
fn shown_methods() -> [(&'static str, &'static str, Method); 3] {
    let of = |selection: Selection| selection.method(DELTA);
    [
        (Selection::Deviation.key(), "border", of(Selection::Deviation)),
        (Selection::Psrt.key(), "PSRT", of(Selection::Psrt)),
        ("certified", "certified", certified()),
    ]
}

/// Each pixel is shown this many pixels wide.
const MAGNIFIED: u32 = 4;
/// A highlight is lost if the ball's brightest pixel is darker by more than this many levels.
const LOST_LEVELS: f64 = 10.0;

pub(super) fn fig7(lab: &Lab, _: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    lab.doing("Fig. 7: very small balls");
    let (scene, balls) = small_balls();
    let settings =
        |method| Settings { layers: vec![Layer::Surface, Layer::State], ..square(SMALL_BALLS_SIDE, method) };
    let full = lab.picture(&scene, &settings(Method::Full))?;
    let mut cells = vec![shown("full", &full.colors)?];
    let columns = [
        "ball",
        "radius_px",
        "shift_px",
        "method",
        "brightest_full",
        "brightest",
        "highlight_lost",
        "ball_lost",
    ];
    let mut table = Table::new("fig7", &columns);
    for (key, name, method) in shown_methods() {
        let picture = lab.picture(&scene, &settings(method))?;
        let mut lost = [0_u32; 2];
        for (surface, ball) in (0_u32..).zip(&balls) {
            let pixels = || (0..full.colors.len()).filter(|&i| full.surface[i] == surface);
            let brightest = |p: &Picture| pixels().map(|i| levels(p.colors[i])[0]).fold(0.0, f64::max);
            let background = full.colors[full.surface.iter().position(|s| *s == u32::MAX).unwrap_or(0)];
            let (right, seen) = (brightest(&full), brightest(&picture));
            let ball_lost = pixels().all(|i| levels(picture.colors[i]) == levels(background));
            let highlight_lost = !ball_lost && right - seen > LOST_LEVELS;
            lost[0] += u32::from(highlight_lost);
            lost[1] += u32::from(ball_lost);
            table.push([
                surface.into(),
                ball.radius.into(),
                ball.shift.into(),
                key.into(),
                right.into(),
                seen.into(),
                u32::from(highlight_lost).into(),
                u32::from(ball_lost).into(),
            ]);
        }
        findings.note("fig7", format!("highlights-lost/{key}"), Some(f64::from(lost[0])));
        findings.note("fig7", format!("balls-lost/{key}"), Some(f64::from(lost[1])));
        cells.push(shown(name, &picture.colors)?);
        cells.push(shown(&format!("{name}: difference"), &difference_map(&picture.colors, &full.colors))?);
        cells.push(shown(&format!("{name}: traced"), &picture.traced_map())?);
    }
    findings.add(table);
    findings.note("fig7", "balls", Some(balls.len() as f64));
    Ok(Figure {
        id: "fig7",
        heading: "Fig. 7: the lost highlight on very small balls".to_owned(),
        paper: "Four rays hit one very small ball, happen to be equally bright, the histories agree, and the highlight between \
                them is lost. Every method that judges by brightness and history alone has this flaw.",
        parts: vec![sheet(&cells)],
        caption: format!(
            "{} balls of 1.5 to 3.75 pixels' radius, lit from the eye, each inside a block of 16 pixels, \
             so between the points of PSRT; each pixel shown {MAGNIFIED} wide; differences from \
             full ray tracing: black 0, violet 1 level, then red to yellow. Border ray tracing loses {} highlights and \
             {} balls, PSRT {} highlights and {} balls, certified {} highlights.",
            findings.show("balls", 0),
            findings.show("highlights-lost/border-deviation", 0),
            findings.show("balls-lost/border-deviation", 0),
            findings.show("highlights-lost/pixel-selected", 0),
            findings.show("balls-lost/pixel-selected", 0),
            findings.show("highlights-lost/certified", 0),
        ),
        table: "fig7",
    })
}

fn shown(name: &str, colors: &[[f32; 3]]) -> Result<String, PaperError> {
    let image = image_element(colors, SMALL_BALLS_SIDE, MAGNIFIED * SMALL_BALLS_SIDE, name)?;
    Ok(format!("<td>{image}<br>{name}</td>"))
}

/// The full picture, and beside it a row for each method.
fn sheet(cells: &[String]) -> String {
    let rows = cells[1..].chunks(3).enumerate().map(|(i, row)| {
        let first = if i == 0 { cells[0].clone() } else { "<td></td>".to_owned() };
        format!("<tr>{first}{}</tr>", row.concat())
    });
    format!(
        "<div class=\"scroll\"><table class=\"sheet\"><tbody>{}</tbody></table></div>",
        rows.collect::<String>()
    )
}

/// How many of the small things in `adversary` are lost: more than half of their pixels are wrong.
pub(super) fn lost_objects(
    lab: &Lab,
    subjects: &Subjects,
    findings: &mut Findings,
) -> Result<Figure, PaperError> {
    /// Objects of fewer pixels are not counted.
    const LEAST_PIXELS: usize = 4;
    let size = lab.picture_size(512);
    lab.doing("Lost objects");
    let scene = &subjects.adversary.scene;
    let layers = vec![Layer::Surface];
    let full = lab.picture(scene, &Settings { layers, ..square(size, Method::Full) })?;
    let mut table = Table::new("lost", &["method", "objects_seen", "objects_lost", "pixels_over_10"]);
    for selection in SHOWN {
        let picture = lab.picture(scene, &square(size, selection.method(DELTA)))?;
        let wrong = |i: usize| {
            let (a, b) = (levels(picture.colors[i]), levels(full.colors[i]));
            (0..3).any(|c| (a[c] - b[c]).abs() > LOST_LEVELS)
        };
        let surfaces = full.surface.iter().copied().filter(|s| *s != u32::MAX).max().map_or(0, |s| s + 1);
        let mut pixels = vec![[0_usize; 2]; surfaces as usize];
        for (i, &surface) in full.surface.iter().enumerate().filter(|(_, s)| **s != u32::MAX) {
            pixels[surface as usize][0] += 1;
            pixels[surface as usize][1] += usize::from(wrong(i));
        }
        let seen = pixels.iter().filter(|p| p[0] >= LEAST_PIXELS).count();
        let lost = pixels.iter().filter(|p| p[0] >= LEAST_PIXELS && 2 * p[1] > p[0]).count();
        let over = (0..full.colors.len()).filter(|&i| wrong(i)).count();
        table.push([selection.key().into(), seen.into(), lost.into(), over.into()]);
        findings.note("lost", format!("objects-lost/{}", selection.key()), Some(lost as f64));
        findings.note("lost", "objects-seen", (selection == SHOWN[0]).then_some(seen as f64));
    }
    let parts = vec![shown_table(&table, 0)];
    findings.add(table);
    Ok(Figure {
        id: "lost",
        heading: format!("Small objects lost (scene adversary, N = {size}, Δ = 16)"),
        paper: "A directly visible object always appears in the perspective image, so small objects inside an interpolation \
                region are not lost.",
        parts,
        caption: format!(
            "Of {} objects of at least {LEAST_PIXELS} pixels BRT loses {}, PSRT {}: more than half of their pixels are \
             off by more than 10 levels.",
            findings.show("objects-seen", 0),
            findings.show("objects-lost/border-deviation", 0),
            findings.show("objects-lost/pixel-selected", 0)
        ),
        table: "lost",
    })
}
