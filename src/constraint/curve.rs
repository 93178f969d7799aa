//! What the division-free form removes of a length.
//!
//! With `v = d.d / L^2` the exact share is `1 - 1 / sqrt(v)`. For `1/2 <= v < 2` it is evaluated as
//!
//! ```text
//! 1 - (c0 - v (c1 - v (c2 - v (c3 - v c4))))
//! ```
//!
//! whose value and slope at `v = 1` are the exact ones, 0 and 1/2, and whose coefficients make the
//! greatest relative error least: 1.4 % (a linear program over 800 points). Elsewhere `v` is first
//! divided by 4 once or twice, or multiplied by 4, and the root of that taken back:
//! `1 - 1/sqrt(4v) = 1/2 + (1 - 1/sqrt(v)) / 2`; below 1/2 the error is 2 %. Beyond 4 lengths the
//! share stays what it is there or grows to that of 5.7; below a third of the length it is -1.
//!
//! All factors are positive, so products need no signs; each keeps the upper 32 of 64 bits.

/// The share in thousand-millionths of the length: 28 fractional bits, -2^28 < f < 2^28.
pub(super) const SHARE_BITS: u32 = 28;

/// 1 as a share.
pub(super) const SHARE_ONE: i32 = 1 << SHARE_BITS;

/// 1 as a `v`.
pub(super) const RATIO_ONE: u32 = 1 << 26;

/// `c0` to `c4`, with 28, 29, 30, 31 and 32 fractional bits.
pub(super) const COEFFICIENTS: [u32; 5] =
    [0x2735_13de, 0x63e3_8c2c, 0xa44c_4284, 0x8928_f3bf, 0x2cec_00f0];

/// Lengths that the form can have, raw: 0.5 mm to 64 m.
pub(super) const LENGTHS: core::ops::RangeInclusive<i64> = 1 << 13..=1 << 30;

/// How `v` is made of `d.d` without a division.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Scale {
    /// Even, so that few differ in a mesh: `2^26 <= L^2 / 2^shift < 2^28`.
    pub(super) shift: u32,
    /// `2^58 2^shift / L^2`, more than 2^30.
    pub(super) inverse: u32,
}

impl Scale {
    /// Of a rest length in [`LENGTHS`].
    pub(super) fn of(length: i64) -> Self {
        debug_assert!(LENGTHS.contains(&length), "a length of another form");
        let square = length.unsigned_abs().pow(2); // 2^26 to 2^60
        let shift = (64 - square.leading_zeros() - 27) & !1;
        let inverse = (1_u128 << (58 + shift)) / u128::from(square);
        // At most 2^32, and that only for powers of two.
        Self { shift, inverse: u32::try_from(inverse).unwrap_or(u32::MAX) }
    }

    /// `d.d / L^2`, 26 fractional bits, saturated.
    #[inline]
    pub(super) fn ratio(self, length_sq: u64) -> u32 {
        let scaled = u32::try_from(length_sq >> self.shift);
        scaled.map_or(u32::MAX, |scaled| high(scaled, self.inverse))
    }
}

/// The upper half of a product.
#[inline]
pub(super) fn high(a: u32, b: u32) -> u32 {
    let [_, _, _, _, high @ ..] = (u64::from(a) * u64::from(b)).to_le_bytes();
    u32::from_le_bytes(high)
}

/// The share `1 - 1 / sqrt(v)` of the difference by which the ends must approach.
#[inline]
pub(super) fn share(ratio: u32) -> i32 {
    let (half, two) = (RATIO_ONE / 2, 2 * RATIO_ONE - 1);
    if (half..=two).contains(&ratio) {
        return polynomial(ratio);
    }
    if ratio < half {
        // 1 - 2 y, where y <= 1.42.
        let share = 2 * polynomial((4 * ratio).max(half)) - SHARE_ONE;
        return share.max(1 - SHARE_ONE);
    }
    let quarter = ratio.min(i32::MAX.unsigned_abs()) / 4;
    let once = |share: i32| (share >> 1) + SHARE_ONE / 2;
    if quarter <= two {
        return once(polynomial(quarter));
    }
    once(once(polynomial((quarter / 4).min(two))))
}

/// The share for `1/2 <= v < 2`.
#[inline]
fn polynomial(ratio: u32) -> i32 {
    let v = ratio << 5; // 31 fractional bits
    let [c0, c1, c2, c3, c4] = COEFFICIENTS;
    // 0.7 <= each difference <= 3.2, so that none wraps; each product has a fractional bit less.
    let inverse_root = c0 - high(v, c1 - high(v, c2 - high(v, c3 - high(v, c4))));
    SHARE_ONE - inverse_root.cast_signed()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::root::isqrt;

    /// 1 - 1 / sqrt(v) with 28 fractional bits.
    fn exact(ratio: u32) -> i64 {
        // 2^28 / sqrt(ratio / 2^26) = sqrt(2^60 2^22 / ratio)
        let inverse_sq = (1_u128 << 82) / u128::from(ratio);
        let inverse = u64::try_from(inverse_sq).map_or(u64::from(u32::MAX), isqrt);
        i64::from(SHARE_ONE) - inverse.cast_signed()
    }

    #[test]
    fn the_share_is_near_the_exact_one() {
        for ratio in (RATIO_ONE / 8..16 * RATIO_ONE).step_by(97) {
            let (share, exact) = (i64::from(share(ratio)), exact(ratio).max(1 - (1 << 28)));
            let error = (share - exact).abs();
            let per_mille = if ratio < RATIO_ONE / 2 { 20 } else { 14 };
            assert!(error <= per_mille * exact.abs() / 1000 + 8, "v {ratio}: {share} for {exact}");
        }
        assert_eq!(share(RATIO_ONE), 0);
    }

    #[test]
    fn the_share_is_bounded_everywhere() {
        for ratio in (0..=u32::MAX).step_by(65_537).chain([u32::MAX]) {
            let share = share(ratio);
            assert!(share.abs() < SHARE_ONE);
            let sign = (ratio >= RATIO_ONE / 8).then(|| ratio.cmp(&RATIO_ONE));
            assert!(sign.is_none_or(|sign| share.cmp(&0) == sign), "v {ratio}: {share}");
        }
    }

    #[test]
    fn the_scale_gives_the_ratio() {
        for bit in 13..=30 {
            for length in [1_i64 << bit, (1 << bit) - 1, 3 << (bit - 1), 7 << (bit - 2)] {
                if !LENGTHS.contains(&length) {
                    continue;
                }
                let ratio = Scale::of(length).ratio(length.unsigned_abs().pow(2));
                assert!(ratio.abs_diff(RATIO_ONE) <= 2, "length {length}: {ratio}");
            }
        }
    }
}
