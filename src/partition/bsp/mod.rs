//! Space divided by planes.

mod build;
mod plane;

use alloc::vec::Vec;
use core::ops::Range;

use super::roster::Roster;
use super::{Object, Pair, Partition, PartitionError};
use crate::geometry::{Aabb, TriangleMesh};

use build::{Node, Piece, build};
use plane::{Plane, Side, Span};

/// Binary space partition with planes (3) or with lines on the ground (2).
///
/// A plane has things behind it, before it, and across it: an object is kept where the first plane
/// cuts or touches it, or in the part of space that it has to itself. Two objects that touch are
/// therefore never kept in different branches. The planes are those of the faces of a mesh
/// ([`walls`](Self::walls)): made for rooms, whose walls keep apart what is in them, while what
/// stands in a door is compared with both sides. Without walls they are taken from the objects,
/// anew when more changed than there were.
///
/// After a change [`pairs`](Partition::pairs) takes O(n log n), and O(1) for each object in the
/// same branch as another one. A [`query`](Partition::query) takes O(log n) for each part of space
/// that it touches.
#[derive(Clone, Debug)]
pub struct Bsp<const D: usize> {
    roster: Roster,
    /// Which axes are divided: 0 is x.
    axes: [u8; D],
    nodes: Vec<Node<D>>,
    /// Whether the planes are those of walls.
    is_walled: bool,
    /// Changes until planes are taken from the objects again: as many as there were objects.
    patience: u32,
    /// Sorted by node. Some may be stale.
    entries: Vec<Entry>,
    pairs: Vec<Pair>,
}

/// An object in a part of space.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Entry {
    node: u32,
    id: u32,
}

impl Bsp<2> {
    /// Without objects, divides the ground: x and z.
    #[must_use]
    pub fn new() -> Self {
        Self::along([0, 2])
    }

    /// Without objects, divides these two axes; 0 is x, and what is not an axis is z.
    #[must_use]
    pub fn along(axes: [u8; 2]) -> Self {
        Self::divide(axes.map(|axis| axis.min(2)))
    }
}

impl Bsp<3> {
    /// Without objects.
    #[must_use]
    pub fn new() -> Self {
        Self::divide([0, 1, 2])
    }
}

impl Default for Bsp<2> {
    fn default() -> Self {
        Self::new()
    }
}

impl Default for Bsp<3> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const D: usize> Bsp<D> {
    fn divide(axes: [u8; D]) -> Self {
        Self {
            roster: Roster::default(),
            axes,
            nodes: build(&[]),
            is_walled: false,
            patience: 0,
            entries: Vec::new(),
            pairs: Vec::new(),
        }
    }

    /// Divides space by the faces of a mesh, extended along the axes that are not divided. Faces
    /// that are degenerate, or lie across those axes, do not count.
    #[must_use]
    pub fn walls(mut self, mesh: &TriangleMesh) -> Self {
        let axes = self.axes.map(usize::from);
        let piece = |triangle| {
            let plane = Plane::of(&triangle, axes)?;
            Some(Piece { span: self.span(&triangle.bounds()), plane })
        };
        let pieces: Vec<_> = mesh.triangles().filter_map(piece).collect();
        self.nodes = build(&pieces);
        self.is_walled = true;
        self.entries.clear();
        self.roster.mark_all();
        self
    }

    /// A box along the axes that are divided.
    fn span(&self, bounds: &Aabb) -> Span<D> {
        let corners = [bounds.min().raw(), bounds.max().raw()];
        corners.map(|corner| self.axes.map(|axis| corner[usize::from(axis)]))
    }

    /// Takes planes from the objects, each just beyond one of its faces.
    fn rebuild(&mut self) {
        let piece = |(at, id): (u32, u32)| {
            let span = self.span(self.roster.bounds(id));
            // Mixed: only some pieces are tried, and of axes in turn these could have one only.
            let axis = (at.wrapping_mul(0x9E37_79B9) >> 16) as usize % D;
            Piece { span, plane: Plane::across(axis, span[1][axis] + 1) }
        };
        self.nodes = build(&(0..).zip(self.roster.ids()).map(piece).collect::<Vec<_>>());
        self.patience = self.roster.len();
        self.entries.clear();
    }

    /// The part of space that an object is kept in.
    fn node_of(&self, id: u32) -> u32 {
        let span = self.span(self.roster.bounds(id));
        let mut index = 0;
        while let Some(plane) = &self.nodes[index as usize].plane {
            index = match plane.side(&span) {
                Side::Behind => index + 1,
                Side::Front => self.nodes[index as usize].front,
                Side::Across => break,
            };
        }
        index
    }

    /// Files the objects that changed, or all of them among new planes.
    fn settle(&mut self) {
        // No more ids than 2^20.
        let changed = u32::try_from(self.roster.stale().len()).unwrap_or(u32::MAX);
        let patience = self.patience.checked_sub(changed);
        self.patience = patience.unwrap_or(0);
        if !self.is_walled && patience.is_none() {
            self.rebuild();
            let all = self.roster.ids().map(|id| Entry { node: self.node_of(id), id });
            self.entries = all.collect();
        } else {
            let roster = &self.roster;
            self.entries.retain(|entry| !roster.is_stale(entry.id));
            let changed = self.roster.stale().iter().filter(|&&id| self.roster.contains(id));
            let changed = changed.map(|&id| Entry { node: self.node_of(id), id });
            let changed: Vec<_> = changed.collect();
            self.entries.extend(changed);
        }
        self.entries.sort_unstable();
        self.roster.settle();
    }

    /// The entries of this node and of those before `end`.
    fn range(&self, nodes: Range<u32>) -> Range<usize> {
        let position = |node: u32| self.entries.partition_point(|entry| entry.node < node);
        position(nodes.start)..position(nodes.end)
    }
}

impl<const D: usize> Partition for Bsp<D> {
    fn insert(&mut self, id: u32, object: Object) -> Result<(), PartitionError> {
        self.roster.insert(id, object)
    }

    fn update(&mut self, id: u32, object: Object) -> Result<(), PartitionError> {
        self.roster.update(id, object)?;
        self.roster.mark(id);
        Ok(())
    }

    fn remove(&mut self, id: u32) -> Result<(), PartitionError> {
        self.roster.remove(id)
    }

    fn object(&self, id: u32) -> Option<Object> {
        self.roster.object(id)
    }

    fn len(&self) -> u32 {
        self.roster.len()
    }

    fn pairs(&mut self) -> &[Pair] {
        if self.roster.stale().is_empty() {
            return &self.pairs;
        }
        self.settle();
        let mut pairs = core::mem::take(&mut self.pairs);
        pairs.clear();
        for (at, a) in self.entries.iter().enumerate() {
            let end = self.range(a.node..self.nodes[a.node as usize].end).end;
            for b in &self.entries[at + 1..end] {
                let pair = [a.id.min(b.id), a.id.max(b.id)];
                if self.roster.touch(pair) {
                    pairs.push(pair);
                }
            }
        }
        pairs.sort_unstable();
        self.pairs = pairs;
        &self.pairs
    }

    fn query(&self, region: &Aabb, ids: &mut Vec<u32>) {
        ids.clear();
        let span = self.span(region);
        let mut stack = Vec::from([0]);
        while let Some(index) = stack.pop() {
            let own = self.entries[self.range(index..index + 1)].iter().map(|entry| entry.id);
            let settled = own.filter(|&id| !self.roster.is_stale(id));
            ids.extend(settled.filter(|&id| self.roster.bounds(id).overlaps(region)));
            let Node { plane: Some(plane), front, .. } = &self.nodes[index as usize] else {
                continue;
            };
            let side = plane.side(&span);
            if side != Side::Front {
                stack.push(index + 1);
            }
            if side != Side::Behind {
                stack.push(*front);
            }
        }
        self.roster.complete(region, ids);
    }

    fn validate(&self) -> Result<(), &'static str> {
        self.roster.validate()?;
        let last = self.nodes.len();
        for (index, node) in self.nodes.iter().enumerate() {
            let end = node.end as usize;
            let front = node.front as usize;
            let behind = index + 1;
            let sound = match node.plane {
                None => end == behind,
                Some(_) => {
                    behind < front
                        && front < end
                        && end <= last
                        && self.nodes[behind].end as usize == front
                        && self.nodes[front].end as usize == end
                }
            };
            if !sound {
                return Err("bsp: parts that do not lie within one another");
            }
        }
        if !self.entries.is_sorted() {
            return Err("bsp: entries out of order");
        }
        let settled = |id: &u32| !self.roster.is_stale(*id);
        let kept = self.entries.iter().filter(|entry| settled(&entry.id));
        if !kept.clone().all(|entry| entry.node == self.node_of(entry.id)) {
            return Err("bsp: an object in another part of space");
        }
        let mut ids: Vec<_> = kept.map(|entry| entry.id).collect();
        ids.sort_unstable();
        if ids.into_iter().eq(self.roster.ids().filter(settled)) {
            Ok(())
        } else {
            Err("bsp: an object that is not kept once")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    /// How many of 96 cubes in a row along an axis are in one part, if so many came first.
    fn most_in_a_part(axis: usize, first: u32) -> usize {
        let mut bsp = Bsp::<3>::new();
        for id in 0..96 {
            let mut corner = [0; 3];
            corner[axis] = i64::from(id) * 2;
            let end = corner.map(|c| c + 1);
            let bounds = Aabb::new(Vec3::from_raw(corner), Vec3::from_raw(end));
            bsp.insert(id, bounds.into()).expect("inserted");
            if id + 1 == first {
                bsp.pairs();
            }
        }
        assert!(bsp.pairs().is_empty());
        let inside = |node| bsp.entries.iter().filter(|entry| entry.node == node).count();
        bsp.entries.iter().map(|entry| inside(entry.node)).max().unwrap_or(0)
    }

    /// Objects that are told once and then rest have planes between them.
    #[test]
    fn the_first_objects_bring_planes() {
        for first in [0, 1, 40] {
            let most = most_in_a_part(0, first);
            assert!(most < 24, "{most} in one part, {first} first");
        }
    }

    /// Along whichever axis they stand.
    #[test]
    fn all_axes_are_divided() {
        let most = [0, 1, 2].map(|axis| most_in_a_part(axis, 0));
        assert!(most.into_iter().all(|most| most < 24), "{most:?}");
    }
}
