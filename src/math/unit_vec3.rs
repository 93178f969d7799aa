//! Directions.

use core::ops::Neg;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::root::root_nearest;
use super::wide::{dot_wide, is_narrow, round_div_magnitude};
use super::{Unit, Vec3};

/// A vector of length 1, up to the rounding of its components to 2^-30.
///
/// [`normalize`](Self::normalize) errs by at most 1.7 units of 2^-30 a component, is odd, and
/// commutes with permutations of the axes. [`is_unit`](Self::is_unit) holds for everything it
/// returns; writing to the fields, [`from_raw`](Self::from_raw) or `serde`, which sees a tuple of
/// three [`Unit`]s, can break it: whoever takes one from outside checks it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(C)]
pub struct UnitVec3 {
    /// To the right.
    pub x: Unit,
    /// Up.
    pub y: Unit,
    /// Towards the viewer.
    pub z: Unit,
}

/// Bits of the longest component before the root is taken: its square, three times, fits `u64`.
const LEADING_BITS: u32 = 31;

impl UnitVec3 {
    /// (1, 0, 0).
    pub const X: Self = Self { x: Unit::ONE, y: Unit::ZERO, z: Unit::ZERO };
    /// (0, 1, 0).
    pub const Y: Self = Self { x: Unit::ZERO, y: Unit::ONE, z: Unit::ZERO };
    /// (0, 0, 1).
    pub const Z: Self = Self { x: Unit::ZERO, y: Unit::ZERO, z: Unit::ONE };

    /// The direction of `v`; `None` for the zero vector.
    #[inline]
    #[must_use]
    pub fn normalize(v: Vec3) -> Option<Self> {
        let magnitudes = v.raw().map(i64::unsigned_abs);
        let longest = magnitudes[0] | magnitudes[1] | magnitudes[2];
        let leading = match u64::BITS - longest.leading_zeros() {
            0 => return None,
            bits @ 1..=LEADING_BITS => magnitudes.map(|m| m << (LEADING_BITS - bits)),
            bits => {
                let surplus = bits - LEADING_BITS;
                // Rounds half away. A magnitude is at most 2^63: the half fits.
                magnitudes.map(|m| (m + (1 << (surplus - 1))) >> surplus)
            }
        };
        Some(Self::from_leading(leading, v.raw().map(i64::is_negative)))
    }

    /// The direction of a vector in any unit, such as an exact cross product; `None` for the
    /// zero vector. Where both apply it is [`normalize`](Self::normalize).
    #[inline]
    #[must_use]
    pub fn normalize_wide(v: [i128; 3]) -> Option<Self> {
        let magnitudes = v.map(i128::unsigned_abs);
        let longest = magnitudes[0] | magnitudes[1] | magnitudes[2];
        if longest >> 63 == 0 {
            // Every magnitude is below 2^63.
            return Self::normalize(Vec3::from_raw(v.map(|c| c as i64)));
        }
        let surplus = u128::BITS - longest.leading_zeros() - LEADING_BITS;
        // Rounds half away, to at most 2^31. A magnitude is at most 2^127: the half fits.
        let leading = magnitudes.map(|m| ((m + (1 << (surplus - 1))) >> surplus) as u64);
        Some(Self::from_leading(leading, v.map(i128::is_negative)))
    }

    /// The vector with these raw components, which the caller knows to be a unit vector.
    #[inline]
    #[must_use]
    pub const fn from_raw(raw: [i32; 3]) -> Self {
        let [x, y, z] = raw;
        Self { x: Unit::from_raw(x), y: Unit::from_raw(y), z: Unit::from_raw(z) }
    }

    /// The integers behind the components, times 2^-30.
    #[inline]
    #[must_use]
    pub const fn raw(self) -> [i64; 3] {
        [self.x.raw() as i64, self.y.raw() as i64, self.z.raw() as i64]
    }

    /// Whether the length is 1 up to rounding, | |n|^2 - 2^60 | <= 2^32 raw, and no component is
    /// beyond 1.
    #[must_use]
    pub const fn is_unit(self) -> bool {
        let excess = dot_wide(self.raw(), self.raw()) - (1 << 60);
        excess.unsigned_abs() <= 1 << 32 && is_narrow(self.raw())
    }

    /// Divides by the length. The longest magnitude has 31 bits, or is 2^31 by rounding up.
    ///
    /// Of the 1.7 units of error, 0.69 come from the shift before (its part across the vector),
    /// 0.5 from the root and 0.5 from the quotient. Length: the root is wrong by 2^-31 of itself
    /// at most, so |n|^2 by 2^30, and the quotients add at most 2 * 2^30 * sqrt(3) / 2: together
    /// less than 2^31.5.
    #[inline]
    fn from_leading(magnitudes: [u64; 3], negative: [bool; 3]) -> Self {
        let [x, y, z] = magnitudes;
        // At most 3 * 2^62 < 2^64.
        let length = root_nearest(x * x + y * y + z * z);
        let component = |magnitude: u64, negative: bool| {
            // At most 2^61 above; a magnitude is at most the length, so at most 2^30 in all.
            let share = round_div_magnitude(magnitude << 30, length) as i32;
            if negative { -share } else { share }
        };
        let [left, down, back] = negative;
        Self::from_raw([component(x, left), component(y, down), component(z, back)])
    }
}

impl Neg for UnitVec3 {
    type Output = Self;
    /// The opposite direction; exact.
    #[inline]
    fn neg(self) -> Self {
        let Self { x, y, z } = self;
        Self::from_raw([x, y, z].map(|c| c.raw().strict_neg()))
    }
}

impl Serialize for UnitVec3 {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { x, y, z } = self;
        (x, y, z).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for UnitVec3 {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (x, y, z) = Deserialize::deserialize(deserializer)?;
        Ok(Self { x, y, z })
    }
}
