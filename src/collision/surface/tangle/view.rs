//! Surfaces seen from behind, or a little beside where they are.

use alloc::vec::Vec;

use crate::geometry::{Aabb, Surface};
use crate::math::Vec3;

/// A surface, or the same one with its inside out: what has no inside may have it on either side.
#[derive(Debug)]
pub(super) struct View<'a, S> {
    pub(super) surface: &'a S,
    pub(super) is_turned: bool,
    /// What is added to its places.
    pub(super) shift: Vec3,
}

impl<S> Clone for View<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for View<'_, S> {}

impl<'a, S> View<'a, S> {
    /// As it is.
    pub(super) const fn new(surface: &'a S) -> Self {
        Self { surface, is_turned: false, shift: Vec3::ZERO }
    }
}

impl<S: Surface> Surface for View<'_, S> {
    fn bounds(&self) -> Aabb {
        moved(&self.surface.bounds(), self.shift)
    }

    fn faces_near(&self, bounds: &Aabb, faces: &mut Vec<u32>) {
        self.surface.faces_near(&moved(bounds, -self.shift), faces);
    }

    #[inline]
    fn corners(&self, face: u32) -> [u32; 3] {
        let [a, b, c] = self.surface.corners(face);
        if self.is_turned { [a, c, b] } else { [a, b, c] }
    }

    #[inline]
    fn sides(&self, face: u32) -> [u32; 3] {
        let [a, b, c] = self.surface.sides(face);
        if self.is_turned { [c, b, a] } else { [a, b, c] }
    }

    #[inline]
    fn ends(&self, edge: u32) -> [u32; 2] {
        self.surface.ends(edge)
    }

    #[inline]
    fn position(&self, vertex: u32) -> Vec3 {
        self.surface.position(vertex) + self.shift
    }

    #[inline]
    fn faces_at_edge(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.surface.faces_at_edge(edge)
    }

    #[inline]
    fn faces_at_vertex(&self, vertex: u32) -> impl Iterator<Item = u32> {
        self.surface.faces_at_vertex(vertex)
    }

    fn is_two_sided(&self) -> bool {
        self.surface.is_two_sided()
    }

    fn is_closed(&self) -> bool {
        self.surface.is_closed()
    }

    fn shells(&self) -> &[u32] {
        self.surface.shells()
    }
}

fn moved(bounds: &Aabb, way: Vec3) -> Aabb {
    Aabb::new(bounds.min() + way, bounds.max() + way)
}
