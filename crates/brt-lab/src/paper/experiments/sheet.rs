//! Picture 1: A for the six Δ, pictures and traced pixels, BRT above PSRT. Paper: P7.

use brt::{Layer, Method, Settings};

use super::Figure;
use crate::paper::PaperError;
use crate::paper::contenders::{DELTAS, Selection};
use crate::paper::findings::Findings;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::{error, image_element};
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;

/// Width of each picture on the page.
const SHOWN: u32 = 170;

pub(super) fn picture1(
    lab: &Lab,
    subjects: &Subjects,
    findings: &mut Findings,
) -> Result<Figure, PaperError> {
    let size = lab.picture_size(256);
    let subject = subjects.papers("A");
    let full = lab.picture(&subject.scene, &square(size, Method::Full))?;
    let mut table = Table::new("picture1", &["scene", "method", "delta", "traced_percent", "mean_error"]);
    let heads: String = DELTAS.iter().map(|d| format!("<th>Δ = {d}</th>")).collect();
    let mut html = format!(
        "<div class=\"scroll\"><table class=\"sheet\"><thead><tr><th></th>{heads}</tr></thead><tbody>"
    );
    for (selection, name) in [(Selection::Deviation, "BRT"), (Selection::Psrt, "PSRT")] {
        let mut rows = [format!("<tr><th>{name}</th>"), format!("<tr><th>{name},<br>traced</th>")];
        for delta in DELTAS {
            lab.doing(&format!("Picture 1: {name}, Δ = {delta}"));
            let settings = Settings { layers: vec![Layer::State], ..square(size, selection.method(delta)) };
            let picture = lab.picture(&subject.scene, &settings)?;
            let (traced, width) = (picture.traced_percent(), picture.width());
            let mean = error(&picture.colors, &full.colors).mean_error;
            table.push([
                (&subject.name).into(),
                selection.key().into(),
                delta.into(),
                traced.into(),
                mean.into(),
            ]);
            let shown = SHOWN.min(width);
            let text = format!("{name}, Δ = {delta}");
            let image = image_element(&picture.colors, width, shown, &text)?;
            rows[0].push_str(&format!("<td>{image}<br>error {mean:.2}</td>"));
            let image = image_element(&picture.traced_map(), width, shown, &format!("{text}: traced"))?;
            rows[1].push_str(&format!("<td>{image}<br>{traced:.1} %</td>"));
        }
        html.extend(rows.map(|row| row + "</tr>"));
    }
    html.push_str("</tbody></table></div>");
    findings.add(table);
    Ok(Figure {
        id: "picture1",
        heading: format!("Picture 1: {} at N = {size} for six Δ, and the traced pixels", subject.name),
        paper: "Pictures by border ray tracing above, by pixel-selected ray tracing below.",
        parts: vec![html],
        caption: "White pixels are traced, black ones interpolated. Below the pictures stand the mean error in levels and \
                  the traced share."
            .to_owned(),
        table: "picture1",
    })
}
