//! Axes: which numbers stand where.
#![expect(clippy::disallowed_methods, reason = "ticks of charts")]

/// An axis before its range is known.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    /// What is shown, with its unit.
    pub(crate) label: String,
    logarithmic: bool,
    /// Numbers at the axis; none: chosen from the range.
    ticks: Vec<(f64, String)>,
}

impl Axis {
    /// From 0, or the least value if that is negative.
    pub(crate) fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), logarithmic: false, ticks: Vec::new() }
    }

    pub(crate) fn logarithmic(label: impl Into<String>) -> Self {
        Self { logarithmic: true, ..Self::linear(label) }
    }

    /// Logarithmic, with numbers at these values.
    pub(crate) fn steps(label: impl Into<String>, values: &[f64]) -> Self {
        Self { ticks: values.iter().map(|&v| (v, short(v))).collect(), ..Self::logarithmic(label) }
    }

    /// Names in a row, at 0, 1, 2, …
    pub(crate) fn names(label: impl Into<String>, names: &[String]) -> Self {
        let ticks = names.iter().enumerate().map(|(i, name)| (i as f64, name.clone())).collect();
        Self { ticks, ..Self::linear(label) }
    }

    pub(super) fn can_show(&self, value: f64) -> bool {
        value.is_finite() && (!self.logarithmic || value > 0.0)
    }

    /// The axis over the values, drawn between two places.
    pub(super) fn scale(&self, values: impl Iterator<Item = f64>, from: f64, to: f64) -> Scale<'_> {
        let known = self.ticks.iter().map(|tick| tick.0);
        let (lo, hi) = values
            .chain(known)
            .map(|v| self.measure(v))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)));
        let (lo, hi) = match (lo <= hi, self.logarithmic, self.ticks.is_empty()) {
            (false, ..) => (0.0, 1.0),
            (_, true, _) => (lo - 0.05, hi + 0.05),
            (_, false, true) => (lo.min(0.0), 1.06 * hi),
            (_, false, false) => (lo - 0.35, hi + 0.35),
        };
        let hi = if hi > lo { hi } else { lo + 1.0 };
        Scale { axis: self, lo, hi, from, to }
    }

    fn measure(&self, value: f64) -> f64 {
        if self.logarithmic { value.log10() } else { value }
    }
}

/// An axis over a range.
#[derive(Debug)]
pub(super) struct Scale<'a> {
    axis: &'a Axis,
    lo: f64,
    hi: f64,
    from: f64,
    to: f64,
}

impl Scale<'_> {
    /// Where a value stands.
    pub(super) fn place(&self, value: f64) -> f64 {
        let share = (self.axis.measure(value) - self.lo) / (self.hi - self.lo);
        self.from + share * (self.to - self.from)
    }

    /// Places and texts of the numbers at the axis.
    pub(super) fn ticks(&self) -> Vec<(f64, String)> {
        let values = match (self.axis.ticks.is_empty(), self.axis.logarithmic) {
            (false, _) => self.axis.ticks.clone(),
            (true, true) => with_texts(self.powers()),
            (true, false) => with_texts(self.round_numbers()),
        };
        values.into_iter().map(|(value, text)| (self.place(value), text)).collect()
    }

    /// 1 of each decade, with as many more as it takes to show three numbers.
    fn powers(&self) -> Vec<f64> {
        const DIGITS: [&[f64]; 4] = [
            &[1.0],
            &[1.0, 2.0, 5.0],
            &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0],
            &[1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 9.0],
        ];
        let inside = |digits: &[f64]| -> Vec<f64> {
            (self.lo.floor() as i32..=self.hi.ceil() as i32)
                .flat_map(|decade| digits.iter().map(move |digit| digit * 10_f64.powi(decade)))
                .filter(|value| (self.lo..=self.hi).contains(&value.log10()))
                .collect()
        };
        let enough = DIGITS.iter().map(|digits| inside(digits)).find(|values| values.len() >= 3);
        enough.unwrap_or_else(|| inside(DIGITS[3]))
    }

    /// Four to nine multiples of 1, 2 or 5.
    fn round_numbers(&self) -> Vec<f64> {
        let rough = (self.hi - self.lo) / 5.0;
        let power = 10_f64.powf(rough.log10().floor());
        let step =
            [1.0, 2.0, 5.0, 10.0].map(|d| d * power).into_iter().find(|s| *s >= rough).unwrap_or(rough);
        let first = (self.lo / step).ceil() as i64;
        let last = (self.hi / step).floor() as i64;
        (first..=last).map(|i| i as f64 * step).collect()
    }
}

fn with_texts(values: Vec<f64>) -> Vec<(f64, String)> {
    values.into_iter().map(|v| (v, short(v))).collect()
}

/// A number as short as it is exact to four digits.
fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let decimals = (3 - value.abs().log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis, values: &[f64]) -> Vec<String> {
        axis.scale(values.iter().copied(), 0.0, 100.0).ticks().into_iter().map(|t| t.1).collect()
    }

    #[test]
    fn numbers_at_axes_are_round() {
        assert_eq!(texts(&Axis::linear(""), &[3.0, 9.0]), ["0", "2", "4", "6", "8"]);
        assert_eq!(texts(&Axis::logarithmic(""), &[1.0, 12.0]), ["1", "2", "5", "10"]);
        assert_eq!(texts(&Axis::logarithmic(""), &[0.01, 1000.0]), ["0.01", "0.1", "1", "10", "100", "1000"]);
        assert_eq!(texts(&Axis::steps("", &[128.0, 256.0]), &[128.0]), ["128", "256"]);
    }

    #[test]
    fn greater_values_stand_farther_on() {
        let axis = Axis::logarithmic("");
        let scale = axis.scale([1.0, 100.0].into_iter(), 0.0, 100.0);
        assert!((scale.place(10.0) - 50.0).abs() < 1e-9);
    }
}
