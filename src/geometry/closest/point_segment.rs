//! From a point to a segment.

use super::ClosestPoint;
use super::blend::blend;
use super::width::{Area, Narrow, Wide, Width, is_narrow};
use crate::geometry::{Feature, Segment};
use crate::math::Vec3;

/// The point of a segment that is nearest to `point`, which may be any. O(1).
///
/// ```
/// use verlock::geometry::{Feature, Segment, closest_point_segment};
/// use verlock::{Real, Vec3, real};
///
/// let segment = Segment::new([Vec3::ZERO, Vec3::X])?;
/// let foot = closest_point_segment(Vec3::new(real!("0.25"), Real::ONE, Real::ONE), &segment);
/// assert_eq!(foot.position, Vec3::X * real!("0.25"));
/// assert_eq!(foot.feature, Feature::Edge(0));
/// assert_eq!(closest_point_segment(-Vec3::ONE, &segment).feature, Feature::Vertex(0));
/// # Ok::<(), verlock::geometry::ShapeError>(())
/// ```
#[inline]
#[must_use]
pub fn closest_point_segment(point: Vec3, segment: &Segment) -> ClosestPoint<2> {
    let ends = segment.ends();
    if is_narrow([point, ends[0], ends[1]]) {
        closest::<Narrow>(point, ends)
    } else {
        closest::<Wide>(point, ends)
    }
}

fn closest<W: Width>(point: Vec3, ends: [Vec3; 2]) -> ClosestPoint<2> {
    Place::nearest::<W>(point, ends).on(ends)
}

/// Where on a segment.
#[derive(Clone, Copy)]
pub(super) enum Place<A> {
    /// At the start.
    Start,
    /// At the end.
    End,
    /// Between them, after the part `n / d` of the way.
    Between(A, A),
}

impl<A: Area> Place<A> {
    /// `n / d`, or the end next to it; at the start of a segment without a length.
    #[inline]
    pub(super) fn of(n: A, d: A) -> Self {
        if n <= A::default() {
            Self::Start
        } else if n >= d {
            Self::End
        } else {
            Self::Between(n, d)
        }
    }

    /// The place nearest to a point.
    #[inline]
    pub(super) fn nearest<W: Width<Area = A>>(point: Vec3, [from, to]: [Vec3; 2]) -> Self {
        let along = W::difference(to, from);
        let reach = W::dot(along, W::difference(point, from));
        Self::of(W::widen(reach), W::widen(W::dot(along, along)))
    }

    /// The point there.
    #[inline]
    pub(super) fn on(self, ends: [Vec3; 2]) -> ClosestPoint<2> {
        match self {
            Self::Start => ClosestPoint::at_corner(&ends, 0),
            Self::End => ClosestPoint::at_corner(&ends, 1),
            Self::Between(n, d) => {
                let (position, weights) = blend(ends, [d.minus(n), n]);
                ClosestPoint { position, feature: Feature::Edge(0), weights }
            }
        }
    }
}
