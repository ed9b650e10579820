//! The experiments, in the order of the paper and then beyond it.
//!
//! Each measures, adds its tables and numbers to the findings, and draws its figures from them.

mod bounds;
mod checks;
mod delta;
mod equal_error;
mod families;
mod first_hit;
mod growth;
mod highlight;
mod histogram;
mod kinds;
mod regions;
mod selected;
mod sheet;
mod table1;

use super::PaperError;
use super::contenders::Selection;
use super::findings::Findings;
use super::lab::Lab;
use super::subjects::Subjects;
use super::table::Table;
use crate::plot::{Chart, Dash, Look, Marker, escape};

/// A figure of the page.
#[derive(Clone, Debug)]
pub(crate) struct Figure {
    /// Its anchor.
    pub(crate) id: &'static str,
    pub(crate) heading: String,
    /// What the paper says of it.
    pub(crate) paper: &'static str,
    /// Charts, pictures, tables: elements side by side.
    pub(crate) parts: Vec<String>,
    /// What is seen here.
    pub(crate) caption: String,
    /// The file with its numbers, without `.csv`.
    pub(crate) table: &'static str,
}

/// An experiment.
type Experiment = fn(&Lab, &Subjects, &mut Findings) -> Result<Figure, PaperError>;

/// All of them, in the order of the page.
pub(crate) const ALL: [Experiment; 18] = [
    table1::table1,
    growth::fig1,
    growth::fig2,
    selected::fig3,
    growth::fig4,
    delta::fig5,
    histogram::fig6,
    highlight::fig7,
    highlight::lost_objects,
    sheet::picture1,
    equal_error::equal_error,
    regions::regions,
    first_hit::first_hit,
    families::families,
    kinds::kinds,
    bounds::bounds,
    bounds::certificates,
    checks::checks,
];

/// The look of a selection of pixels, the same in all figures.
fn look_of(selection: Selection) -> Look {
    match selection {
        Selection::Deviation => Look::new(0, Dash::Solid, Marker::Disc),
        Selection::Variance => Look::new(2, Dash::Solid, Marker::Triangle),
        Selection::Difference => Look::new(4, Dash::Dotted, Marker::Diamond),
        Selection::Psrt => Look::new(1, Dash::Broken, Marker::Ring),
    }
}

/// Charts as elements of a figure.
fn drawn(charts: &[Chart]) -> Vec<String> {
    charts.iter().map(Chart::svg).collect()
}

/// A table as an element of a figure, numbers rounded.
fn shown_table(table: &Table, decimals: usize) -> String {
    use super::table::Cell;
    let head: String =
        table.columns().iter().map(|c| format!("<th>{}</th>", escape(&c.replace('_', " ")))).collect();
    let cell = |cell: &Cell| match cell {
        Cell::Text(text) => format!("<td>{}</td>", escape(text)),
        Cell::Number(n) if n.fract() == 0.0 => format!("<td class=\"n\">{n}</td>"),
        Cell::Number(n) => format!("<td class=\"n\">{n:.decimals$}</td>"),
    };
    let row = |cells: &Vec<Cell>| format!("<tr>{}</tr>\n", cells.iter().map(cell).collect::<String>());
    let rows: String = table.rows().iter().map(row).collect();
    format!(
        "<div class=\"scroll\"><table><thead><tr>{head}</tr></thead><tbody>\n{rows}</tbody></table></div>"
    )
}

/// Sizes as numbers at an axis.
fn size_steps(lab: &Lab) -> Vec<f64> {
    lab.sizes.iter().map(|&s| f64::from(s)).collect()
}
