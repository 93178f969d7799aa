//! The faces of a surface that are near something.

use crate::geometry::{Aabb, Surface, Triangle, orient3d};
use crate::math::{Real, Vec3};
use core::cmp::Ordering;

/// A face, and those of its vertices and edges that it speaks for.
///
/// Of all faces at a vertex or an edge, the lowest does. Where one of the others is near something,
/// so is that one, whose box holds the vertex or edge too: each is met once, and nothing has to be
/// remembered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub(super) face: u32,
    pub(super) triangle: Triangle,
    pub(super) bounds: Aabb,
    /// Bit k: it speaks for corner k.
    corners: u8,
    /// Bit k: it speaks for side k, and that is one where something else's edge may be nearest.
    sides: u8,
}

impl Near {
    pub(super) fn of<S: Surface>(surface: &S, face: u32) -> Self {
        let triangle = surface.triangle(face);
        let (corners, sides) = (surface.corners(face), surface.sides(face));
        let mut near = Self { face, triangle, bounds: triangle.bounds(), corners: 0, sides: 0 };
        for k in 0..3 {
            let is_new = !corners[..k].contains(&corners[k]);
            if is_new && surface.faces_at_vertex(corners[k]).next() == Some(face) {
                near.corners |= 1 << k;
            }
            let [from, to] = [corners[k], corners[(k + 1) % 3]];
            let is_new = from != to && !sides[..k].contains(&sides[k]);
            if is_new && has_cone(surface, sides[k], face) {
                near.sides |= 1 << k;
            }
        }
        near
    }

    /// The corners that it speaks for.
    pub(super) fn corners(&self) -> impl Iterator<Item = usize> {
        ones(self.corners)
    }

    /// The sides that it speaks for.
    pub(super) fn sides(&self) -> impl Iterator<Item = usize> {
        ones(self.sides)
    }

    /// Whether its box comes as near to a box as `reach`, along each axis.
    #[inline]
    pub(super) fn is_near(&self, bounds: &Aabb, reach: Real) -> bool {
        is_near(&self.bounds, bounds, reach)
    }
}

/// Whether boxes come as near as `reach` along each axis. Coordinates are below 2^61.
#[inline]
#[allow(clippy::needless_bitwise_bool, reason = "a branch a comparison costs more")]
pub(super) fn is_near(a: &Aabb, b: &Aabb, reach: Real) -> bool {
    let apart = |low: Real, high: Real| low.raw() - high.raw() > reach.raw();
    !(apart(a.min().x, b.max().x)
        | apart(b.min().x, a.max().x)
        | apart(a.min().y, b.max().y)
        | apart(b.min().y, a.max().y)
        | apart(a.min().z, b.max().z)
        | apart(b.min().z, a.max().z))
}

fn ones(bits: u8) -> impl Iterator<Item = usize> {
    (0..3).filter(move |k| bits >> k & 1 == 1)
}

/// Whether a face speaks for an edge at which another edge may be nearest: not where both faces lie
/// in one plane, nor, of a surface with an inside, in a valley.
fn has_cone<S: Surface>(surface: &S, edge: u32, face: u32) -> bool {
    let mut faces = surface.faces_at_edge(edge);
    if faces.next() != Some(face) {
        return false;
    }
    let (Some(other), None) = (faces.next(), faces.next()) else { return true };
    match fold(surface, edge, [face, other]) {
        Ordering::Greater => surface.is_two_sided(),
        Ordering::Equal => false,
        Ordering::Less => true,
    }
}

/// On which side of the first face's plane the second face lies, which meet in an edge: `Less` is
/// behind, `Equal` in the plane.
pub(super) fn fold<S: Surface>(surface: &S, edge: u32, [face, other]: [u32; 2]) -> Ordering {
    let [a, b, c] = *surface.triangle(face).corners();
    orient3d(a, b, c, tip(surface, edge, other))
}

/// The corner of a face that is no end of an edge of it; an end if the face is a line.
#[inline]
pub(super) fn tip<S: Surface>(surface: &S, edge: u32, face: u32) -> Vec3 {
    let (ends, corners) = (surface.ends(edge), surface.corners(face));
    let tip = corners.into_iter().find(|corner| !ends.contains(corner));
    surface.position(tip.unwrap_or(corners[0]))
}
