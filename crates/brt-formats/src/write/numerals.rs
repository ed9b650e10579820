//! Numbers as text that reads back exactly.

use std::fmt::Write as _;

use brt_geometry::Vec3;

/// The shortest digits that read back exactly; whole numbers without a point.
pub(crate) fn push_number(out: &mut String, x: f64) {
    /// Up to here a double that is whole has few digits and stands for itself.
    const GREATEST_WHOLE: f64 = 1_000_000_000_000_000.0;
    let is_minus_zero = x == 0.0 && x.is_sign_negative();
    // Writing to a text cannot fail.
    let _ = if x.fract() == 0.0 && x.abs() < GREATEST_WHOLE && !is_minus_zero {
        write!(out, "{}", x as i64)
    } else {
        write!(out, "{x:?}")
    };
}

/// The same as a text of its own.
pub(crate) fn number(x: f64) -> String {
    let mut out = String::new();
    push_number(&mut out, x);
    out
}

/// Three numbers with a text between them.
pub(crate) fn joined(v: Vec3, between: &str) -> String {
    let mut out = String::new();
    push_number(&mut out, v.x);
    for x in [v.y, v.z] {
        out.push_str(between);
        push_number(&mut out, x);
    }
    out
}
