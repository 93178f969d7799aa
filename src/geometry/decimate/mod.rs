//! Meshes of fewer faces.
//!
//! Edges become vertices, the cheapest one first, until few enough faces are left (Garland and
//! Heckbert, *Surface Simplification Using Quadric Error Metrics*, 1997). A vertex stands for all
//! faces that have been drawn into it, by the sum of squared distances from their planes; an edge
//! becomes the point where the sum for both its ends is smallest. All sums are exact, so the order
//! of the edges is the same on every machine.

mod lattice;
mod planes;
mod quadric;
mod surface;

use alloc::collections::BinaryHeap;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;

use self::lattice::Lattice;
use self::quadric::{Quadric, SPAN_BITS};
use self::surface::{Role, Surface};
use super::{Aabb, MeshError, TriangleMesh};
use crate::math::Vec3;

/// Edges that could not collapse are tried again so often, after others have.
const ROUNDS_MAX: u32 = 16;

/// Edges at a vertex of more faces stay until it has fewer: a collapse costs as much as all of them
/// together.
const DEGREE_MAX: usize = 256;

impl TriangleMesh {
    /// A mesh of at most `faces` faces that looks like this one. O(n log n) for n faces.
    ///
    /// Edges collapse as long as what is left is a surface of the same kind: parts stay apart,
    /// holes open, and boundaries lie along boundaries. No face turns by more than 75 degrees at
    /// once, and no edge collapses at a vertex of more than 256 faces. Where that forbids it, more
    /// faces than `faces` are left: 4 of each closed part without holes through it, 14 of a ring, 1
    /// of each sheet, and all around edges of three faces and more. Faces that are far from one
    /// another may come to intersect.
    ///
    /// Vertices and faces that remain keep their order; faces that name a vertex twice, and
    /// vertices of no face, are left out. How far the result is from the mesh is what
    /// [`Deviation`](crate::partition::bvh::Deviation) measures. Beyond a span of 16 m, vertices
    /// move to multiples of the 2^-28th part of it.
    ///
    /// # Errors
    /// [`MeshError::NoFace`] if every face names a vertex twice.
    ///
    /// ```
    /// use verlock::Vec3;
    /// use verlock::geometry::{Grid, TriangleMesh};
    ///
    /// let (edge_u, edge_v) = (Vec3::X, Vec3::Y);
    /// let grid = Grid { corner: Vec3::ZERO, edge_u, edge_v, columns: 9, rows: 9 };
    /// let sheet = TriangleMesh::grid(&grid)?.decimated(2)?;
    /// assert_eq!(sheet.faces().len(), 2);
    /// assert!(sheet.vertices().contains(&Vec3::from_ints(1, 1, 0)));
    /// # Ok::<(), verlock::geometry::MeshError>(())
    /// ```
    pub fn decimated(&self, faces: usize) -> Result<Self, MeshError> {
        let Some(bounds) = Aabb::around(self.vertices().iter().copied()) else {
            return Err(MeshError::NoFace);
        };
        let mut decimation = Decimation::new(self, bounds);
        for _ in 0..ROUNDS_MAX {
            if !decimation.round(faces) {
                break;
            }
        }
        decimation.into_mesh()
    }
}

/// A surface on its way to fewer faces.
struct Decimation {
    lattice: Lattice,
    surface: Surface,
    quadrics: Vec<Quadric>,
    /// How often each vertex has changed.
    changes: Vec<u32>,
    candidates: BinaryHeap<Reverse<Candidate>>,
}

/// An edge that may collapse: valid as long as its ends have not changed. The cheapest is first,
/// among equals the one with the lowest ends.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Candidate {
    cost: u128,
    /// The lower one first: it stays.
    ends: [u32; 2],
    changes: [u32; 2],
}

impl Decimation {
    fn new(mesh: &TriangleMesh, bounds: Aabb) -> Self {
        let lattice = Lattice::over(bounds, SPAN_BITS);
        let surface = Surface::new(mesh);
        Self {
            quadrics: planes::quadrics(&surface, &lattice, mesh.vertices().len()),
            changes: vec![0; mesh.vertices().len()],
            candidates: BinaryHeap::new(),
            lattice,
            surface,
        }
    }

    /// Tries every edge, until so few faces are left; whether that is worth repeating.
    fn round(&mut self, target: usize) -> bool {
        let before = self.surface.len();
        let mut edges: Vec<[u32; 2]> = self.surface.faces().flat_map(sides).collect();
        edges.sort_unstable(); // equal ones are dropped
        edges.dedup();
        let candidates: Vec<_> =
            edges.into_iter().filter_map(|ends| self.candidate(ends)).map(Reverse).collect();
        self.candidates = candidates.into();
        let mut next = Vec::new();
        while self.surface.len() > target {
            let Some(Reverse(candidate)) = self.candidates.pop() else { break };
            let ends = candidate.ends;
            if candidate.changes != self.changes_of(ends) {
                continue;
            }
            let Some((_, position)) = self.place(ends) else { continue };
            if !self.surface.can_collapse(ends, position) {
                continue;
            }
            self.collapse(ends, position);
            next.clear();
            self.surface.neighbours(ends[0], &mut next);
            for &neighbour in &next {
                let ends = [ends[0].min(neighbour), ends[0].max(neighbour)];
                let candidate = self.candidate(ends);
                self.candidates.extend(candidate.map(Reverse));
            }
        }
        target < self.surface.len() && self.surface.len() < before
    }

    fn changes_of(&self, ends: [u32; 2]) -> [u32; 2] {
        ends.map(|end| self.changes[end as usize])
    }

    fn candidate(&self, ends: [u32; 2]) -> Option<Candidate> {
        let (cost, _) = self.place(ends)?;
        Some(Candidate { cost, ends, changes: self.changes_of(ends) })
    }

    /// What it costs to collapse an edge, and where to; none if it stays.
    ///
    /// An inner vertex is drawn to the boundary and to what is fixed, not they to it. Else it is an
    /// end or where the sum of squares is smallest, whichever is best; ends win ties. To the sum a
    /// 2^-24th of all weights times the squared length is added: flat places are collapsed evenly.
    fn place(&self, ends: [u32; 2]) -> Option<(u128, Vec3)> {
        if ends.iter().any(|&end| self.surface.degree(end) > DEGREE_MAX) {
            return None;
        }
        let mut quadric = self.quadrics[ends[0] as usize];
        quadric += &self.quadrics[ends[1] as usize];
        let positions = ends.map(|end| self.surface.position(end));
        let cells = positions.map(|position| self.lattice.cell(position));
        let [a, b] = [0, 1].map(|k| (quadric.at(cells[k]), positions[k]));
        let (cost, position) = match ends.map(|end| self.surface.role(end)) {
            [Role::Fixed, Role::Fixed] => return None,
            [Role::Fixed, _] | [Role::Rim, Role::Inner] => a,
            [_, Role::Fixed] | [Role::Inner, Role::Rim] => b,
            [Role::Inner, Role::Inner] | [Role::Rim, Role::Rim] => {
                let best = if b.0 < a.0 { b } else { a };
                self.lowest(&quadric, cells).filter(|lowest| lowest.0 < best.0).unwrap_or(best)
            }
        };
        let length_sq: u64 = (0..3).map(|k| cells[0][k].abs_diff(cells[1][k]).pow(2)).sum();
        // 2^62.9 and 3 * 2^56.
        let pull = (u128::from(quadric.trace().unsigned_abs()) * u128::from(length_sq)) >> 24;
        Some((cost + pull, position))
    }

    /// The smallest sum near an edge, and where it is.
    fn lowest(&self, quadric: &Quadric, [a, b]: [[i64; 3]; 2]) -> Option<(u128, Vec3)> {
        let middle = [0, 1, 2].map(|k| (a[k] + b[k]) >> 1);
        let reach = (0..3).map(|k| (a[k] - b[k]).abs()).fold(0, i64::max);
        let position = self.lattice.point(quadric.lowest(middle, reach)?);
        Some((quadric.at(self.lattice.cell(position)), position))
    }

    fn collapse(&mut self, ends: [u32; 2], position: Vec3) {
        let [kept, gone] = ends.map(|end| end as usize);
        let other = self.quadrics[gone];
        self.quadrics[kept] += &other;
        self.changes[kept] += 1; // by every collapse once: below 2^22
        self.changes[gone] += 1;
        self.surface.collapse(ends, position);
    }

    fn into_mesh(self) -> Result<TriangleMesh, MeshError> {
        let faces: Vec<_> = self.surface.faces().collect();
        let mut places = vec![u32::MAX; self.changes.len()];
        for &corner in faces.iter().flatten() {
            places[corner as usize] = 0;
        }
        let mut vertices = Vec::new();
        let kept = (0..).zip(&mut places).filter(|(_, place)| **place == 0);
        for (number, (vertex, place)) in (0..).zip(kept) {
            *place = number;
            vertices.push(self.surface.position(vertex));
        }
        TriangleMesh::new(vertices, faces.into_iter().map(|face| face.map(|c| places[c as usize])))
    }
}

/// The edges of a face, the lower end of each first.
fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)])
}
