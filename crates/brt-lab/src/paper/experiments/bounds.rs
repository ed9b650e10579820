//! Beyond the paper: bounds instead of probes, on things that are seen only in mirrors or as shadows. Paper: P17, P19, P20.

use brt::{Certificate, Layer, Method, Settings};

use super::{Figure, shown_table};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTA, Selection, certified};
use crate::paper::findings::Findings;
use crate::paper::fit::exponent;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::{Picture, difference_map, image_element, unrounded_error, unrounded_levels};
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;

/// The side of pictures on the page.
const SHOWN_SIDE: u32 = 320;
/// Pixels that are off by more levels are wrong beyond doubt.
const FAR_OFF: f64 = 16.0;

/// The two by which the sheet is made, in tables and on the page.
fn contenders() -> [(&'static str, Method); 2] {
    [("border", Selection::Deviation.method(DELTA)), ("certified", certified())]
}

/// The scene `adversary` by probes and by bounds.
pub(super) fn bounds(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let size = lab.picture_size(1024);
    lab.doing("Probes and bounds");
    let scene = &subjects.adversary.scene;
    let full = lab.picture(scene, &square(size, Method::Full))?;
    let columns = [
        "method",
        "traced_percent",
        "shaded_percent",
        "filled_percent",
        "over_1",
        "over_10",
        "over_16",
        "greatest_error",
    ];
    let mut table = Table::new("bounds", &columns);
    let mut rows = String::new();
    for (name, method) in contenders() {
        let picture = lab.picture(scene, &Settings { layers: vec![Layer::State], ..square(size, method) })?;
        let error = unrounded_error(&picture.colors, &full.colors);
        let far_off = far_off(&picture, &full);
        let pixels = picture.stats.pixels;
        let percent = |count: u64| 100.0 * count as f64 / pixels.total as f64;
        table.push([
            name.into(),
            percent(pixels.traced).into(),
            percent(pixels.shaded).into(),
            percent(pixels.filled).into(),
            (error.over_1 as usize).into(),
            (error.over_10 as usize).into(),
            far_off.into(),
            error.max_error.into(),
        ]);
        findings.note("bounds", format!("far-off/{name}"), Some(far_off as f64));
        findings.note("bounds", format!("off-by-1/{name}"), Some(error.over_1 as f64));
        findings.note("bounds", format!("greatest-error/{name}"), Some(error.max_error));
        rows += &sheet_row(name, &picture, &full, size)?;
    }
    let sheet = format!("<div class=\"scroll\"><table class=\"sheet\"><tbody>{rows}</tbody></table></div>");
    let parts = vec![sheet, shown_table(&table, 2)];
    findings.add(table);
    Ok(Figure {
        id: "bounds",
        heading: format!("Beyond the paper: bounds instead of probes (scene adversary, N = {size})"),
        paper: "Future work: reflection angle, curvature, highlight and light direction in the judgement; perspective images \
                that include shadows and mirrored objects.",
        parts,
        caption: format!(
            "Tiny balls with sharp highlights, things seen only in a mirror, things out of view that only cast shadows. \
             Differences from full ray tracing: black 0, violet 1 level, then red to yellow. By probes {} pixels are off by \
             more than {FAR_OFF} levels, by bounds {}; the greatest error of certified is {} levels.",
            findings.show("far-off/border", 0),
            findings.show("far-off/certified", 0),
            findings.show("greatest-error/certified", 2),
        ),
        table: "bounds",
    })
}

fn far_off(picture: &Picture, full: &Picture) -> usize {
    let is_far = |(a, b): &(&[f32; 3], &[f32; 3])| {
        let (a, b) = (unrounded_levels(**a), unrounded_levels(**b));
        (0..3).any(|c| (a[c] - b[c]).abs() > FAR_OFF)
    };
    picture.colors.iter().zip(&full.colors).filter(is_far).count()
}

fn sheet_row(name: &str, picture: &Picture, full: &Picture, size: u32) -> Result<String, PaperError> {
    let cell = |what: &str, colors: &[[f32; 3]]| {
        image_element(colors, size, SHOWN_SIDE, &format!("{name}: {what}"))
            .map(|image| format!("<td>{image}<br>{name}: {what}</td>"))
    };
    Ok(format!(
        "<tr>{}{}{}</tr>",
        cell("picture", &picture.colors)?,
        cell("difference", &difference_map(&picture.colors, &full.colors))?,
        cell("traced", &picture.traced_map())?
    ))
}

/// How often each certificate succeeds, and how what is left to trace grows.
pub(super) fn certificates(
    lab: &Lab,
    subjects: &Subjects,
    findings: &mut Findings,
) -> Result<Figure, PaperError> {
    lab.doing("Certificates");
    let mut tries = Table::new("certificates", &["scene", "size", "certificate", "tried", "proven"]);
    let columns = ["scene", "size", "border_traced", "certified_traced", "certified_filled_percent"];
    let mut growth = Table::new("certified-growth", &columns);
    let mut exponents = Table::new("certified-exponents", &["scene", "border_traced", "certified_traced"]);
    let last = lab.sizes.last().copied().unwrap_or(0);
    for subject in subjects.with_blocks() {
        let mut points: [Vec<(f64, f64)>; 2] = Default::default();
        for &size in lab.sizes.iter().filter(|&&size| size >= 512 || lab.quick) {
            let [border, certified] =
                contenders().map(|(_, method)| lab.count(&subject.scene, &square(size, method)));
            let (border, certified) = (border?, certified?);
            points[0].push((f64::from(size), border.pixels.traced as f64));
            points[1].push((f64::from(size), certified.pixels.traced as f64));
            let filled = 100.0 * certified.pixels.filled as f64 / certified.pixels.total as f64;
            growth.push([
                (&subject.name).into(),
                size.into(),
                (border.pixels.traced as usize).into(),
                (certified.pixels.traced as usize).into(),
                filled.into(),
            ]);
            for certificate in Certificate::ALL.into_iter().filter(|_| size == last) {
                let brt::Tries { proven, failed } = certified.certificates[certificate];
                if proven + failed == 0 {
                    continue;
                }
                tries.push([
                    (&subject.name).into(),
                    size.into(),
                    certificate.name().into(),
                    ((proven + failed) as usize).into(),
                    (proven as usize).into(),
                ]);
            }
        }
        let [border, certified] = points.map(|points| exponent(&points));
        exponents.push([
            (&subject.name).into(),
            border.unwrap_or(f64::NAN).into(),
            certified.unwrap_or(f64::NAN).into(),
        ]);
        let name = format!("certified-traced-exponent/{}", subject.name);
        findings.note("certified-exponents", name, certified);
    }
    let parts = vec![shown_table(&exponents, 2), shown_table(&growth, 1), shown_table(&tries, 0)];
    for table in [tries, growth, exponents] {
        findings.add(table);
    }
    let names: Vec<String> =
        subjects.with_blocks().map(|s| format!("certified-traced-exponent/{}", s.name)).collect();
    let power = findings.knows_any(&names).then(|| {
        let power = findings.show_range(&names, 2);
        format!("The number of pixels that certified traces grows as N to the power {power}: what")
    });
    Ok(Figure {
        id: "certificates",
        heading: "Beyond the paper: what is proven, and what is left to trace".to_owned(),
        paper: "The number of traced pixels grows with the length of borders, in proportion to N.",
        parts,
        caption: format!(
            "{} is not proven lies along borders, \
             in a collar of blocks of 8 pixels that is wide in small pictures. Above: how often each certificate was tried \
             at N = {last}; what a block inherits is not tried again.",
            power.unwrap_or_else(|| "What".to_owned())
        ),
        table: "certified-growth",
    })
}
