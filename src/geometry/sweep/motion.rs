//! Straight motion.

use crate::geometry::{Capsule, Sphere, Triangle};
use crate::math::wide::{round_shift_wide, to_i32, to_i64};
use crate::math::{Real, Unit, Vec3};

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
    /// Where it is at a time in 0..=1, to which it is cut. The way from the start is rounded, once.
    #[inline]
    #[must_use]
    pub fn at(&self, time: Unit) -> Vec3 {
        let (start, end) = (self.start.raw(), self.end.raw());
        let time = i128::from(time.clamp(Unit::ZERO, Unit::ONE).raw());
        let along = |k: usize| {
            // At most 2^64 * 2^30, and after rounding no more than the way to the end.
            let way = i128::from(end[k]) - i128::from(start[k]);
            let part = round_shift_wide(way * time, Unit::FRACTION_BITS);
            to_i64(i128::from(start[k]) + part)
        };
        Vec3::from_raw([along(0), along(1), along(2)])
    }
}

/// When what changes evenly is no longer above 0, rounded down; `None` if it always is. Values are
/// within 2^62.
#[inline]
pub(crate) fn fall(start: i64, end: i64) -> Option<Unit> {
    if start <= 0 {
        return Some(Unit::ZERO);
    }
    if end > 0 {
        return None;
    }
    // Not below the start; shares are at most 2^30.
    let way = start - end;
    let share = if start >> (63 - Unit::FRACTION_BITS) == 0 {
        (start << Unit::FRACTION_BITS) / way
    } else {
        to_i64((i128::from(start) << Unit::FRACTION_BITS) / i128::from(way))
    };
    Some(Unit::from_raw(to_i32(share)))
}

/// The first of some times before this at which something is clear: 2^-30 before, then each time
/// about twice as long before; or 0.
pub(crate) fn back_off(time: Unit, is_clear: impl Fn(Unit) -> bool) -> Unit {
    let mut back = 1;
    loop {
        let earlier = Unit::from_raw((time.raw() - back).max(0));
        if earlier == Unit::ZERO || is_clear(earlier) {
            return earlier;
        }
        // A time is at most 2^30, so that this is at most 2^31 - 1.
        back = 2 * back + 1;
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

impl Motion<Capsule> {
    /// Where it is at a time in 0..=1, both ends rounded as points, with the larger of its radii.
    #[must_use]
    pub fn at(&self, time: Unit) -> Capsule {
        Capsule::between(self.ends().map(|end| end.at(time)), self.radius())
    }

    /// The motions of its ends.
    #[inline]
    #[must_use]
    pub fn ends(&self) -> [Motion<Vec3>; 2] {
        let ([a, b], [c, d]) = (self.start.ends(), self.end.ends());
        [Motion::new(a, c), Motion::new(b, d)]
    }

    /// The larger of its radii, in metres, which counts for all of the step.
    #[inline]
    #[must_use]
    pub fn radius(&self) -> Real {
        self.start.radius().max(self.end.radius())
    }
}

impl From<Motion<Sphere>> for Motion<Capsule> {
    /// The ball as a capsule whose ends are one point.
    fn from(ball: Motion<Sphere>) -> Self {
        Self::new(ball.start.into(), ball.end.into())
    }
}
