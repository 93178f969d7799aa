//! Surfaces of triangles: meshes, height fields, cloth.
//!
//! Surfaces touch where a corner of one is near a face, an edge or a corner of the other, or an
//! edge is near an edge. A part of a surface takes part only where it is nearest of all around it:
//! where the other lies in its Voronoi region, told by exact signs. So inner edges of flat or
//! hollow parts never touch anything, and no contact is found twice.

mod contained;
mod contains;
mod escape;
mod exit;
mod features;
mod feet;
mod manifolds;
mod mesh_shape;
mod near;
mod pair;
mod proximity;
mod ridges;
mod round;
mod shell;
mod side;
mod skin;
mod tangle;

pub use manifolds::{
    manifolds_half_space_surface, manifolds_mesh_height_field, manifolds_mesh_mesh,
};
pub(super) use manifolds::{manifolds_shape_height_field, manifolds_shape_mesh};
pub use mesh_shape::MeshShape;
pub use round::{manifolds_capsule_surface, manifolds_sphere_surface};

use crate::math::Real;

/// Nothing is looked for farther away: 65,536 m. Margins and radii together are below.
pub(super) const REACH_MAX: Real = Real::from_int(1 << 16);

/// How deep what is nearest still tells the way out: 2 mm.
pub(super) const DEPTH_MAX: Real = Real::from_raw((1 << 24) / 500);
