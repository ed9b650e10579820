//! What the two changes against the first publication bring: judgement by variance, regions apart. Paper: P6.

use brt::{Method, Regions};

use super::equal_error::{SWEEP, target};
use super::{Figure, shown_table};
use crate::paper::PaperError;
use crate::paper::contenders::{DELTA, Selection};
use crate::paper::findings::Findings;
use crate::paper::fit::at;
use crate::paper::lab::{Lab, square};
use crate::paper::picture::error;
use crate::paper::subjects::{Subject, Subjects};
use crate::paper::table::Table;
use crate::plot::{Axis, Chart, Dash, Line, Look, Marker};

/// The old and the new judgement, each with both treatments of two regions. The first is the first publication.
const VARIANTS: [(Selection, Regions, &str); 4] = [
    (Selection::Difference, Regions::Together, "difference, together"),
    (Selection::Difference, Regions::Separate, "difference, separate"),
    (Selection::Deviation, Regions::Together, "deviation, together"),
    (Selection::Deviation, Regions::Separate, "deviation, separate"),
];

/// Error and traced share of a variant over Δ.
type Curve = Vec<(f64, f64)>;

pub(super) fn regions(lab: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let columns = [
        "scene",
        "variant",
        "traced_percent_at_16",
        "error_at_16",
        "equal_error",
        "traced_percent_at_equal_error",
    ];
    let mut table = Table::new("regions", &columns);
    for subject in &subjects.main {
        lab.doing(&format!("Old and new judgement: {}", subject.name));
        let (curves, at_16) = sweep(lab, subject)?;
        let target = target(&curves);
        let traced: Vec<Option<f64>> = curves.iter().map(|curve| at(curve, target)).collect();
        for ((variant, traced), (mean, traced_at_16)) in VARIANTS.iter().zip(&traced).zip(at_16) {
            let scene = &subject.name;
            let traced_cell = traced.map_or("–".into(), Into::into);
            table.push([
                scene.into(),
                variant.2.into(),
                traced_at_16.into(),
                mean.into(),
                target.into(),
                traced_cell,
            ]);
        }
        let ratio = |new: usize, old: usize| traced[new].zip(traced[old]).map(|(new, old)| new / old);
        let scene = &subject.name;
        findings.note("regions", format!("separate-over-together/{scene}"), ratio(3, 2));
        findings.note("regions", format!("deviation-over-difference/{scene}"), ratio(3, 1));
        findings.note("regions", format!("new-over-first-version/{scene}"), ratio(3, 0));
    }
    let parts = [vec![chart(&table, &subjects.names()).svg()], vec![shown_table(&table, 3)]].concat();
    findings.add(table);
    let names = |what: &str| subjects.names().iter().map(|s| format!("{what}/{s}")).collect::<Vec<_>>();
    Ok(Figure {
        id: "regions",
        heading: format!("Old and new judgement (N = {})", lab.picture_size(512)),
        paper: "Since the first publication, of two regions the one that can be interpolated is (before: both or none), and \
                brightness is judged by variance (before: by difference from the mean).",
        parts,
        caption: format!(
            "Traced pixels at equal error, new over old: regions apart {}, judgement {}, both changes {}. Below 1 the \
             change saves rays.",
            findings.show_range(&names("separate-over-together"), 3),
            findings.show_range(&names("deviation-over-difference"), 3),
            findings.show_range(&names("new-over-first-version"), 3)
        ),
        table: "regions",
    })
}

/// A curve for each variant, and its error and traced share at Δ = 16.
fn sweep(lab: &Lab, subject: &Subject) -> Result<(Vec<Curve>, Curve), PaperError> {
    let size = lab.picture_size(512);
    let full = lab.picture(&subject.scene, &square(size, Method::Full))?;
    let (mut curves, mut at_16) = (Vec::new(), Vec::new());
    for (selection, regions, _) in VARIANTS {
        let mut curve = Vec::new();
        for delta in SWEEP {
            let method = selection.method_with(delta, regions);
            let picture = lab.picture(&subject.scene, &square(size, method))?;
            let point = (error(&picture.colors, &full.colors).mean_error, picture.traced_percent());
            curve.push(point);
            if delta == DELTA {
                at_16.push(point);
            }
        }
        curves.push(curve);
    }
    Ok((curves, at_16))
}

fn chart(table: &Table, names: &[String]) -> Chart {
    let looks = [
        Look::new(1, Dash::None, Marker::Ring),
        Look::new(4, Dash::None, Marker::Diamond),
        Look::new(2, Dash::None, Marker::Triangle),
        Look::new(0, Dash::None, Marker::Disc),
    ];
    // Side by side, so that none hides another.
    let points = |place: usize| {
        let shift = 0.12 * (place as f64 - 1.5);
        let of = move |(i, scene): (usize, &String)| {
            let fields = [("scene", scene.as_str()), ("variant", VARIANTS[place].2)];
            table.number(&fields, "traced_percent_at_equal_error").map(|y| (i as f64 + shift, y))
        };
        names.iter().enumerate().filter_map(of).collect()
    };
    Chart {
        title: "Traced at equal error".to_owned(),
        x: Axis::names("scene", names),
        y: Axis::linear("traced pixels, %"),
        lines: VARIANTS
            .iter()
            .zip(looks)
            .enumerate()
            .map(|(place, (v, look))| Line { name: v.2.to_owned(), points: points(place), look })
            .collect(),
    }
}
