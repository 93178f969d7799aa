//! Whether and where two triangles meet: exactly.
//!
//! The test of Devillers and Guigue (*Faster Triangle-Triangle Intersection Tests*, INRIA RR-4488,
//! 2002): on which side of each plane the corners of the other triangle are, six signs; they say
//! how to turn and to mirror both triangles so that two more signs decide. Here no sign is ever
//! wrong, which leaves two gaps of the published code, both closed: triangles in one plane, and
//! triangles without an area ([`flat`]).
//!
//! Turning and mirroring is looked up, not branched upon: branches that half of all pairs take are
//! what such a test spends its time on.

mod flat;
mod intersection;
mod point;
mod polygon;
mod sides;

pub use intersection::{Feature, Intersection, IntersectionPoint, intersection_triangle_triangle};

use super::Triangle;
use crate::math::determinant::{Full, Middle, Narrow, Width};
use crate::math::wide::sub;
use crate::math::{Real, Vec3};
use sides::{Sides, order, ordered};

/// The corners of a triangle, raw.
type Corners = [[i64; 3]; 3];

/// Whether two triangles have a point in common; touching counts. Exact. O(1).
///
/// ```
/// use verlock::geometry::{Triangle, overlap_triangle_triangle};
/// use verlock::{Real, Vec3};
///
/// let floor = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::Z])?;
/// let above = |y| Triangle::new([Vec3::X, Vec3::Y, Vec3::Z].map(|p| p + Vec3::Y * y));
/// assert!(overlap_triangle_triangle(&floor, &above(Real::ZERO)?));
/// assert!(!overlap_triangle_triangle(&floor, &above(Real::ULP)?));
/// # Ok::<(), verlock::geometry::TriangleError>(())
/// ```
#[inline]
#[must_use]
pub fn overlap_triangle_triangle(a: &Triangle, b: &Triangle) -> bool {
    // Each spans less than 2^41, and where their boxes meet both span less than 2^42.
    let Some(span) = joint_span(a, b) else { return false };
    if span <= Narrow::SPAN_MAX {
        overlap::<Narrow>(a, b)
    } else if span <= Middle::SPAN_MAX {
        overlap::<Middle>(a, b)
    } else {
        overlap::<Full>(a, b)
    }
}

/// The longest edge of the box around both triangles; none where their own boxes do not meet.
///
/// Not by way of [`Aabb`](crate::geometry::Aabb): axis after axis stays in registers, which halves
/// the time of the whole test.
#[inline]
fn joint_span(a: &Triangle, b: &Triangle) -> Option<u64> {
    let (a, b) = (a.corners(), b.corners());
    let (x, y, z) = (ranges(a, b, |p| p.x), ranges(a, b, |p| p.y), ranges(a, b, |p| p.z));
    // Negative where they are apart along any axis.
    let overlap = |[low_a, high_a, low_b, high_b]: [i64; 4]| (high_b - low_a) | (high_a - low_b);
    if (overlap(x) | overlap(y) | overlap(z)) < 0 {
        return None;
    }
    let span = |[low_a, high_a, low_b, high_b]: [i64; 4]| high_a.max(high_b) - low_a.min(low_b);
    Some(span(x).max(span(y)).max(span(z)).cast_unsigned())
}

/// Where both triangles begin and end along an axis, raw: coordinates are at most 2^60.
#[inline]
fn ranges(a: &[Vec3; 3], b: &[Vec3; 3], axis: fn(&Vec3) -> Real) -> [i64; 4] {
    let [p, q, r] = [axis(&a[0]).raw(), axis(&a[1]).raw(), axis(&a[2]).raw()];
    let [s, t, u] = [axis(&b[0]).raw(), axis(&b[1]).raw(), axis(&b[2]).raw()];
    [p.min(q).min(r), p.max(q).max(r), s.min(t).min(u), s.max(t).max(u)]
}

fn raw(triangle: &Triangle) -> Corners {
    let [a, b, c] = triangle.corners();
    [a.raw(), b.raw(), c.raw()]
}

fn overlap<W: Width>(a: &Triangle, b: &Triangle) -> bool {
    match relation::<W>(a, b) {
        Relation::Apart => false,
        Relation::Flat => flat::overlap(&raw(a), &raw(b)),
        Relation::Across(orders) => {
            let (a, b) = (ordered(a, orders[0]), ordered(b, orders[1]));
            // Both triangles cross the line of the two planes. The interval of each begins where
            // the other's has not ended yet.
            let between = sub(b[0], a[0]);
            let first = W::cross(sub(a[1], a[0]), between);
            let second = W::cross(sub(a[2], a[0]), sub(b[2], a[0]));
            let last = if cfg!(planted) { -1 } else { 0 };
            (W::sign(&first, sub(b[1], a[0])) <= 0) & (W::sign(&second, between) <= last)
        }
    }
}

/// How the planes of two triangles part them.
enum Relation {
    /// One lies on one side of the other's plane.
    Apart,
    /// They lie in one plane, or one has none.
    Flat,
    /// Each has corners on both sides of the other's plane, or on it. In these orders the first
    /// corner of each is alone on its side, and in front of the other's plane or on it.
    Across([[u8; 3]; 2]),
}

#[inline]
fn relation<W: Width>(a: &Triangle, b: &Triangle) -> Relation {
    let of_a = sides::<W>(a, b);
    if of_a.are_one() {
        return Relation::Apart;
    }
    let of_b = sides::<W>(b, a);
    if of_b.are_one() {
        return Relation::Apart;
    }
    if of_a.are_none() | of_b.are_none() {
        return Relation::Flat;
    }
    Relation::Across([order(of_a, of_b), order(of_b, of_a)])
}

/// On which sides of the plane of `b` the corners of `a` are.
#[inline]
fn sides<W: Width>(a: &Triangle, b: &Triangle) -> Sides {
    let ([p, q, r], [s, t, u]) = (a.corners(), b.corners());
    let origin = s.raw();
    let normal = W::cross(sub(t.raw(), origin), sub(u.raw(), origin));
    let side = |corner: &Vec3| W::sign(&normal, sub(corner.raw(), origin));
    Sides::of([side(p), side(q), side(r)])
}
