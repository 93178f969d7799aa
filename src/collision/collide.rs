//! Any two shapes.

use alloc::vec::Vec;

use super::surface::{manifolds_shape_height_field, manifolds_shape_mesh};
use super::{Manifold, Shape, manifold_convex_convex};
use crate::math::Real;

/// Adds the manifolds of two shapes that touch, or are at most `margin` apart: one of convex
/// shapes, one for each patch of meshes and height fields, sorted by the features of their first
/// contacts.
///
/// A margin, in metres, counts from 0 to [`MARGIN_MAX`](super::MARGIN_MAX), in every function that
/// takes one: what is below is 0. All pairs of faces of two surfaces that are nearer are listed,
/// which takes time and memory for each; so keep it small against the faces.
///
/// Boxes and hulls beside a mesh or a height field are surfaces too, see
/// [`manifolds_mesh_mesh`](super::manifolds_mesh_mesh), and so are triangles, of both sides. What
/// pairs cost is said there, and at [`manifold_convex_convex`]. Two half-spaces have no manifold.
///
/// ```
/// use verlock::collision::{Shape, collide};
/// use verlock::geometry::{Capsule, Sphere};
/// use verlock::{Vec3, real};
///
/// let ball: Shape = Sphere::new(Vec3::Y * real!("1.4"), real!("0.5"))?.into();
/// let log: Shape = Capsule::new([Vec3::ZERO, Vec3::X], real!("1"))?.into();
/// let mut manifolds = Vec::new();
/// collide(&ball, &log, real!("0.01"), &mut manifolds);
/// assert_eq!(manifolds.len(), 1);
/// assert_eq!(manifolds[0].separation(), real!("1.4") - real!("1.5"));
/// # Ok::<(), verlock::geometry::ShapeError>(())
/// ```
pub fn collide(a: &Shape, b: &Shape, margin: Real, out: &mut Vec<Manifold>) {
    let first = out.len();
    match (a, b) {
        (_, Shape::MeshShape(b)) => manifolds_shape_mesh(a, b, margin, out),
        (_, Shape::HeightField(b)) => manifolds_shape_height_field(a, b, margin, out),
        (Shape::MeshShape(a), _) => manifolds_shape_mesh(b, a, margin, out),
        (Shape::HeightField(a), _) => manifolds_shape_height_field(b, a, margin, out),
        _ => out.extend(manifold_convex_convex(a, b, margin)),
    }
    let is_surface = |shape| matches!(shape, &Shape::MeshShape(_) | &Shape::HeightField(_));
    if is_surface(a) && !is_surface(b) {
        let found = &mut out[first..];
        for manifold in &mut *found {
            *manifold = manifold.flipped();
        }
        found.sort_unstable_by_key(|manifold| manifold.contacts()[0].features);
    }
}
