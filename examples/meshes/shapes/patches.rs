//! Meshes of bent rectangles.

use verlock::geometry::TriangleMesh;
use verlock::{Real, Vec3};

/// Rectangles of cells, which are welded where they meet.
#[derive(Default)]
pub struct Patches {
    vertices: Vec<Vec3>,
    faces: Vec<[u32; 3]>,
}

impl Patches {
    /// Adds a rectangle of `columns` times `rows` cells, whose corners `(column, row)` are at
    /// `place`: its front is where columns lead to the right and rows up.
    pub fn add(&mut self, columns: u32, rows: u32, place: impl Fn(u32, u32) -> Vec3) -> &mut Self {
        let first = u32::try_from(self.vertices.len()).expect("few vertices");
        let at = |column, row| first + row * (columns + 1) + column;
        for row in 0..=rows {
            self.vertices.extend((0..=columns).map(|column| place(column, row)));
        }
        for (column, row) in (0..rows).flat_map(|row| (0..columns).map(move |c| (c, row))) {
            let [a, b] = [at(column, row), at(column + 1, row)];
            let [c, d] = [at(column + 1, row + 1), at(column, row + 1)];
            self.faces.extend(if (column + row) % 2 == 0 {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            });
        }
        self
    }

    /// Adds a box of `cells` along each edge between two opposite corners, the lowest first.
    pub fn block(&mut self, low: Vec3, high: Vec3, cells: [u32; 3]) -> &mut Self {
        let (low, high) = (low.raw(), high.raw());
        let along = |k: usize, part: u32| {
            low[k] + (high[k] - low[k]) * i64::from(part) / i64::from(cells[k])
        };
        for axis in 0..3 {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            for (end, [u, v]) in [(low[axis], [v, u]), (high[axis], [u, v])] {
                self.add(cells[u], cells[v], |i, j| {
                    let mut point = [end; 3];
                    (point[u], point[v]) = (along(u, i), along(v, j));
                    Vec3::from_raw(point)
                });
            }
        }
        self
    }

    /// The mesh: patches joined where vertices coincide, without faces that have no area.
    pub fn mesh(&mut self) -> TriangleMesh {
        let Self { vertices, faces } = std::mem::take(self);
        let welded = TriangleMesh::new(vertices, faces).expect("a mesh");
        let welded = welded.welded(Real::ZERO).expect("a mesh");
        let flat: Vec<_> = welded.degenerate_faces().collect();
        let faces = (0..).zip(welded.faces());
        let faces = faces.filter(|(face, _)| flat.binary_search(face).is_err());
        let faces: Vec<_> = faces.map(|(_, &corners)| corners).collect();
        TriangleMesh::new(welded.vertices().iter().copied(), faces).expect("a mesh")
    }
}
