//! Two triangles in motion.

use super::{Impact, Motion, Sweep, back_off};
use crate::geometry::{Triangle, overlap_triangle_triangle};
use crate::math::Unit;

impl Sweep {
    /// When two triangles touch; `None` proves that they do not. Exact, O(`work_max`).
    ///
    /// They touch at once where they meet already; otherwise first where a corner of one meets the
    /// other, or an edge an edge. Weights are those of the pair that touches first.
    #[must_use]
    pub fn triangle_triangle(&self, a: Motion<Triangle>, b: Motion<Triangle>) -> Option<Impact> {
        if overlap_triangle_triangle(&a.start, &b.start) {
            return Some(Impact::AT_ONCE);
        }
        let (a, b) = (a.corners(), b.corners());
        let mut first: Option<Impact> = None;
        let until = |first: &Option<Impact>| first.map_or(Unit::ONE, |impact| impact.time);
        let mut keep = |find: &dyn Fn(Unit) -> Option<Impact>| {
            // Of those of one time the first stays.
            let earlier = find(until(&first))
                .filter(|impact| first.is_none_or(|first| impact.time < first.time));
            first = earlier.or(first);
        };
        for corner in a {
            keep(&|until| self.vertex_face_until(until, corner, b));
        }
        for corner in b {
            keep(&|until| self.vertex_face_until(until, corner, a));
        }
        for edge_a in edges(a) {
            for edge_b in edges(b) {
                keep(&|until| self.edge_edge_until(until, edge_a, edge_b));
            }
        }
        first
    }

    /// Until when both triangles can move such that, with corners rounded as
    /// [`Motion::at`] does, they do not meet: 1 if they never touch, otherwise strictly before they
    /// do, or 0. O(`work_max`).
    ///
    /// With a gap of 2 raw units or more, which no rounding bridges, they never trade sides either.
    #[must_use]
    pub fn advance_triangle_triangle(&self, a: Motion<Triangle>, b: Motion<Triangle>) -> Unit {
        let Some(impact) = self.triangle_triangle(a, b) else { return Unit::ONE };
        back_off(impact.time, |time| !overlap_triangle_triangle(&a.at(time), &b.at(time)))
    }
}

/// The edges between corners.
fn edges<T: Copy>([a, b, c]: [T; 3]) -> [[T; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
