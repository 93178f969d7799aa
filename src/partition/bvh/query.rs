//! What meets what.

use alloc::vec::Vec;
use core::ops::ControlFlow;

use super::build::{LANES, LEVELS_MAX, Link};
use super::cells::Frame;
use super::volume::{Enclose, Volume};
use super::{Bvh, CellBox};
use crate::geometry::{Aabb, overlap_triangle_triangle};
use crate::math::Real;

/// How closely is looked.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Precision {
    /// Faces intersect: their triangles have a point in common, exactly.
    #[default]
    Exact,
    /// The volumes of faces meet, or cannot be told not to: all that intersect, and some more.
    Volumes,
}

/// Two nodes that may meet.
type Open = [u32; 2];

/// No more of them are open at a time: what is taken is replaced by at most 16, each farther down
/// in one tree or in both.
const OPEN_MAX: usize = 15 * 2 * LEVELS_MAX as usize + 1;

impl<V: Volume> Bvh<V> {
    /// The faces that meet, as `[face, face of the other]`, sorted. Touching counts.
    ///
    /// Both are where their vertices are. The order of the trees does not change what is found
    /// exactly. O(k log k) for k nodes and faces that are near one another.
    #[must_use]
    pub fn pairs(&self, other: &Self, precision: Precision) -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        let _: ControlFlow<()> = self.meet(other, precision, |a, b| {
            pairs.push([self.shape.faces[a], other.shape.faces[b]]);
            ControlFlow::Continue(())
        });
        pairs.sort_unstable();
        pairs
    }

    /// Whether any faces meet: whether [`pairs`](Self::pairs) finds one, at a lower cost.
    #[must_use]
    pub fn overlaps(&self, other: &Self, precision: Precision) -> bool {
        self.meet(other, precision, |_, _| ControlFlow::Break(())).is_break()
    }

    /// The faces whose boxes meet this box, sorted. Exact, whatever the volumes; touching counts.
    #[must_use]
    pub fn faces_near(&self, bounds: &Aabb) -> Vec<u32> {
        let cells = self.cells.of_box(bounds);
        let mut faces = Vec::new();
        let mut open = Vec::from([0]);
        while let Some(node) = open.pop() {
            let link = self.shape.links[node];
            for (lane, place) in self.volumes[node].iter().zip(link.below()) {
                if !lane.bounds().overlaps(&cells) {
                    continue;
                }
                if !link.is_leaf {
                    open.push(place);
                } else if self.triangles[place].bounds().overlaps(bounds) {
                    faces.push(self.shape.faces[place]);
                }
            }
        }
        faces.sort_unstable();
        faces
    }

    /// Visits the places of all faces that meet, in no particular order, until told to stop.
    fn meet(
        &self,
        other: &Self,
        precision: Precision,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let visit = |a: usize, b: usize| {
            let meet = precision == Precision::Volumes
                || overlap_triangle_triangle(&self.triangles[a], &other.triangles[b]);
            if meet { visit(a, b) } else { ControlFlow::Continue(()) }
        };
        self.descend_either(other, 0, visit)
    }

    /// Visits the places of all faces whose volumes meet, those of one tree grown by `reach`.
    fn descend_either(
        &self,
        other: &Self,
        reach: i64,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        if self.cells.is_coarser(&other.cells) {
            self.descend(other, reach, visit)
        } else {
            other.descend(self, reach, |b, a| visit(a, b))
        }
    }

    /// Visits the places of all faces whose volumes meet those of a tree with finer cells.
    ///
    /// The larger of two nodes is replaced by its children, or both if they are about as large.
    fn descend(
        &self,
        finer: &Self,
        reach: i64,
        mut visit: impl FnMut(usize, usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let Some(frame) = self.cells.frame(&finer.cells, reach) else {
            return ControlFlow::Continue(());
        };
        let mut open: Vec<Open> = Vec::with_capacity(OPEN_MAX);
        open.push([0, 0]);
        while let Some([a, b]) = open.pop() {
            let (link_a, link_b) = (self.shape.links[a as usize], finer.shape.links[b as usize]);
            let lanes = [&self.volumes[a as usize], &finer.volumes[b as usize]];
            let hits = hits(lanes, &frame) & used(link_a.len, link_b.len);
            let down = steps([link_a, link_b], [frame.shift(), 0]);
            if down == [false, false] {
                for (i, j) in ones(hits) {
                    visit((link_a.first + i) as usize, (link_b.first + j) as usize)?;
                }
                continue;
            }
            open.extend(ones(joined(hits, down)).map(|(i, j)| {
                [
                    if down[0] { link_a.first + i } else { a },
                    if down[1] { link_b.first + j } else { b },
                ]
            }));
            debug_assert!(open.len() <= OPEN_MAX, "a tree is too deep");
        }
        ControlFlow::Continue(())
    }
}

impl Bvh<CellBox> {
    /// Adds the faces whose boxes come as near to one another as `reach` along each axis, as
    /// `[face, face of the other]`, in no particular order; and perhaps some more, by less than a
    /// cell. O(k) for k nodes and faces that are near one another.
    pub(crate) fn near_pairs(&self, other: &Self, reach: Real, pairs: &mut Vec<[u32; 2]>) {
        let _: ControlFlow<()> = self.descend_either(other, reach.raw(), |a, b| {
            pairs.push([self.shape.faces[a], other.shape.faces[b]]);
            ControlFlow::Continue(())
        });
    }
}

/// Which of two nodes are replaced by their children, the larger one or both; neither if both are
/// leaves. Cells are as wide as these powers of two.
#[inline]
pub(super) fn steps([a, b]: [Link; 2], shifts: [u32; 2]) -> [bool; 2] {
    let [size_a, size_b] = [u32::from(a.size) + shifts[0], u32::from(b.size) + shifts[1]];
    let down_a = !a.is_leaf && (b.is_leaf || size_a + 1 >= size_b);
    let down_b = !b.is_leaf && (a.is_leaf || size_b + 1 >= size_a);
    [down_a, down_b]
}

/// Bit `4 i + j` says whether lane i of one node meets lane j of the other, whose cells are finer.
#[inline]
fn hits<V: Volume>([a, b]: [&[V; LANES]; 2], frame: &Frame) -> u32 {
    let mut hits = 0;
    for (j, other) in b.iter().enumerate() {
        let other = other.framed(frame);
        for (i, one) in a.iter().enumerate() {
            hits |= u32::from(one.overlaps(&other)) << (LANES * i + j);
        }
    }
    hits
}

/// The bits of lanes in use.
#[inline]
fn used(len_a: u8, len_b: u8) -> u32 {
    let row = (1 << len_b) - 1;
    (row * 0x1111) & ((1 << (LANES * usize::from(len_a))) - 1)
}

/// The bits as they are, those of all lanes of the other node in its first lane if that node stays
/// whole.
#[inline]
fn joined(hits: u32, down: [bool; 2]) -> u32 {
    match down {
        [true, false] => (hits | hits >> 1 | hits >> 2 | hits >> 3) & 0x1111,
        [false, true] => (hits | hits >> 4 | hits >> 8 | hits >> 12) & 0xF,
        _ => hits,
    }
}

/// The lanes of the bits that are set, in order.
#[inline]
fn ones(mut hits: u32) -> impl Iterator<Item = (u32, u32)> {
    core::iter::from_fn(move || {
        if hits == 0 {
            return None;
        }
        let bit = hits.trailing_zeros();
        hits &= hits - 1;
        Some((bit >> 2, bit & 3))
    })
}
