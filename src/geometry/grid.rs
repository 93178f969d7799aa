//! Meshes of parallelograms.

use super::{MeshError, TriangleMesh};
use crate::math::Vec3;
use crate::math::wide::{round_div_wide, to_i64};

/// A parallelogram of vertices in rows and columns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Grid {
    /// Where the first row and the first column begin, metres.
    pub corner: Vec3,
    /// From there to the end of the first row.
    pub edge_u: Vec3,
    /// From there to the end of the first column.
    pub edge_v: Vec3,
    /// Vertices in a row, at least 2.
    pub columns: u32,
    /// Vertices in a column, at least 2.
    pub rows: u32,
}

impl TriangleMesh {
    /// The mesh of a grid: vertices row by row, two faces a cell, whose diagonals alternate so that
    /// cloth shears alike both ways. O(vertices).
    ///
    /// # Errors
    /// [`MeshError`] if it has no cell or is too large.
    pub fn grid(grid: &Grid) -> Result<Self, MeshError> {
        let Grid { corner, edge_u, edge_v, columns, rows } = *grid;
        if u64::from(columns) * u64::from(rows) > Self::VERTICES_MAX as u64 {
            return Err(MeshError::TooManyVertices);
        }
        // Without this 2^32 rows of nothing would be counted.
        if columns < 2 || rows < 2 {
            return Err(MeshError::NoFace);
        }
        let cells = [columns.saturating_sub(1), rows.saturating_sub(1)];
        let vertices = (0..rows).flat_map(|row| {
            (0..columns).map(move |column| {
                let (u, v) = (part(edge_u, column, cells[0]), part(edge_v, row, cells[1]));
                // Far too large grids wrap into a range that is refused.
                let raw =
                    [0, 1, 2].map(|k| corner.raw()[k].saturating_add(u[k]).saturating_add(v[k]));
                Vec3::from_raw(raw)
            })
        });
        let at = |column, row| row * columns + column; // below 2^22
        let faces = (0..cells[1]).flat_map(|row| {
            (0..cells[0]).flat_map(move |column| {
                let [a, b] = [at(column, row), at(column + 1, row)];
                let [c, d] = [at(column + 1, row + 1), at(column, row + 1)];
                if (column + row) % 2 == 0 {
                    [[a, d, c], [a, c, b]]
                } else {
                    [[a, d, b], [b, d, c]]
                }
            })
        });
        Self::new(vertices, faces)
    }
}

/// `k / n` of an edge.
fn part(edge: Vec3, k: u32, n: u32) -> [i64; 3] {
    edge.raw().map(|c| to_i64(round_div_wide(i128::from(c) * i128::from(k), i128::from(n.max(1)))))
}
