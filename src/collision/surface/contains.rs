//! Inside or outside of a closed mesh, wherever a point is.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::MeshShape;
use crate::geometry::{Aabb, Surface, Triangle, orient2d, orient3d, overlap_triangle_triangle};
use crate::math::Vec3;

impl MeshShape {
    /// Whether a point is inside a closed mesh or on the surface of any. Exact; what is inside an
    /// open mesh means nothing. O(log n) and a little for each face that a ray along x meets.
    ///
    /// It takes the mesh for solid, where [`Shape::contains`](crate::collision::Shape::contains)
    /// and all queries take it for hollow. Where shells overlap, or one is in another, it is inside
    /// all of them together; a shell that is turned inside out makes a cavity in another one.
    ///
    /// By how often the mesh goes around the point: the sum of the signed crossings of that ray,
    /// moved by something that is infinitely little along y, and infinitely less along z: so it
    /// never meets an edge or a vertex.
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        is_within(self, point)
    }
}

/// Whether a point is inside a closed surface or on any, see [`MeshShape::contains`].
pub(super) fn is_within<S: Surface>(surface: &S, point: Vec3) -> bool {
    winding(surface, point) != Some(0)
}

/// Whether a point is inside a closed surface, and not on it.
pub(super) fn is_inside<S: Surface>(surface: &S, point: Vec3) -> bool {
    winding(surface, point).is_some_and(|turns| turns != 0)
}

/// Whether a point is inside a closed surface, not on it, and the surface is not inside out there.
pub(super) fn is_in_solid<S: Surface>(surface: &S, point: Vec3) -> bool {
    winding(surface, point).is_some_and(|turns| turns > 0)
}

/// How often a closed surface goes around a point; `None` if the point is on it.
fn winding<S: Surface>(surface: &S, point: Vec3) -> Option<i32> {
    let (bounds, place) = (surface.bounds(), Aabb::of_point(point));
    if !bounds.overlaps(&place) {
        return Some(0);
    }
    let mut faces = Vec::new();
    let end = Vec3::new(bounds.max().x, point.y, point.z);
    surface.faces_near(&Aabb::new(point, end), &mut faces);
    let here = Triangle::between([point; 3]);
    let crossings = faces.into_iter().map(|face| {
        let triangle = surface.triangle(face);
        let is_near = triangle.bounds().overlaps(&place);
        let is_on = is_near && overlap_triangle_triangle(&triangle, &here);
        (!is_on).then(|| crossing(&triangle, point))
    });
    // There are fewer than 2^31 faces.
    crossings.sum()
}

/// 1 or -1 if the moved ray from a point that is not on a triangle goes through it one way or the
/// other, else 0.
fn crossing(triangle: &Triangle, point: Vec3) -> i32 {
    let [a, b, c] = *triangle.corners();
    let turns = [turn(a, b, point), turn(b, c, point), turn(c, a, point)];
    // Around the ray one way, and the point on the other side than the ray's end; a triangle along
    // the ray is met by no moved one.
    let is_met = turns == [turns[0]; 3] && orient3d(a, b, c, point) == turns[0].reverse();
    if is_met { turns[0] as i32 } else { 0 }
}

/// On which side of an edge the moved ray is, seen along x; none where the edge is along the ray.
fn turn(from: Vec3, to: Vec3, point: Vec3) -> Ordering {
    let shadow = |p: Vec3| [p.y, p.z];
    orient2d(shadow(from), shadow(to), shadow(point))
        .then(from.z.cmp(&to.z))
        .then(to.y.cmp(&from.y))
}
