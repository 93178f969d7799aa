//! Bounding-volume hierarchies of triangle meshes.
//!
//! A [`Bvh`] is a tree over the faces of a [`TriangleMesh`], each node with at most four children,
//! each leaf with at most four faces. It finds which faces of two meshes intersect, exactly, or
//! whose volumes do ([`Precision`]). Volumes are boxes, spheres or cylinders; they change what a
//! query costs, and what it finds only where it stops at the volumes.
//!
//! # Cells
//!
//! Volumes are kept in 32 bits, in cells that the tree lays over its mesh from the lowest corner:
//! the smallest power of two of which 2^28 are longer than the mesh. Below a span of 16 m a cell is
//! one raw unit and a box exact; beyond, what is not a whole number of cells is rounded
//! **outward**, so that a volume holds every point of its faces, always. Rounding depends on
//! differences only: a tree is the same wherever its mesh is.
//!
//! ```
//! use std::sync::Arc;
//! use verlock::Vec3;
//! use verlock::geometry::{Grid, TriangleMesh};
//! use verlock::partition::bvh::{Bvh, CellBox, Precision};
//!
//! let sheet = |corner, edge_v| {
//!     let edge_u = Vec3::from_ints(8, 0, 0);
//!     TriangleMesh::grid(&Grid { corner, edge_u, edge_v, columns: 9, rows: 9 })
//! };
//! let floor = Arc::new(sheet(Vec3::ZERO, Vec3::from_ints(0, 0, 8))?);
//! let wall = Arc::new(sheet(Vec3::from_ints(0, -4, 4), Vec3::from_ints(0, 8, 0))?);
//! let mut floor = Bvh::<CellBox>::new(floor);
//! let wall = Bvh::new(wall);
//! assert!(floor.overlaps(&wall, Precision::Exact));
//!
//! let far: Vec<_> =
//!     floor.mesh().vertices().iter().map(|&p| p + Vec3::from_ints(0, 9, 0)).collect();
//! floor.refit(&far).expect("in range");
//! assert!(floor.pairs(&wall, Precision::Exact).is_empty());
//! # Ok::<(), verlock::geometry::MeshError>(())
//! ```

mod build;
mod cell_box;
mod cell_cylinder;
mod cell_sphere;
mod cells;
mod deviation;
mod nearest;
mod query;
mod refit;
mod swept;
mod validate;
mod volume;

use alloc::sync::Arc;
use alloc::vec::Vec;

use crate::geometry::{Triangle, TriangleMesh};
use crate::store::{Hash, Hasher};

pub use cell_box::CellBox;
pub use cell_cylinder::CellCylinder;
pub use cell_sphere::CellSphere;
pub use deviation::{Deviation, Farthest};
pub use nearest::Nearest;
pub use query::Precision;
pub use refit::RefitError;
pub use swept::SweptBvh;
pub use validate::BvhFault;
pub use volume::Volume;

use build::{LANES, Link, Shape};
use cells::Cells;

/// A tree of volumes over the faces of a mesh, which it shares.
///
/// Which faces a leaf holds is decided once, when the tree is made, and is a function of the mesh
/// alone. [`refit`](Self::refit) moves the vertices and keeps the tree: good as long as faces that
/// were near one another stay so, right in any case. Two trees are equal if they have the same
/// mesh, shape, positions and volumes.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Bvh<V: Volume = CellBox> {
    mesh: Arc<TriangleMesh>,
    shape: Shape,
    /// Where the faces are now, in the order of the leaves: those of a leaf are neighbours.
    triangles: Vec<Triangle>,
    /// The grid of the volumes.
    cells: Cells,
    /// The volumes of every node's children, and of every leaf's faces; unused ones at the end
    /// repeat the first.
    volumes: Vec<[V; LANES]>,
}

impl<V: Volume> Bvh<V> {
    /// The most faces in a leaf, and the most children of a node.
    pub const LEAF_MAX: usize = LANES;

    /// The tree of a mesh. O(n log n) for n faces.
    ///
    /// From above, ranges of faces are cut in two at the best of 16 planes across the longest edge
    /// of the box around their centres: where the sum of area times faces of the two boxes is least
    /// (the surface-area heuristic, in bins; Wald, *On fast Construction of SAH-based Bounding
    /// Volume Hierarchies*, 2007), moved to a multiple of four faces so that leaves are full. The
    /// order along the axis is by centre, then by face. Deep down, cuts are at the median, so no
    /// mesh makes a deep tree.
    #[must_use]
    pub fn new(mesh: Arc<TriangleMesh>) -> Self {
        let cells = Cells::around(mesh.vertices());
        let boxes: Vec<_> = mesh.triangles().map(|triangle| cells.of_triangle(&triangle)).collect();
        let shape = Shape::new(&boxes);
        let triangles = shape.faces.iter().map(|&face| mesh.triangle(face)).collect();
        let mut bvh = Self { mesh, shape, triangles, cells, volumes: Vec::new() };
        bvh.refit_volumes();
        bvh
    }

    /// The mesh, its vertices where they were when the tree was made.
    #[must_use]
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        &self.mesh
    }

    /// How many nodes there are, the leaves included: at most one for each face.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.shape.links.len()
    }

    /// The hash of the tree's shape: which faces are in which leaf, and which nodes in which.
    ///
    /// Of every node's first child or place, its number of children and whether it is a leaf, in 32
    /// bits each, then of every face in the order of the leaves in 32, all little-endian. The same
    /// on every machine.
    #[must_use]
    pub fn shape_hash(&self) -> Hash {
        let mut hasher = Hasher::default();
        for &Link { first, len, is_leaf, size: _ } in &self.shape.links {
            for word in [first, u32::from(len), u32::from(is_leaf)] {
                hasher.write(&word.to_le_bytes());
            }
        }
        self.shape.faces.iter().for_each(|face| hasher.write(&face.to_le_bytes()));
        hasher.finish()
    }
}
