//! Floor 5: where shapes touch. Shapes and where they are; no bodies, no velocity, no material.

#![allow(
    clippy::cast_possible_truncation,
    reason = "counts and places are small; the bound stands beside each cast"
)]

mod convex;
mod feature;
mod few;
mod manifold;
mod patch;
mod shape;
mod surface;
mod width;

pub use convex::manifold_cuboid_cuboid;
pub use feature::{FeatureId, FeatureKind};
pub use manifold::{Contact, Manifold};
pub use shape::Shape;
pub use surface::{
    MeshShape, manifolds_capsule_surface, manifolds_mesh_height_field, manifolds_mesh_mesh,
    manifolds_sphere_surface,
};
