//! Straight motion.

use crate::geometry::Triangle;
use crate::math::wide::{round_shift_wide, to_i64};
use crate::math::{Unit, Vec3};

/// Where something is at the start of a step and at its end; every point of it moves in between
/// along a straight line, evenly.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Motion<T> {
    /// At time 0.
    pub start: T,
    /// At time 1.
    pub end: T,
}

impl<T: Copy> Motion<T> {
    /// From here to there.
    #[inline]
    #[must_use]
    pub const fn new(start: T, end: T) -> Self {
        Self { start, end }
    }

    /// No motion.
    #[inline]
    #[must_use]
    pub const fn rest(place: T) -> Self {
        Self { start: place, end: place }
    }
}

impl Motion<Vec3> {
    /// Where it is at a time in 0..=1. The way from the start is rounded, once.
    ///
    /// Coordinates are at most [`Triangle::COORDINATE_MAX`], which debug builds check.
    #[inline]
    #[must_use]
    pub fn at(&self, time: Unit) -> Vec3 {
        let (start, end) = (self.start.raw(), self.end.raw());
        debug_assert!(Unit::ZERO <= time && time <= Unit::ONE, "Motion: time outside of 0..=1");
        let along = |k: usize| {
            // At most 2^61 * 2^30, and after rounding no more than the way to the end.
            let way = i128::from(end[k]) - i128::from(start[k]);
            start[k] + to_i64(round_shift_wide(way * i128::from(time.raw()), Unit::FRACTION_BITS))
        };
        Vec3::from_raw([along(0), along(1), along(2)])
    }
}

impl Motion<Triangle> {
    /// Where it is at a time in 0..=1, every corner rounded as a point.
    #[must_use]
    pub fn at(&self, time: Unit) -> Triangle {
        Triangle::between(self.corners().map(|corner| corner.at(time)))
    }

    /// The motions of its corners.
    #[inline]
    #[must_use]
    pub fn corners(&self) -> [Motion<Vec3>; 3] {
        let [a, b, c] = *self.start.corners();
        let [d, e, f] = *self.end.corners();
        [Motion::new(a, d), Motion::new(b, e), Motion::new(c, f)]
    }
}
