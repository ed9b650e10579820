//! PNG's row filters: what is stored is the difference to a guess from the left and from above.

/// Filters as numbered by PNG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum RowFilter {
    None = 0,
    Sub = 1,
    Up = 2,
    Average = 3,
    Paeth = 4,
}

/// How the filter of a row is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FilterChoice {
    /// The same for each row.
    Always(RowFilter),
    /// That with the smallest sum of absolute differences: a guess at what compresses best.
    Adaptive,
}

/// Appends a row in filtered form. `above` is the row above, zeros for the first row; `step` is the bytes of a pixel.
pub(crate) fn filter_row(
    choice: FilterChoice,
    row: &[u8],
    above: &[u8],
    step: usize,
    filtered: &mut Vec<u8>,
) {
    match choice {
        FilterChoice::Always(filter) => append(filter, row, above, step, filtered),
        FilterChoice::Adaptive => append_smallest(row, above, step, filtered),
    }
}

fn append_smallest(row: &[u8], above: &[u8], step: usize, filtered: &mut Vec<u8>) {
    use RowFilter::{Average, None, Paeth, Sub, Up};
    let start = filtered.len();
    append(Paeth, row, above, step, filtered);
    let mut least = roughness(&filtered[start..]);
    for filter in [Sub, Up, Average, None] {
        let next = filtered.len();
        append(filter, row, above, step, filtered);
        let sum = roughness(&filtered[next..]);
        if sum < least {
            least = sum;
            filtered.copy_within(next.., start);
        }
        filtered.truncate(next);
    }
}

/// Sum of the differences' absolute values, as signed bytes.
fn roughness(filtered: &[u8]) -> u64 {
    filtered[1..].iter().map(|&d| u64::from(d.cast_signed().unsigned_abs())).sum()
}

fn append(filter: RowFilter, row: &[u8], above: &[u8], step: usize, filtered: &mut Vec<u8>) {
    filtered.push(filter as u8);
    let start = filtered.len();
    filtered.extend_from_slice(row);
    let out = &mut filtered[start..];
    // To the left of the first pixel is zero.
    let (first, out) = out.split_at_mut(step);
    let (above_first, above_rest) = above.split_at(step);
    let pixels = out.iter_mut().zip(&row[step..]).zip(row).zip(above_rest).zip(above);
    let each = pixels.map(|((((out, now), left), up), corner)| (out, *now, *left, *up, *corner));
    match filter {
        RowFilter::None => {}
        RowFilter::Sub => each.for_each(|(out, now, left, ..)| *out = now.wrapping_sub(left)),
        RowFilter::Up => {
            each.for_each(|(out, now, _, up, _)| *out = now.wrapping_sub(up));
            subtract(first, above_first);
        }
        RowFilter::Average => {
            each.for_each(|(out, now, left, up, _)| *out = now.wrapping_sub(left.midpoint(up)));
            first.iter_mut().zip(above_first).for_each(|(out, up)| *out = out.wrapping_sub(up / 2));
        }
        RowFilter::Paeth => {
            each.for_each(|(out, now, left, up, corner)| *out = now.wrapping_sub(paeth(left, up, corner)));
            subtract(first, above_first);
        }
    }
}

fn subtract(from: &mut [u8], what: &[u8]) {
    from.iter_mut().zip(what).for_each(|(out, what)| *out = out.wrapping_sub(*what));
}

/// Paeth's predictor in bytes alone, so that the compiler takes sixteen at a time: the difference of `left + up` to
/// `corner` cannot be the smallest unless `corner` lies between them, and then it is that of both differences
/// (Luca Versari, FPNGE).
#[inline(always)]
fn paeth(left: u8, up: u8, corner: u8) -> u8 {
    let to_left = up.max(corner) - up.min(corner);
    let to_up = left.max(corner) - left.min(corner);
    let between = (left < corner) == (corner < up);
    let to_corner = if between { to_left.max(to_up) - to_left.min(to_up) } else { 255 };
    let nearer = if to_up <= to_corner { up } else { corner };
    if to_left <= to_up && to_left <= to_corner { left } else { nearer }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the PNG specification has it.
    fn paeth_by_definition(left: u8, up: u8, corner: u8) -> u8 {
        let guess = i32::from(left) + i32::from(up) - i32::from(corner);
        let [a, b, c] = [left, up, corner].map(|v| (guess - i32::from(v)).abs());
        if a <= b && a <= c {
            left
        } else if b <= c {
            up
        } else {
            corner
        }
    }

    #[test]
    fn paeth_is_as_specified_for_all_bytes() {
        for left in 0..=255 {
            for up in 0..=255 {
                for corner in 0..=255 {
                    assert_eq!(paeth(left, up, corner), paeth_by_definition(left, up, corner));
                }
            }
        }
    }

    #[test]
    fn adaptive_rows_are_never_rougher_than_those_of_one_filter() {
        let above: Vec<u8> = (0..60).map(|i| (i * 7 % 31) as u8).collect();
        let row: Vec<u8> = (0..60).map(|i| (i * 5 % 23 + i) as u8).collect();
        let mut best = Vec::new();
        filter_row(FilterChoice::Adaptive, &row, &above, 3, &mut best);
        for filter in [RowFilter::None, RowFilter::Sub, RowFilter::Up, RowFilter::Average, RowFilter::Paeth] {
            let mut one = Vec::new();
            filter_row(FilterChoice::Always(filter), &row, &above, 3, &mut one);
            assert_eq!(one.len(), 61);
            assert!(roughness(&best) <= roughness(&one));
            assert!(one[0] != best[0] || one == best);
        }
    }
}
