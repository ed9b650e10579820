//! Does the method do what it says? The perspective image shows what rays meet first, and filled pixels have the history
//! that was judged. Paper: P3, P5.

use brt::{BorderSettings, Layer, Method, SampleState, Settings};

use super::{Figure, shown_table};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTA, Selection};
use crate::paper::findings::Findings;
use crate::paper::lab::{Lab, square};
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;

pub(super) fn checks(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let size = lab.picture_size(512);
    let mut table = Table::new(
        "checks",
        &[
            "scene",
            "pixels_differing_with_known_first_hits",
            "filled_pixels",
            "filled_with_the_right_history_percent",
        ],
    );
    for subject in subjects.with_blocks() {
        lab.doing(&format!("Checks: {}", subject.name));
        let scene = &subject.scene;
        let with = |layers: Vec<Layer>, method| Settings { layers, ..square(size, method) };
        let full = lab.picture(scene, &with(vec![Layer::History], Method::Full))?;
        // Blocks of one sample: every sample is traced from its known first hit.
        let known = Method::Border(BorderSettings { block: 1, ..Default::default() });
        let known = lab.picture(scene, &with(Vec::new(), known))?;
        let differing = full.colors.iter().zip(&known.colors).filter(|(a, b)| a != b).count();
        let border = lab
            .picture(scene, &with(vec![Layer::History, Layer::State], Selection::Deviation.method(DELTA)))?;
        let filled = || (0..border.state.len()).filter(|&i| border.state[i] == SampleState::Filled);
        let right = filled().filter(|&i| border.history[i] == full.history[i]).count();
        let filled = filled().count();
        let percent = 100.0 * right as f64 / filled.max(1) as f64;
        table.push([(&subject.name).into(), differing.into(), filled.into(), percent.into()]);
        findings.note("checks", format!("known-first-hits-differ/{}", subject.name), Some(differing as f64));
        findings.note("checks", format!("right-history-percent/{}", subject.name), Some(percent));
    }
    let parts = vec![shown_table(&table, 2)];
    findings.add(table);
    Ok(Figure {
        id: "checks",
        heading: format!("Does the method do what it says? (N = {size})"),
        paper: "The perspective image gives the first hit; four equal histories stand for all between them.",
        parts,
        caption: "Every pixel traced from the first hit that the perspective image shows, against searching it: pixels that \
                  differ. And of the filled pixels those whose own history, had they been traced, is the one judged."
            .to_owned(),
        table: "checks",
    })
}
