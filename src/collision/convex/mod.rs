//! Manifolds of convex shapes.

mod boxes;
mod pair;

pub use boxes::manifold_cuboid_cuboid;

use crate::math::Real;

/// The greatest margin: 16,384 m.
const MARGIN_MAX: Real = Real::from_int(1 << 14);
