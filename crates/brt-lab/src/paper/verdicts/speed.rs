//! Verdicts on time and counts: P1, P2, P7–P11, P18.

use super::{Bench, Outcome, Verdict};
use crate::paper::contenders::{ACCELERATORS, Family, METHODS};
use crate::paper::subjects::Subjects;

/// Exponents that count as N² and as N.
const SQUARE: [f64; 2] = [1.9, 2.1];
const LINEAR: [f64; 2] = [0.75, 1.3];
/// A gain that grows with N by at most this power does not grow.
const FLAT: f64 = 0.15;
/// A gain that grows with at least this power grows with resolution.
const GROWS: f64 = 0.3;

fn within([lo, hi]: [f64; 2]) -> impl Fn(f64) -> bool + Copy {
    move |v| (lo..=hi).contains(&v)
}

pub(super) fn verdicts(bench: &Bench, subjects: &Subjects) -> Vec<Verdict> {
    vec![
        p1(bench),
        p2(bench, subjects),
        p7(bench),
        p8(bench),
        p9(bench),
        p10(bench),
        p11(bench),
        p18(bench, subjects),
    ]
}

/// Names of the gains of a family's methods (space divisions: of RT with each structure).
fn of_family(bench: &Bench, what: &str, family: Family) -> Vec<String> {
    match family {
        Family::Standard => {
            let structures = ACCELERATORS.iter().skip(1);
            structures.flat_map(|a| bench.names(&format!("{what}/full/{}/{{}}", a.0))).collect()
        }
        _ => {
            let methods = METHODS.iter().filter(|m| m.family == family);
            methods.flat_map(|m| bench.names(&format!("{what}/{}/none/{{}}", m.name))).collect()
        }
    }
}

fn p1(bench: &Bench) -> Verdict {
    let best = |names: &[String]| {
        let known = names.iter().filter_map(|n| bench.findings.number(n).map(|v| (n.clone(), v)));
        known.max_by(|a, b| a.1.total_cmp(&b.1)).map(|best| best.0)
    };
    let families = [Family::Standard, Family::Interpolation, Family::Hybrid];
    let best = families.map(|f| best(&of_family(bench, "family-gain", f)));
    let parts: Vec<_> =
        best.iter().map(|n| n.as_ref().and_then(|n| bench.test(n, |gain| gain > 1.1))).collect();
    let missing = METHODS.iter().any(|m| m.method.is_none()) || ACCELERATORS.iter().any(|a| a.1.is_none());
    let outcome = match Outcome::of(&parts) {
        Outcome::Holds if missing => Outcome::Partly,
        outcome => outcome,
    };
    let shown = best.each_ref().map(|n| n.as_ref().map_or("–".to_owned(), |n| bench.show(n, 1)));
    let not_built = if missing { "; not all methods it names are built" } else { "" };
    Verdict {
        claim: "P1",
        says: "speed-ups fall into three families: space division, pixel interpolation, hybrids",
        outcome,
        figure: "families",
        numbers: best.into_iter().flatten().collect(),
        why: format!(
            "At the largest size compared, the best of each family is {}, {} and {} times as fast as plain RT{not_built}.",
            shown[0], shown[1], shown[2]
        ),
    }
}

fn p2(bench: &Bench, subjects: &Subjects) -> Verdict {
    let names: Vec<String> = subjects
        .with_blocks()
        .chain([&subjects.torus])
        .map(|s| format!("kind-gain-exponent/{}", s.name))
        .collect();
    let errors = bench.names("error-at-16/border-deviation/{}");
    let growth = bench.findings.knows_any(&names).then(|| {
        let power = bench.range(&names, 2);
        format!(
            "BRT's gain grows as N to the power {power} over balls, planes, mixed scenes and a smooth mesh, while its"
        )
    });
    Verdict {
        claim: "P2",
        says: "interpolation gains with resolution whatever the primitive; its weakness is quality",
        outcome: Outcome::of(&bench.tests(&names, |k| k >= GROWS)),
        figure: "kinds",
        why: format!(
            "{} pictures are off by {} levels in the mean.",
            growth.unwrap_or_else(|| "BRT's".to_owned()),
            bench.range(&errors, 2)
        ),
        numbers: [names, errors].concat(),
    }
}

fn p7(bench: &Bench) -> Verdict {
    let name = "table1/differing-counts".to_owned();
    Verdict {
        claim: "P7",
        says: "scenes A, B, C of Table 1, without acceleration, N = 128 … 1024, Δ = 4 … 128",
        outcome: Outcome::of(&[bench.test(&name, |n| n == 0.0)]),
        figure: "table1",
        why: format!(
            "{} of the counts in Table 1 differ; positions, colours and lights are ours, so absolute numbers may differ.",
            bench.show(&name, 0)
        ),
        numbers: vec![name],
    }
}

fn p8(bench: &Bench) -> Verdict {
    let full = bench.names("time-exponent/full/{}/none");
    let border = bench.names("time-exponent/border/{}/none");
    let flat = [Family::Standard, Family::Hybrid]
        .map(|family| of_family(bench, "family-gain-exponent", family))
        .concat();
    let gaining = flat.iter().filter(|n| bench.test(n, |k| k > FLAT) == Some(true)).count();
    let known = bench.findings.knows_any(&flat);
    let times = bench.findings.knows_any(&full).then(|| {
        let powers = [&full, &border].map(|names| bench.range(names, 2));
        format!("RT's time grows as N to the power {}, BRT's to the power {}.", powers[0], powers[1])
    });
    let gains = known.then(|| {
        format!("The gain of space divisions and hybrids grows as N to the power {}.", bench.range(&flat, 2))
    });
    let parts = [
        bench.tests(&full, within(SQUARE)),
        bench.tests(&border, within(LINEAR)),
        vec![known.then_some(gaining == 0)],
    ];
    Verdict {
        claim: "P8",
        says: "RT's time grows as N², BRT's as N; space division and hybrids do not gain with N",
        outcome: Outcome::of(&parts.concat()),
        figure: "fig1",
        why: times.into_iter().chain(gains).collect::<Vec<_>>().join(" "),
        numbers: [full, border, flat].concat(),
    }
}

fn p9(bench: &Bench) -> Verdict {
    let faster = bench.names("psrt-time-over-brt/{}/none");
    let fewer = bench.names("brt-traced-over-psrt/border-deviation/{}");
    let parts = [bench.tests(&faster, |r| r >= 1.4), bench.tests(&fewer, |r| r < 1.0)];
    Verdict {
        claim: "P9",
        says: "BRT is 1.4 to 5 times as fast as PSRT and traces fewer pixels",
        outcome: Outcome::of(&parts.concat()),
        figure: "fig2",
        why: format!(
            "Without acceleration BRT is {} times as fast as PSRT and traces {} times as many pixels, at the same Δ; at \
             equal error it traces {} times as many.",
            bench.range(&faster, 2),
            bench.range(&fewer, 2),
            bench.range(&bench.names("brt-traced-over-psrt-at-equal-error/{}"), 2)
        ),
        numbers: [faster, fewer, bench.names("brt-traced-over-psrt-at-equal-error/{}")].concat(),
    }
}

fn p10(bench: &Bench) -> Verdict {
    let (most, fewest) = ("first-hit-gain/shadows/most", "first-hit-gain/shadows/fewest");
    let grows = bench.findings.number(most).zip(bench.findings.number(fewest)).map(|(a, b)| a > b);
    Verdict {
        claim: "P10",
        says: "knowing the first hit gains up to 2× where only shading is computed, most with many primitives",
        outcome: Outcome::of(&[bench.test(most, within([1.5, 2.3])), grows]),
        figure: "first-hit",
        why: format!(
            "With one light and its shadows the gain rises from {} with one ball to {} with most.",
            bench.show(fewest, 2),
            bench.show(most, 2)
        ),
        numbers: vec![most.to_owned(), fewest.to_owned()],
    }
}

fn p11(bench: &Bench) -> Verdict {
    let papers = bench.names("perspective-share/{}/none");
    let today = bench.names("perspective-share/{}/bvh");
    Verdict {
        claim: "P11",
        says: "the perspective image costs 1 to 5 % of BRT's time even at N = 1024",
        outcome: Outcome::of(&bench.tests(&papers, |share| share <= 5.0)),
        figure: "fig4",
        why: format!(
            "It takes {} % without acceleration and {} % with a hierarchy, where rays are cheaper.",
            bench.range(&papers, 1),
            bench.range(&today, 1)
        ),
        numbers: [papers, today].concat(),
    }
}

fn p18(bench: &Bench, subjects: &Subjects) -> Verdict {
    let name = |scene: &str| format!("kind-gain/{scene}");
    let gain = |scene: &str| bench.findings.number(&name(scene));
    let more = |a: &str, b: &str| gain(a).zip(gain(b)).map(|(a, b)| a > b);
    let flat = if subjects.are_papers { vec!["C", "blocks"] } else { vec!["blocks"] };
    let round = if subjects.are_papers { vec!["A", "B"] } else { vec!["torus"] };
    let parts: Vec<Option<bool>> =
        flat.iter().flat_map(|f| round.iter().map(|r| more(f, r)).collect::<Vec<_>>()).collect();
    let names = |scenes: &[&str]| scenes.iter().map(|s| name(s)).collect::<Vec<_>>();
    Verdict {
        claim: "P18",
        says: "acceleration depends on the kind of primitive and is largest on planes",
        outcome: Outcome::of(&parts),
        figure: "kinds",
        why: format!(
            "Planar scenes gain {} times, those with curved primitives {} times, a smooth mesh {} times.",
            bench.range(&names(&flat), 1),
            bench.range(&names(&round), 1),
            bench.show(&name("torus"), 1)
        ),
        numbers: [names(&flat), names(&round), vec![name("torus")]].concat(),
    }
}
