//! What triangle meshes and height fields have in common.

use alloc::vec::Vec;

use super::{Aabb, Triangle};
use crate::math::Vec3;

/// Triangles that share edges and vertices, wherever they are now.
///
/// Vertices, edges and faces are numbered from 0, each kind by itself, and keep their numbers when
/// they move. A face is seen from outside where its corners go around counter-clockwise. What does
/// not exist must not be asked for: a function may panic then.
pub trait Surface {
    /// The smallest box around all faces.
    fn bounds(&self) -> Aabb;

    /// Replaces `faces` with those whose boxes meet this box, touching included, sorted.
    fn faces_near(&self, bounds: &Aabb, faces: &mut Vec<u32>);

    /// The vertices at the corners of a face. O(1).
    fn corners(&self, face: u32) -> [u32; 3];

    /// The edges of a face: from corner 0 to 1, from 1 to 2, from 2 to 0. O(1).
    ///
    /// There is no edge between a corner and itself: where a face names a vertex twice, that side
    /// is given some edge of the surface.
    fn sides(&self, face: u32) -> [u32; 3];

    /// The vertices at both ends of an edge, the lower one first. O(1).
    fn ends(&self, edge: u32) -> [u32; 2];

    /// Where a vertex is, in metres. O(1).
    fn position(&self, vertex: u32) -> Vec3;

    /// The faces at an edge, sorted; at least one.
    fn faces_at_edge(&self, edge: u32) -> impl Iterator<Item = u32>;

    /// The faces at a vertex, sorted.
    fn faces_at_vertex(&self, vertex: u32) -> impl Iterator<Item = u32>;

    /// Whether its faces have no inside: they touch from either side, as cloth does. If not, what
    /// is behind them is inside.
    fn is_two_sided(&self) -> bool;

    /// Whether every edge has two faces that go along it in opposite directions: there is no hole.
    /// O(1). No, unless a surface says so.
    fn is_closed(&self) -> bool {
        false
    }

    /// A face of each of its parts that hang together by vertices. O(1). It is one part, unless a
    /// surface says otherwise.
    fn shells(&self) -> &[u32] {
        &[0]
    }

    /// The triangle of a face. O(1).
    #[inline]
    fn triangle(&self, face: u32) -> Triangle {
        Triangle::between(self.corners(face).map(|vertex| self.position(vertex)))
    }
}

/// A triangle by itself: vertex k is corner k, edge k goes from there to the next one.
impl Surface for Triangle {
    fn bounds(&self) -> Aabb {
        Self::bounds(self)
    }

    fn faces_near(&self, bounds: &Aabb, faces: &mut Vec<u32>) {
        faces.clear();
        faces.extend(Self::bounds(self).overlaps(bounds).then_some(0));
    }

    fn corners(&self, _: u32) -> [u32; 3] {
        [0, 1, 2]
    }

    fn sides(&self, _: u32) -> [u32; 3] {
        [0, 1, 2]
    }

    fn ends(&self, edge: u32) -> [u32; 2] {
        [[0, 1], [1, 2], [0, 2]][edge as usize]
    }

    fn position(&self, vertex: u32) -> Vec3 {
        self.corners()[vertex as usize]
    }

    fn faces_at_edge(&self, _: u32) -> impl Iterator<Item = u32> {
        core::iter::once(0)
    }

    fn faces_at_vertex(&self, _: u32) -> impl Iterator<Item = u32> {
        core::iter::once(0)
    }

    fn is_two_sided(&self) -> bool {
        true
    }
}
