//! Trees around faces in motion.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Reverse;
use core::mem;

use super::Bvh;
use super::build::LANES;
use super::cell_box::CellBox;
use super::cells::Cells;
use super::query::steps;
use super::refit::RefitError;
use super::volume::Enclose;
use crate::geometry::sweep::fall;
use crate::geometry::{Aabb, Triangle};
use crate::math::{Real, Unit, Vec3};

/// A tree of boxes over the faces of a mesh in motion: around where each is at the start of a step,
/// and where it is in the end. In between it is in the box as far on its way between the two.
#[derive(Clone, Debug)]
pub struct SweptBvh {
    start: Bvh<CellBox>,
    /// The boxes in the end, in the cells of the tree.
    ends: Vec<[CellBox; LANES]>,
}

/// A box in motion: the lowest corner and the highest, raw, at the start and in the end.
#[derive(Clone, Copy, Debug)]
struct Moving([[[i64; 3]; 2]; 2]);

/// Two nodes, or two faces. The earlier they may meet, the higher; of those that may at once, the
/// last is the highest, so that few are open.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Open {
    first: Reverse<Unit>,
    number: u64,
    /// Nodes, or places of faces.
    pair: [u32; 2],
    is_face: bool,
}

impl SweptBvh {
    /// The tree of a mesh whose vertices move from where they are in another to these positions, in
    /// metres, one for each. O(n).
    ///
    /// # Errors
    /// [`RefitError`] names the first vertex, or else the first face, that is not possible.
    pub fn new(start: &Bvh, end: &[Vec3]) -> Result<Self, RefitError> {
        let mut tree = start.clone();
        tree.place(end)?;
        let corners = start.triangles.iter().chain(&tree.triangles).flat_map(Triangle::corners);
        if let Some(all) = Aabb::around(corners.copied()) {
            tree.cells = Cells::around(&[all.min(), all.max()]);
        }
        tree.refit_volumes();
        let ends = mem::take(&mut tree.volumes);
        tree.triangles.copy_from_slice(&start.triangles);
        tree.refit_volumes();
        Ok(Self { start: tree, ends })
    }

    /// The faces that may be as near to one another as `reach` along every axis, both at one time,
    /// which is no later than `until`, as `[face, face of the other]`, sorted: all whose boxes are,
    /// and where cells are coarse a few more. The reach is in metres, 0..=32,768, to which it is
    /// cut. O(k log k) for k nodes and faces.
    #[must_use]
    pub fn pairs(&self, other: &Self, reach: Real, until: Unit) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        self.visit_pairs(other, reach, until, |pair, _| {
            pairs.push(pair);
            until
        });
        pairs.sort_unstable();
        pairs
    }

    /// Visits these [`pairs`](Self::pairs), each with the time before which its boxes are farther
    /// apart, rounded down, in the order of that. Every visit returns until when pairs are looked
    /// for from now on.
    pub(crate) fn visit_pairs(
        &self,
        other: &Self,
        reach: Real,
        mut until: Unit,
        mut visit: impl FnMut([u32; 2], Unit) -> Unit,
    ) {
        let reach = reach.clamp(Real::ZERO, Real::from_int(1 << 15)).raw();
        let shifts = [self, other].map(|tree| tree.start.cells.shift());
        let mut open = BinaryHeap::new();
        open.push(Open { first: Reverse(Unit::ZERO), number: 0, pair: [0; 2], is_face: false });
        let mut number = 0;
        while let Some(Open { first: Reverse(first), pair: [a, b], is_face, .. }) = open.pop() {
            if first > until {
                break;
            }
            if is_face {
                let face = |tree: &Self, place: u32| tree.start.shape.faces[place as usize];
                until = visit([face(self, a), face(other, b)], first);
                continue;
            }
            let links = [(self, a), (other, b)].map(|(t, node)| t.start.shape.links[node as usize]);
            let mut down = steps(links, shifts);
            let is_face = down == [false; 2];
            if is_face {
                down = [true; 2];
            }
            let below_b: Vec<_> = other.below(b, down[1]).collect();
            for (a, box_a) in self.below(a, down[0]) {
                for &(b, box_b) in &below_b {
                    if let Some(first) = box_a.meets(&box_b, reach).filter(|&time| time <= until) {
                        number += 1;
                        open.push(Open { first: Reverse(first), number, pair: [a, b], is_face });
                    }
                }
            }
        }
    }

    /// What is below a node, or else the node, with its box.
    fn below(&self, node: u32, is_down: bool) -> impl Iterator<Item = (u32, Moving)> {
        let link = self.start.shape.links[node as usize];
        let lanes = [&self.start.volumes, &self.ends].map(|volumes| volumes[node as usize]);
        let moving = move |boxes: [CellBox; 2]| {
            Moving(boxes.map(|bounds| self.start.cells.corners(&bounds)))
        };
        let len = if is_down { link.len } else { 1 };
        (0..u32::from(len)).map(move |lane| {
            if is_down {
                (link.first + lane, moving(lanes.map(|lanes| lanes[lane as usize])))
            } else {
                // Unused lanes repeat the first.
                (node, moving(lanes.map(|lanes| CellBox::around(&lanes))))
            }
        })
    }
}

impl Moving {
    /// Before when two boxes are farther apart than `reach` along an axis, rounded down; `None` if
    /// they always are along one or another.
    #[inline]
    fn meets(&self, other: &Self, reach: i64) -> Option<Unit> {
        let mut meet = Unit::ZERO;
        let mut part = Unit::ONE;
        for (Self([start, end]), Self([other_start, other_end])) in [(self, other), (other, self)] {
            for k in 0..3 {
                // Less than a cell of 2^34 beyond 2^61 and a reach of 2^39.
                let start = start[0][k] - other_start[1][k] - reach;
                let end = end[0][k] - other_end[1][k] - reach;
                if start > 0 {
                    meet = meet.max(fall(start, end)?);
                } else if end > 0 {
                    // Backwards in time; rounded up.
                    let back = fall(end, start).unwrap_or(Unit::ZERO);
                    part = part.min(Unit::from_raw(Unit::ONE.raw() - back.raw()));
                }
            }
        }
        (meet <= part).then_some(meet)
    }
}
