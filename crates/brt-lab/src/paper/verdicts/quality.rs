//! Verdicts on the method and its errors: P3–P6, P12–P17, P19, P20.

use super::{Bench, Outcome, Verdict};
use crate::paper::subjects::Subjects;

/// A step by less than this share is none: the curve has saturated.
const SATURATED: f64 = 0.02;

pub(super) fn verdicts(bench: &Bench, subjects: &Subjects) -> Vec<Verdict> {
    vec![
        p3(bench, subjects),
        p4(bench),
        p5(bench, subjects),
        p6(bench),
        p12(bench),
        p13(bench, subjects),
        p14(bench),
        p15(bench),
        p16(bench),
        p17(bench),
        p19(bench),
        p20(bench),
    ]
}

fn with_blocks(pattern: &str, subjects: &Subjects) -> Vec<String> {
    subjects.with_blocks().map(|s| pattern.replace("{}", &s.name)).collect()
}

fn p3(bench: &Bench, subjects: &Subjects) -> Verdict {
    let differ = with_blocks("known-first-hits-differ/{}", subjects);
    let traced = with_blocks("traced-percent/border-deviation/{}", subjects);
    let parts = [bench.tests(&differ, |n| n == 0.0), bench.tests(&traced, |share| share < 50.0)];
    Verdict {
        claim: "P3",
        says: "a perspective image chooses which pixels are traced and which interpolated",
        outcome: Outcome::of(&parts.concat()),
        figure: "checks",
        why: format!(
            "{} pixels change when first hits are taken from it instead of searched, and {} % of the pixels are traced.",
            bench.range(&differ, 0),
            bench.range(&traced, 1)
        ),
        numbers: [differ, traced].concat(),
    }
}

fn p4(bench: &Bench) -> Verdict {
    let names = [
        "balls-lost/border-deviation",
        "balls-lost/pixel-selected",
        "objects-lost/border-deviation",
        "objects-lost/pixel-selected",
    ];
    let fewer = bench.names("brt-traced-over-psrt/border-deviation/{}");
    let tests = "first-hit-tests/ambient/most";
    let number = |name: &str| bench.findings.number(name);
    let fewer_lost = number(names[2]).zip(number(names[3])).map(|(brt, psrt)| brt < psrt);
    let mut parts = vec![bench.test(names[0], |n| n == 0.0), fewer_lost, bench.test(tests, |t| t <= 1.0)];
    parts.extend(bench.tests(&fewer, |r| r < 1.0));
    Verdict {
        claim: "P4",
        says: "small objects are not lost, fewer pixels are traced, the first hit costs one test",
        outcome: Outcome::of(&parts),
        figure: "lost",
        why: format!(
            "BRT loses {} of the very small balls (PSRT {}) and gets {} of the adversary's objects wrong (PSRT {}), traces \
             {} times as many pixels as PSRT, and needs {} test per first hit.",
            bench.show(names[0], 0),
            bench.show(names[1], 0),
            bench.show(names[2], 0),
            bench.show(names[3], 0),
            bench.range(&fewer, 2),
            bench.show(tests, 2)
        ),
        numbers: [names.map(str::to_owned).to_vec(), fewer, vec![tests.to_owned()]].concat(),
    }
}

fn p5(bench: &Bench, subjects: &Subjects) -> Verdict {
    let names = with_blocks("right-history-percent/{}", subjects);
    Verdict {
        claim: "P5",
        says: "four points of equal history and small variance stand for all between them",
        outcome: Outcome::of(&bench.tests(&names, |percent| percent >= 99.0)),
        figure: "checks",
        why: format!(
            "{} % of the filled pixels would have had the history judged; the others are what four points overlook.",
            bench.range(&names, 2)
        ),
        numbers: names,
    }
}

fn p6(bench: &Bench) -> Verdict {
    let regions = bench.names("separate-over-together/{}");
    let judge = bench.names("deviation-over-difference/{}");
    let parts = [bench.tests(&regions, |r| r < 1.0), bench.tests(&judge, |r| r <= 1.005)];
    Verdict {
        claim: "P6",
        says: "two regions are judged apart, and by variance instead of difference",
        outcome: Outcome::of(&parts.concat()),
        figure: "regions",
        why: format!(
            "At equal error regions judged apart trace {} times as many pixels as together; deviation {} times as many as \
             difference.",
            bench.range(&regions, 3),
            bench.range(&judge, 3)
        ),
        numbers: [regions, judge].concat(),
    }
}

fn p12(bench: &Bench) -> Verdict {
    let name = "error-formula/greatest-difference";
    Verdict {
        claim: "P12",
        says: "error of a pixel: (|r − r₀| + |g − g₀| + |b − b₀|) / 3 against RT",
        outcome: Outcome::of(&[bench.test(name, |d| d < 1e-6)]),
        figure: "fig5",
        why: format!(
            "The formula written out and the measure of <code>brt compare</code> differ by {} levels at most.",
            bench.show(name, 6)
        ),
        numbers: vec![name.to_owned()],
    }
}

fn p13(bench: &Bench, subjects: &Subjects) -> Verdict {
    let key = "border-deviation";
    let error = bench.names(&format!("error-128-over-64/{key}/{{}}"));
    let traced = bench.names(&format!("traced-128-over-64/{key}/{{}}"));
    let falls = bench.names(&format!("traced-128-over-4/{key}/{{}}"));
    let steady = |v: f64| (v - 1.0).abs() <= SATURATED;
    let mut parts = [bench.tests(&error, steady), bench.tests(&traced, steady)].concat();
    parts.extend(bench.tests(&falls, |v| v < 1.0));
    let from_the_start = format!("error-4-over-128/{key}/C");
    let mut numbers = [error.clone(), traced, falls].concat();
    let mut why = format!(
        "From Δ = 64 to 128 the error changes by a factor of {} (less than 2 % counts as saturated)",
        bench.range(&error, 3)
    );
    if subjects.are_papers {
        parts.push(bench.test(&from_the_start, |v| v > 0.8));
        why.push_str(&format!(
            "; on C it is at Δ = 4 {} of what it is at 128, where the paper sees hardly any change",
            bench.show(&from_the_start, 2)
        ));
        numbers.push(from_the_start);
    }
    Verdict {
        claim: "P13",
        says: "with growing Δ error and traced share saturate; C is decided by histories from the start",
        outcome: Outcome::of(&parts),
        figure: "fig5",
        why: why + ".",
        numbers,
    }
}

fn p14(bench: &Bench) -> Verdict {
    let names = bench.names("best-delta/border-deviation/{}");
    Verdict {
        claim: "P14",
        says: "a Δ with small error and few traced pixels exists and differs per picture; 16 is near the best",
        outcome: Outcome::of(&bench.tests(&names, |delta| (8.0..=32.0).contains(&delta))),
        figure: "fig5",
        why: format!(
            "The least sum of error and traced share, each scaled from its least to its greatest, is at Δ = {}; a factor of \
             two from 16 counts as near.",
            bench.range(&names, 0)
        ),
        numbers: names,
    }
}

fn p15(bench: &Bench) -> Verdict {
    let [traced, errors] = ["brt-traced-over-psrt", "brt-error-over-psrt"].map(|what| {
        ["border-deviation", "border-variance", "border-difference"]
            .map(|reading| bench.names(&format!("{what}/{reading}/{{}}")))
    });
    // Fewer traced and less error, of one reading on one scene.
    let both = traced.iter().flatten().zip(errors.iter().flatten()).filter_map(|(traced, error)| {
        let less = |name: &String| bench.test(name, |ratio| ratio < 1.0);
        less(traced).zip(less(error)).map(|(fewer, smaller)| fewer && smaller)
    });
    let both: Vec<bool> = both.collect();
    let mut parts = bench.tests(&traced[0], |r| r < 1.0);
    parts.push((!both.is_empty()).then(|| both.contains(&true)));
    Verdict {
        claim: "P15",
        says: "BRT interpolates more pixels than PSRT, yet its error is at times smaller",
        outcome: Outcome::of(&parts),
        figure: "fig5",
        why: format!(
            "At Δ = 16 deviation traces {} times as many pixels as PSRT with {} times its error, variance {} times as many \
             with {} times its error.",
            bench.range(&traced[0], 2),
            bench.range(&errors[0], 2),
            bench.range(&traced[1], 2),
            bench.range(&errors[1], 2)
        ),
        numbers: [traced.concat(), errors.concat()].concat(),
    }
}

fn p16(bench: &Bench) -> Verdict {
    let names = bench.names("error-at-16/border-deviation/{}");
    let (few, percent) = ("red-over-10/border-deviation", "red-over-10-percent/border-deviation");
    let mut parts = bench.tests(&names, |e| (0.15..0.35).contains(&e));
    parts.push(bench.test(few, |n| n > 0.0));
    parts.push(bench.test(percent, |p| p < 2.0));
    Verdict {
        claim: "P16",
        says: "at Δ = 16 the mean error is 0.2 to 0.3 levels, and a few pixels are off by more than 10",
        outcome: Outcome::of(&parts),
        figure: "fig6",
        why: format!(
            "The mean error is {} levels, and {} pixels in the red channel of one scene ({} %) are off by more than 10.",
            bench.range(&names, 2),
            bench.show(few, 0),
            bench.show(percent, 2)
        ),
        numbers: [names, vec![few.to_owned(), percent.to_owned()]].concat(),
    }
}

fn p17(bench: &Bench) -> Verdict {
    let (border, psrt) = ("highlights-lost/border-deviation", "balls-lost/pixel-selected");
    Verdict {
        claim: "P17",
        says: "a highlight between four equally bright points is lost, by every method of this kind",
        outcome: Outcome::of(&[bench.test(border, |n| n > 0.0), bench.test(psrt, |n| n > 0.0)]),
        figure: "fig7",
        why: format!(
            "Of {} very small balls BRT loses {} highlights; PSRT loses {} whole balls.",
            bench.show("balls", 0),
            bench.show(border, 0),
            bench.show(psrt, 0)
        ),
        numbers: vec!["balls".to_owned(), border.to_owned(), psrt.to_owned()],
    }
}

/// Answered by bounds, which contain all of what the paper lists, instead of by a finer judgement.
fn p19(bench: &Bench) -> Verdict {
    let (lost, kept) = ("highlights-lost/border-deviation", "highlights-lost/certified");
    let off = "off-by-1/certified";
    Verdict {
        claim: "P19",
        says: "future work: reflection angle, curvature, highlight and light direction in the judgement",
        outcome: Outcome::of(&[bench.test(kept, |n| n == 0.0), bench.test(off, |n| n == 0.0)]),
        figure: "fig7",
        why: format!(
            "Bounds over a block contain them all: certified loses {} of the highlights of which BRT loses {}, and {} pixels \
             of the scene adversary are off by more than a level.",
            bench.show(kept, 0),
            bench.show(lost, 0),
            bench.show(off, 0)
        ),
        numbers: [lost, kept, off].map(str::to_owned).to_vec(),
    }
}

fn p20(bench: &Bench) -> Verdict {
    let (probes, bounds) = ("far-off/border", "far-off/certified");
    Verdict {
        claim: "P20",
        says: "future work: perspective images that include shadows and mirrored objects",
        outcome: Outcome::of(&[bench.test(probes, |n| n > 0.0), bench.test(bounds, |n| n == 0.0)]),
        figure: "bounds",
        why: format!(
            "Shafts along mirror and shadow rays do for them what the perspective image does for what is seen directly: {} \
             pixels of the scene adversary are off by more than 16 levels, {} by BRT.",
            bench.show(bounds, 0),
            bench.show(probes, 0)
        ),
        numbers: [probes, bounds].map(str::to_owned).to_vec(),
    }
}
