//! Exact products in wide integers, and the crate's only rounding.
//!
//! A formula sums its products exactly, in `i64` where three of them provably fit and in `i128`
//! elsewhere, and rounds **once**: to nearest, ties away from zero. That rule is odd-symmetric
//! (`round(-v) == -round(v)`), so a mirrored world stays mirrored; the shift alone rounds down
//! and would drag everything by half a unit each time.

/// The largest component, 2^30 raw (64 m), whose products with another still sum, three of them,
/// in an `i64`, and come from the 32 x 32 -> 64 multiply that every SIMD unit has.
pub const NARROW_MAX: i64 = 1 << 30;

/// `v / 2^s` to nearest, ties away from zero.
///
/// Requires `1 <= s <= 62` and `v <= i64::MAX - 2^(s-1)`. A negative `v` only moves towards zero
/// and needs no such margin. Both are checked in debug builds; callers prove them.
#[inline]
#[must_use]
pub const fn round_shift(v: i64, s: u32) -> i64 {
    debug_assert!(1 <= s && s <= 62, "round_shift: shift outside 1..=62");
    let half = 1 << (s - 1);
    debug_assert!(v <= i64::MAX - half, "round_shift: no room for the half");
    // `v >> 63` is the sign, -1 or 0: it turns "half up" into "half away" below zero.
    (v + (half + (v >> 63))) >> s
}

/// `v / 2^s` to nearest, ties away from zero, in 128 bits.
///
/// Requires `1 <= s <= 126` and `v <= i128::MAX - 2^(s-1)`, checked in debug builds.
#[inline]
#[must_use]
pub const fn round_shift_wide(v: i128, s: u32) -> i128 {
    debug_assert!(1 <= s && s <= 126, "round_shift_wide: shift outside 1..=126");
    let half = 1 << (s - 1);
    debug_assert!(v <= i128::MAX - half, "round_shift_wide: no room for the half");
    (v + (half + (v >> 127))) >> s
}

/// `n / d` to nearest, ties away from zero, exact for every `n`.
///
/// # Panics
///
/// In every profile when `d <= 0`. The check replaces the two that the hardware division would
/// need (zero, and `MIN / -1`), so it costs nothing.
#[inline]
#[must_use]
pub const fn round_div(n: i64, d: i64) -> i64 {
    assert!(d > 0, "round_div: the divisor must be positive");
    let quotient = n / d;
    // |rest| < d, so neither side of the comparison can overflow; `2 |rest| >= d` could.
    let rest = (n % d).abs();
    // When a rest is left, |quotient| <= |n| / 2, so the step away from zero fits.
    if rest >= d - rest { quotient + n.signum() } else { quotient }
}

/// `n / d` to nearest, ties up, of magnitudes: [`round_div`] without its signs, and cheaper.
///
/// Requires `n <= u64::MAX - d / 2`, checked in debug builds.
///
/// # Panics
///
/// In every profile when `d` is 0.
#[inline]
#[must_use]
pub const fn round_div_magnitude(n: u64, d: u64) -> u64 {
    debug_assert!(n <= u64::MAX - d / 2, "round_div_magnitude: no room for the half");
    // For an odd d the half is cut, but then no rest lies between the two.
    (n + d / 2) / d
}

/// `n / d` to nearest, ties away from zero, exact for every `n`, in 128 bits.
///
/// # Panics
///
/// In every profile when `d <= 0`.
#[inline]
#[must_use]
pub const fn round_div_wide(n: i128, d: i128) -> i128 {
    assert!(d > 0, "round_div_wide: the divisor must be positive");
    let quotient = n / d;
    // |quotient * d| <= |n|. A product is cheaper than a second 128-bit division.
    let rest = (n - quotient * d).abs();
    if rest >= d - rest { quotient + n.signum() } else { quotient }
}

/// Whether every |component| is at most [`NARROW_MAX`]. Branch-free.
#[inline]
#[must_use]
pub const fn is_narrow(d: [i64; 3]) -> bool {
    // Moved up by 2^30, the range [-2^30, 2^30] becomes [0, 2^31]; anything else, also what
    // wraps, becomes larger than that when it is read without a sign.
    const SPAN: u64 = NARROW_MAX.unsigned_abs() << 1;
    (d[0].wrapping_add(NARROW_MAX).cast_unsigned() <= SPAN)
        & (d[1].wrapping_add(NARROW_MAX).cast_unsigned() <= SPAN)
        & (d[2].wrapping_add(NARROW_MAX).cast_unsigned() <= SPAN)
}

/// The exact dot product of two [narrow](is_narrow) vectors: three products of at most 2^60.
///
/// Requires both to be narrow, checked in debug builds.
#[inline]
#[must_use]
pub const fn dot_narrow(a: [i64; 3], b: [i64; 3]) -> i64 {
    debug_assert!(is_narrow(a) && is_narrow(b), "dot_narrow: component beyond 2^30");
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The exact dot product of two vectors with |components| <= 2^62: at most 3 * 2^124.
///
/// The bound is checked in debug builds.
#[inline]
#[must_use]
pub const fn dot_wide(a: [i64; 3], b: [i64; 3]) -> i128 {
    debug_assert!(is_summable(a) && is_summable(b), "dot_wide: component beyond 2^62");
    a[0] as i128 * b[0] as i128 + a[1] as i128 * b[1] as i128 + a[2] as i128 * b[2] as i128
}

/// `a - b` by components. Requires |components| < 2^62, checked in debug builds.
#[inline]
#[must_use]
pub const fn sub(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    debug_assert!(is_summable(a) && is_summable(b), "sub: component beyond 2^62");
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + b` by components. Requires |components| < 2^62, checked in debug builds.
#[inline]
#[must_use]
pub const fn add(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    debug_assert!(is_summable(a) && is_summable(b), "add: component beyond 2^62");
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// |components| <= 2^62. At exactly 2^62 the sum of two may still overflow: the operators of a
/// debug build catch that one value.
const fn is_summable(d: [i64; 3]) -> bool {
    const MAX: u64 = 1 << 62;
    d[0].unsigned_abs() <= MAX && d[1].unsigned_abs() <= MAX && d[2].unsigned_abs() <= MAX
}

/// A value that the caller has proved to fit 64 bits; checked in debug builds.
#[inline]
#[must_use]
pub(crate) const fn to_i64(v: i128) -> i64 {
    let low = v as i64;
    debug_assert!(low as i128 == v, "to_i64: more than 64 bits");
    low
}

/// A value that the caller has proved to fit 32 bits; checked in debug builds.
#[inline]
#[must_use]
pub(crate) const fn to_i32(v: i64) -> i32 {
    let low = v as i32;
    debug_assert!(low as i64 == v, "to_i32: more than 32 bits");
    low
}

/// A value that the caller has proved to fit 16 bits; checked in debug builds.
#[inline]
#[must_use]
pub(crate) const fn to_i16(v: i64) -> i16 {
    let low = v as i16;
    debug_assert!(low as i64 == v, "to_i16: more than 16 bits");
    low
}

/// The value in 64 bits, if it fits.
#[inline]
pub(super) const fn narrow(v: i128) -> Option<i64> {
    let low = v as i64;
    if low as i128 == v { Some(low) } else { None }
}
