//! Which faces are near one another.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::cell_box::CellBox;

/// Children of a node, and faces of a leaf.
pub(super) const LANES: usize = 4;

/// Planes at which a range may be cut, and one more.
const BINS: usize = 1 << BINS_BITS;
const BINS_BITS: u32 = 4;

/// Nodes this far below the root are cut at the median.
const HEURISTIC_LEVELS: u32 = 16;

/// No node is farther below the root.
///
/// A cut at the median leaves `n / 2 + 3` faces or fewer, and a node cuts the larger half again: of
/// `n` faces a child has at most `n / 4 + 5`. From 2^23 faces 12 levels lead to 4.
pub(super) const LEVELS_MAX: u32 = HEURISTIC_LEVELS + 12;

/// A tree without its volumes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Shape {
    /// The nodes, the root first. Children stand behind their node, and next to one another.
    pub(super) links: Vec<Link>,
    /// The faces in the order of the leaves; sorted in each leaf.
    pub(super) faces: Vec<u32>,
}

/// What a node has below it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Link {
    /// The first child, or the place of a leaf's first face.
    pub(super) first: u32,
    /// How many of them there are, 1 to 4.
    pub(super) len: u8,
    pub(super) is_leaf: bool,
    /// The bits of the longest edge of the box around it, in cells.
    pub(super) size: u8,
}

/// A node to be made of a range of faces.
struct Open {
    node: usize,
    range: Range<usize>,
    level: u32,
}

/// What falls between two planes.
#[derive(Clone, Copy, Default)]
struct Bin {
    count: usize,
    bounds: Option<CellBox>,
}

impl Shape {
    /// The shape of the tree over faces with these boxes; see [`Bvh::new`](super::Bvh::new).
    #[expect(clippy::cast_possible_truncation, reason = "no more nodes than faces, at most 2^23")]
    pub(super) fn new(boxes: &[CellBox]) -> Self {
        let mut faces: Vec<u32> = (0..).take(boxes.len()).collect();
        let mut links = vec![Link::default()];
        let mut open = vec![Open { node: 0, range: 0..faces.len(), level: 0 }];
        while let Some(Open { node, range, level }) = open.pop() {
            debug_assert!(level <= LEVELS_MAX, "a tree is too deep");
            if range.len() <= LANES {
                links[node] = Link {
                    first: range.start as u32,
                    len: range.len() as u8,
                    is_leaf: true,
                    size: 0,
                };
                // Whatever order the cuts left: only which faces are here is theirs to decide.
                faces[range].sort_unstable();
                continue;
            }
            let first = links.len();
            let is_deep = level >= HEURISTIC_LEVELS;
            let parts = quarter(boxes, &mut faces, range, is_deep);
            links[node] = Link { first: first as u32, len: parts.len() as u8, ..Link::default() };
            for (child, range) in (first..).zip(parts) {
                links.push(Link::default());
                open.push(Open { node: child, range, level: level + 1 });
            }
        }
        Self { links, faces }
    }
}

impl Link {
    /// The children, or the places of the faces.
    #[inline]
    pub(super) fn below(self) -> Range<usize> {
        let first = self.first as usize;
        first..first + usize::from(self.len)
    }
}

/// Cuts a range in two, then the part with the most faces, until there are four parts or no part
/// has more faces than a leaf. Parts are in order.
fn quarter(
    boxes: &[CellBox],
    faces: &mut [u32],
    range: Range<usize>,
    is_deep: bool,
) -> Vec<Range<usize>> {
    let mut parts = vec![range];
    while parts.len() < LANES {
        // The first of the largest; `max_by_key` gives the last.
        let largest = (0..parts.len()).rev().max_by_key(|&part| parts[part].len()).unwrap_or(0);
        let part = parts[largest].clone();
        if part.len() <= LANES {
            break;
        }
        let middle = part.start + cut(boxes, &mut faces[part.clone()], is_deep);
        parts[largest] = part.start..middle;
        parts.insert(largest + 1, middle..part.end);
    }
    parts
}

/// Puts the faces of the lower part first, and counts them: a multiple of 4, neither 0 nor all.
///
/// Faces are compared by centre, then by number, so that no two are equal and the part is the same
/// whatever the selection does with the order inside.
fn cut(boxes: &[CellBox], faces: &mut [u32], is_deep: bool) -> usize {
    let centre = |face: u32| {
        let (min, max) = (boxes[face as usize].min(), boxes[face as usize].max());
        [0, 1, 2].map(|k| min[k] + max[k]) // twice the centre, below 2^30
    };
    let centres = faces.iter().map(|&face| CellBox::new(centre(face), centre(face)));
    let Some(bounds) = centres.reduce(|a, b| a.union(&b)) else { return 0 };
    let extents = bounds.extents();
    // The first of the longest; `max_by_key` gives the last.
    let axis = (0..3).rev().max_by_key(|&k| extents[k]).unwrap_or(0);
    let count = if is_deep || extents[axis] == 0 {
        faces.len() / 2
    } else {
        let place = |face: u32| i64::from(centre(face)[axis]) - i64::from(bounds.min()[axis]);
        cheapest(boxes, faces, |face| scaled(place(face), extents[axis]))
    };
    let count =
        ((count + LANES / 2) / LANES * LANES).clamp(LANES, (faces.len() - 1) / LANES * LANES);
    faces.select_nth_unstable_by_key(count, |&face| (centre(face)[axis], face));
    count
}

/// The bin of a place along an edge.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 15")]
fn scaled(place: i64, extent: i64) -> usize {
    ((place << BINS_BITS) / (extent + 1)) as usize
}

/// How many faces are below the plane where the sum of area times faces is least, the first one if
/// there are several.
fn cheapest(boxes: &[CellBox], faces: &[u32], bin: impl Fn(u32) -> usize) -> usize {
    let mut bins = [Bin::default(); BINS];
    for &face in faces {
        bins[bin(face)].add(Bin { count: 1, bounds: Some(boxes[face as usize]) });
    }
    let mut above = [0; BINS];
    let mut part = Bin::default();
    for k in (1..BINS).rev() {
        part.add(bins[k]);
        above[k] = part.cost();
    }
    let mut part = Bin::default();
    let mut best = (u128::MAX, 0);
    for k in 1..BINS {
        part.add(bins[k - 1]);
        best = best.min((part.cost() + above[k], part.count));
    }
    best.1
}

impl Bin {
    fn add(&mut self, other: Self) {
        self.count += other.count;
        self.bounds = match (self.bounds, other.bounds) {
            (Some(a), Some(b)) => Some(a.union(&b)),
            (a, b) => a.or(b),
        };
    }

    /// Half the area times the number of faces: at most 3 * 2^56 * 2^23.
    fn cost(&self) -> u128 {
        let Some(bounds) = self.bounds else { return 0 };
        let [x, y, z] = bounds.extents().map(i64::unsigned_abs);
        u128::from(x * y + y * z + z * x) * self.count as u128
    }
}
