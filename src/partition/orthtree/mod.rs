//! Quadtrees and octrees.

mod cell;

use alloc::vec::Vec;
use core::ops::Range;

use super::roster::Roster;
use super::{Object, Pair, Partition, PartitionError};
use crate::geometry::Aabb;

use cell::{Cell, WORLD};

/// Cells that halve along `D` axes: a quadtree (2) or an octree (3).
///
/// An object is filed by its centre: in the smallest cell that holds the centre and has an edge of
/// at least the object's *size*, twice the way from the centre to the farthest face of its box. It
/// may stick out of the cell, by no more than half an edge. Cells are not divided below a level,
/// nor when fewer than a number of objects are inside.
///
/// There are no nodes, only a list of objects in order of the keys of their cells. A cell is
/// compared with itself, with all smaller cells inside it and inside its neighbours, and with
/// those neighbours of its own size that come after it. The classic rule takes the smaller cells
/// of the latter only, and misses pairs: of two neighbours of different size only the larger one
/// looks at the other.
///
/// After a change [`pairs`](Partition::pairs) takes O(n log n), and O(1) for each object in the
/// cells that are compared. A [`query`](Partition::query) takes O(log n) for each cell that it
/// touches.
#[derive(Clone, Debug)]
pub struct Orthtree<const D: usize> {
    roster: Roster,
    /// Which axes are divided: 0 is x.
    axes: [u8; D],
    depth: u32,
    objects_min: u32,
    /// Sorted by cell. Some may be stale.
    entries: Vec<Entry<D>>,
    pairs: Vec<Pair>,
}

/// An object in its cell.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Entry<const D: usize> {
    cell: Cell<D>,
    id: u32,
}

impl Orthtree<2> {
    /// Without objects, divides the ground: x and z.
    #[must_use]
    pub fn new() -> Self {
        Self::along([0, 2])
    }

    /// Without objects, divides these two axes, whichever is named first; 0 is x, and what is not
    /// an axis is z.
    #[must_use]
    pub fn along(axes: [u8; 2]) -> Self {
        Self::divide(axes.map(|axis| axis.min(2)))
    }
}

impl Orthtree<3> {
    /// Without objects.
    #[must_use]
    pub fn new() -> Self {
        Self::divide([0, 1, 2])
    }
}

impl Default for Orthtree<2> {
    fn default() -> Self {
        Self::new()
    }
}

impl Default for Orthtree<3> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const D: usize> Orthtree<D> {
    /// The deepest level that cells can have, and have unless told otherwise: 60 with 2 axes, 40
    /// with 3, where cells are 12.5 cm wide. Level 0 is the world.
    pub const DEPTH_MAX: u32 = Cell::<D>::DEPTH;

    fn divide(axes: [u8; D]) -> Self {
        Self {
            roster: Roster::default(),
            axes,
            depth: Self::DEPTH_MAX,
            objects_min: 4,
            entries: Vec::new(),
            pairs: Vec::new(),
        }
    }

    /// No cells below this level; at most [`DEPTH_MAX`](Self::DEPTH_MAX).
    #[must_use]
    pub fn depth(mut self, depth: u32) -> Self {
        self.depth = depth.min(Self::DEPTH_MAX);
        self.roster.mark_all();
        self
    }

    /// Cells with fewer objects are not divided; 4 unless told otherwise.
    #[must_use]
    pub fn objects_min(mut self, objects: u32) -> Self {
        self.objects_min = objects;
        self.roster.mark_all();
        self
    }

    /// The smallest cell that an object can be filed in.
    fn cell_of(&self, id: u32) -> Cell<D> {
        let bounds = self.roster.bounds(id);
        let [low, high] = [bounds.min().raw(), bounds.max().raw()];
        let centre = self.roster.centre(id).raw();
        let axes = self.axes.map(usize::from);
        let reach = |axis: usize| (high[axis] - centre[axis]).max(centre[axis] - low[axis]);
        let size = 2 * axes.map(reach).into_iter().max().unwrap_or(0).unsigned_abs(); // <= 2^62
        // Edges are powers of two; this one is at least the size.
        let edge = size.checked_next_power_of_two().map_or(u64::BITS, u64::trailing_zeros);
        let level = WORLD.saturating_sub(edge).min(self.depth);
        Cell::around(axes.map(|axis| centre[axis]), level)
    }

    /// Files every object anew.
    fn settle(&mut self) {
        if self.roster.stale().is_empty() {
            return;
        }
        let mut entries = core::mem::take(&mut self.entries);
        entries.clear();
        entries.extend(self.roster.ids().map(|id| Entry { cell: self.cell_of(id), id }));
        entries.sort_unstable();
        gather(Cell::ROOT, &mut entries, self.objects_min as usize);
        self.entries = entries;
        self.roster.settle();
    }

    /// Index of the first entry whose cell does not come before this one.
    fn position(&self, cell: Cell<D>) -> usize {
        self.entries.partition_point(|entry| entry.cell < cell)
    }

    /// Appends the pairs of objects of which one is in this cell, whose entries are from `start` to
    /// `behind`, and the other one is there too, further down, or in a neighbour.
    fn meet(&self, start: usize, behind: usize, pairs: &mut Vec<Pair>) {
        let cell = self.entries[start].cell;
        let end = self.position(cell.end());
        for own in start..behind {
            self.compare(own..own + 1, own + 1..end, pairs);
        }
        for (offset, is_positive) in offsets::<D>() {
            let Some(neighbour) = cell.neighbour(offset) else { continue };
            let [first, end] = [neighbour, neighbour.end()].map(|cell| self.position(cell));
            let equal = |entry: &Entry<D>| entry.cell == neighbour;
            let below = first + self.entries[first..end].partition_point(equal);
            // Cells of one size look at each other once; smaller ones never look up.
            let below = if cfg!(planted) { end } else { below };
            let from = if is_positive { first } else { below };
            self.compare(start..behind, from..end, pairs);
        }
    }

    /// Appends the pairs that touch, of one object from each list.
    fn compare(&self, some: Range<usize>, others: Range<usize>, pairs: &mut Vec<Pair>) {
        for a in &self.entries[some] {
            for b in &self.entries[others.clone()] {
                let pair = [a.id.min(b.id), a.id.max(b.id)];
                if self.roster.touch(pair) {
                    pairs.push(pair);
                }
            }
        }
    }

    /// Tells of all entries in a cell, or below, that may touch the region.
    fn visit(
        &self,
        cell: Cell<D>,
        entries: &[Entry<D>],
        region: &Aabb,
        found: &mut impl FnMut(u32),
    ) {
        let (corner, edge) = cell.extent();
        let [low, high] = [region.min().raw(), region.max().raw()];
        // What is filed here sticks out by half an edge at most: all but the root's.
        let is_near = |(k, axis): (usize, usize)| {
            corner[k] - edge / 2 <= high[axis] && low[axis] <= corner[k] + edge + edge / 2
        };
        if cell != Cell::ROOT && !self.axes.map(usize::from).into_iter().enumerate().all(is_near) {
            return;
        }
        let own = entries.partition_point(|entry| entry.cell <= cell);
        entries[..own].iter().for_each(|entry| found(entry.id));
        let mut below = &entries[own..];
        while let Some((child, count)) = first_child(cell, below) {
            self.visit(child, &below[..count], region, found);
            below = &below[count..];
        }
    }
}

/// Of entries below a cell: the child that the first one is in, and how many are in it.
fn first_child<const D: usize>(cell: Cell<D>, below: &[Entry<D>]) -> Option<(Cell<D>, usize)> {
    let child = below.first()?.cell.ancestor(cell.level() + 1);
    Some((child, below.partition_point(|entry| entry.cell < child.end())))
}

/// Brings entries in a cell and below together in it if they are fewer than `least`; otherwise does
/// so for each of its children. Keeps them sorted by cell.
fn gather<const D: usize>(cell: Cell<D>, entries: &mut [Entry<D>], least: usize) {
    if entries.len() < least {
        for entry in entries {
            entry.cell = cell;
        }
        return;
    }
    let own = entries.partition_point(|entry| entry.cell <= cell);
    let mut below = &mut entries[own..];
    while let Some((child, count)) = first_child(cell, below) {
        let (inside, behind) = below.split_at_mut(count);
        gather(child, inside, least);
        below = behind;
    }
}

/// The ways to all neighbours of a cell, and whether each is lexicographically positive.
fn offsets<const D: usize>() -> impl Iterator<Item = ([i32; D], bool)> {
    // Counts in base 3; the first axis counts most, and in the middle no axis differs.
    let all = 3i32.pow(if D == 2 { 2 } else { 3 });
    (0..all).filter(move |&code| code != all / 2).map(move |code| {
        let mut rest = code;
        let mut offset = [0; D];
        for way in offset.iter_mut().rev() {
            *way = rest % 3 - 1;
            rest /= 3;
        }
        (offset, code > all / 2)
    })
}

impl<const D: usize> Partition for Orthtree<D> {
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
        let mut start = 0;
        while let Some(first) = self.entries.get(start) {
            let run = self.entries[start..].partition_point(|entry| entry.cell == first.cell);
            self.meet(start, start + run, &mut pairs);
            start += run;
        }
        pairs.sort_unstable();
        self.pairs = pairs;
        &self.pairs
    }

    fn query(&self, region: &Aabb, ids: &mut Vec<u32>) {
        ids.clear();
        self.visit(Cell::ROOT, &self.entries, region, &mut |id| {
            if !self.roster.is_stale(id) && self.roster.bounds(id).overlaps(region) {
                ids.push(id);
            }
        });
        self.roster.complete(region, ids);
    }

    fn validate(&self) -> Result<(), &'static str> {
        self.roster.validate()?;
        if !self.entries.is_sorted_by_key(|entry| entry.cell) {
            return Err("orthtree: entries out of order");
        }
        let settled = |id: &u32| !self.roster.is_stale(*id);
        let mut filed: Vec<_> = self.entries.iter().map(|entry| entry.id).filter(settled).collect();
        filed.sort_unstable();
        if !filed.into_iter().eq(self.roster.ids().filter(settled)) {
            return Err("orthtree: an object that is not filed once");
        }
        let fits = |entry: &Entry<D>| {
            let cell = self.cell_of(entry.id);
            entry.cell.level() <= cell.level() && cell.ancestor(entry.cell.level()) == entry.cell
        };
        let entries = self.entries.iter();
        if !entries.filter(|entry| settled(&entry.id)).all(fits) {
            return Err("orthtree: a cell that is too small or elsewhere");
        }
        Ok(())
    }
}
