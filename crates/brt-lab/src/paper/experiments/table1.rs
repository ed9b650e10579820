//! Table 1: how many primitives of which kind, the paper's beside ours. Paper: P7.

use brt::{Scene, Shape};

use super::Figure;
use crate::paper::PaperError;
use crate::paper::findings::Findings;
use crate::paper::lab::Lab;
use crate::paper::subjects::Subjects;
use crate::paper::table::Table;
use crate::plot::escape;

/// The paper's counts: mirrored planes, mirrored balls, all.
const PAPERS: [(&str, [u32; 3]); 3] = [("A", [2, 1, 4]), ("B", [0, 49, 50]), ("C", [57, 0, 71])];
const ROWS: [&str; 3] = ["plane (mirror)", "ball (mirror)", "total"];

pub(super) fn table1(_: &Lab, subjects: &Subjects, findings: &mut Findings) -> Result<Figure, PaperError> {
    let mut table = Table::new("table1", &["scene", "primitives", "paper", "here"]);
    let mut wrong = 0;
    for subject in &subjects.main {
        let papers = PAPERS.iter().find(|p| p.0 == subject.name).map(|p| p.1);
        for (i, (row, here)) in ROWS.into_iter().zip(counts(&subject.scene)).enumerate() {
            let paper = papers.filter(|_| subjects.are_papers).map(|p| p[i]);
            wrong += u32::from(paper.is_some_and(|p| p != here));
            let paper = paper.map_or("–".into(), Into::into);
            table.push([(&subject.name).into(), row.into(), paper, here.into()]);
        }
    }
    let differing = subjects.are_papers.then_some(f64::from(wrong));
    findings.note("table1", "table1/differing-counts", differing);
    let parts = vec![as_in_the_paper(subjects, &table)];
    findings.add(table);
    Ok(Figure {
        id: "table1",
        heading: "Table 1: experiment data".to_owned(),
        paper: "Counts of primitives. The scenes themselves, their positions, colours and lights, are not in the paper.",
        parts,
        caption: if subjects.are_papers {
            "The scenes <code>seed-a</code>, <code>seed-b</code> and <code>seed-c</code> are our reconstruction with \
             the paper's counts; <code>brt scene seed-a -o a.toml</code> writes the first."
                .to_owned()
        } else {
            "Your scene in place of the paper's three.".to_owned()
        },
        table: "table1",
    })
}

/// Kinds in rows, scenes in columns.
fn as_in_the_paper(subjects: &Subjects, table: &Table) -> String {
    let columns = if subjects.are_papers { ["paper", "here"].as_slice() } else { &["here"] };
    let scenes = || subjects.main.iter().flat_map(|s| columns.iter().map(move |column| (&s.name, *column)));
    let head: String =
        scenes().map(|(scene, column)| format!("<th>{}, {column}</th>", escape(scene))).collect();
    let row = |kind: &str| {
        let cell = |(scene, column): (&String, &str)| {
            let count = table.number(&[("scene", scene), ("primitives", kind)], column);
            format!("<td class=\"n\">{}</td>", count.map_or("–".to_owned(), |c| c.to_string()))
        };
        format!("<tr><td>{kind}</td>{}</tr>", scenes().map(cell).collect::<String>())
    };
    let rows: String = ROWS.into_iter().map(row).collect();
    format!(
        "<div class=\"scroll\"><table><thead><tr><th>primitives</th>{head}</tr></thead><tbody>{rows}</tbody></table></div>"
    )
}

/// Mirrored flat primitives, mirrored balls, all primitives.
fn counts(scene: &Scene) -> [u32; 3] {
    let mut counts = [0, 0, scene.objects.len() as u32];
    for object in &scene.objects {
        let is_mirror = scene.materials[object.material.0 as usize].reflection > 0.0;
        match object.shape {
            Shape::Plane { .. } | Shape::Polygon { .. } | Shape::Disc { .. } => {
                counts[0] += u32::from(is_mirror);
            }
            Shape::Sphere { .. } => counts[1] += u32::from(is_mirror),
            _ => {}
        }
    }
    counts
}
