//! Where two triangles meet: a point, a segment or a polygon.

use super::flat::orient;
use super::point::{Owner, Pair};
use super::sides::ordered;
use super::{Relation, joint_span, polygon, raw, relation};
use crate::geometry::Triangle;
use crate::math::Vec3;
use crate::math::determinant::Full;

/// The part of a triangle that a point lies on, and on no smaller one.
///
/// Of a triangle without an area, the first corner or else the first edge that holds the point.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Feature {
    /// A corner: 0, 1 or 2.
    Vertex(u8),
    /// The inside of an edge: 0 goes from corner 0 to 1, 1 from 1 to 2, 2 from 2 to 0.
    Edge(u8),
    /// The inside.
    Face,
}

/// A point that two triangles have in common.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct IntersectionPoint {
    /// Where it is. Its distance from the lexicographically smallest of the six corners is rounded,
    /// by components, to nearest; so it moves along when both triangles are moved.
    pub position: Vec3,
    /// What of the first triangle it lies on.
    pub on_a: Feature,
    /// What of the second triangle it lies on.
    pub on_b: Feature,
}

/// What two triangles have in common: the convex hull of 1 to 6 points, each a corner of it.
///
/// Two points are in lexicographic order; a short way between them may be rounded to none. More go
/// around a polygon, which only triangles in one plane have in common: from the smallest towards
/// the smaller one of its neighbours, so that the list of their positions is the first of all ways
/// around.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Intersection {
    points: [IntersectionPoint; 6],
    len: u8,
}

impl Intersection {
    /// The corners of what is common: one is a point, two are a segment, more a polygon.
    #[must_use]
    pub fn points(&self) -> &[IntersectionPoint] {
        &self.points[..usize::from(self.len)]
    }

    /// The segment between two points, or the point that both are.
    pub(super) fn between(a: IntersectionPoint, b: IntersectionPoint) -> Self {
        let mut points = [a.min(b); 6];
        points[1] = a.max(b);
        Self { points, len: if a == b { 1 } else { 2 } }
    }

    /// The polygon of 3 to 6 points in their order.
    pub(super) fn polygon(ring: &[IntersectionPoint]) -> Self {
        let mut points = [ring[0]; 6];
        let mut len = 0;
        for (point, &corner) in points.iter_mut().zip(ring) {
            *point = corner;
            len += 1;
        }
        Self { points, len }
    }
}

/// What two triangles have in common, with the parts of them that meet there; `None` where
/// [`overlap_triangle_triangle`](super::overlap_triangle_triangle) is false. O(1).
///
/// Points are exact until each is rounded once. The order of corners and triangles changes only the
/// names of the features, and the order of points that round to one place.
///
/// ```
/// use verlock::Vec3;
/// use verlock::geometry::{Feature, Triangle, intersection_triangle_triangle};
///
/// let triangle = |corners: [(i32, i32, i32); 3]| {
///     Triangle::new(corners.map(|(x, y, z)| Vec3::from_ints(x, y, z)))
/// };
/// let floor = triangle([(0, 0, 0), (4, 0, 0), (0, 0, 4)])?;
/// let blade = triangle([(1, 2, 1), (1, -2, 1), (1, 0, 5)])?;
/// let segment = intersection_triangle_triangle(&floor, &blade).expect("they cross");
/// let [from, to] = segment.points() else { panic!("along a line") };
/// assert_eq!((from.position, to.position), (Vec3::from_ints(1, 0, 1), Vec3::from_ints(1, 0, 3)));
/// assert_eq!((from.on_a, from.on_b), (Feature::Face, Feature::Edge(0)));
/// assert_eq!((to.on_a, to.on_b), (Feature::Edge(1), Feature::Face));
/// # Ok::<(), verlock::geometry::TriangleError>(())
/// ```
#[must_use]
pub fn intersection_triangle_triangle(a: &Triangle, b: &Triangle) -> Option<Intersection> {
    joint_span(a, b)?;
    match relation::<Full>(a, b) {
        Relation::Apart => None,
        Relation::Flat => polygon::intersection(&raw(a), &raw(b)),
        Relation::Across(orders) => segment(a, b, orders),
    }
}

/// What two triangles have in common that cross the line of their planes. Each crosses it between
/// the edges that leave its first corner; what is common is bounded by one of each pair of ends.
fn segment(a: &Triangle, b: &Triangle, orders: [[u8; 3]; 2]) -> Option<Intersection> {
    let [[p1, q1, r1], [p2, q2, r2]] = [ordered(a, orders[0]), ordered(b, orders[1])];
    let (a, b) = (raw(a), raw(b));
    let pair = Pair::new(&a, &b);
    let of_a = |to: usize| pair.crossing(Owner::A, [orders[0][0], orders[0][to]]);
    let of_b = |to: usize| pair.crossing(Owner::B, [orders[1][0], orders[1][to]]);
    let (q, r) = (1, 2);
    let ends = if orient(p1, q1, r2, p2) > 0 {
        if orient(p1, r1, r2, p2) > 0 {
            return None;
        }
        let crosses = orient(p1, r1, q2, p2) > 0;
        [if crosses { of_a(r) } else { of_b(q) }, of_b(r)]
    } else {
        if orient(p1, q1, q2, p2) < 0 {
            return None;
        }
        let crosses = orient(p1, r1, q2, p2) >= 0;
        [if crosses { of_a(r) } else { of_b(q) }, of_a(q)]
    };
    Some(Intersection::between(ends[0], ends[1]))
}
