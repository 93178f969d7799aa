//! How the faces of a convex polyhedron hang together.

use alloc::vec::Vec;

use super::quickhull::simplex;
use crate::geometry::lists::Lists;
use crate::math::determinant::cross;
use crate::math::wide::{dot_wide, sub};
use crate::store::{Hash, Hasher};

/// What a convex hull keeps wherever it is moved: corners of faces, and edges. Immutable.
///
/// Vertices are in the order of the points that the hull is around. A face is a polygon, its
/// corners counter-clockwise, seen from outside, from the lowest one; faces are sorted. Edges are
/// sorted by their ends. No two faces lie in one plane, nor two edges of a face on one line, where
/// the hull was made.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct HullTopology {
    vertices: u32,
    faces: Lists,
    widest: Vec<[u32; 3]>,
    edges: Vec<HullEdge>,
    neighbours: Lists,
    simplex: [u32; 4],
    hash: Hash,
}

/// Where two faces of a convex hull meet.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct HullEdge {
    /// The lower vertex, then the higher one.
    pub ends: [u32; 2],
    /// The face in whose order of corners the higher end follows the lower one, then the other:
    /// from end to end the edge runs along the cross product of their normals.
    pub faces: [u32; 2],
}

impl HullTopology {
    /// The topology of faces, see `Facets`, with these corners; `None` if they are flat.
    #[expect(clippy::cast_possible_truncation, reason = "fewer than 2^30 points")]
    pub(super) fn new(corners: &[[i64; 3]], polygons: &[Vec<u32>]) -> Option<Self> {
        let vertices = corners.len() as u32;
        let widest: Vec<_> = polygons.iter().map(|polygon| widest(polygon, corners)).collect();
        let simplex = simplex(corners)?;
        let mut faces = Lists::new();
        for polygon in polygons {
            faces.push(polygon.iter().copied());
        }
        let edges = edges(&faces);
        let neighbours = Lists::neighbours(edges.iter().map(|edge| edge.ends), corners.len());
        let hash = content_hash(vertices, &faces, &widest, simplex);
        Some(Self { vertices, faces, widest, edges, neighbours, simplex, hash })
    }

    /// How many vertices there are: at least 4.
    #[inline]
    #[must_use]
    pub const fn vertices_len(&self) -> u32 {
        self.vertices
    }

    /// The corners of every face, in order; see [`face_corners`](Self::face_corners).
    #[must_use]
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.faces.iter()
    }

    /// The corners of a face, at least 3, counter-clockwise, seen from outside, from the lowest
    /// vertex; none if there is no such face. O(1).
    #[inline]
    #[must_use]
    pub fn face_corners(&self, face: u32) -> &[u32] {
        self.faces.get(face as usize)
    }

    /// For every face the three of its corners with the greatest area between them, in its order;
    /// of several such the first. Of more than 64 corners only 64, evenly spaced, and up to
    /// three that are far apart are looked at. Its normal is theirs.
    #[inline]
    #[must_use]
    pub fn widest_corners(&self) -> &[[u32; 3]] {
        &self.widest
    }

    /// Every edge once, sorted by its ends.
    #[inline]
    #[must_use]
    pub fn edges(&self) -> &[HullEdge] {
        &self.edges
    }

    /// The other ends of the edges of a vertex, at least 3, sorted; none if there is no such
    /// vertex. O(1).
    #[inline]
    #[must_use]
    pub fn neighbours(&self, vertex: u32) -> &[u32] {
        self.neighbours.get(vertex as usize)
    }

    /// Four vertices far apart, the last behind the plane of the others: they tell whether a moved
    /// hull is still the right way round.
    #[inline]
    pub(super) const fn simplex(&self) -> [u32; 4] {
        self.simplex
    }

    /// The hash which names the topology: equal ones have equal hashes, others but for a chance of
    /// 2^-128 do not. Of the number of vertices, that of faces, each face's number of corners, its
    /// corners and its widest ones, and four vertices far apart; all in 32 bits, little-endian.
    #[must_use]
    pub const fn content_hash(&self) -> Hash {
        self.hash
    }
}

/// See [`HullTopology::edges`].
fn edges(faces: &Lists) -> Vec<HullEdge> {
    let mut sides = Vec::new();
    for (face, corners) in (0..).zip(faces.iter()) {
        let next = corners.iter().cycle().skip(1);
        for (&from, &to) in corners.iter().zip(next) {
            sides.push(([from.min(to), from.max(to)], from > to, face));
        }
    }
    sides.sort_unstable();
    // The hull is closed: every edge is a side of two faces, once in each direction.
    let (pairs, _) = sides.as_chunks();
    let edge = |&[one, other]: &[([u32; 2], bool, u32); 2]| HullEdge {
        ends: one.0,
        faces: [one.2, other.2],
    };
    pairs.iter().map(edge).collect()
}

/// Of so many corners of a face, and three that are far apart, the widest are looked for.
const WIDEST_OF_MAX: usize = 64;

/// See [`HullTopology::widest_corners`]. O(k + n^2) for n of k corners, of which there are few.
///
/// Beyond a side of a convex polygon the distance of its corners rises, then falls; and where the
/// side's end moves on, so does the farthest corner.
fn widest(polygon: &[u32], positions: &[[i64; 3]]) -> [u32; 3] {
    let count = polygon.len().min(WIDEST_OF_MAX);
    let mut shown: Vec<_> = (0..count).map(|k| k * polygon.len() / count).collect();
    if count < polygon.len() {
        shown.extend(far_apart(polygon, positions));
        shown.sort_unstable();
        shown.dedup();
    }
    let polygon: Vec<u32> = shown.into_iter().map(|k| polygon[k]).collect();
    let at = |k: usize| positions[polygon[k] as usize];
    // All normals are parallel: the sums of their components' sizes compare as their lengths do.
    // Below 3 * 2^82.
    let area = |[i, j, k]: [usize; 3]| -> i128 {
        cross(sub(at(j), at(i)), sub(at(k), at(i))).map(i128::abs).iter().sum()
    };
    let mut best = [0, 1, 2];
    let mut greatest = area(best);
    for i in 0..polygon.len() - 2 {
        let mut k = i + 2;
        for j in i + 1..polygon.len() - 1 {
            k = k.max(j + 1);
            while k + 1 < polygon.len() && area([i, j, k + 1]) > area([i, j, k]) {
                k += 1;
            }
            if area([i, j, k]) > greatest {
                best = [i, j, k];
                greatest = area(best);
            }
        }
    }
    best.map(|k| polygon[k])
}

/// The places of three corners of a polygon: the one farthest from the first, the one farthest from
/// that, and the one farthest from the line through both. O(k).
fn far_apart(polygon: &[u32], positions: &[[i64; 3]]) -> [usize; 3] {
    let way = |from: usize, to: usize| {
        sub(positions[polygon[to] as usize], positions[polygon[from] as usize])
    };
    // Below 3 * 2^82, and the sums of components likewise.
    let farthest = |size: &dyn Fn(usize) -> i128| (0..polygon.len()).max_by_key(|&k| size(k));
    let from = |place: usize| farthest(&|k| dot_wide(way(place, k), way(place, k))).unwrap_or(0);
    let one = from(0);
    let other = from(one);
    let beside = |k: usize| cross(way(one, other), way(one, k)).map(i128::abs).iter().sum();
    [one, other, farthest(&beside).unwrap_or(0)]
}

/// See [`HullTopology::content_hash`].
#[expect(clippy::cast_possible_truncation, reason = "fewer than 2^31 faces and corners")]
fn content_hash(vertices: u32, faces: &Lists, widest: &[[u32; 3]], simplex: [u32; 4]) -> Hash {
    let mut hasher = Hasher::default();
    let mut write = |number: u32| hasher.write(&number.to_le_bytes());
    write(vertices);
    write(faces.len() as u32);
    for (corners, widest) in faces.iter().zip(widest) {
        write(corners.len() as u32);
        corners.iter().chain(widest).for_each(|&corner| write(corner));
    }
    simplex.into_iter().for_each(&mut write);
    hasher.finish()
}
