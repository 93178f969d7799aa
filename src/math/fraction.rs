//! Small numbers in 32 bits.

use super::decimal::{self, DecimalError};
use super::real::{RealError, ratio};

/// A number with `BITS` fraction bits in 32, between -2^(31 - `BITS`) and 2^(31 - `BITS`)
/// without the latter; `1 <= BITS <= 30`.
///
/// Text and `serde` as for [`Real`](super::Real); the raw integer is an `i32`. No operators:
/// formulas take the raw values and round once at the end.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[repr(transparent)]
pub struct Fraction<const BITS: u32>(i32);

/// Components of unit vectors, shares, stiffness: [-2, 2) in steps of 2^-30.
pub type Unit = Fraction<30>;

/// Barycentric weights: [-16, 16) in steps of 2^-27.
pub type Weight = Fraction<27>;

/// Friction, scale of gravity: [-32768, 32768) in steps of 2^-16.
pub type Factor = Fraction<16>;

/// Why a number could not become a [`Fraction`].
pub type FractionError = RealError;

impl<const BITS: u32> Fraction<BITS> {
    /// 0.
    pub const ZERO: Self = Self::from_raw(0);
    /// 1.
    pub const ONE: Self = Self::from_raw({
        assert!(1 <= BITS && BITS <= 30, "Fraction: BITS outside 1..=30");
        1 << BITS
    });
    /// Bits behind the binary point.
    pub const FRACTION_BITS: u32 = BITS;

    /// `raw * 2^-BITS`.
    #[inline]
    #[must_use]
    pub const fn from_raw(raw: i32) -> Self {
        Self(raw)
    }

    /// The integer behind the number: the value times 2^`BITS`.
    #[inline]
    #[must_use]
    pub const fn raw(self) -> i32 {
        self.0
    }

    /// The value nearest to `num / den`, ties away from zero; the denominator may be negative.
    ///
    /// # Errors
    ///
    /// [`FractionError::ZeroDenominator`], or [`FractionError::OutOfRange`].
    pub const fn from_ratio(num: i64, den: i64) -> Result<Self, FractionError> {
        match ratio(num, den, BITS) {
            Ok(raw) => Self::from_wide(raw),
            Err(error) => Err(error),
        }
    }

    /// The value nearest to a decimal, in the grammar of [`Real::parse`](super::Real::parse).
    ///
    /// # Errors
    ///
    /// [`DecimalError`] says which byte is wrong, or that the value does not fit.
    pub const fn parse(text: &str) -> Result<Self, DecimalError> {
        match decimal::parse(text.as_bytes(), BITS) {
            Ok(raw) => match Self::from_wide(raw) {
                Ok(value) => Ok(value),
                Err(_) => Err(DecimalError::OutOfRange),
            },
            Err(error) => Err(error),
        }
    }

    /// The raw value, if it fits.
    pub(super) const fn from_wide(raw: i128) -> Result<Self, FractionError> {
        let low = raw as i32;
        if low as i128 == raw { Ok(Self(low)) } else { Err(FractionError::OutOfRange) }
    }
}
