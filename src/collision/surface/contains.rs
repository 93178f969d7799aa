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
    /// and all queries take it for hollow.
    ///
    /// By the parity of the crossings of that ray, moved by something that is infinitely little
    /// along y, and infinitely less along z: so it never meets an edge or a vertex.
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        is_within(self, point)
    }
}

/// Whether a point is inside a closed surface or on any, see [`MeshShape::contains`].
pub(super) fn is_within<S: Surface>(surface: &S, point: Vec3) -> bool {
    let bounds = surface.bounds();
    if !bounds.overlaps(&Aabb::of_point(point)) {
        return false;
    }
    let mut faces = Vec::new();
    let end = Vec3::new(bounds.max().x, point.y, point.z);
    surface.faces_near(&Aabb::new(point, end), &mut faces);
    let here = Triangle::between([point; 3]);
    let mut is_inside = false;
    for face in faces {
        let triangle = surface.triangle(face);
        if overlap_triangle_triangle(&triangle, &here) {
            return true;
        }
        is_inside ^= is_crossed(&triangle, point);
    }
    is_inside
}

/// Whether the moved ray from a point that is not on a triangle goes through it.
fn is_crossed(triangle: &Triangle, point: Vec3) -> bool {
    let [a, b, c] = *triangle.corners();
    let turns = [turn(a, b, point), turn(b, c, point), turn(c, a, point)];
    // Around the ray one way, and the point on the other side than the ray's end; a triangle along
    // the ray is met by no moved one.
    turns == [turns[0]; 3] && orient3d(a, b, c, point) == turns[0].reverse()
}

/// On which side of an edge the moved ray is, seen along x; none where the edge is along the ray.
fn turn(from: Vec3, to: Vec3, point: Vec3) -> Ordering {
    let shadow = |p: Vec3| [p.y, p.z];
    orient2d(shadow(from), shadow(to), shadow(point))
        .then(from.z.cmp(&to.z))
        .then(to.y.cmp(&from.y))
}
