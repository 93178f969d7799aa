//! Any two shapes.

use alloc::vec::Vec;

use super::{Manifold, Shape, collide_surface, manifold_convex_convex};
use crate::math::Real;

/// Adds the manifolds of two shapes that touch, or are at most `margin` apart: one of convex
/// shapes, one for each patch of meshes and height fields, sorted by the features of their first
/// contacts.
///
/// What they cost is said where each kind of pair is: [`manifold_convex_convex`],
/// [`collide_surface`]. Two half-spaces have no manifold.
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
    let is_surface = |shape| matches!(shape, &Shape::MeshShape(_) | &Shape::HeightField(_));
    if is_surface(b) {
        collide_surface(a, b, margin, out);
    } else if is_surface(a) {
        let first = out.len();
        collide_surface(b, a, margin, out);
        let found = &mut out[first..];
        for manifold in &mut *found {
            *manifold = manifold.flipped();
        }
        found.sort_unstable_by_key(|manifold| manifold.contacts()[0].features);
    } else {
        out.extend(manifold_convex_convex(a, b, margin));
    }
}
