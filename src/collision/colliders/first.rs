//! What is hit first.

use alloc::vec::Vec;

use super::query::shifted;
use super::{ColliderId, Colliders, Filter};
use crate::collision::cast::{cast_segment_until, cast_until, early_max};
use crate::collision::distance::grown;
use crate::collision::{Cast, Shape};
use crate::geometry::{Aabb, Segment};
use crate::math::{Unit, Vec3};

impl Colliders {
    /// What a shape touches first, moving by `motion` in metres without turning: what
    /// [`cast`](Self::cast) lists first, at a lower cost, as nothing behind a hit is looked at.
    /// O(k log k) for k colliders whose boxes meet the box around the way, and a cast for each that
    /// the shape may reach no later than what it hits.
    #[must_use]
    pub fn cast_first(
        &self,
        shape: &Shape,
        motion: Vec3,
        filter: &Filter,
    ) -> Option<(ColliderId, Cast)> {
        let cast = |other: &Shape, until| cast_until(shape, motion, other, until);
        self.first(shape.bounds(), motion, filter, cast)
    }

    /// What a segment, from its first end to its second, goes through first: what
    /// [`cast_segment`](Self::cast_segment) lists first, at a lower cost. Costs as much as
    /// [`cast_first`](Self::cast_first).
    ///
    /// ```
    /// use verlock::collision::{Colliders, Filter};
    /// use verlock::geometry::{HalfSpace, Segment, Sphere};
    /// use verlock::math::UnitVec3;
    /// use verlock::{Vec3, real};
    ///
    /// let mut colliders = Colliders::new();
    /// colliders.insert(HalfSpace::new(Vec3::ZERO, UnitVec3::Y)?.into())?;
    /// let ball = Sphere::new(Vec3::from_ints(0, 2, 0), real!("1"))?;
    /// let ball = colliders.insert(ball.into())?;
    /// let down = Segment::new([Vec3::from_ints(0, 9, 0), Vec3::from_ints(0, -9, 0)])?;
    /// let (id, hit) = colliders.cast_segment_first(&down, &Filter::ALL).ok_or("no hit")?;
    /// let touch = hit.touch.ok_or("it begins inside")?;
    /// assert_eq!(id, ball);
    /// assert_eq!(-touch.normal, UnitVec3::Y); // the surface's own
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub fn cast_segment_first(
        &self,
        segment: &Segment,
        filter: &Filter,
    ) -> Option<(ColliderId, Cast)> {
        let [from, to] = segment.ends();
        let cast = |shape: &Shape, until| cast_segment_until(segment, shape, until);
        self.first(Some(Aabb::of_point(from)), to - from, filter, cast)
    }

    /// The first hit of what is in a box that moves, of several at a time that of the lowest id.
    ///
    /// Colliders are asked in the order in which their boxes are reached, and for nothing later
    /// than what is known.
    fn first(
        &self,
        bounds: Option<Aabb>,
        motion: Vec3,
        filter: &Filter,
        cast: impl Fn(&Shape, Unit) -> Option<Cast>,
    ) -> Option<(ColliderId, Cast)> {
        let region = bounds.map(|bounds| bounds.union(shifted(&bounds, motion)));
        let early = early_max(motion);
        let reached = |other: &Shape| match (bounds, other.bounds()) {
            (Some(bounds), Some(other)) => arrival(&bounds, motion, &grown(&other, early)),
            _ => Unit::ZERO,
        };
        let near = self.near(region, filter);
        let mut near: Vec<_> =
            near.map(|(id, other)| (reached(&other.shape), id, &other.shape)).collect();
        near.sort_by_key(|&(reached, id, _)| (reached, id));
        let mut first: Option<(ColliderId, Cast)> = None;
        for (reached, id, other) in near {
            let until = first.map_or(Unit::ONE, |(_, hit)| hit.time);
            if reached > until {
                break;
            }
            let next = cast(other, until).map(|hit| (id, hit));
            first = first.into_iter().chain(next).min_by_key(|&(id, hit)| (hit.time, id));
        }
        first
    }
}

/// Before when a box that moves does not touch one that rests, rounded down; the end if never.
fn arrival(moving: &Aabb, motion: Vec3, rest: &Aabb) -> Unit {
    let one = i128::from(Unit::ONE.raw());
    let [low, high] = [moving.min(), moving.max()].map(Vec3::raw);
    let [rest_low, rest_high] = [rest.min(), rest.max()].map(Vec3::raw);
    let latest = (0..3).fold(0, |latest: i128, k| {
        let way = i128::from(motion.raw()[k]);
        let gap = if way < 0 {
            i128::from(low[k]) - i128::from(rest_high[k])
        } else {
            i128::from(rest_low[k]) - i128::from(high[k])
        };
        // Below 2^65 * 2^30. What does not move along an axis tells nothing there.
        if way == 0 { latest } else { latest.max(gap * one / way.abs()) }
    });
    Unit::from_raw(latest.min(one) as i32) // from 0 to one
}
