//! Manifolds of convex shapes.

mod boxes;
mod half_space;
mod manifold;
mod pair;
mod separate;
mod solid;

pub use boxes::manifold_cuboid_cuboid;
pub use manifold::manifold_convex_convex;

use crate::math::Real;

/// The greatest margin: 16,384 m.
pub(super) const MARGIN_MAX: Real = Real::from_int(1 << 14);
