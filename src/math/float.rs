//! Floats at the edges, converted by their bits: the core's only file that names them.
//!
//! Reading takes the nearest value, ties away from zero, like every rounding of the crate.
//! Writing takes the nearest float, ties to even, like every conversion of IEEE 754. Neither
//! does arithmetic on floats, so neither depends on a processor's modes or a compiler's flags.

#![allow(clippy::disallowed_types, reason = "the one place where floats come in and go out")]

use super::{Fraction, FractionError, Real, RealError, UnitVec3, Vec3};

/// An IEEE 754 binary format: sign, exponent, significand, from the top.
struct Binary {
    exponent_bits: u32,
    significand_bits: u32,
}

const F32: Binary = Binary { exponent_bits: 8, significand_bits: 23 };
const F64: Binary = Binary { exponent_bits: 11, significand_bits: 52 };

impl Binary {
    const fn bias(&self) -> i32 {
        (1 << (self.exponent_bits - 1)) - 1
    }

    /// The integer nearest to the float times 2^`fraction_bits`, ties away from zero.
    const fn decode(&self, bits: u64, fraction_bits: u32) -> Result<i128, RealError> {
        let hidden = 1 << self.significand_bits;
        let field = bits & (hidden - 1);
        let exponent = ((bits >> self.significand_bits) & ((1 << self.exponent_bits) - 1)) as i32;
        if exponent == (1 << self.exponent_bits) - 1 {
            return Err(if field == 0 { RealError::Infinite } else { RealError::NotANumber });
        }
        if exponent == 0 {
            // Zeros, and subnormals: below 2^-125 in either format.
            return Ok(0);
        }
        // The float is `significand * 2^power`.
        let significand = field | hidden;
        let power = exponent - self.bias() - self.significand_bits.cast_signed();
        let Some(magnitude) = shift(significand, power + fraction_bits.cast_signed()) else {
            return Err(RealError::OutOfRange);
        };
        let negative = bits >> (self.significand_bits + self.exponent_bits) != 0;
        Ok(if negative { -magnitude } else { magnitude })
    }

    /// The bits of the float nearest to `raw * 2^-fraction_bits`, ties to even.
    ///
    /// The result is 0 or between 2^-30 and 2^39 in magnitude: normal, never infinite.
    const fn encode(&self, raw: i64, fraction_bits: u32) -> u64 {
        let magnitude = raw.unsigned_abs();
        if magnitude == 0 {
            return 0;
        }
        let top = magnitude.ilog2();
        let significand = if top <= self.significand_bits {
            magnitude << (self.significand_bits - top)
        } else {
            let lost = top - self.significand_bits;
            let kept = magnitude >> lost;
            let rest = magnitude & ((1 << lost) - 1);
            let half = 1 << (lost - 1);
            kept + (rest > half || rest == half && kept & 1 == 1) as u64
        };
        // At least the bias - 30: positive.
        let exponent = (top + self.bias().cast_unsigned() - fraction_bits) as u64;
        // The hidden bit is taken off by counting the exponent one lower; a significand rounded
        // up to the next power of two thereby carries into the exponent, as it should.
        let sign = (raw < 0) as u64;
        (sign << (self.exponent_bits + self.significand_bits))
            + ((exponent - 1) << self.significand_bits)
            + significand
    }
}

/// `significand * 2^power` to nearest, ties away; `None` from 2^127 on. `significand < 2^53`.
const fn shift(significand: u64, power: i32) -> Option<i128> {
    let wide = significand as i128;
    match power {
        // 53 + 74 bits at most.
        0..=74 => Some(wide << power),
        75.. => None,
        // At most 2^53 / 2^55: a quarter.
        ..=-55 => Some(0),
        // Below 2^53 + 2^53.
        _ => Some((wide + (1 << (-power - 1))) >> -power),
    }
}

macro_rules! number_conversions {
    ($number:ty, $error:ty $(, const $generic:ident)?) => {
        impl $(<const $generic: u32>)? $number {
            /// The value nearest to a float, ties away from zero; both zeros are 0.
            ///
            /// # Errors
            ///
            /// NaN, infinities, and values that do not fit.
            pub const fn from_f64(value: f64) -> Result<Self, $error> {
                match F64.decode(value.to_bits(), Self::FRACTION_BITS) {
                    Ok(raw) => Self::from_wide(raw),
                    Err(error) => Err(error),
                }
            }

            /// The value nearest to a float, ties away from zero; both zeros are 0.
            ///
            /// # Errors
            ///
            /// NaN, infinities, and values that do not fit.
            pub const fn from_f32(value: f32) -> Result<Self, $error> {
                match F32.decode(value.to_bits() as u64, Self::FRACTION_BITS) {
                    Ok(raw) => Self::from_wide(raw),
                    Err(error) => Err(error),
                }
            }

            /// The nearest float, ties to even; exact for up to 53 significant bits.
            #[must_use]
            pub const fn to_f64(self) -> f64 {
                f64::from_bits(F64.encode(self.raw() as i64, Self::FRACTION_BITS))
            }

            /// The nearest float, ties to even; exact for up to 24 significant bits.
            #[must_use]
            pub const fn to_f32(self) -> f32 {
                // The 32-bit format leaves the upper half empty.
                f32::from_bits(F32.encode(self.raw() as i64, Self::FRACTION_BITS) as u32)
            }
        }
    };
}

number_conversions!(Real, RealError);
number_conversions!(Fraction<BITS>, FractionError, const BITS);

macro_rules! vector_to_floats {
    ($vector:ty) => {
        impl $vector {
            /// The nearest floats, for rendering.
            #[must_use]
            pub const fn to_f32(self) -> [f32; 3] {
                [self.x.to_f32(), self.y.to_f32(), self.z.to_f32()]
            }

            /// The nearest floats.
            #[must_use]
            pub const fn to_f64(self) -> [f64; 3] {
                [self.x.to_f64(), self.y.to_f64(), self.z.to_f64()]
            }
        }
    };
}

vector_to_floats!(Vec3);
vector_to_floats!(UnitVec3);

impl Vec3 {
    /// The nearest vector, ties away from zero.
    ///
    /// # Errors
    ///
    /// That of the first component which is NaN, infinite or does not fit.
    pub fn from_f32([x, y, z]: [f32; 3]) -> Result<Self, RealError> {
        Ok(Self::new(Real::from_f32(x)?, Real::from_f32(y)?, Real::from_f32(z)?))
    }

    /// The nearest vector, ties away from zero.
    ///
    /// # Errors
    ///
    /// That of the first component which is NaN, infinite or does not fit.
    pub fn from_f64([x, y, z]: [f64; 3]) -> Result<Self, RealError> {
        Ok(Self::new(Real::from_f64(x)?, Real::from_f64(y)?, Real::from_f64(z)?))
    }
}

macro_rules! mint_conversions {
    ($($mint:ty, $to:ident, $from:ident;)*) => {$(
        impl From<Vec3> for $mint {
            fn from(v: Vec3) -> Self {
                v.$to().into()
            }
        }

        impl TryFrom<$mint> for Vec3 {
            type Error = RealError;
            fn try_from(v: $mint) -> Result<Self, RealError> {
                Self::$from(v.into())
            }
        }
    )*};
}

mint_conversions! {
    mint::Vector3<f32>, to_f32, from_f32;
    mint::Vector3<f64>, to_f64, from_f64;
    mint::Point3<f32>, to_f32, from_f32;
    mint::Point3<f64>, to_f64, from_f64;
}
