//! Sines and cosines.

use verlock::Vec3;
use verlock::math::wide::{round_div, round_shift, round_shift_wide};

/// Pi, 30 fractional bits.
const PI: i64 = 3_373_259_426;

/// Cosine and sine of `k` of `n` equal parts of a full turn, 30 fractional bits. Points of the same
/// circle repeat exactly after `n`, and are mirrored exactly.
pub fn circle(k: u32, n: u32) -> [i64; 2] {
    let (k, n) = (i64::from(k % n), i64::from(n));
    // By eighths, which have angles of 45 degrees at most.
    let (quarter, rest) = (4 * k / n, 4 * k % n);
    let [c, s] = if 2 * rest <= n { small(rest, n) } else { small(n - rest, n).map_swap() };
    match quarter {
        0 => [c, s],
        1 => [-s, c],
        2 => [-c, -s],
        _ => [s, -c],
    }
}

/// Cosine and sine of `part / whole` of a quarter turn, at most an eighth turn, by their series.
fn small(part: i64, whole: i64) -> [i64; 2] {
    let angle = round_div(part * (PI / 2), whole);
    let (mut sums, mut term) = ([0, 0], 1 << 30);
    for n in 0..14 {
        let sign = if n % 4 < 2 { 1 } else { -1 };
        sums[n % 2] += sign * term;
        term = round_div(round_shift(term * angle, 30), n as i64 + 1);
    }
    sums
}

/// The other order.
trait Swap {
    fn map_swap(self) -> Self;
}

impl Swap for [i64; 2] {
    fn map_swap(self) -> Self {
        [self[1], self[0]]
    }
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
