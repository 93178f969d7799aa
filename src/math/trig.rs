//! Points of the unit circle: for set-up and animation, never inside a step.

use super::Unit;
use super::wide::round_shift_wide;

/// Fraction bits of what is computed before it is rounded.
const BITS: u32 = 60;
const ONE: i128 = 1 << BITS;
/// 2 pi, to nearest.
const TURN: i128 = 7_244_019_458_077_122_842;

/// Cosine and sine of `part / whole` of a turn, each within 0.501 units of 2^-30.
///
/// Of all multiples of the same part the eight octants are mirror images, to the bit; quarters of
/// a turn give exactly 0, 1 and -1.
///
/// # Panics
///
/// When `whole` is 0.
///
/// ```
/// use verlock::math::Unit;
/// use verlock::math::trig::cos_sin;
///
/// assert_eq!(cos_sin(1, 4), [Unit::ZERO, Unit::ONE]);
/// assert_eq!(cos_sin(1, 3)[0].raw(), -Unit::ONE.raw() / 2);
/// ```
#[must_use]
pub fn cos_sin(part: u32, whole: u32) -> [Unit; 2] {
    assert!(whole > 0, "cos_sin: nothing is a part of 0");
    // The octant, and the way into it in units of 1 / (8 whole) turn.
    let eighths = 8 * u64::from(part % whole);
    let (octant, way) = (eighths / u64::from(whole), eighths % u64::from(whole));
    let way = if octant % 2 == 0 { way } else { u64::from(whole) - way };
    // At most 2^63 * 2^32 before the division: an angle of at most pi / 4.
    let [cos, sin] = series(TURN * i128::from(way) / (8 * i128::from(whole)));
    let [cos, sin] = if octant % 2 == 0 { [cos, sin] } else { [sin, cos] };
    match octant / 2 {
        0 => [cos, sin],
        1 => [-sin, cos],
        2 => [-cos, -sin],
        _ => [sin, -cos],
    }
    // At most 2^30.
    .map(|c| Unit::from_raw(round_shift_wide(c, BITS - Unit::FRACTION_BITS) as i32))
}

/// Cosine and sine of an angle from 0 to pi / 4, by their Taylor series.
///
/// What is left out is below (pi / 4)^18 / 18! < 2^-58, and each of the 9 steps cuts less than
/// 2^-58 off: together below 2^-54.
fn series(angle: i128) -> [i128; 2] {
    let square = (angle * angle) >> BITS;
    let step = |sum: i128, n: i128| ONE - ((square * sum) >> BITS) / (n * (n - 1));
    let cos = (1..=8).rev().fold(ONE, |sum, k| step(sum, 2 * k));
    let sin = (1..=8).rev().fold(ONE, |sum, k| step(sum, 2 * k + 1));
    [cos, (angle * sin) >> BITS]
}
