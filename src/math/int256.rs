//! Integers of 256 bits: for exact signs and quotients that 128 do not hold.

use core::cmp::Ordering;
use core::ops::{Add, Neg, Sub};

/// A signed integer of 256 bits that wraps, like the machine's own: sums and products are right
/// wherever the final value fits, whatever the parts do on the way.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Int256 {
    high: i128,
    low: u128,
}

impl Int256 {
    /// The exact product.
    #[must_use]
    pub(crate) fn product(a: i128, b: i128) -> Self {
        let magnitude = magnitude_of_product(a.unsigned_abs(), b.unsigned_abs());
        if (a < 0) == (b < 0) { magnitude } else { -magnitude }
    }

    /// `self * factor`, modulo 2^256.
    #[must_use]
    pub(crate) fn times(self, factor: i64) -> Self {
        // Without the sign the product of 64 bits and the high half wraps as it should.
        let magnitude = u128::from(factor.unsigned_abs());
        let Self { high, low } = magnitude_of_product(self.low, magnitude);
        let high = high.wrapping_add(self.high.wrapping_mul(magnitude.cast_signed()));
        let product = Self { high, low };
        if factor < 0 { -product } else { product }
    }

    /// Bits of the magnitude, 0 for 0.
    #[must_use]
    pub(crate) fn bits(self) -> u32 {
        let Self { high, low } = self.abs();
        if high == 0 { u128::BITS - low.leading_zeros() } else { 256 - high.leading_zeros() }
    }

    /// `self >> shift`, rounded down; the lower 128 bits of it. `shift < 256`.
    #[must_use]
    pub(crate) fn shifted(self, shift: u32) -> i128 {
        match shift {
            0 => self.low.cast_signed(),
            1..128 => (self.high << (128 - shift)) | (self.low >> shift).cast_signed(),
            _ => self.high >> (shift - 128),
        }
    }

    /// -1, 0 or 1.
    #[must_use]
    pub(crate) fn signum(self) -> i8 {
        self.cmp(&Self::default()) as i8
    }

    fn abs(self) -> Self {
        if self.high < 0 { -self } else { self }
    }
}

/// The product of two magnitudes, at most (2^128 - 1)^2: a product of less than 2^255 is positive.
fn magnitude_of_product(a: u128, b: u128) -> Int256 {
    const LOW: u128 = u64::MAX as u128;
    let [a_high, a_low, b_high, b_low] = [a >> 64, a & LOW, b >> 64, b & LOW];
    // Each is at most (2^64 - 1)^2 = 2^128 - 2^65 + 1: two halves more of 64 bits fit.
    let lowest = a_low * b_low;
    let middle = a_high * b_low + (lowest >> 64);
    let other = a_low * b_high + (middle & LOW);
    let highest = a_high * b_high + (middle >> 64) + (other >> 64);
    Int256 { high: highest.cast_signed(), low: (other << 64) | (lowest & LOW) }
}

impl From<i128> for Int256 {
    fn from(v: i128) -> Self {
        Self { high: v >> 127, low: v.cast_unsigned() }
    }
}

impl Add for Int256 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (low, carry) = self.low.overflowing_add(other.low);
        let high = self.high.wrapping_add(other.high).wrapping_add(i128::from(carry));
        Self { high, low }
    }
}

impl Neg for Int256 {
    type Output = Self;
    fn neg(self) -> Self {
        Self::default() - self
    }
}

impl Sub for Int256 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        let (low, borrow) = self.low.overflowing_sub(other.low);
        let high = self.high.wrapping_sub(other.high).wrapping_sub(i128::from(borrow));
        Self { high, low }
    }
}

impl Ord for Int256 {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.high, self.low).cmp(&(other.high, other.low))
    }
}

impl PartialOrd for Int256 {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use num_bigint::BigInt;

    use super::*;
    use crate::math::Pcg;

    fn big(v: Int256) -> BigInt {
        (BigInt::from(v.high) << 128) + BigInt::from(v.low)
    }

    /// What is left of an integer of any size in 256 bits.
    fn wrapped(v: &BigInt) -> BigInt {
        let whole: BigInt = BigInt::from(1) << 256;
        let half: BigInt = BigInt::from(1) << 255;
        let rest = ((v + &half) % &whole + &whole) % &whole;
        rest - half
    }

    fn numbers() -> Vec<i128> {
        let mut rng = Pcg::new(256, 0);
        let ends = [0, 1, -1, i128::MAX, i128::MIN, i128::MIN + 1, 1 << 64, (1 << 64) - 1];
        let mut draw = || (i128::from(rng.next_u64()) << 64) | i128::from(rng.next_u64());
        ends.into_iter().chain((0..60).map(|k| draw() >> (k * 2))).collect()
    }

    #[test]
    fn arithmetic_is_that_of_big_integers_wrapped() {
        let numbers = numbers();
        for &a in &numbers {
            for &b in &numbers {
                let product = Int256::product(a, b);
                assert_eq!(big(product), wrapped(&(BigInt::from(a) * b)), "{a} * {b}");
                let (c, factor) = (Int256::from(b), (a >> 64) as i64);
                assert_eq!(big(product + c), wrapped(&(big(product) + b)));
                assert_eq!(big(product - c), wrapped(&(big(product) - b)));
                assert_eq!(big(product.times(factor)), wrapped(&(big(product) * factor)));
                assert_eq!(product.cmp(&c), big(product).cmp(&big(c)));
                assert_eq!(product.bits(), u32::try_from(big(product).bits()).unwrap_or(0));
                assert_eq!(product.signum(), big(product).cmp(&BigInt::ZERO) as i8);
                for shift in [0, 1, 64, 127, 128, 129, 255] {
                    let shifted = big(product) >> shift;
                    let low = BigInt::from(product.shifted(shift));
                    assert_eq!((shifted - low) % (BigInt::from(1) << 128), BigInt::ZERO);
                }
            }
        }
    }
}
