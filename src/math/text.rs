//! How the numbers read, print and serialize, once for all of them.
//!
//! Human-readable formats carry the decimal as a string, for most of them would take a number
//! through `f64`. Others carry the raw integer.

use core::fmt;
use core::marker::PhantomData;
use core::str::FromStr;

use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::decimal::{self, DecimalError};
use super::{Fraction, Real};

/// Reads a decimal string.
struct Decimal<T>(PhantomData<T>);

impl<T: FromStr<Err = DecimalError>> Visitor<'_> for Decimal<T> {
    type Value = T;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a decimal in a string")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<T, E> {
        text.parse().map_err(E::custom)
    }
}

macro_rules! decimal_text {
    ($number:ty, $raw:ty, $bits:expr $(, const $generic:ident)?) => {
        impl $(<const $generic: u32>)? FromStr for $number {
            type Err = DecimalError;
            fn from_str(text: &str) -> Result<Self, DecimalError> {
                Self::parse(text)
            }
        }

        /// The shortest decimal that parses back to the same value; width, fill and `+` apply.
        impl $(<const $generic: u32>)? fmt::Display for $number {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                decimal::write(i64::from(self.raw()), $bits, f)
            }
        }

        impl $(<const $generic: u32>)? fmt::Debug for $number {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }

        impl $(<const $generic: u32>)? Serialize for $number {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                if serializer.is_human_readable() {
                    serializer.collect_str(self)
                } else {
                    self.raw().serialize(serializer)
                }
            }
        }

        impl<'de $(, const $generic: u32)?> Deserialize<'de> for $number {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                if deserializer.is_human_readable() {
                    deserializer.deserialize_str(Decimal(PhantomData))
                } else {
                    <$raw>::deserialize(deserializer).map(Self::from_raw)
                }
            }
        }
    };
}

decimal_text!(Real, i64, Real::FRACTION_BITS);
decimal_text!(Fraction<BITS>, i32, BITS, const BITS);
