//! What a node is enclosed in.

use core::fmt::Debug;

use super::cell_box::CellBox;
use super::cells::Frame;
use crate::math::root::isqrt;

/// The volumes that a [`Bvh`](super::Bvh) can be made of: [`CellBox`],
/// [`CellSphere`](super::CellSphere) and [`CellCylinder`](super::CellCylinder).
pub trait Volume: Enclose {}

impl<V: Enclose> Volume for V {}

/// What a volume must be able to do. All are in cells; a point is the cell that it is in.
pub trait Enclose: Copy + Eq + Debug {
    /// A volume around boxes, at least one and at most four: the cells of a face's corners, or the
    /// smallest boxes around the children of a node. Not around their volumes: then those of nodes
    /// would grow with every level.
    fn around(parts: &[CellBox]) -> Self;

    /// Whether all of a cell lies in it. Exact; surfaces count.
    fn contains(&self, cell: &CellBox) -> bool;

    /// A box around it.
    fn bounds(&self) -> CellBox;

    /// A volume around it in the cells of another tree.
    fn framed(&self, frame: &Frame) -> Self;

    /// Whether they meet, touching included. True whenever they do; spheres and cylinders may be
    /// taken to meet when they nearly do.
    fn overlaps(&self, other: &Self) -> bool;
}

/// The square root, rounded up.
#[allow(clippy::cast_possible_wrap, reason = "at most 2^32")]
pub(super) fn root_up(square: u64) -> i64 {
    let root = isqrt(square);
    (root + u64::from(root * root < square)) as i64
}
