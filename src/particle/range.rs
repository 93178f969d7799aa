//! Numbers out of their ranges.

use core::fmt;
use core::ops::RangeInclusive;

use crate::math::wide::round_shift;
use crate::math::{Factor, Real, Unit, Vec3};

/// A field does not hold what it declares.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct RangeError {
    /// The field, as the API spells it.
    pub field: &'static str,
    /// What is wrong with it.
    pub fault: RangeFault,
}

/// What is wrong with a field.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[non_exhaustive]
pub enum RangeFault {
    /// It is out of a range that more than the field decides.
    OutOfRange,
    /// A number, or a component of a vector, is not within two others.
    Outside {
        /// The number, to the nearest [`Real`].
        value: Real,
        /// The least that it may be.
        least: Real,
        /// The most that it may be.
        most: Real,
    },
    /// It names nothing, and must.
    Empty,
    /// It names a particle for the second time.
    SameParticle,
    /// What it links is at the same place.
    Coincident,
}

/// A number that a message can tell.
pub(crate) trait Amount: Copy + PartialOrd {
    /// The nearest number of metres and the like.
    fn amount(self) -> Real;
}

impl RangeError {
    /// An error that tells the field alone.
    pub(crate) const fn new(field: &'static str) -> Self {
        Self { field, fault: RangeFault::OutOfRange }
    }

    /// This field names nothing.
    pub(crate) const fn empty(field: &'static str) -> Self {
        Self { field, fault: RangeFault::Empty }
    }

    /// A particle is named twice, the second time by this field.
    pub(crate) const fn same_particle(field: &'static str) -> Self {
        Self { field, fault: RangeFault::SameParticle }
    }

    /// This field links what is at the same place.
    pub(crate) const fn coincident(field: &'static str) -> Self {
        Self { field, fault: RangeFault::Coincident }
    }
}

/// An error that names the field, unless its value is good.
pub(crate) fn check(good: bool, field: &'static str) -> Result<(), RangeError> {
    if good { Ok(()) } else { Err(RangeError::new(field)) }
}

/// An error that names the field, its value and its range, unless that holds the value.
pub(crate) fn check_in<T: Amount>(
    value: T,
    range: RangeInclusive<T>,
    field: &'static str,
) -> Result<(), RangeError> {
    if range.contains(&value) {
        return Ok(());
    }
    let [value, least, most] = [value, *range.start(), *range.end()].map(T::amount);
    Err(RangeError { field, fault: RangeFault::Outside { value, least, most } })
}

/// An error that names the field and its value, if that is negative.
pub(crate) fn check_not_negative(value: Factor, field: &'static str) -> Result<(), RangeError> {
    check_in(value, Factor::ZERO..=Factor::from_raw(i32::MAX), field)
}

/// The same for the components of a vector, each of which is within `+-limit` (raw).
pub(crate) fn check_within(v: Vec3, limit: i64, field: &'static str) -> Result<(), RangeError> {
    let range = Real::from_raw(-limit)..=Real::from_raw(limit);
    v.raw().into_iter().try_for_each(|c| check_in(Real::from_raw(c), range.clone(), field))
}

/// Whether every component is within `+-limit` (raw).
pub(crate) fn within(v: Vec3, limit: i64) -> bool {
    v.raw().iter().all(|c| c.unsigned_abs() <= limit.unsigned_abs())
}

impl Amount for Real {
    fn amount(self) -> Real {
        self
    }
}

impl Amount for Factor {
    fn amount(self) -> Real {
        Real::from_raw(i64::from(self.raw()) << (Real::FRACTION_BITS - Self::FRACTION_BITS))
    }
}

impl Amount for Unit {
    fn amount(self) -> Real {
        let lost = Self::FRACTION_BITS - Real::FRACTION_BITS;
        Real::from_raw(round_shift(self.raw().into(), lost)) // 32 bits
    }
}

impl Amount for u32 {
    fn amount(self) -> Real {
        Real::from_raw(i64::from(self) << Real::FRACTION_BITS) // below 2^56
    }
}

impl fmt::Display for RangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { field, fault } = self;
        match fault {
            RangeFault::OutOfRange => write!(f, "{field} is out of range"),
            RangeFault::Outside { value, least, most } => {
                write!(f, "{field} is {value}, allowed {least} to {most}")
            }
            RangeFault::Empty => write!(f, "{field} names nothing"),
            RangeFault::SameParticle => write!(f, "{field} names the same particle twice"),
            RangeFault::Coincident => write!(f, "{field}: the ends coincide"),
        }
    }
}

impl core::error::Error for RangeError {}
