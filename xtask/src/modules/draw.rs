//! Graphs as a picture: what uses stands above what is used.

use std::fmt::Write as _;

use super::graph::Graph;

const WIDTH: f64 = 1200.0;
const ROW: f64 = 52.0;
const BOX: [f64; 2] = [96.0, 22.0];
const TITLE: f64 = 34.0;

/// All graphs one below the other, as SVG.
pub(super) fn svg(graphs: &[Graph]) -> String {
    let mut body = String::new();
    let mut top = 0.0;
    for graph in graphs {
        top += panel(&mut body, graph, top);
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {top}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"{WIDTH}\" height=\"{top}\" fill=\"#fff\"/>\n{body}</svg>\n"
    )
}

/// Draws a graph below `top`; returns its height.
fn panel(out: &mut String, graph: &Graph, top: f64) -> f64 {
    // Circles are no picture's matter.
    let rows = graph.rows().unwrap_or_default();
    let height = TITLE + ROW * rows.len() as f64;
    let mut places: Vec<(&str, [f64; 2])> = Vec::new();
    for (row, names) in rows.iter().enumerate() {
        let y = top + height - ROW * (row as f64 + 0.5);
        let step = WIDTH / names.len() as f64;
        for (column, &name) in in_order(graph, names, &places).iter().enumerate() {
            places.push((name, [step * (column as f64 + 0.5), y]));
        }
    }
    text(
        out,
        &format!(
            "<text x=\"12\" y=\"{}\" font-size=\"16\" font-weight=\"bold\">{}</text>",
            top + 22.0,
            graph.name
        ),
    );
    let place = |name: &str| places.iter().find(|(known, _)| *known == name).map(|(_, place)| *place);
    for (user, [x, y]) in &places {
        for [to_x, to_y] in graph.nearest(user).into_iter().filter_map(place) {
            let (from, to) = (y + 0.5 * BOX[1], to_y - 0.5 * BOX[1]);
            let bend = 0.5 * (from + to);
            text(
                out,
                &format!(
                    "<path d=\"M{x:.1} {from:.1}C{x:.1} {bend:.1} {to_x:.1} {bend:.1} {to_x:.1} {to:.1}\" fill=\"none\" stroke=\"#8aa\"/>"
                ),
            );
        }
    }
    for (name, [x, y]) in &places {
        let [width, high] = BOX;
        text(
            out,
            &format!(
                "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{width}\" height=\"{high}\" rx=\"4\" fill=\"#eef3f5\" stroke=\"#567\"/>\
             <text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{name}</text>",
                x - 0.5 * width,
                y - 0.5 * high,
                y + 4.0,
            ),
        );
    }
    height
}

/// Names of a row, each about above what it uses: arrows cross less.
fn in_order<'g>(graph: &Graph, names: &[&'g str], places: &[(&str, [f64; 2])]) -> Vec<&'g str> {
    let middle = |name: &str| {
        let used: Vec<f64> = places
            .iter()
            .filter(|(known, _)| graph.used_by(name).any(|used| used == *known))
            .map(|p| p.1[0])
            .collect();
        if used.is_empty() { 0.5 * WIDTH } else { used.iter().sum::<f64>() / used.len() as f64 }
    };
    let mut ordered = names.to_vec();
    ordered.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
    ordered
}

fn text(out: &mut String, line: &str) {
    // Writing to a text cannot fail.
    let _ = writeln!(out, "{line}");
}
