//! Manifolds of convex shapes.

mod boxes;
mod half_space;
mod manifold;
mod pair;
mod separate;
mod solid;

pub use boxes::manifold_cuboid_cuboid;
pub use manifold::manifold_convex_convex;
