//! Directions between nearest points: from exact vectors, not from the rounded points.

use core::cmp::Ordering;

use super::width::{Area, Narrow, Wide, Width, is_narrow};
use crate::geometry::{Feature, Segment, Triangle};
use crate::math::{UnitVec3, Vec3};

/// The direction from a point to a segment, given the feature of its
/// [closest point](super::closest_point_segment); `None` if the point lies on it. O(1).
///
/// As exact as a unit vector is, however near the point may be.
#[must_use]
pub fn normal_point_segment(point: Vec3, segment: &Segment, on: Feature) -> Option<UnitVec3> {
    let ends = segment.ends();
    if is_narrow([point, ends[0], ends[1]]) {
        to_segment::<Narrow>(point, ends, on)
    } else {
        to_segment::<Wide>(point, ends, on)
    }
}

/// The direction from a point to a triangle, given the feature of its
/// [closest point](super::closest_point_triangle); `None` if the point lies on it. O(1).
///
/// As exact as a unit vector is, however near the point may be: to a face it is the normal of the
/// face, or the opposite one.
#[must_use]
pub fn normal_point_triangle(point: Vec3, triangle: &Triangle, on: Feature) -> Option<UnitVec3> {
    if let Feature::Edge(edge) = on {
        return normal_point_segment(point, &triangle.edge(edge), Feature::Edge(0));
    }
    let corners = triangle.corners();
    if is_narrow([point, corners[0], corners[1], corners[2]]) {
        to_triangle::<Narrow>(point, corners, on)
    } else {
        to_triangle::<Wide>(point, corners, on)
    }
}

/// The direction from one segment to another, given the features of their
/// [closest points](super::closest_segment_segment); `None` if they meet. O(1).
///
/// As exact as a unit vector is, however near they may be.
#[must_use]
pub fn normal_segment_segment(a: &Segment, b: &Segment, on: [Feature; 2]) -> Option<UnitVec3> {
    let (ends_a, ends_b) = (a.ends(), b.ends());
    match on {
        [Feature::Vertex(end), on_b] => normal_point_segment(ends_a[place(end)], b, on_b),
        [on_a, Feature::Vertex(end)] => {
            normal_point_segment(ends_b[place(end)], a, on_a).map(|normal| -normal)
        }
        _ if is_narrow([ends_a[0], ends_a[1], ends_b[0], ends_b[1]]) => {
            between_edges::<Narrow>(ends_a, ends_b)
        }
        _ => between_edges::<Wide>(ends_a, ends_b),
    }
}

/// The end of that number, the last one for all that are higher.
fn place(end: u8) -> usize {
    usize::from(end.min(1))
}

fn to_segment<W: Width>(point: Vec3, ends: [Vec3; 2], on: Feature) -> Option<UnitVec3> {
    W::Area::direction(match on {
        Feature::Vertex(end) => to_point::<W>(point, ends[place(end)]),
        _ => to_line::<W>(point, ends),
    })
}

fn to_triangle<W: Width>(point: Vec3, corners: &[Vec3; 3], on: Feature) -> Option<UnitVec3> {
    W::Area::direction(match on {
        Feature::Vertex(corner) => to_point::<W>(point, corners[usize::from(corner.min(2))]),
        _ => to_plane::<W>(point, corners),
    })
}

fn between_edges<W: Width>(a: [Vec3; 2], b: [Vec3; 2]) -> Option<UnitVec3> {
    let [u, v] = [a, b].map(|[from, to]| W::difference(to, from));
    let normal = W::cross(u, v);
    let way = W::difference(b[0], a[0]);
    W::Area::direction(if normal == [W::Dot::default(); 3] {
        across::<W>(u, way)
    } else {
        towards::<W>(normal, way)
    })
}

/// The way from a point to another.
#[inline]
pub(super) fn to_point<W: Width>(from: Vec3, to: Vec3) -> [W::Area; 3] {
    let [x, y, z] = W::difference(to, from);
    [W::widen(W::raise(x)), W::widen(W::raise(y)), W::widen(W::raise(z))]
}

/// The way from a point to the line through two others, times the square of their distance.
#[inline]
pub(super) fn to_line<W: Width>(point: Vec3, [from, to]: [Vec3; 2]) -> [W::Area; 3] {
    across::<W>(W::difference(to, from), W::difference(from, point))
}

/// The normal of three points, or the opposite one, whichever goes from a point to their plane;
/// nothing from a point on it.
#[inline]
pub(super) fn to_plane<W: Width>(point: Vec3, corners: &[Vec3; 3]) -> [W::Area; 3] {
    let [a, b, c] = *corners;
    let normal = W::cross(W::difference(b, a), W::difference(c, a));
    towards::<W>(normal, W::difference(a, point))
}

/// The part of a way that is at right angles to an edge: `way (e . e) - e (e . way)`.
#[inline]
fn across<W: Width>(edge: [W::Side; 3], way: [W::Side; 3]) -> [W::Area; 3] {
    let (whole, along) = (W::dot(edge, edge), W::dot(edge, way));
    let part = |k: usize| W::minor(W::raise(way[k]), whole, W::raise(edge[k]), along);
    [part(0), part(1), part(2)]
}

/// A normal, or the opposite one, whichever goes with a way; nothing across it.
#[inline]
fn towards<W: Width>(normal: [W::Dot; 3], way: [W::Side; 3]) -> [W::Area; 3] {
    let zero = W::Dot::default();
    let term = |k: usize| W::minor(normal[k], W::raise(way[k]), zero, zero);
    let [x, y, z] = normal;
    match term(0).plus(term(1)).plus(term(2)).cmp(&W::Area::default()) {
        Ordering::Less => [W::widen(-x), W::widen(-y), W::widen(-z)],
        Ordering::Equal => [W::Area::default(); 3],
        Ordering::Greater => [W::widen(x), W::widen(y), W::widen(z)],
    }
}
