//! Floor 1: shapes made of points. Pure functions of positions: no ids, no mass, no motion.
//!
//! A [`TriangleMesh`] is a list of vertices and of triangles between them, in the order of the file
//! or of the code that made it; nothing sorts, drops or merges them unasked. Whatever is derived
//! from a mesh names its vertices and faces by their places in these lists.
//!
//! ```
//! use verlock::Vec3;
//! use verlock::geometry::{Adjacency, TriangleMesh};
//!
//! // A square of two triangles.
//! let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(x, y)| Vec3::from_ints(x, y, 0));
//! let mesh = TriangleMesh::new(corners, [[0, 1, 2], [0, 2, 3]])?;
//! let adjacency = Adjacency::new(&mesh);
//! assert_eq!(adjacency.edges().len(), 5);
//! assert_eq!(adjacency.boundary().count(), 4);
//! assert_eq!(adjacency.neighbours(1), [0, 2]);
//! # Ok::<(), verlock::geometry::MeshError>(())
//! ```

mod aabb;
mod adjacency;
mod capsule;
mod closest;
mod cuboid;
mod decimate;
mod error;
mod fit;
mod grid;
mod half_space;
mod height_field;
mod hull;
mod lists;
mod mesh;
mod predicates;
mod segment;
mod sphere;
mod surface;
pub mod sweep;
mod triangle;
mod triangle_triangle;
mod weld;

pub use aabb::Aabb;
pub use adjacency::{Adjacency, Edge, Hinge};
pub use capsule::Capsule;
pub(crate) use closest::{ClosestConvex, closest_convex};
pub use closest::{
    ClosestPoint, closest_point_segment, closest_point_triangle, closest_segment_segment,
    normal_point_segment, normal_point_triangle, normal_segment_segment,
};
pub use cuboid::Cuboid;
pub use error::ShapeError;
pub use fit::{Fit, fit_capsule, fit_cuboid, fit_hull, fit_sphere};
pub use grid::Grid;
pub use half_space::HalfSpace;
pub use height_field::HeightField;
pub use hull::{ConvexHull, HullEdge, HullTopology};
pub(crate) use lists::Lists;
pub use mesh::{MeshBuilder, MeshError, TriangleMesh};
pub use predicates::{orient2d, orient3d};
pub use segment::Segment;
pub use sphere::Sphere;
pub use surface::Surface;
pub(crate) use triangle::is_in_range;
pub use triangle::{Triangle, TriangleError};
pub use triangle_triangle::{
    Feature, Intersection, IntersectionPoint, intersection_triangle_triangle,
    overlap_triangle_triangle,
};
