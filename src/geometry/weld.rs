//! Vertices in one place made one.

use alloc::collections::BTreeSet;
use alloc::vec::Vec;

use super::mesh::{MeshBuilder, MeshError, TriangleMesh};
use crate::math::{Real, Vec3};

impl TriangleMesh {
    /// The mesh with vertices joined that are no farther apart than `tolerance`, in metres.
    ///
    /// In order, each vertex joins the first vertex kept so far that is within the tolerance, or is
    /// kept itself; a kept vertex stays where it is. Kept vertices are thus farther apart than the
    /// tolerance, and a second weld changes nothing. All faces remain, in order, some perhaps
    /// without an area now. The places of kept vertices move up. O(n log n).
    ///
    /// With a tolerance of 0, vertices join that are equal to the bit: what a file needs that
    /// repeats its vertices for every face, or along the seams of its textures.
    ///
    /// # Errors
    /// [`MeshError::NegativeTolerance`], or [`MeshError::TooLong`] if joining stretches a face so.
    pub fn welded(&self, tolerance: Real) -> Result<Self, MeshError> {
        if tolerance.is_negative() {
            return Err(MeshError::NegativeTolerance);
        }
        let mut welded = MeshBuilder::default();
        let mut kept = Kept::new(tolerance);
        let mut places = Vec::with_capacity(self.vertices().len());
        for &position in self.vertices() {
            places.push(match kept.first_near(position) {
                Some(vertex) => vertex,
                None => kept.insert(position, welded.vertex(position)?),
            });
        }
        for face in self.faces() {
            welded.face(face.map(|vertex| places[vertex as usize]))?;
        }
        welded.build()
    }
}

/// The vertices kept so far, in the cells of a grid as wide as the tolerance.
///
/// The grid finds candidates and decides nothing. A cell holds at most 8 of them: of two in the
/// same half of it along each axis, one would have joined the other.
struct Kept {
    tolerance: Real,
    vertices: Vec<Vec3>,
    cells: BTreeSet<([i64; 3], u32)>,
}

impl Kept {
    fn new(tolerance: Real) -> Self {
        Self { tolerance, vertices: Vec::new(), cells: BTreeSet::new() }
    }

    /// The first kept vertex within the tolerance.
    fn first_near(&self, position: Vec3) -> Option<u32> {
        // Squares of components up to 2^61 and of tolerances up to 2^63 fit 128 bits.
        let limit = u128::from(self.tolerance.raw().unsigned_abs()).pow(2);
        let is_near =
            |vertex: &u32| (self.vertices[*vertex as usize] - position).length_sq_wide() <= limit;
        let reach = i64::from(self.tolerance > Real::ZERO);
        let [x, y, z] = self.cell(position);
        let columns = (x - reach..=x + reach)
            .flat_map(|x| (y - reach..=y + reach).map(move |y| (x, y)))
            .flat_map(|(x, y)| {
                self.cells.range(([x, y, z - reach], 0)..=([x, y, z + reach], u32::MAX))
            });
        columns.map(|&(_, vertex)| vertex).filter(is_near).min()
    }

    /// Keeps the next vertex.
    fn insert(&mut self, position: Vec3, vertex: u32) -> u32 {
        self.vertices.push(position);
        self.cells.insert((self.cell(position), vertex));
        vertex
    }

    /// Coordinates are within 2^60, and so are cells.
    fn cell(&self, position: Vec3) -> [i64; 3] {
        position.raw().map(|c| c.div_euclid(self.tolerance.raw().max(1)))
    }
}
