//! How far two surfaces are from one another.
//!
//! The distance from one face is a convex function: on a convex piece of a plane it is greatest at
//! a corner. So whatever face one chooses, the distances of the corners from it bound how far any
//! point of the piece is from the surface. Pieces of which that says too little are cut, the least
//! certain one first, until the bound is near enough to the greatest distance that was met at a
//! corner (Tang, Lee and Kim, *Interactive Hausdorff Distance Computation for General Polygonal
//! Models*, 2009).

mod piece;

use alloc::collections::BinaryHeap;
use alloc::vec;
use alloc::vec::Vec;

use self::piece::{Corner, Piece};
use super::Bvh;
use super::nearest::Nearest;
use super::volume::Volume;
use crate::geometry::Aabb;
use crate::math::{Real, Vec3};

/// How far a surface and what stands in for it are from one another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Deviation {
    /// What of the original is farthest from the proxy.
    pub of_original: Farthest,
    /// What of the proxy is farthest from the original.
    pub of_proxy: Farthest,
}

/// The point of a surface that is farthest from another surface, as far as it is known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Farthest {
    /// A point that is that far away. It is a vertex, or lies on the surface that it belongs to but
    /// for rounding: by less than a raw unit for each of the cuts, one in another, that have led to
    /// it, some dozens at most.
    pub point: Vec3,
    /// Its distance, rounded down, metres, less what it may be off its surface: the greatest
    /// distance is not less.
    pub at_least: Real,
    /// No point of the surface is farther away, metres.
    pub at_most: Real,
}

/// After so many cuts the bounds are what they are.
const CUTS_MAX: u32 = 1 << 17;

impl Deviation {
    /// The greatest distance of a point of either surface from the other one, metres.
    #[must_use]
    pub fn at_most(&self) -> Real {
        self.of_original.at_most.max(self.of_proxy.at_most)
    }
}

impl<V: Volume> Bvh<V> {
    /// How far this mesh and one that stands in for it are from one another, both where their
    /// vertices are: see [`farthest_from`](Self::farthest_from).
    #[must_use]
    pub fn deviation(&self, proxy: &Self) -> Deviation {
        let (of_original, of_proxy) = (self.farthest_from(proxy), proxy.farthest_from(self));
        Deviation { of_original, of_proxy }
    }

    /// What of this mesh is farthest from another: the directed Hausdorff distance.
    ///
    /// `at_most` is no more than 1/256 above `at_least`, or than 4 micrometres or the 2^-20th part
    /// of how wide both are together, unless 2^17 cuts do not suffice: they may not where a plane
    /// is compared with very many small faces. It is true in any case. O(n log n) for n faces of
    /// both, and a second at most for cuts.
    #[must_use]
    pub fn farthest_from(&self, other: &Self) -> Farthest {
        let mut search = Search::new(self, other);
        let corners = search.corners();
        for names in self.mesh.faces() {
            let corners = names.iter().filter_map(|&vertex| corners[vertex as usize]);
            search.open(Piece::new(corners.collect()));
        }
        search.run()
    }
}

/// What is known of the greatest distance.
struct Search<'a, V: Volume> {
    from: &'a Bvh<V>,
    to: &'a Bvh<V>,
    point: Vec3,
    /// The greatest distance that was met.
    at_least: u64,
    /// That of pieces which have been looked at closely enough.
    at_most: u64,
    /// Bounds may be so far apart whatever the distance is.
    tolerance: u64,
    pieces: BinaryHeap<Piece>,
}

impl<'a, V: Volume> Search<'a, V> {
    fn new(from: &'a Bvh<V>, to: &'a Bvh<V>) -> Self {
        let corners = [from, to].into_iter().flat_map(|tree| &tree.triangles);
        let bounds = Aabb::around(corners.flat_map(|triangle| *triangle.corners()));
        let span = bounds.map_or(0, |bounds| bounds.span());
        Self {
            from,
            to,
            point: from.triangles[0].corners()[0],
            at_least: 0,
            at_most: 0,
            tolerance: (span >> 20).max(64),
            pieces: BinaryHeap::new(),
        }
    }

    /// Every vertex with its distance; none for those of no face.
    fn corners(&mut self) -> Vec<Option<Corner>> {
        let from = self.from;
        let mut corners = vec![None; from.mesh.vertices().len()];
        let mut last = 0;
        for (place, triangle) in from.triangles.iter().enumerate() {
            let names = from.mesh.faces()[from.shape.faces[place] as usize];
            for (vertex, &position) in names.into_iter().zip(triangle.corners()) {
                if corners[vertex as usize].is_none() {
                    // Neighbours are near the same faces.
                    let corner = self.corner(position, 0, &[last]);
                    last = corner.place;
                    corners[vertex as usize] = Some(corner);
                }
            }
        }
        corners
    }

    /// A point with its distance; some of the faces, of which there is one, are near it.
    fn corner(&mut self, position: Vec3, roundings: u64, near: &[u32]) -> Corner {
        let found = near.iter().map(|&place| self.to.nearest_on(place, position));
        let first = found.min_by_key(|found: &Nearest| found.distance_sq);
        let nearest = match first {
            Some(first) => self.to.nearest_or(first, position),
            None => self.to.nearest(position),
        };
        let corner = Corner::new(position, &nearest, roundings);
        if corner.at_least > self.at_least {
            (self.at_least, self.point) = (corner.at_least, position);
        }
        corner
    }

    /// What is not farther away need not be known.
    fn limit(&self) -> u64 {
        self.at_least + self.tolerance.max(self.at_least >> 8)
    }

    /// Looks at a new piece.
    fn open(&mut self, mut piece: Piece) {
        if piece.bound(self.to, self.limit()) {
            self.pieces.push(piece);
        } else {
            self.at_most = self.at_most.max(piece.at_most);
        }
    }

    fn run(mut self) -> Farthest {
        let mut cuts = 0;
        while let Some(piece) = self.pieces.pop() {
            if piece.at_most <= self.limit() || cuts == CUTS_MAX {
                self.at_most = self.at_most.max(piece.at_most);
                break;
            }
            cuts += 1;
            for half in self.cut(&piece) {
                self.open(half);
            }
        }
        let metres = |raw: u64| Real::from_raw(raw.cast_signed()); // below 2^63
        let at_most = self.at_most.max(self.at_least);
        Farthest { point: self.point, at_least: metres(self.at_least), at_most: metres(at_most) }
    }

    /// Cuts a piece in two.
    fn cut(&mut self, piece: &Piece) -> [Piece; 2] {
        let cut = piece.cut(self.to);
        let corners = cut.ends.map(|end| {
            piece.end(end).unwrap_or_else(|(position, roundings, [a, b])| {
                self.corner(position, roundings, &[a, b, piece.face])
            })
        });
        piece.halves(&cut, corners)
    }
}
