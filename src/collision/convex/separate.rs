//! The axis along which two solids overlap least.
//!
//! The axes are those of the faces of either, and of pairs of edges that make a face of the
//! Minkowski difference: edges whose arcs cross on the Gauss map (Gregorius, *The Separating Axis
//! Test Between Convex Polyhedra*, 2013). Few pairs do, and signs of dot products tell which.

use super::solid::{Edge, Solid};
use crate::collision::patch::to_beat;
use crate::collision::width::Width;
use crate::math::UnitVec3;
use crate::math::wide::{dot_wide, sub};

/// An axis, and what it belongs to.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    /// From A to B.
    pub(super) normal: UnitVec3,
    /// Of the cores, raw.
    pub(super) separation: i64,
    pub(super) owner: Owner,
}

/// What an axis is at right angles to.
#[derive(Clone, Copy)]
pub(super) enum Owner {
    FaceOfA(u32),
    FaceOfB(u32),
    /// An edge of each; the faces of both that look along the axis most.
    Edges([Option<u32>; 2]),
}

/// What the axes say.
pub(super) enum Verdict {
    /// Along one the cores are farther apart than asked for.
    Apart,
    /// The best one; faces first where it is nearly a tie, A's before B's. None if there are no
    /// axes at all.
    Best(Option<Axis>),
}

/// Finds the best axis of two solids that are at most `margin` apart, which is 0 or more.
pub(super) fn separate<W: Width>(a: &Solid, b: &Solid, margin: i64) -> Verdict {
    let of_a = best_face::<W>(a, b, margin).map(|(face, separation)| {
        let normal = a.normals[face as usize];
        Axis { normal, separation, owner: Owner::FaceOfA(face) }
    });
    if of_a.is_some_and(|axis| axis.separation > margin) {
        return Verdict::Apart;
    }
    let of_b = best_face::<W>(b, a, margin).map(|(face, separation)| {
        let normal = -b.normals[face as usize];
        Axis { normal, separation, owner: Owner::FaceOfB(face) }
    });
    if of_b.is_some_and(|axis| axis.separation > margin) {
        return Verdict::Apart;
    }
    let of_faces = match (of_a, of_b) {
        (Some(a), Some(b)) if b.separation > to_beat(a.separation) => of_b,
        (None, _) => of_b,
        _ => of_a,
    };
    let best = of_a.iter().chain(&of_b).map(|axis| axis.separation).max();
    match best_edges::<W>(a, b, best.map_or(i64::MIN, to_beat)) {
        Some(axis) if axis.separation > margin => Verdict::Apart,
        Some(axis) => Verdict::Best(Some(axis)),
        None => Verdict::Best(of_faces),
    }
}

/// The face of one solid that the other is farthest in front of, the first of several; or any that
/// it is farther in front of than the margin.
fn best_face<W: Width>(of: &Solid, other: &Solid, margin: i64) -> Option<(u32, i64)> {
    let mut best: Option<(u32, i64)> = None;
    for (face, &normal) in (0..).zip(of.normals.iter()) {
        let nearest = -other.farthest::<W>(-normal).1;
        let separation = W::round(nearest - of.face_reach::<W>(face));
        if best.is_none_or(|(_, most)| separation > most) {
            best = Some((face, separation));
            if separation > margin {
                break;
            }
        }
    }
    best
}

/// The axis of a pair of edges that separates most, if by more than `least`.
fn best_edges<W: Width>(a: &Solid, b: &Solid, mut least: i64) -> Option<Axis> {
    let (edges_a, edges_b) = (a.edges(), b.edges());
    let mut best = None;
    for of_a in edges_a.iter() {
        for of_b in edges_b.iter() {
            let Some(is_against) = crossing::<W>(of_a, of_b) else { continue };
            let cross = W::cross(of_a.way, of_b.way);
            let axis = W::shorten(cross);
            let gap: i128 = W::along(axis, sub(of_b.from, of_a.from)).into();
            let gap = if is_against { -gap } else { gap };
            if gap <= product_max::<W>(least, axis) {
                continue;
            }
            let Some(normal) = W::normalize(cross) else { continue };
            let normal = if is_against { -normal } else { normal };
            // Of the solids, not of the edges: arcs that are rounded may cross when others do not.
            let nearest = -b.farthest::<W>(-normal).1;
            let separation = W::round(nearest - a.farthest::<W>(normal).1);
            if separation > least {
                least = separation;
                let owner = Owner::Edges([towards(of_a, normal), towards(of_b, -normal)]);
                best = Some(Axis { normal, separation, owner });
            }
        }
    }
    best
}

/// What a separation times the length of its axis is above, if the separation is above `least`: so
/// most axes need no root.
#[inline]
pub(super) fn product_max<W: Width>(least: i64, axis: UnitVec3) -> i128 {
    let [x, y, z] = axis.raw().map(i64::abs);
    let least = i128::from(least) - i128::from(W::SLACK);
    // No length is above the sum of the components, or below the greatest.
    least * i128::from(if least < 0 { x + y + z } else { x.max(y).max(z) })
}

/// The face at an edge that looks along a direction most, the first of equal ones.
fn towards(edge: &Edge, direction: UnitVec3) -> Option<u32> {
    let [first, second] = edge.normals?.map(|n| dot_wide(n.raw(), direction.raw()));
    Some(edge.faces[usize::from(second > first)])
}

/// Whether the arc of an edge of A crosses that of an edge of B turned inside out; and if so,
/// whether the cross product of the edges points from B to A.
///
/// An arc leads from the normal of the first face to that of the second, and the edge is at right
/// angles to both: an arc crosses the circle of the other edge if its ends are on both sides. An
/// edge without faces has a whole circle for an arc. Where both arcs cross the circles, they do so
/// on the same half of the sphere if the signs agree.
fn crossing<W: Width>(a: &Edge, b: &Edge) -> Option<bool> {
    let of_a = sides::<W>(a, b)?;
    let of_b = sides::<W>(b, a)?;
    match (of_a, of_b) {
        (0, 0) => {
            let axis = W::shorten(W::cross(a.way, b.way));
            Some(W::along(axis, sub(b.from, a.from)) < W::Reach::default())
        }
        (0, side) | (side, 0) => Some(side < 0),
        (side, other) => (side == other).then_some(side < 0),
    }
}

/// On which side of the circle of another edge the arc of an edge begins, 0 for a whole circle;
/// none if it does not cross it.
#[inline]
fn sides<W: Width>(edge: &Edge, other: &Edge) -> Option<i8> {
    let Some(normals) = edge.normals else { return Some(0) };
    let zero = W::Reach::default();
    let [first, second] = normals.map(|normal| W::along(normal, other.way));
    if first > zero && second < zero {
        Some(1)
    } else if first < zero && second > zero {
        Some(-1)
    } else {
        None
    }
}
