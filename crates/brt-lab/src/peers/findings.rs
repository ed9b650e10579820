//! What was measured.

use brt::Comparison;

use super::deviation::Deviation;
use super::entrant::{Class, ENTRANTS, Entrant};
use super::history::Record;

/// All that goes into the table, the file and the page.
pub(super) struct Findings {
    /// Where and when, a line each.
    pub(super) conditions: Vec<String>,
    /// What is missing, what was replaced, what went wrong.
    pub(super) notes: Vec<String>,
    /// In the order of scenes, sizes, entrants.
    pub(super) rows: Vec<Row>,
    /// Pictures of each scene, beside each other.
    pub(super) pictures: Vec<Strip>,
    pub(super) repeat: u32,
    /// What former runs recorded and this one does.
    pub(super) history: Vec<Record>,
    pub(super) processor: String,
}

/// A scene at a size by an entrant.
pub(super) struct Row {
    pub(super) scene: String,
    pub(super) size: [u32; 2],
    pub(super) entrant: Entrant,
    /// What was subtracted from each run, in seconds.
    pub(super) start_up: f64,
    /// User CPU of each run without its start-up, in nanoseconds per pixel, ascending.
    pub(super) ns_per_pixel: Vec<f64>,
    /// From the reference of its class.
    pub(super) deviation: Option<Deviation>,
}

/// Pictures of a scene.
pub(super) struct Strip {
    pub(super) scene: String,
    /// A caption and an `<img>` each.
    pub(super) pictures: Vec<(String, String)>,
}

impl Row {
    pub(super) fn median(&self) -> Option<f64> {
        median(&self.ns_per_pixel)
    }

    /// Least and greatest.
    pub(super) fn range(&self) -> Option<[f64; 2]> {
        Some([*self.ns_per_pixel.first()?, *self.ns_per_pixel.last()?])
    }
}

/// Share of the pixels that differ by more than 2 levels, in percent.
pub(super) fn percent_over_2(error: &Comparison) -> f64 {
    100.0 * error.over_2 as f64 / error.pixels.max(1) as f64
}

impl Findings {
    /// How many times as long as our own entrant of the same scene, size and class.
    pub(super) fn ratio(&self, row: &Row, ours: &str) -> Option<f64> {
        let name = |e: &&Entrant| e.class == row.entrant.class && e.name.starts_with(ours);
        let ours = ENTRANTS.iter().find(name)?;
        let same = |r: &&Row| r.scene == row.scene && r.size == row.size && r.entrant == *ours;
        let base = self.rows.iter().find(same)?.median().filter(|base| *base > 0.0)?;
        Some(row.median()? / base)
    }

    /// Scenes with their sizes, each once, in order.
    pub(super) fn tasks(&self) -> Vec<(&str, [u32; 2])> {
        let mut tasks: Vec<(&str, [u32; 2])> = self.rows.iter().map(|r| (r.scene.as_str(), r.size)).collect();
        tasks.dedup();
        tasks
    }

    /// The rows of a scene at a size in a class.
    pub(super) fn rows_of(&self, task: (&str, [u32; 2]), class: Class) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |r| (r.scene.as_str(), r.size) == task && r.entrant.class == class)
    }

    /// The median of how far runs of the same work lie apart, as a share of their median; `None` without repetitions.
    pub(super) fn spread(&self) -> Option<f64> {
        let mut spreads: Vec<f64> = self
            .rows
            .iter()
            .filter(|row| row.ns_per_pixel.len() > 1)
            .filter_map(|row| Some((row.range()?, row.median().filter(|m| *m > 0.0)?)))
            .map(|([least, greatest], median)| (greatest - least) / median)
            .collect();
        spreads.sort_by(f64::total_cmp);
        median(&spreads)
    }
}

/// Of ascending values.
pub(super) fn median(values: &[f64]) -> Option<f64> {
    let middle = values.len() / 2;
    match values.len() {
        0 => None,
        n if n % 2 == 1 => Some(values[middle]),
        _ => Some(0.5 * (values[middle - 1] + values[middle])),
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::deviation::Amount;
    use super::*;

    /// `full` takes 100 ns, everybody else 50 more than the one before.
    pub(in super::super) fn example() -> Findings {
        let row = |(i, entrant): (usize, &Entrant)| {
            let median = 100.0 + 50.0 * i as f64;
            let (linear, srgb) = (Amount { mean: 0.25, rms: 0.75 }, Amount { mean: 0.5, rms: 1.5 });
            let deviation = Some(Deviation { linear, srgb, percent_over_2: 0.5 });
            let ns_per_pixel = vec![0.9 * median, median, 1.1 * median];
            let size = [32, 32];
            Row { scene: "a,b".into(), size, entrant: *entrant, start_up: 0.002, ns_per_pixel, deviation }
        };
        let rows = ENTRANTS.iter().enumerate().map(row).collect();
        let picture = ("POV-Ray".to_owned(), "<img alt=\"\">".to_owned());
        let pictures = vec![Strip { scene: "a,b".into(), pictures: vec![picture] }];
        let conditions = vec!["Processor <1>".to_owned()];
        let (history, processor) = (Vec::new(), "Fast 3000".to_owned());
        Findings {
            conditions,
            notes: vec!["a & b".to_owned()],
            rows,
            pictures,
            repeat: 3,
            history,
            processor,
        }
    }

    #[test]
    fn ratios_are_to_ours_of_the_same_class() {
        let findings = example();
        // POV-Ray: 250 to 100 of `full` and 200 of `certified`.
        assert_eq!(findings.ratio(&findings.rows[3], "brt full"), Some(2.5));
        assert_eq!(findings.ratio(&findings.rows[3], "brt certified"), Some(1.25));
        // Anti-aliased POV-Ray: 500 to 350.
        assert_eq!(findings.ratio(&findings.rows[8], "brt full"), Some(500.0 / 350.0));
        assert!((findings.spread().unwrap() - 0.2).abs() < 1e-12);
        assert_eq!(findings.tasks(), [("a,b", [32, 32])]);
    }

    #[test]
    fn medians_of_any_number() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[1.0, 3.0, 8.0]), Some(3.0));
        assert_eq!(median(&[1.0, 3.0]), Some(2.0));
    }
}
