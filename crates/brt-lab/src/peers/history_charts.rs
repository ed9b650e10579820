//! The history as charts: what became of the ratios to the peers, and of our times, from label to label.

use super::findings::median;
use super::history::Record;
use super::program::Peer;
use crate::plot::{Axis, Chart, Dash, Line, Look, Marker};

const METHODS: [(&str, Marker); 3] =
    [("full", Marker::Square), ("border", Marker::Triangle), ("certified", Marker::Disc)];

/// A section of the page; nothing unless a processor has seen several labels. Times of two processors say nothing about
/// programs.
pub(super) fn section(history: &[Record], processor: &str) -> String {
    let here: Vec<&Record> = history.iter().filter(|r| r.processor == processor).collect();
    let labels = distinct(here.iter().map(|r| r.label.as_str()));
    if labels.len() < 2 {
        return String::new();
    }
    let charts: String = distinct(here.iter().map(|r| (r.scene.as_str(), r.samples)))
        .into_iter()
        .flat_map(|(scene, samples)| {
            let mine = |r: &&&Record| r.scene == scene && r.samples == samples;
            let records: Vec<&Record> = here.iter().filter(mine).copied().collect();
            // Of several sizes the largest says most.
            let size = records.iter().map(|r| r.size).max().unwrap_or_default();
            let records: Vec<&Record> = records.into_iter().filter(|r| r.size == size).collect();
            charts(&records, &labels)
        })
        .collect();
    format!(
        "<h2>History</h2>\n<p>Medians of all runs of a label on this processor, in the order in which labels were first \
         recorded. Ratios come from programs that took turns and tell more than times.</p>\n\
         <div class=\"parts\">\n{charts}</div>\n"
    )
}

/// In the order of their first appearance.
fn distinct<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    items.fold(Vec::new(), |mut known, item| {
        if !known.contains(&item) {
            known.push(item);
        }
        known
    })
}

/// Those of a scene at one size with one number of samples.
fn charts(records: &[&Record], labels: &[&str]) -> Vec<String> {
    let Some(first) = records.first() else { return Vec::new() };
    let [width, height] = first.size;
    let s = if first.samples == 1 { "" } else { "s" };
    let title = format!("{} {width} × {height}, {} sample{s}", first.scene, first.samples);
    let chart = |title: String, unit: &str, lines: Vec<Line>| {
        let names: Vec<String> = labels.iter().map(|&label| label.to_owned()).collect();
        let drawn = lines.iter().any(|line| !line.points.is_empty());
        let chart = Chart { title, x: Axis::names("", &names), y: Axis::logarithmic(unit), lines };
        drawn.then(|| chart.svg())
    };
    let ratios = Peer::ALL.into_iter().enumerate().map(|(i, peer)| {
        let lines = lines(records, labels, |record| record.ratios[i]);
        chart(format!("{title}: {} ÷ brt", peer.name()), "times as long as brt", lines)
    });
    let times = lines(records, labels, |record| Some(record.ns_per_pixel));
    ratios.chain([chart(title.clone(), "ns per pixel", times)]).flatten().collect()
}

/// A line for each method.
fn lines(records: &[&Record], labels: &[&str], value: impl Fn(&Record) -> Option<f64>) -> Vec<Line> {
    let at = |method: &str, label: &str| {
        let same = records.iter().filter(|r| r.method == method && r.label == label);
        let mut values: Vec<f64> = same.filter_map(|record| value(record)).collect();
        values.sort_by(f64::total_cmp);
        median(&values)
    };
    let line = |(color, (method, marker)): (usize, (&str, Marker))| {
        let points = labels.iter().enumerate().filter_map(|(i, label)| Some((i as f64, at(method, label)?)));
        Line {
            name: method.to_owned(),
            points: points.collect(),
            look: Look::new(color, Dash::Solid, marker),
        }
    };
    METHODS.into_iter().enumerate().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::super::history::tests::two_runs;
    use super::*;

    #[test]
    fn several_labels_of_this_processor_are_drawn() {
        let runs = two_runs();
        let html = section(&runs, "Fast 3000");
        // Two classes; two peers and our times each.
        assert_eq!(html.matches("<svg").count(), 2 * 3);
        // A disc for certified at both labels, and one in the legend.
        assert_eq!(html.matches("<circle").count(), 2 * 3 * 3);
        assert!(html.contains("a,b 32 × 32, 1 sample: POV-Ray ÷ brt") && html.contains(">0.2</text>"));
        assert_eq!(section(&runs, "another"), "");
        assert_eq!(section(&runs[..6], "Fast 3000"), "");
    }
}
