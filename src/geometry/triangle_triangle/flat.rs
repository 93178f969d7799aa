//! Triangles in one plane, and triangles that are segments or points.
//!
//! Most pairs have been decided before, so none of this is in a hurry: all in 128 bits, and by
//! cases on dimensions only, which no order of corners can disturb.

use super::Corners;
use crate::math::determinant::{Full, Width, cross};
use crate::math::wide::sub;

type Point = [i64; 3];
/// The coordinates that are left when one axis is dropped.
type Shadow = [i64; 2];

/// Whether two triangles have a point in common, of which one is flat or both are in one plane.
/// The boxes around them meet.
pub(super) fn overlap(a: &Corners, b: &Corners) -> bool {
    match [axis_of(a), axis_of(b)] {
        [Some(axis), Some(_)] => {
            let [a, b] = [a, b].map(|corners| corners.map(|corner| shadow(corner, axis)));
            triangles_meet(&a, &b)
        }
        [None, Some(axis)] => edges(a).any(|edge| segment_meets(edge, b, axis)),
        [Some(axis), None] => edges(b).any(|edge| segment_meets(edge, a, axis)),
        [None, None] => edges(a).any(|edge| edges(b).any(|other| segments_meet(edge, other))),
    }
}

/// An axis that may be dropped without flattening the triangle; none if it is flat.
pub(super) fn axis_of(corners: &Corners) -> Option<usize> {
    normal(corners).iter().position(|&minor| minor != 0)
}

pub(super) fn normal([a, b, c]: &Corners) -> [i128; 3] {
    cross(sub(*b, *a), sub(*c, *a))
}

fn edges<P: Copy>(&[a, b, c]: &[P; 3]) -> impl Iterator<Item = [P; 2]> {
    [[a, b], [b, c], [c, a]].into_iter()
}

/// A point without one of its coordinates.
pub(super) fn shadow(point: Point, axis: usize) -> Shadow {
    [point[(axis + 1) % 3], point[(axis + 2) % 3]]
}

/// The sign of `(b - a) x (c - a)`: 1 for a turn to the left.
pub(super) fn turn(a: Shadow, b: Shadow, c: Shadow) -> i8 {
    i8::from(turn_wide(a, b, c) > 0) - i8::from(turn_wide(a, b, c) < 0)
}

/// `(b - a) x (c - a)`: at most `S^2 < 2^84`.
pub(super) fn turn_wide(a: Shadow, b: Shadow, c: Shadow) -> i128 {
    let side = |p: Shadow, k: usize| i128::from(p[k] - a[k]);
    side(b, 0) * side(c, 1) - side(b, 1) * side(c, 0)
}

/// The sign of `((b - a) x (c - a)) . (d - a)`.
pub(super) fn orient(a: Point, b: Point, c: Point, d: Point) -> i8 {
    Full::sign(&Full::cross(sub(b, a), sub(c, a)), sub(d, a))
}

/// A corner of one lies in the other, or edges meet.
fn triangles_meet(a: &[Shadow; 3], b: &[Shadow; 3]) -> bool {
    contains(b, a[0])
        || contains(a, b[0])
        || edges(a).any(|edge| edges(b).any(|other| shadows_meet(edge, other)))
}

/// Whether a point lies in a triangle that is not flat.
fn contains(triangle: &[Shadow; 3], point: Shadow) -> bool {
    let [a, b, c] = *triangle;
    let side = turn(a, b, c);
    edges(triangle).all(|[from, to]| side * turn(from, to, point) >= 0)
}

/// Whether two segments, or points, of a plane meet.
fn shadows_meet([a, b]: [Shadow; 2], [c, d]: [Shadow; 2]) -> bool {
    let [at_c, at_d] = [turn(a, b, c), turn(a, b, d)];
    let [at_a, at_b] = [turn(c, d, a), turn(c, d, b)];
    at_c * at_d < 0 && at_a * at_b < 0
        || at_c == 0 && is_between(a, b, c)
        || at_d == 0 && is_between(a, b, d)
        || at_a == 0 && is_between(c, d, a)
        || at_b == 0 && is_between(c, d, b)
}

/// Whether a point is in the box of two others; of a point on their line: between them.
pub(super) fn is_between<const D: usize>(a: [i64; D], b: [i64; D], p: [i64; D]) -> bool {
    (0..D).all(|k| (a[k].min(b[k])..=a[k].max(b[k])).contains(&p[k]))
}

/// Whether a segment or point meets a triangle that is not flat and may lose the axis.
fn segment_meets([from, to]: [Point; 2], triangle: &Corners, axis: usize) -> bool {
    let [a, b, c] = *triangle;
    let [at_from, at_to] = [from, to].map(|end| orient(a, b, c, end));
    if at_from == 0 && at_to == 0 {
        let segment = [from, to].map(|end| shadow(end, axis));
        let triangle = triangle.map(|corner| shadow(corner, axis));
        return contains(&triangle, segment[0])
            || edges(&triangle).any(|edge| shadows_meet(segment, edge));
    }
    let turns = || edges(triangle).map(|[a, b]| orient(from, to, a, b));
    at_from * at_to <= 0 && (turns().all(|turn| turn >= 0) || turns().all(|turn| turn <= 0))
}

/// Whether two segments, or points, of space meet.
fn segments_meet([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    if orient(a, b, c, d) != 0 {
        return false;
    }
    // They lie in one plane: an axis that may be dropped is where any of these is not 0.
    let normals =
        [[b, a, d, c], [b, a, c, a], [d, c, a, c]].map(|[p, q, r, s]| cross(sub(p, q), sub(r, s)));
    match normals.iter().find_map(|normal| normal.iter().position(|&minor| minor != 0)) {
        Some(axis) => {
            shadows_meet([a, b].map(|p| shadow(p, axis)), [c, d].map(|p| shadow(p, axis)))
        }
        // They lie on one line: they meet where their boxes do.
        None => {
            (0..3).all(|k| a[k].min(b[k]) <= c[k].max(d[k]) && c[k].min(d[k]) <= a[k].max(b[k]))
        }
    }
}
