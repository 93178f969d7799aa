//! Trees around everywhere that faces come by.

use alloc::vec::Vec;
use core::mem;

use super::Bvh;
use super::cell_box::CellBox;
use super::cells::Cells;
use super::refit::RefitError;
use crate::geometry::{Aabb, Triangle};
use crate::math::{Real, Vec3};

/// A tree of boxes over the faces of a mesh in motion: around where each is at the start of a step,
/// where it is in the end, and all between.
#[derive(Clone, Debug)]
pub struct SweptBvh(Bvh<CellBox>);

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
        for (start, end) in tree.volumes.iter_mut().flatten().zip(ends.iter().flatten()) {
            *start = start.union(end);
        }
        Ok(Self(tree))
    }

    /// The faces that may come as near to one another as `reach` along every axis, as
    /// `[face, face of the other]`, sorted: all whose boxes do, and where cells are coarse a few
    /// more. The reach is in metres, 0..=32,768, to which it is cut. O(k log k) for k nodes and
    /// faces.
    #[must_use]
    pub fn pairs(&self, other: &Self, reach: Real) -> Vec<[u32; 2]> {
        let reach = reach.clamp(Real::ZERO, Real::from_int(1 << 15));
        let mut pairs = Vec::new();
        self.0.near_pairs(&other.0, reach, &mut pairs);
        pairs.sort_unstable();
        pairs
    }
}
