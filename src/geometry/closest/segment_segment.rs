//! From a segment to a segment.

use super::ClosestPoint;
use super::point_segment::Place;
use super::width::{Area, Narrow, Wide, Width, is_narrow};
use crate::geometry::Segment;
use crate::math::Vec3;

/// The nearest points of two segments. O(1).
///
/// Where many pairs of points are nearest, because the segments are parallel and side by side, it
/// is the one in the middle of them. Exchanging the segments exchanges the points.
///
/// ```
/// use verlock::geometry::{Segment, closest_segment_segment};
/// use verlock::{Vec3, real};
///
/// let a = Segment::new([Vec3::ZERO, Vec3::X])?;
/// let b = Segment::new([Vec3::Y, Vec3::from_ints(9, 1, 0)])?;
/// let [on_a, on_b] = closest_segment_segment(&a, &b);
/// assert_eq!(on_a.position, Vec3::X * real!("0.5"));
/// assert_eq!(on_b.position, Vec3::Y + Vec3::X * real!("0.5"));
/// # Ok::<(), verlock::geometry::ShapeError>(())
/// ```
#[inline]
#[must_use]
pub fn closest_segment_segment(a: &Segment, b: &Segment) -> [ClosestPoint<2>; 2] {
    let (a, b) = (a.ends(), b.ends());
    if is_narrow([a[0], a[1], b[0], b[1]]) {
        closest::<Narrow>(a, b)
    } else {
        closest::<Wide>(a, b)
    }
}

fn closest<W: Width>(a: [Vec3; 2], b: [Vec3; 2]) -> [ClosestPoint<2>; 2] {
    let [place_a, place_b] = places::<W>(a, b);
    [place_a.on(a), place_b.on(b)]
}

/// With the ways u along A and v along B, and w from the start of B to that of A, the lines are
/// nearest at `s = (uv vw - uw vv) / (uu vv - uv uv)` on A and `t = (uu vw - uv uw) / ..` on B. A
/// place beyond an end is moved to the end, and the other one after it.
fn places<W: Width>(a: [Vec3; 2], b: [Vec3; 2]) -> [Place<W::Area>; 2] {
    let (u, v, w) =
        (W::difference(a[1], a[0]), W::difference(b[1], b[0]), W::difference(a[0], b[0]));
    let (uu, vv, uv) = (W::dot(u, u), W::dot(v, v), W::dot(u, v));
    let (uw, vw) = (W::dot(u, w), W::dot(v, w));
    // Nearest to the start and to the end of the other segment.
    let on_a = |from: W::Dot| Place::of(W::widen(from), W::widen(uu));
    let on_b = |from: W::Dot| Place::of(W::widen(from), W::widen(vv));
    let lines = W::minor(uu, vv, uv, uv);
    if lines <= W::Area::default() {
        let place_a = middle::<W>(uu, uv, uw);
        let place_b = match place_a {
            Place::Start => on_b(vw),
            Place::End => on_b(uv + vw),
            // Both points are in the middle of what both have side by side.
            Place::Between(..) => middle::<W>(vv, uv, -vw),
        };
        return [place_a, place_b];
    }
    let place_a = Place::of(W::minor(uv, vw, uw, vv), lines);
    let place_b = match place_a {
        Place::Start => on_b(vw),
        Place::End => on_b(uv + vw),
        Place::Between(..) => Place::of(W::minor(uu, vw, uv, uw), lines),
    };
    match place_b {
        Place::Start => [on_a(-uw), place_b],
        Place::End => [on_a(uv - uw), place_b],
        Place::Between(..) => [place_a, place_b],
    }
}

/// The middle of what a parallel segment leaves of this one, or the end next to it: its ends are at
/// `-uw` and `uv - uw` on the way from 0 to `uu`.
fn middle<W: Width>(uu: W::Dot, uv: W::Dot, uw: W::Dot) -> Place<W::Area> {
    let zero = W::Dot::default();
    let ends = [-uw, uv - uw];
    let low = ends[0].min(ends[1]).max(zero);
    let high = ends[0].max(ends[1]).min(uu);
    let [low, high, uu] = [low, high, uu].map(W::widen);
    Place::of(low.plus(high), uu.plus(uu))
}
