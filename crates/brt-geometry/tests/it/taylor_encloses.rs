//! A Taylor model encloses what the same expression computes for any sample, and a mask is certain only if it is so.

use brt_geometry::{Exponent, Mask, Real, Taylor, Trilean};
use brt_testkit::Random;

/// A random expression over two variables; written once, read by every [`Real`].
#[derive(Clone, Debug)]
enum Expression {
    Constant(f64),
    Column,
    Row,
    Neg(Box<Self>),
    Sqrt(Box<Self>),
    Power(Box<Self>, f64),
    Pair(Pair, Box<Self>, Box<Self>),
    /// `if a < b { c } else { d }`, with `<=` if the flag is set.
    Choice(bool, Box<[Self; 4]>),
}

#[derive(Clone, Copy, Debug)]
enum Pair {
    Add,
    Sub,
    Mul,
    Div,
    Min,
    Max,
}

impl Expression {
    fn random(random: &mut Random, depth: u32, constant: &dyn Fn(&mut Random) -> f64) -> Self {
        if depth == 0 || random.one_in(8) {
            return match random.below(3) {
                0 => Self::Constant(constant(random)),
                1 => Self::Column,
                _ => Self::Row,
            };
        }
        let part = |random: &mut Random| Self::random(random, depth - 1, constant);
        match random.below(12) {
            0 => Self::Neg(Box::new(part(random))),
            1 => Self::Sqrt(Box::new(part(random))),
            2 => {
                let whole = f64::from(random.below(6));
                let exponent = if random.one_in(2) { whole } else { random.between(0.0, 6.0) };
                Self::Power(Box::new(part(random)), exponent)
            }
            3 => {
                let parts = [part(random), part(random), part(random), part(random)];
                Self::Choice(random.one_in(2), Box::new(parts))
            }
            _ => {
                use Pair::{Add, Div, Max, Min, Mul, Sub};
                let pair = random.pick(&[Add, Add, Sub, Sub, Mul, Mul, Div, Min, Max]);
                Self::Pair(pair, Box::new(part(random)), Box::new(part(random)))
            }
        }
    }

    fn value<R: Real>(&self, column: R, row: R) -> R {
        let zero = R::constant(0.0);
        match self {
            Self::Constant(x) => R::constant(*x),
            Self::Column => column,
            Self::Row => row,
            Self::Neg(a) => -a.value(column, row),
            Self::Sqrt(a) => a.value(column, row).max(zero).sqrt(),
            Self::Power(a, exponent) => Exponent::new(*exponent).power(a.value(column, row).max(zero)),
            Self::Pair(pair, a, b) => {
                let (a, b) = (a.value(column, row), b.value(column, row));
                match pair {
                    Pair::Add => a + b,
                    Pair::Sub => a - b,
                    Pair::Mul => a * b,
                    Pair::Div => a / b,
                    Pair::Min => a.min(b),
                    Pair::Max => a.max(b),
                }
            }
            Self::Choice(or_equal, parts) => {
                let [a, b, yes, no] = parts.each_ref().map(|part| part.value(column, row));
                R::select(if *or_equal { a.le(b) } else { a.lt(b) }, yes, no)
            }
        }
    }

    /// Is any part of it NaN or infinite at this sample? Then no claim is made: scenes keep far from overflow.
    fn overflows(&self, column: f64, row: f64) -> bool {
        let parts: Vec<&Self> = match self {
            Self::Constant(_) | Self::Column | Self::Row => Vec::new(),
            Self::Neg(a) | Self::Sqrt(a) | Self::Power(a, _) => vec![a],
            Self::Pair(_, a, b) => vec![a, b],
            Self::Choice(_, parts) => parts.iter().collect(),
        };
        !self.value(column, row).is_finite() || parts.iter().any(|part| part.overflows(column, row))
    }
}

/// A rectangle of samples with its model, as the perspective image makes them.
struct Block {
    first: [f64; 2],
    count: [u32; 2],
}

impl Block {
    fn random(random: &mut Random) -> Self {
        let first = [random.below(3000), random.below(3000)].map(|x| f64::from(x) - 1000.0);
        Self { first, count: [1 + random.below(12), 1 + random.below(12)] }
    }

    fn models(&self) -> (Taylor, Taylor) {
        let half = self.count.map(|n| 0.5 * f64::from(n - 1));
        let x = Taylor::linear(self.first[0] + half[0], half[0], 0.0);
        let y = Taylor::linear(self.first[1] + half[1], 0.0, half[1]);
        (x, y)
    }

    fn samples(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let at = |axis: usize, i: u32| self.first[axis] + f64::from(i);
        (0..self.count[1]).flat_map(move |j| (0..self.count[0]).map(move |i| (at(0, i), at(1, j))))
    }
}

/// Checks values and comparisons of random expressions; returns the share of blocks about which something is known.
fn check(seed: u64, cases: u32, depth: u32, constant: &dyn Fn(&mut Random) -> f64) -> f64 {
    let mut random = Random::new(seed);
    let mut known = 0;
    for case in 0..cases {
        let (a, b) = (
            Expression::random(&mut random, depth, constant),
            Expression::random(&mut random, depth, constant),
        );
        let block = Block::random(&mut random);
        let (x, y) = block.models();
        let (model_a, model_b) = (a.value(x, y), b.value(x, y));
        let [lo, hi] = model_a.range();
        known += u32::from(lo.is_finite() && hi.is_finite());
        let (less, or_equal) = (model_a.lt(model_b), model_a.le(model_b));
        for (x, y) in block.samples() {
            let (value_a, value_b) = (a.value(x, y), b.value(x, y));
            if !a.overflows(x, y) {
                assert!(
                    lo <= value_a && value_a <= hi,
                    "case {case}: {value_a} not in {lo}..{hi} at {x},{y}: {a:?}"
                );
                if !b.overflows(x, y) {
                    assert_fits(less, value_a < value_b, &(case, "<", value_a, value_b, &a, &b));
                    assert_fits(or_equal, value_a <= value_b, &(case, "<=", value_a, value_b, &a, &b));
                }
            }
        }
    }
    f64::from(known) / f64::from(cases)
}

fn assert_fits<M: Mask>(mask: M, truth: bool, what: &dyn std::fmt::Debug) {
    assert!(truth || !mask.all(), "certain, but false: {what:?}");
    assert!(!truth || mask.any(), "impossible, but true: {what:?}");
    assert_eq!((!mask).any(), !mask.all());
    assert!((mask | !mask).all() || (mask.any() && !mask.all()));
}

#[test]
fn models_enclose_tame_expressions_and_know_something_of_most() {
    let tame = |random: &mut Random| random.between(-100.0, 100.0);
    let known = check(1, 20_000, 3, &tame);
    assert!(known > 0.7, "known {known}");
    check(2, 6_000, 5, &tame);
}

#[test]
fn models_enclose_expressions_full_of_zeros_ones_and_equal_values() {
    let few = |random: &mut Random| random.pick(&[0.0, -0.0, 1.0, -1.0, 0.5, 2.0, 1000.0]);
    check(3, 20_000, 3, &few);
    check(4, 6_000, 5, &few);
}

#[test]
fn models_enclose_expressions_of_extreme_magnitudes() {
    let wild = |random: &mut Random| {
        let sign = random.pick(&[1.0, -1.0]);
        match random.below(8) {
            0 => sign * f64::MIN_POSITIVE,
            1 => sign * 5e-324,
            2 => sign * 1e300,
            3 => random.zero(),
            _ => sign * random.magnitude(-120.0, 120.0),
        }
    };
    check(5, 20_000, 3, &wild);
    check(6, 6_000, 4, &wild);
}

#[test]
fn infinities_and_nan_are_never_certain() {
    let specials = [f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
    for special in specials {
        for other in [0.0, 1.0, -1e300, special] {
            // Nothing is known of a sum with an infinity, so comparisons must stay open.
            let unknown = Taylor::constant(special) + Taylor::constant(other);
            let [lo, hi] = unknown.range();
            assert!(lo == f64::NEG_INFINITY && hi == f64::INFINITY, "{special} + {other}: {lo}..{hi}");
            for mask in
                [unknown.lt(Taylor::constant(1.0)), unknown.le(unknown), Taylor::constant(0.0).lt(unknown)]
            {
                assert!(mask.any() && !mask.all(), "{special} + {other}");
            }
        }
    }
    let through_zero = Taylor::constant(1.0) / Taylor::linear(0.0, 1.0, 0.0);
    assert_eq!(through_zero.range(), [f64::NEG_INFINITY, f64::INFINITY]);
    // An unknown value behind a mask that leaves it out does not spoil the other.
    let kept = Taylor::select(Trilean::TRUE, Taylor::constant(2.0), through_zero);
    assert!(kept.range()[1] < 2.1);
}

#[test]
fn masks_combine_like_sets_of_truths() {
    // Over U in −1..1: U < 2 always, U < 0 at times, U < −2 never.
    let u = Taylor::linear(0.0, 1.0, 0.0);
    let below = |limit: f64| u.lt(Taylor::constant(limit));
    let (always, at_times, never) = (below(2.0), below(0.0), below(-2.0));
    let answers = |m: Trilean| (m.any(), m.all());
    assert_eq!([always, at_times, never].map(answers), [(true, true), (true, false), (false, false)]);
    assert_eq!(answers(always & at_times), (true, false));
    assert_eq!(answers(never | at_times), (true, false));
    assert_eq!(answers(always | at_times), (true, true));
    assert_eq!(answers(never & at_times), (false, false));
    assert_eq!([!always, !at_times, !never].map(answers), [(false, false), (true, false), (true, true)]);
    assert_eq!((answers(Trilean::TRUE), answers(Trilean::FALSE)), ((true, true), (false, false)));
}

/// Width of the enclosure over the width of what is enclosed, sampled densely.
fn width_ratio(x: Taylor, y: Taylor, f: &dyn Fn(f64, f64) -> f64, model: Taylor) -> f64 {
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    for i in 0..=200 {
        for j in 0..=200 {
            let (u, v) = (f64::from(i) * 0.01 - 1.0, f64::from(j) * 0.01 - 1.0);
            let value = f(x.c + x.u * u, y.c + y.v * v);
            (least, greatest) = (least.min(value), greatest.max(value));
        }
    }
    let [lo, hi] = model.range();
    (hi - lo) / (greatest - least)
}

#[test]
fn enclosures_of_tame_expressions_are_hardly_wider_than_what_they_enclose() {
    let (x, y) = (Taylor::linear(10.0, 1.0, 0.0), Taylor::linear(20.0, 0.0, 1.0));
    let c = Taylor::constant;
    type Scalar = &'static dyn Fn(f64, f64) -> f64;
    let cases: [(&str, Taylor, Scalar, f64); 10] = [
        ("linear", c(3.0) * x - y, &|x, y| 3.0 * x - y, 1.000_001),
        ("product", x * y, &|x, y| x * y, 1.04),
        ("square", x * x, &|x, _| x * x, 1.03),
        ("quotient", x / y, &|x, y| x / y, 1.05),
        ("reciprocal", c(1.0) / x, &|x, _| 1.0 / x, 1.06),
        ("root", x.sqrt(), &|x, _| x.sqrt(), 1.03),
        ("inverse root", x.inverse_sqrt(), &|x, _| 1.0 / x.sqrt(), 1.05),
        ("whole power", Exponent::new(3.0).power(x), &|x, _| x * x * x, 1.1),
        ("broken power", Exponent::new(2.5).power(x), &|x, _| libm::pow(x, 2.5), 1.000_1),
        ("choice", x.max(y).min(c(1e9)), &|_, y| y, 1.000_001),
    ];
    for (name, model, f, most) in cases {
        let ratio = width_ratio(x, y, f, model);
        assert!((1.0 - 1e-9..most).contains(&ratio), "{name}: {ratio}");
    }
}

#[test]
fn halving_a_block_quarters_the_error() {
    let error = |half: f64| {
        let (x, y) = (Taylor::linear(3.0, half, 0.0), Taylor::linear(4.0, 0.0, half));
        ((x * x + y * y).sqrt() / (x * y)).e
    };
    for half in [0.5, 0.25, 0.125] {
        let ratio = error(half) / error(0.5 * half);
        assert!((3.5..5.5).contains(&ratio), "{half}: {ratio}");
    }
}

/// The greatest distance of a function from the linear part of its model, over the model's remainder.
fn used_share(x: Taylor, y: Taylor, f: &dyn Fn(f64, f64) -> f64, model: Taylor) -> f64 {
    let mut greatest: f64 = 0.0;
    for i in 0..=200 {
        for j in 0..=200 {
            let (u, v) = (f64::from(i) * 0.01 - 1.0, f64::from(j) * 0.01 - 1.0);
            let linear = model.c + model.u * u + model.v * v;
            greatest = greatest.max((f(x.c + x.u * u, y.c + y.v * v) - linear).abs());
        }
    }
    greatest / model.e
}

/// So a remainder that is a tenth smaller would be wrong, and the tests above would tell.
#[test]
fn remainders_are_used_up() {
    let (x, y) = (Taylor::linear(10.0, 3.0, 0.0), Taylor::linear(20.0, 0.0, 5.0));
    let mixed = Taylor::linear(0.5, 2.0, 0.0);
    let c = Taylor::constant;
    type Scalar = &'static dyn Fn(f64, f64) -> f64;
    let cases: [(&str, Taylor, Taylor, Scalar); 8] = [
        ("product", x, x * y, &|x, y| x * y),
        ("square", x, x * x, &|x, _| x * x),
        ("reciprocal", x, c(1.0) / x, &|x, _| 1.0 / x),
        ("root", x, x.sqrt(), &|x, _| x.sqrt()),
        ("inverse root", x, x.inverse_sqrt(), &|x, _| 1.0 / x.sqrt()),
        ("whole power", x, Exponent::new(2.0).power(x), &|x, _| x * x),
        ("broken power", x, Exponent::new(2.5).power(x), &|x, _| libm::pow(x, 2.5)),
        ("greater of two", mixed, mixed.max(c(0.0)), &|x, _| x.max(0.0)),
    ];
    for (name, x, model, f) in cases {
        let share = used_share(x, y, f, model);
        assert!(share > 0.9 && share <= 1.0, "{name}: {share}");
    }
}
