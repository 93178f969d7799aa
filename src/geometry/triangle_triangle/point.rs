//! Points where parts of two triangles meet.

use super::Corners;
use super::flat::{axis_of, is_between, normal, orient, shadow, turn, turn_wide};
use super::intersection::{Feature, IntersectionPoint};
use crate::math::Vec3;
use crate::math::determinant::{dot, scale_floor};
use crate::math::wide::sub;

type Point = [i64; 3];

/// Whose edge or corner it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Owner {
    A,
    B,
}

/// Two triangles whose boxes meet.
pub(super) struct Pair<'a> {
    a: &'a Corners,
    b: &'a Corners,
    /// The smallest corner: what is rounded is the way from here.
    base: Point,
}

impl<'a> Pair<'a> {
    pub(super) fn new(a: &'a Corners, b: &'a Corners) -> Self {
        let base = a.iter().chain(b).fold(a[0], |base, &corner| base.min(corner));
        Self { a, b, base }
    }

    /// The owner's corners, then those of the other triangle.
    pub(super) fn seen_by(&self, owner: Owner) -> [&'a Corners; 2] {
        match owner {
            Owner::A => [self.a, self.b],
            Owner::B => [self.b, self.a],
        }
    }

    /// The point where an edge, between two corners of its owner, crosses the plane of the other
    /// triangle within that triangle. The corners are not both on that plane.
    pub(super) fn crossing(&self, owner: Owner, ends: [u8; 2]) -> IntersectionPoint {
        let [own, other] = self.seen_by(owner);
        let [from, to] = ends.map(|corner| own[usize::from(corner)]);
        // The other's normal is below 3 * 2^82 in all, the edge below 2^41: so is their product
        // below 2^125, and that is the sum of both heights.
        let normal = normal(other);
        let heights = [from, to].map(|end| dot(&normal, sub(end, other[0])).unsigned_abs());
        let on_own = match heights {
            [0, _] => Feature::Vertex(ends[0]),
            [_, 0] => Feature::Vertex(ends[1]),
            _ => Feature::Edge(edge_between(ends)),
        };
        let lines = [0, 1, 2].map(|k| orient(from, to, other[k], other[(k + 1) % 3]) == 0);
        let on_other = match lines {
            [true, true, _] => Feature::Vertex(1),
            [_, true, true] => Feature::Vertex(2),
            [true, _, true] => Feature::Vertex(0),
            [true, ..] => Feature::Edge(0),
            [_, true, _] => Feature::Edge(1),
            [.., true] => Feature::Edge(2),
            [false, false, false] => Feature::Face,
        };
        let position = self.position(from, to, heights);
        IntersectionPoint::new(owner, position, on_own, on_other)
    }

    /// The point where the insides of two edges cross, if they do in one point.
    pub(super) fn edges_crossing(&self, edge_a: u8, edge_b: u8) -> Option<IntersectionPoint> {
        let [[a, b], [c, d]] = [ends(self.a, edge_a), ends(self.b, edge_b)];
        if orient(a, b, c, d) != 0 {
            return None;
        }
        // Dropping an axis must flatten neither edge onto the other.
        let axis = axis_of(&[a, b, c]).or_else(|| axis_of(&[a, b, d]))?;
        let [p, q, r, s] = [a, b, c, d].map(|point| shadow(point, axis));
        let parts = |a, b, c, d| turn(a, b, c) * turn(a, b, d) < 0;
        if !parts(p, q, r, s) || !parts(r, s, p, q) {
            return None;
        }
        let heights = [p, q].map(|end| turn_wide(r, s, end).unsigned_abs());
        let position = self.position(a, b, heights);
        let features = [edge_a, edge_b].map(Feature::Edge);
        Some(IntersectionPoint::new(Owner::A, position, features[0], features[1]))
    }

    /// A corner, if it lies in the other triangle.
    pub(super) fn corner(&self, owner: Owner, corner: u8) -> Option<IntersectionPoint> {
        let [own, other] = self.seen_by(owner);
        let position = own[usize::from(corner)];
        let on_other = locate(position, other)?;
        let on_own = Feature::Vertex(corner);
        Some(IntersectionPoint::new(owner, Vec3::from_raw(position), on_own, on_other))
    }

    /// The point of a segment whose ends are so far from something that it crosses there.
    fn position(&self, from: Point, to: Point, heights: [u128; 2]) -> Vec3 {
        let whole = heights[0] + heights[1];
        Vec3::from_raw([0, 1, 2].map(|k| {
            // To the crossing from the base, exactly: `floor + rest / whole`.
            let (steps, rest) = scale_floor(from[k].abs_diff(to[k]), heights[0], whole);
            let steps = steps.cast_signed(); // below 2^41
            let start = from[k] - self.base[k];
            let (floor, rest) = match (from[k] <= to[k], rest) {
                (true, rest) => (start + steps, rest),
                (false, 0) => (start - steps, 0),
                (false, rest) => (start - steps - 1, whole - rest),
            };
            // To nearest, ties away from zero: below zero a half goes down.
            let up = if floor < 0 { 2 * rest > whole } else { 2 * rest >= whole };
            self.base[k] + floor + i64::from(up)
        }))
    }
}

impl IntersectionPoint {
    fn new(owner: Owner, position: Vec3, on_own: Feature, on_other: Feature) -> Self {
        let [on_a, on_b] = match owner {
            Owner::A => [on_own, on_other],
            Owner::B => [on_other, on_own],
        };
        Self { position, on_a, on_b }
    }
}

/// The edge between two corners.
fn edge_between([i, j]: [u8; 2]) -> u8 {
    if (i + 1) % 3 == j { i } else { j }
}

/// The corners at the ends of an edge.
pub(super) fn ends(corners: &Corners, edge: u8) -> [Point; 2] {
    [edge, (edge + 1) % 3].map(|corner| corners[usize::from(corner)])
}

/// What of a triangle holds a point, if anything does.
fn locate(point: Point, corners: &Corners) -> Option<Feature> {
    let vertex = (0..3).find(|&corner| corners[usize::from(corner)] == point);
    if vertex.is_some() {
        return vertex.map(Feature::Vertex);
    }
    let Some(axis) = axis_of(corners) else {
        let holds = |&edge: &u8| {
            let [from, to] = ends(corners, edge);
            axis_of(&[from, to, point]).is_none() && is_between(from, to, point)
        };
        return (0..3).find(holds).map(Feature::Edge);
    };
    if dot(&normal(corners), sub(point, corners[0])) != 0 {
        return None;
    }
    let [a, b, c] = corners.map(|corner| shadow(corner, axis));
    let point = shadow(point, axis);
    let side = turn(a, b, c);
    let turns = [[a, b], [b, c], [c, a]].map(|[from, to]| side * turn(from, to, point));
    if turns.contains(&-1) {
        return None;
    }
    let edge = (0..3).find(|&edge| turns[usize::from(edge)] == 0);
    Some(edge.map_or(Feature::Face, Feature::Edge))
}
