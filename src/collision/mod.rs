//! Floor 5: where shapes touch. Shapes and where they are; no bodies, no velocity, no material.
//!
//! # Pairs
//!
//! Any [`Shape`] can be asked about any other: how far apart they are ([`closest_points`],
//! [`distance`]), whether they [`overlap`], and when one that moves touches the other ([`cast`],
//! [`cast_segment`]). How it is found out:
//!
//! | | half-space | sphere, capsule, box, hull, triangle | mesh, height field |
//! |---|---|---|---|
//! | half-space | the gap of planes | the lowest corner | the lowest corner of any face |
//! | sphere | corner | hull to hull | hull to each face near |
//! | capsule | corner | hull to hull | hull to each face near |
//! | box | corner | hull to hull | hull to each face near |
//! | hull | corner | hull to hull | hull to each face near |
//! | triangle | corner | hull to hull | hull to each face near |
//! | mesh | corner | face to hull | each face to each near |
//! | height field | corner | face to hull | each face to each near |
//!
//! Spheres and capsules are hulls of one and of two points, with a radius. Meshes and height fields
//! are surfaces, hollow to queries: what is behind a face does not overlap, and is as far from it
//! as what is in front. A set of shapes is a [`Colliders`].
//!
//! Where two shapes touch, [`collide`] tells, in up to four points a patch:
//!
//! | | half-space | sphere, capsule | box, hull, triangle | mesh, height field |
//! |---|---|---|---|---|
//! | half-space | | corners | corners | vertices |
//! | sphere, capsule | corners | nearest points | nearest or least overlap | nearest parts |
//! | box, hull, triangle | corners | nearest or least overlap | least overlap | nearest parts |
//! | mesh, height field | vertices | nearest parts | nearest parts | nearest parts |
//!
//! Contacts know the inside of one-sided surfaces and lead out of it. Those with like normals share
//! a manifold, of which there are eight a pair at most, the deepest; that goes for cloth too.

#![allow(
    clippy::cast_possible_truncation,
    reason = "counts and places are small; the bound stands beside each cast"
)]

mod cast;
mod collide;
mod colliders;
mod continuous;
mod convex;
mod distance;
mod feature;
mod few;
mod manifold;
mod margin;
mod patch;
mod shape;
mod surface;
mod width;

pub use cast::{Cast, Touch, cast, cast_segment};
pub use collide::collide;
pub use colliders::{Collider, ColliderError, ColliderId, Colliders, Filter, Layers};
pub use continuous::{MeshMotion, TimeOfImpact};
pub use convex::{manifold_convex_convex, manifold_cuboid_cuboid};
pub use distance::{Closest, closest_points, distance, overlap};
pub use feature::{FeatureId, FeatureKind};
pub use manifold::{Contact, Manifold};
pub use margin::MARGIN_MAX;
pub use shape::Shape;
pub use surface::{
    MeshShape, manifolds_capsule_surface, manifolds_half_space_surface,
    manifolds_mesh_height_field, manifolds_mesh_mesh, manifolds_sphere_surface,
};
