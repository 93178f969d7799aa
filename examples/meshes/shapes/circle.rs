//! Points of circles, and lengths.

use verlock::Vec3;
use verlock::math::trig::cos_sin;
use verlock::math::wide::{round_div, round_shift_wide};

/// Cosine and sine of `part / whole` of a turn, 30 fractional bits.
pub fn circle(part: u32, whole: u32) -> [i64; 2] {
    cos_sin(part, whole).map(|unit| unit.raw().into())
}

/// A length times a number of 30 fractional bits.
pub fn times(length: i64, factor: i64) -> i64 {
    let product = round_shift_wide(i128::from(length) * i128::from(factor), 30);
    i64::try_from(product).expect("a length")
}

/// Millimetres.
pub fn mm(x: i64, y: i64, z: i64) -> Vec3 {
    Vec3::from_raw([x, y, z].map(raw_mm))
}

/// Raw units of so many millimetres.
pub fn raw_mm(length: i64) -> i64 {
    round_div(length << 24, 1000)
}
