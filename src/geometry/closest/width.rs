//! How wide the parts of a formula are.

use core::ops::{Add, Neg, Sub};

use crate::geometry::Aabb;
use crate::math::int256::Int256;
use crate::math::wide::{NARROW_MAX, sub};
use crate::math::{UnitVec3, Vec3};

/// What a formula of differences, dot products and products of two of those is made of.
pub(super) trait Width {
    /// A difference of coordinates.
    type Side: Copy;
    /// A dot product of two differences, and the sum of two.
    type Dot: Copy
        + Ord
        + Default
        + Add<Output = Self::Dot>
        + Sub<Output = Self::Dot>
        + Neg<Output = Self::Dot>;
    /// A product of two dot products, and the sum of four.
    type Area: Area;

    /// `p - o`.
    fn difference(p: Vec3, o: Vec3) -> [Self::Side; 3];

    fn dot(a: [Self::Side; 3], b: [Self::Side; 3]) -> Self::Dot;

    fn cross(a: [Self::Side; 3], b: [Self::Side; 3]) -> [Self::Dot; 3];

    /// `a b - c d`.
    fn minor(a: Self::Dot, b: Self::Dot, c: Self::Dot, d: Self::Dot) -> Self::Area;

    fn raise(side: Self::Side) -> Self::Dot;

    fn widen(dot: Self::Dot) -> Self::Area;
}

/// An integer that wraps.
pub(super) trait Area: Copy + Ord + Default {
    /// The number after this one.
    fn successor(self) -> Self;
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn times(self, length: i64) -> Self;
    /// Bits of a value that is not negative.
    fn bits(self) -> u32;
    /// A value that is not negative, shifted right so far that it has at most 64 bits.
    fn leading(self, shift: u32) -> u64;
    /// The direction of a vector; `None` of the zero vector.
    fn direction(v: [Self; 3]) -> Option<UnitVec3>;
}

/// All within a box of 2^30: differences are at most 2^30, dot products 3 * 2^60, and their
/// products 9 * 2^120, of which even eight fit.
pub(super) enum Narrow {}

/// Triangles and segments below 2^41, points anywhere in 64 bits: differences are below 2^41 or
/// 2^65, dot products below 3 * 2^106, and their products below 2^216.
pub(super) enum Wide {}

/// Whether all of these points are within a box of 2^30.
#[inline]
pub(super) fn is_narrow(points: impl IntoIterator<Item = Vec3>) -> bool {
    Aabb::around(points).is_some_and(|bounds| bounds.span() <= NARROW_MAX.unsigned_abs())
}

/// Whether all of these points are within a box of 2^29, and so the differences between any two
/// ways from one to another are narrow.
#[inline]
pub(super) fn is_narrow_by_half(points: impl IntoIterator<Item = Vec3>) -> bool {
    Aabb::around(points).is_some_and(|bounds| bounds.span() <= NARROW_MAX.unsigned_abs() / 2)
}

impl Width for Narrow {
    type Side = i64;
    type Dot = i64;
    type Area = i128;

    #[inline]
    fn difference(p: Vec3, o: Vec3) -> [i64; 3] {
        sub(p.raw(), o.raw())
    }

    #[inline]
    fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    #[inline]
    fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }

    #[inline]
    fn minor(a: i64, b: i64, c: i64, d: i64) -> i128 {
        i128::from(a) * i128::from(b) - i128::from(c) * i128::from(d)
    }

    #[inline]
    fn raise(side: i64) -> i64 {
        side
    }

    #[inline]
    fn widen(dot: i64) -> i128 {
        dot.into()
    }
}

impl Width for Wide {
    type Side = i128;
    type Dot = i128;
    type Area = Int256;

    fn difference(p: Vec3, o: Vec3) -> [i128; 3] {
        let (p, o) = (p.raw().map(i128::from), o.raw().map(i128::from));
        [p[0] - o[0], p[1] - o[1], p[2] - o[2]]
    }

    fn dot(a: [i128; 3], b: [i128; 3]) -> i128 {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    fn cross(a: [i128; 3], b: [i128; 3]) -> [i128; 3] {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    }

    fn minor(a: i128, b: i128, c: i128, d: i128) -> Int256 {
        Int256::product(a, b) - Int256::product(c, d)
    }

    fn raise(side: i128) -> i128 {
        side
    }

    fn widen(dot: i128) -> Int256 {
        dot.into()
    }
}

impl Area for i128 {
    #[inline]
    fn successor(self) -> Self {
        self.wrapping_add(1)
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        self.wrapping_add(other)
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self.wrapping_sub(other)
    }

    #[inline]
    fn times(self, length: i64) -> Self {
        self.wrapping_mul(length.into())
    }

    #[inline]
    fn bits(self) -> u32 {
        Self::BITS - self.leading_zeros()
    }

    #[inline]
    #[allow(clippy::cast_possible_truncation, reason = "the caller leaves 64 bits")]
    fn leading(self, shift: u32) -> u64 {
        (self >> shift).cast_unsigned() as u64
    }

    #[inline]
    fn direction(v: [Self; 3]) -> Option<UnitVec3> {
        UnitVec3::normalize_wide(v)
    }
}

impl Area for Int256 {
    fn successor(self) -> Self {
        self + Self::from(1)
    }

    fn plus(self, other: Self) -> Self {
        self + other
    }

    fn minus(self, other: Self) -> Self {
        self - other
    }

    fn times(self, length: i64) -> Self {
        Self::times(self, length)
    }

    fn bits(self) -> u32 {
        Self::bits(self)
    }

    #[allow(clippy::cast_possible_truncation, reason = "the caller leaves 64 bits")]
    fn leading(self, shift: u32) -> u64 {
        self.shifted(shift).cast_unsigned() as u64
    }

    fn direction(v: [Self; 3]) -> Option<UnitVec3> {
        // What is cut off is below 2^-95 of the longest component; the sign comes last, so that
        // opposite vectors have opposite directions.
        let shift = v.map(Self::bits).into_iter().max()?.saturating_sub(126);
        UnitVec3::normalize_wide(v.map(|c| {
            let magnitude = if c.signum() < 0 { -c } else { c }.shifted(shift);
            if c.signum() < 0 { -magnitude } else { magnitude }
        }))
    }
}
