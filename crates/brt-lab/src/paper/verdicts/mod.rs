//! A verdict on each claim of the paper, by rules over the measured numbers. Paper: P1–P20.

mod quality;
mod speed;

use super::findings::{Findings, without_elements};
use super::subjects::Subjects;
use super::table::Table;

/// What becomes of a claim here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Holds,
    Partly,
    DoesNotHold,
    /// What it needs was left out of this run.
    NotMeasured,
}

impl Outcome {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Partly => "partly",
            Self::DoesNotHold => "does not hold here",
            Self::NotMeasured => "not measured in this run",
        }
    }

    /// Holds if all parts do, partly if some do.
    fn of(parts: &[Option<bool>]) -> Self {
        let known: Vec<bool> = parts.iter().filter_map(|p| *p).collect();
        match (known.len(), known.iter().filter(|holds| **holds).count()) {
            (0, _) => Self::NotMeasured,
            (_, 0) => Self::DoesNotHold,
            (all, holding) if holding == all && all == parts.len() => Self::Holds,
            _ => Self::Partly,
        }
    }
}

/// A verdict, with what it rests on.
#[derive(Clone, Debug)]
pub(crate) struct Verdict {
    /// "P8".
    pub(crate) claim: &'static str,
    /// The claim in short.
    pub(crate) says: &'static str,
    pub(crate) outcome: Outcome,
    /// Anchor of the figure that shows it.
    pub(crate) figure: &'static str,
    /// Names of numbers.
    pub(crate) numbers: Vec<String>,
    /// One sentence for the page, its numbers tied to their names.
    pub(crate) why: String,
}

/// All verdicts, P1 to P20.
pub(crate) fn all(findings: &Findings, subjects: &Subjects) -> Vec<Verdict> {
    let bench = Bench { findings, scenes: subjects.names() };
    let mut all = speed::verdicts(&bench, subjects);
    all.extend(quality::verdicts(&bench, subjects));
    all.sort_by_key(|verdict| verdict.claim[1..].parse::<u32>().unwrap_or(0));
    all
}

/// The verdicts as a file: a row for each number that a verdict rests on.
pub(crate) fn table(verdicts: &[Verdict], findings: &Findings) -> Table {
    let mut table = Table::new("verdicts", &["claim", "verdict", "figure", "number", "value", "why"]);
    for v in verdicts {
        for name in &v.numbers {
            let value = findings.number(name).map_or("".into(), Into::into);
            let why = without_elements(&v.why);
            table.push([
                v.claim.into(),
                v.outcome.name().into(),
                v.figure.into(),
                name.into(),
                value,
                (&why).into(),
            ]);
        }
    }
    table
}

/// Where the rules look numbers up.
struct Bench<'a> {
    findings: &'a Findings,
    /// Names of the main scenes.
    scenes: Vec<String>,
}

impl Bench<'_> {
    /// A name for each main scene: `{}` stands for it.
    fn names(&self, pattern: &str) -> Vec<String> {
        self.scenes.iter().map(|scene| pattern.replace("{}", scene)).collect()
    }

    /// Does a number satisfy a condition?
    fn test(&self, name: &str, holds: impl Fn(f64) -> bool) -> Option<bool> {
        self.findings.number(name).map(holds)
    }

    /// The same for each of several.
    fn tests(&self, names: &[String], holds: impl Fn(f64) -> bool) -> Vec<Option<bool>> {
        names.iter().map(|name| self.test(name, &holds)).collect()
    }

    fn range(&self, names: &[String], decimals: usize) -> String {
        self.findings.show_range(names, decimals)
    }

    fn show(&self, name: &str, decimals: usize) -> String {
        self.findings.show(name, decimals)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outcome_follows_from_its_parts() {
        assert_eq!(Outcome::of(&[Some(true), Some(true)]), Outcome::Holds);
        assert_eq!(Outcome::of(&[Some(true), Some(false)]), Outcome::Partly);
        assert_eq!(Outcome::of(&[Some(true), None]), Outcome::Partly);
        assert_eq!(Outcome::of(&[Some(false), None]), Outcome::DoesNotHold);
        assert_eq!(Outcome::of(&[None]), Outcome::NotMeasured);
        assert_eq!(Outcome::of(&[]), Outcome::NotMeasured);
    }

    #[test]
    fn rules_follow_the_numbers() {
        let subjects =
            Subjects::new(&crate::paper::Options { sizes: vec![16], repeat: 1, quick: true, scene: None });
        let subjects = subjects.unwrap();
        let outcome = |full: f64, border: f64| {
            let mut findings = Findings::default();
            for scene in ["A", "B", "C"] {
                findings.note("fig1", format!("time-exponent/full/{scene}/none"), Some(full));
                findings.note("fig1", format!("time-exponent/border/{scene}/none"), Some(border));
            }
            all(&findings, &subjects).into_iter().find(|v| v.claim == "P8").unwrap().outcome
        };
        // The parts on other families are unknown, so it can hold partly at best.
        assert_eq!(outcome(2.0, 1.1), Outcome::Partly);
        assert_eq!(outcome(2.4, 1.9), Outcome::DoesNotHold);
    }

    #[test]
    fn there_is_a_verdict_on_each_claim() {
        let options = crate::paper::Options { sizes: vec![16], repeat: 1, quick: true, scene: None };
        let subjects = Subjects::new(&options).unwrap();
        let claims: Vec<&str> = all(&Findings::default(), &subjects).iter().map(|v| v.claim).collect();
        let expected: Vec<String> = (1..=20).map(|i| format!("P{i}")).collect();
        assert_eq!(claims, expected);
    }
}
