//! Surfaces of triangles: meshes, height fields, cloth.

mod features;
mod mesh_shape;

pub use mesh_shape::MeshShape;
