//! What lies on a plane.

use super::solid::Solid;
use crate::collision::margin::counted;
use crate::collision::patch::{Contacts, Seam, reduce};
use crate::collision::width::{Wide, Width};
use crate::collision::{FeatureId, Manifold, Shape};
use crate::geometry::HalfSpace;
use crate::math::Real;
use crate::math::wide::sub;

/// Where a convex shape touches a half-space, A: at those corners that are near or below it.
pub(super) fn manifold_half_space(
    ground: &HalfSpace,
    shape: &Shape,
    margin: Real,
) -> Option<Manifold> {
    let origin = shape.bounds()?.min().raw();
    let solid = Solid::new(shape, origin)?;
    let normal = ground.normal();
    let margin = counted(margin).raw();
    let seam = Seam { normal, radii: [0, solid.radius], margin, origin };
    // Coordinates are at most 2^60: what is that deep is wide indeed.
    let level = sub(ground.point().raw(), origin);
    let mut contacts = Contacts::new();
    for (corner, at) in (0..).zip(solid.corners.iter()) {
        let height = Wide::round(Wide::along(normal, sub(at.raw(), level)));
        let features = [FeatureId::face(0), solid.corner_name(corner)];
        let contact = seam.above::<Wide>(features, at.raw(), height);
        if contact.separation.raw() <= margin {
            contacts.push(contact);
        }
    }
    reduce(normal, &contacts)
}
