//! How wide the products of a pair of shapes are.

use core::ops::{Add, Neg, Sub};

use crate::math::wide::{
    NARROW_MAX, dot_narrow, dot_wide, round_div, round_div_wide, round_shift, round_shift_wide,
    to_i64,
};
use crate::math::{UnitVec3, Vec3, determinant};

/// Products of differences of points of two shapes that are near one another.
///
/// Let `S` be the longest edge of the box around both, grown by the margin: no difference is longer
/// along an axis. All products and sums are exact whatever the width, so both widths give the same
/// bits; the narrow one is quicker.
pub(super) trait Width {
    /// How far something reaches along a direction, times 2^30.
    type Reach: Copy
        + Ord
        + Default
        + Add<Output = Self::Reach>
        + Sub<Output = Self::Reach>
        + Neg<Output = Self::Reach>
        + Into<i128>;
    /// A component of a cross product.
    type Minor: Copy;

    /// How wrong a separation along a [shortened](Self::shorten) axis may be, raw.
    ///
    /// Its components are cut off by less than a unit, the longest is 2^29 at least: that turns the
    /// axis by less than 2^-28, and a reach of `2 S` by less than `S / 2^27`, in the separation and
    /// in the length; as much again is for directions that are rounded.
    const SLACK: i64;

    /// The dot product of a direction and a difference.
    fn along(direction: UnitVec3, d: [i64; 3]) -> Self::Reach;

    /// A reach in raw units.
    fn round(reach: Self::Reach) -> i64;

    /// How long a way is that reaches as far, in raw units; the cosine of its angle, times 2^30,
    /// is above 0.
    fn slant(reach: Self::Reach, cosine: i64) -> i64;

    /// The cross product of two differences, or of a direction and a difference.
    fn cross(u: [i64; 3], v: [i64; 3]) -> [Self::Minor; 3];

    /// The direction of a cross product; none of 0.
    fn normalize(cross: [Self::Minor; 3]) -> Option<UnitVec3>;

    /// A vector along a cross product that is as short as a direction, of any length: exact where
    /// it need not be shortened.
    fn shorten(cross: [Self::Minor; 3]) -> UnitVec3;

    /// The dot product of a cross product and a difference.
    fn volume(cross: [Self::Minor; 3], d: [i64; 3]) -> i128;

    /// `d * share`, where the share is times 2^30; or `direction * length`, likewise.
    fn scale(d: [i64; 3], share: i64) -> [i64; 3];
}

/// For `S <= 2^30` (64 m). Directions are at most 2^30 by components, as differences are: reaches
/// are at most `3 * 2^60`, minors `2^61`, volumes `3 * 2^91`.
pub(super) enum Narrow {}

/// For `S < 2^42 + 2^38`, two shapes of less than 2^41 and [`MARGIN_MAX`](super::MARGIN_MAX):
/// reaches are below 2^74. Edges are shorter than 2^41, so minors are below 2^83 and volumes, three
/// products of one and a difference, below 2^127.
pub(super) enum Wide {}

impl Narrow {
    /// The greatest `S`.
    pub(super) const SPAN_MAX: i64 = NARROW_MAX;
}

impl Width for Narrow {
    const SLACK: i64 = 1 << 6;

    type Reach = i64;
    type Minor = i64;

    #[inline]
    fn along(direction: UnitVec3, d: [i64; 3]) -> i64 {
        dot_narrow(direction.raw(), d)
    }

    #[inline]
    fn round(reach: i64) -> i64 {
        round_shift(reach, 30)
    }

    #[inline]
    fn slant(reach: i64, cosine: i64) -> i64 {
        round_div(reach, cosine)
    }

    #[inline]
    fn cross(u: [i64; 3], v: [i64; 3]) -> [i64; 3] {
        let minor = |j: usize, k: usize| u[j] * v[k] - u[k] * v[j];
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    #[inline]
    fn normalize(cross: [i64; 3]) -> Option<UnitVec3> {
        UnitVec3::normalize(Vec3::from_raw(cross))
    }

    #[inline]
    fn shorten(cross: [i64; 3]) -> UnitVec3 {
        let bits = cross.iter().fold(0, |bits, minor| bits | minor ^ minor >> 63);
        let surplus = (i64::BITS - bits.leading_zeros()).saturating_sub(30);
        UnitVec3::from_raw(cross.map(|minor| (minor >> surplus) as i32))
    }

    #[inline]
    fn volume(cross: [i64; 3], d: [i64; 3]) -> i128 {
        dot_wide(cross, d)
    }

    #[inline]
    fn scale(d: [i64; 3], share: i64) -> [i64; 3] {
        // At most 2^30 times 2^31.
        d.map(|c| round_shift(c * share, 30))
    }
}

impl Width for Wide {
    const SLACK: i64 = 1 << 18;

    type Reach = i128;
    type Minor = i128;

    fn along(direction: UnitVec3, d: [i64; 3]) -> i128 {
        dot_wide(direction.raw(), d)
    }

    fn round(reach: i128) -> i64 {
        to_i64(round_shift_wide(reach, 30))
    }

    fn slant(reach: i128, cosine: i64) -> i64 {
        // What is so steep that it does not fit is beyond every margin.
        let length = round_div_wide(reach, cosine.into());
        length.clamp(i64::MIN.into(), i64::MAX.into()) as i64
    }

    fn cross(u: [i64; 3], v: [i64; 3]) -> [i128; 3] {
        determinant::cross(u, v)
    }

    fn normalize(cross: [i128; 3]) -> Option<UnitVec3> {
        UnitVec3::normalize_wide(cross)
    }

    fn shorten(cross: [i128; 3]) -> UnitVec3 {
        let bits = cross.iter().fold(0, |bits, minor| bits | minor ^ minor >> 127);
        let surplus = (i128::BITS - bits.leading_zeros()).saturating_sub(30);
        UnitVec3::from_raw(cross.map(|minor| (minor >> surplus) as i32))
    }

    fn volume(cross: [i128; 3], d: [i64; 3]) -> i128 {
        determinant::dot(&cross, d)
    }

    fn scale(d: [i64; 3], share: i64) -> [i64; 3] {
        d.map(|c| to_i64(round_shift_wide(i128::from(c) * i128::from(share), 30)))
    }
}
