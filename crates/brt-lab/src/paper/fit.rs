//! Power laws and interpolation. Paper: P8.
#![expect(clippy::disallowed_methods, reason = "measured times are fitted, not rendered")]

/// The exponent k of y = c·xᵏ by least squares of the logarithms. `None` for fewer than two different x.
pub(crate) fn exponent(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> =
        points.iter().filter(|p| p.0 > 0.0 && p.1 > 0.0).map(|p| (p.0.ln(), p.1.ln())).collect();
    let n = logs.len() as f64;
    let (mean_x, mean_y) =
        (logs.iter().map(|p| p.0).sum::<f64>() / n, logs.iter().map(|p| p.1).sum::<f64>() / n);
    let spread: f64 = logs.iter().map(|p| (p.0 - mean_x).powi(2)).sum();
    let common: f64 = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    (spread > 0.0).then(|| common / spread)
}

/// The y at which a curve first reaches x, between its points in the order of their x; `None` where it does not.
pub(crate) fn at(points: &[(f64, f64)], x: f64) -> Option<f64> {
    points.windows(2).find_map(|pair| {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        let is_between = (x0 <= x && x <= x1) && x1 > x0;
        is_between.then(|| y0 + (y1 - y0) * (x - x0) / (x1 - x0))
    })
}

/// The median; of an even number of values the mean of the two in the middle.
pub(crate) fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    match sorted.len() {
        0 => f64::NAN,
        n if n % 2 == 0 => f64::midpoint(sorted[middle - 1], sorted[middle]),
        _ => sorted[middle],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_of_synthetic_powers_are_found() {
        let power = |k: f64| [128.0, 256.0, 512.0, 1024.0].map(|n: f64| (n, 3e-7 * n.powf(k)));
        for k in [0.0, 1.0, 1.3, 2.0] {
            assert!((exponent(&power(k)).unwrap() - k).abs() < 1e-9);
        }
        // Alternating errors of ±10 % on six points move it by a few hundredths.
        let noisy: Vec<(f64, f64)> = (0..6)
            .map(|i| 128.0 * f64::from(1 << i))
            .map(|n| (n, n * n))
            .enumerate()
            .map(|(i, (n, t))| (n, if i % 2 == 0 { 1.1 * t } else { 0.9 * t }))
            .collect();
        assert!((exponent(&noisy).unwrap() - 2.0).abs() < 0.06);
        assert_eq!(exponent(&[(128.0, 1.0)]), None);
        assert_eq!(exponent(&[]), None);
    }

    #[test]
    fn curves_are_read_between_their_points() {
        let curve = [(0.1, 20.0), (0.3, 10.0), (0.3, 10.0)];
        assert!((at(&curve, 0.2).unwrap() - 15.0).abs() < 1e-9);
        assert_eq!(at(&curve, 0.05), None);
        assert_eq!(at(&curve, 0.4), None);
    }

    #[test]
    fn medians() {
        assert_eq!([median(&[3.0, 1.0, 2.0]), median(&[4.0, 1.0])], [2.0, 2.5]);
    }
}
