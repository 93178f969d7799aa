//! The scalar of the simulation.

use core::fmt;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use fixed::types::I40F24;

use super::decimal::{self, DecimalError};
use super::wide::{narrow, round_div_wide, round_shift_wide};

/// A signed number with 24 fraction bits in 64: steps of 60 nm, up to 5.5 * 10^11 m.
///
/// Every result is exact, or rounded once to nearest with ties away from zero. The methods
/// `checked_*` return `None` on overflow. The operators **panic on overflow, in every build
/// profile**: they are for set-up and game code; the simulation itself does not use them.
///
/// Text is exact both ways: [`parse`](Self::parse) takes the nearest value, and `Display` writes
/// the shortest decimal that parses back to the same value. `serde` uses that decimal, as a
/// string, in human-readable formats, and the raw integer elsewhere.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[repr(transparent)]
pub struct Real(I40F24);

/// Why a number could not become a [`Real`] or a [`Fraction`](super::Fraction).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RealError {
    /// The float is a NaN.
    NotANumber,
    /// The float is infinite.
    Infinite,
    /// The nearest value lies outside the type.
    OutOfRange,
    /// The denominator is zero.
    ZeroDenominator,
}

impl Real {
    /// 0.
    pub const ZERO: Self = Self::from_raw(0);
    /// 1.
    pub const ONE: Self = Self::from_int(1);
    /// The smallest step, 2^-24.
    pub const ULP: Self = Self::from_raw(1);
    /// The lowest value, -2^39.
    pub const MIN: Self = Self::from_raw(i64::MIN);
    /// The highest value, 2^39 - 2^-24.
    pub const MAX: Self = Self::from_raw(i64::MAX);
    /// Bits behind the binary point.
    pub const FRACTION_BITS: u32 = I40F24::FRAC_NBITS;

    /// `raw * 2^-24`.
    #[inline]
    #[must_use]
    pub const fn from_raw(raw: i64) -> Self {
        Self(I40F24::from_bits(raw))
    }

    /// The integer behind the number: the value times 2^24.
    #[inline]
    #[must_use]
    pub const fn raw(self) -> i64 {
        self.0.to_bits()
    }

    /// A whole number; every `i32` fits (2^31 * 2^24 = 2^55).
    #[inline]
    #[must_use]
    pub const fn from_int(value: i32) -> Self {
        Self::from_raw((value as i64) << Self::FRACTION_BITS)
    }

    /// The value nearest to `num / den`; the denominator may be negative.
    ///
    /// # Errors
    ///
    /// [`RealError::ZeroDenominator`], or [`RealError::OutOfRange`] beyond [`MIN`](Self::MIN) or
    /// [`MAX`](Self::MAX).
    pub const fn from_ratio(num: i64, den: i64) -> Result<Self, RealError> {
        match ratio(num, den, Self::FRACTION_BITS) {
            Ok(raw) => Self::from_wide(raw),
            Err(error) => Err(error),
        }
    }

    /// The value nearest to a decimal, `[+-]digits[.digits]` with `_` allowed between digits;
    /// any number of digits, no exponent. For constants there is [`real!`](crate::real).
    ///
    /// # Errors
    ///
    /// [`DecimalError`] says which byte is wrong, or that the value does not fit.
    pub const fn parse(text: &str) -> Result<Self, DecimalError> {
        Self::read(decimal::parse(text.as_bytes(), Self::FRACTION_BITS))
    }

    /// The value nearest to a decimal as other programs print it: `1.5`, `-.5`, `2.`, `1e-3`.
    ///
    /// The grammar is `[+-](digits[.[digits]] | .digits)[(e|E)[+-]digits]`, with any number of
    /// digits in each place, and no `_`.
    ///
    /// # Errors
    ///
    /// [`DecimalError`] says which byte is wrong, or that the value does not fit.
    pub const fn parse_scientific(text: &str) -> Result<Self, DecimalError> {
        Self::read(decimal::parse_scientific(text.as_bytes(), Self::FRACTION_BITS))
    }

    /// What a decimal is, if it fits.
    const fn read(raw: Result<i128, DecimalError>) -> Result<Self, DecimalError> {
        match raw {
            Ok(raw) => match narrow(raw) {
                Some(raw) => Ok(Self::from_raw(raw)),
                None => Err(DecimalError::OutOfRange),
            },
            Err(error) => Err(error),
        }
    }

    /// An exact sum of products of two raw values, in units of 2^-48, rounded once; `None` if
    /// that does not fit.
    #[inline]
    #[must_use]
    pub const fn from_product(product: i128) -> Option<Self> {
        // What fits is below (2^63 + 1) 2^24 < 2^88; what is not leaves no room to round.
        if product.unsigned_abs() >> 88 != 0 {
            return None;
        }
        Self::wrap(narrow(round_shift_wide(product, Self::FRACTION_BITS)))
    }

    /// `self + other`.
    #[inline]
    #[must_use]
    pub const fn checked_add(self, other: Self) -> Option<Self> {
        Self::wrap(self.raw().checked_add(other.raw()))
    }

    /// `self - other`.
    #[inline]
    #[must_use]
    pub const fn checked_sub(self, other: Self) -> Option<Self> {
        Self::wrap(self.raw().checked_sub(other.raw()))
    }

    /// `self * other`, rounded once.
    #[inline]
    #[must_use]
    pub const fn checked_mul(self, other: Self) -> Option<Self> {
        // At most 2^126.
        Self::from_product(self.raw() as i128 * other.raw() as i128)
    }

    /// `self / other`, rounded once; `None` also for a zero `other`.
    #[inline]
    #[must_use]
    pub const fn checked_div(self, other: Self) -> Option<Self> {
        // The scales cancel: the quotient is the ratio of the raw values.
        match Self::from_ratio(self.raw(), other.raw()) {
            Ok(quotient) => Some(quotient),
            Err(_) => None,
        }
    }

    /// `-self`; `None` for [`MIN`](Self::MIN).
    #[inline]
    #[must_use]
    pub const fn checked_neg(self) -> Option<Self> {
        Self::wrap(self.raw().checked_neg())
    }

    /// `|self|`; `None` for [`MIN`](Self::MIN).
    #[inline]
    #[must_use]
    pub const fn checked_abs(self) -> Option<Self> {
        Self::wrap(self.raw().checked_abs())
    }

    /// `|self|`.
    ///
    /// # Panics
    ///
    /// For [`MIN`](Self::MIN), in every profile.
    #[inline]
    #[must_use]
    pub const fn abs(self) -> Self {
        self.checked_abs().expect("Real overflow: abs")
    }

    /// -1, 0 or 1.
    #[inline]
    #[must_use]
    pub const fn signum(self) -> Self {
        Self::from_raw(self.raw().signum() << Self::FRACTION_BITS)
    }

    /// Whether the value is below zero. There is no negative zero.
    #[inline]
    #[must_use]
    pub const fn is_negative(self) -> bool {
        self.raw() < 0
    }

    /// The raw value, if it fits.
    pub(super) const fn from_wide(raw: i128) -> Result<Self, RealError> {
        match narrow(raw) {
            Some(raw) => Ok(Self::from_raw(raw)),
            None => Err(RealError::OutOfRange),
        }
    }

    /// `Option::map`, in a constant.
    #[inline]
    const fn wrap(raw: Option<i64>) -> Option<Self> {
        match raw {
            Some(raw) => Some(Self::from_raw(raw)),
            None => None,
        }
    }
}

/// The integer nearest to `num / den * 2^bits`, for `bits <= 62`.
#[inline]
pub(super) const fn ratio(num: i64, den: i64, bits: u32) -> Result<i128, RealError> {
    if den == 0 {
        return Err(RealError::ZeroDenominator);
    }
    // |num| <= 2^63, so at most 2^125. The sign moves to the numerator.
    let num = (num as i128 * den.signum() as i128) << bits;
    Ok(round_div_wide(num, den.unsigned_abs() as i128))
}

impl fmt::Display for RealError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotANumber => "value is not a number",
            Self::Infinite => "value is infinite",
            Self::OutOfRange => "value is out of range",
            Self::ZeroDenominator => "denominator is zero",
        })
    }
}

impl core::error::Error for RealError {}

/// Operators that panic on overflow in every profile, from the method that checks.
macro_rules! strict_operator {
    ($op:ident $method:ident, $assign:ident $assign_method:ident, $checked:ident, $why:literal) => {
        impl $op for Real {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$checked(other).expect($why)
            }
        }
        impl $assign for Real {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                *self = $op::$method(*self, other);
            }
        }
    };
}

strict_operator!(Add add, AddAssign add_assign, checked_add, "Real overflow: +");
strict_operator!(Sub sub, SubAssign sub_assign, checked_sub, "Real overflow: -");
strict_operator!(Mul mul, MulAssign mul_assign, checked_mul, "Real overflow: *");
strict_operator!(Div div, DivAssign div_assign, checked_div, "Real overflow or zero divisor: /");

impl Neg for Real {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.checked_neg().expect("Real overflow: negation")
    }
}

impl From<i32> for Real {
    #[inline]
    fn from(value: i32) -> Self {
        Self::from_int(value)
    }
}

/// A [`Real`](crate::math::Real) constant from its decimal, exactly: the nearest value.
///
/// ```
/// use verlock::{math::Real, real};
///
/// const GRAVITY: Real = real!("-9.81");
/// assert_eq!(GRAVITY.raw(), -164_584_489);
/// ```
///
/// A text that is no decimal, or does not fit, is a compile error:
///
/// ```compile_fail
/// let speed = verlock::real!("1e3");
/// ```
#[macro_export]
macro_rules! real {
    ($text:expr) => {
        const {
            match $crate::math::Real::parse($text) {
                Ok(value) => value,
                Err(_) => panic!("real!: not a decimal, or out of range"),
            }
        }
    };
}
