//! Terrain: a grid of heights.

use alloc::sync::Arc;
use alloc::vec::Vec;

use super::surface::Surface;
use super::triangle::is_in_range;
use super::{Aabb, ShapeError, Triangle, TriangleMesh};
use crate::math::{Real, Vec3};
use crate::store::{Hash, Hasher};

/// Ground whose height is given at the points of a grid along x and z; what is below is inside.
///
/// It has no floor, and so no way out from any depth: what has gone below it as a whole gets no
/// contact, or none that leads it out. What is fast is kept above by a
/// [cast](crate::collision::cast).
///
/// Vertex `row * columns + column` stands `column` steps along x and `row` steps along z from the
/// origin. Each cell has two faces, seen from above, parted by the diagonal from its lowest vertex:
/// face `2 * cell` is on the side of z, `2 * cell + 1` on that of x, and cells are counted as
/// vertices are. Edge `3 * vertex + k` goes from a vertex along x (k = 0), z (1) or both (2). So
/// nothing but the heights is stored, and they are shared by clones.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HeightField {
    origin: Vec3,
    steps: [Real; 2],
    columns: u32,
    rows: u32,
    heights: Arc<[Real]>,
    /// The lowest and the highest of them.
    range: [Real; 2],
}

/// Edges that begin at a vertex.
const ALONG_X: u32 = 0;
const ALONG_Z: u32 = 1;
const ACROSS: u32 = 2;

/// No height is farther from the origin, raw.
const HEIGHT_MAX: u64 = Triangle::COORDINATE_MAX.unsigned_abs();

impl HeightField {
    /// The field of these heights, row by row, each row along x: `heights.len() / columns` rows.
    ///
    /// All in metres: heights are added to that of `origin`, and `steps` are the distances of
    /// vertices along x and z. O(n).
    ///
    /// # Errors
    /// [`ShapeError::WrongCount`] if there are fewer than two rows or columns, rows of unequal
    /// length or more than [`TriangleMesh::VERTICES_MAX`] heights; [`ShapeError::OutOfRange`] if a
    /// step is not above 0, or a height or a vertex out of range; [`ShapeError::TooLong`] if the
    /// field spans more than [`Triangle::SPAN_MAX`] along an axis.
    pub fn new(
        origin: Vec3,
        steps: [Real; 2],
        columns: u32,
        heights: impl Into<Arc<[Real]>>,
    ) -> Result<Self, ShapeError> {
        let heights = heights.into();
        if columns < 2 {
            return Err(ShapeError::WrongCount("columns"));
        }
        if heights.len() > TriangleMesh::VERTICES_MAX {
            return Err(ShapeError::WrongCount("heights"));
        }
        // At most 2^22.
        #[expect(clippy::cast_possible_truncation, reason = "at most VERTICES_MAX")]
        let len = heights.len() as u32;
        let rows = len / columns;
        if rows < 2 || !len.is_multiple_of(columns) {
            return Err(ShapeError::WrongCount("heights"));
        }
        if steps.iter().any(|&step| step <= Real::ZERO) {
            return Err(ShapeError::OutOfRange("steps"));
        }
        let span = |step: Real, count: u32| i128::from(step.raw()) * i128::from(count - 1);
        let [low, high] = heights.iter().fold([Real::MAX, Real::MIN], |[low, high], &height| {
            [low.min(height), high.max(height)]
        });
        if [low, high].iter().any(|h| h.raw().unsigned_abs() > HEIGHT_MAX) {
            return Err(ShapeError::OutOfRange("heights"));
        }
        let rise = i128::from(high.raw()) - i128::from(low.raw());
        let spans = [span(steps[0], columns), rise, span(steps[1], rows)];
        if spans.iter().any(|&span| span > i128::from(Triangle::SPAN_MAX)) {
            return Err(ShapeError::TooLong);
        }
        let field = Self { origin, steps, columns, rows, heights, range: [low, high] };
        // Steps of the way are below 2^41 from here on.
        let bounds = is_in_range(origin).then(|| field.bounds());
        if !bounds.is_some_and(|bounds| is_in_range(bounds.min()) && is_in_range(bounds.max())) {
            return Err(ShapeError::OutOfRange("origin"));
        }
        Ok(field)
    }

    /// Where vertex 0 stands when its height is 0, in metres.
    #[must_use]
    pub const fn origin(&self) -> Vec3 {
        self.origin
    }

    /// From vertex to vertex along x and along z, in metres.
    #[must_use]
    pub const fn steps(&self) -> [Real; 2] {
        self.steps
    }

    /// Vertices along x, and along z.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        [self.columns, self.rows]
    }

    /// Height above the origin at every vertex, in metres.
    #[must_use]
    pub fn heights(&self) -> &[Real] {
        &self.heights
    }

    /// The hash of what does not move with the origin, which names the field: of the number of
    /// columns and rows in 32 bits, then both steps and every height in 64, all little-endian.
    #[must_use]
    pub fn content_hash(&self) -> Hash {
        let mut hasher = Hasher::default();
        hasher.write(&self.columns.to_le_bytes());
        hasher.write(&self.rows.to_le_bytes());
        let numbers = self.steps.iter().chain(&*self.heights);
        numbers.for_each(|number| hasher.write(&number.raw().to_le_bytes()));
        hasher.finish()
    }

    /// The mesh of the same vertices and faces. O(n).
    ///
    /// # Errors
    /// None for a legal field, as its vertices and faces are in range.
    pub fn mesh(&self) -> Result<TriangleMesh, super::MeshError> {
        let vertices = (0..self.columns * self.rows).map(|vertex| self.position(vertex));
        TriangleMesh::new(vertices, (0..self.faces_len()).map(|face| self.corners(face)))
    }

    /// How many faces there are: fewer than 2^23.
    #[must_use]
    pub const fn faces_len(&self) -> u32 {
        2 * (self.columns - 1) * (self.rows - 1)
    }

    /// The cells that a range along an axis touches, as the first and one past the last.
    ///
    /// `start` is where the axis of the grid begins. Cells are closed: at a line both sides count.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 2^22")]
    fn cells(&self, axis: usize, start: i64, [low, high]: [i64; 2]) -> core::ops::Range<u32> {
        let count = i128::from([self.columns, self.rows][axis] - 1);
        let step = i128::from(self.steps[axis].raw());
        let way = |c: i64| i128::from(c) - i128::from(start);
        // The first cell that ends at `low` or behind it, and the first that begins behind `high`.
        let first = -(-way(low)).div_euclid(step) - 1;
        let end = way(high).div_euclid(step) + 1;
        let cut = |cell: i128| cell.clamp(0, count) as u32;
        cut(first)..cut(end)
    }

    /// The face `side` of the cell at a column and a row, if both have one.
    fn face(&self, column: Option<u32>, row: Option<u32>, side: u32) -> Option<u32> {
        let column = column.filter(|&column| column < self.columns - 1)?;
        let row = row.filter(|&row| row < self.rows - 1)?;
        Some(2 * (row * (self.columns - 1) + column) + side)
    }

    /// The column and the row of a vertex.
    const fn place(&self, vertex: u32) -> [u32; 2] {
        [vertex % self.columns, vertex / self.columns]
    }
}

impl Surface for HeightField {
    fn bounds(&self) -> Aabb {
        let [x, y, z] = self.origin.raw();
        let [low, high] = self.range;
        let far = |from: i64, step: Real, count: u32| from + step.raw() * i64::from(count - 1);
        let min = Vec3::from_raw([x, y + low.raw(), z]);
        let [x, z] = [far(x, self.steps[0], self.columns), far(z, self.steps[1], self.rows)];
        Aabb::new(min, Vec3::from_raw([x, y + high.raw(), z]))
    }

    /// O(cells below or above the box).
    fn faces_near(&self, bounds: &Aabb, faces: &mut Vec<u32>) {
        faces.clear();
        if !self.bounds().overlaps(bounds) {
            return;
        }
        let [x, y, z] = self.origin.raw();
        let [min, max] = [bounds.min().raw(), bounds.max().raw()];
        let columns = self.cells(0, x, [min[0], max[0]]);
        let heights = |vertex: u32| y + self.heights[vertex as usize].raw();
        for row in self.cells(1, z, [min[2], max[2]]) {
            for column in columns.clone() {
                let first = self.face(Some(column), Some(row), 0);
                faces.extend(first.into_iter().flat_map(|face| [face, face + 1]).filter(|&face| {
                    let [a, b, c] = self.corners(face).map(heights);
                    a.min(b).min(c) <= max[1] && min[1] <= a.max(b).max(c)
                }));
            }
        }
    }

    #[inline]
    fn corners(&self, face: u32) -> [u32; 3] {
        let cell = face / 2;
        let (column, row) = (cell % (self.columns - 1), cell / (self.columns - 1));
        let first = row * self.columns + column;
        let across = first + self.columns + 1;
        if face.is_multiple_of(2) {
            [first, first + self.columns, across]
        } else {
            [first, across, first + 1]
        }
    }

    #[inline]
    fn sides(&self, face: u32) -> [u32; 3] {
        let [first, second, third] = self.corners(face);
        if face.is_multiple_of(2) {
            [3 * first + ALONG_Z, 3 * second + ALONG_X, 3 * first + ACROSS]
        } else {
            [3 * first + ACROSS, 3 * third + ALONG_Z, 3 * first + ALONG_X]
        }
    }

    #[inline]
    fn ends(&self, edge: u32) -> [u32; 2] {
        let first = edge / 3;
        [first, first + [1, self.columns, self.columns + 1][edge as usize % 3]]
    }

    #[inline]
    fn position(&self, vertex: u32) -> Vec3 {
        let [column, row] = self.place(vertex).map(i64::from);
        let [x, y, z] = self.origin.raw();
        let [along_x, along_z] = self.steps.map(Real::raw);
        // Ways are below 2^41, and vertices in range.
        let height = self.heights[vertex as usize].raw();
        Vec3::from_raw([x + along_x * column, y + height, z + along_z * row])
    }

    fn faces_at_edge(&self, edge: u32) -> impl Iterator<Item = u32> {
        let [column, row] = self.place(edge / 3);
        let (left, above) = (column.checked_sub(1), row.checked_sub(1));
        let (column, row) = (Some(column), Some(row));
        let faces = match edge % 3 {
            ALONG_X => [self.face(column, above, 0), self.face(column, row, 1)],
            ALONG_Z => [self.face(left, row, 1), self.face(column, row, 0)],
            _ => [self.face(column, row, 0), self.face(column, row, 1)],
        };
        faces.into_iter().flatten()
    }

    fn faces_at_vertex(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let [column, row] = self.place(vertex);
        let (left, above) = (column.checked_sub(1), row.checked_sub(1));
        let (column, row) = (Some(column), Some(row));
        let faces = [
            self.face(left, above, 0),
            self.face(left, above, 1),
            self.face(column, above, 0),
            self.face(left, row, 1),
            self.face(column, row, 0),
            self.face(column, row, 1),
        ];
        faces.into_iter().flatten()
    }

    fn is_two_sided(&self) -> bool {
        false
    }
}
