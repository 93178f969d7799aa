//! Where two faces touch: one clipped by the other, along a direction.
//!
//! Seen along the normal, both faces are convex polygons. What they have in common is a polygon
//! too, and each of its corners is one of three things: a corner of one face that lies over the
//! other, or a point where two sides cross. All are found from the corners of the faces by exact
//! signs, none from another: so each has a name, and none has the rounding errors of another.
//!
//! A corner exactly over a side counts as inside if it is B's, outside if it is A's: where faces
//! share corners and sides, what they have in common has each corner once.

mod clip;
mod outline;
mod reduce;

pub(super) use outline::{Corner, Outline};
pub(super) use reduce::reduce;

use super::few::Few;
use super::width::Width;
use super::{Contact, FeatureId, Manifold};
use crate::math::wide::sub;
use crate::math::{Real, UnitVec3, Vec3};

/// Lengths that differ by less count as one where a choice depends on it, raw: 31 um. So the noise
/// of a stack at rest does not turn one manifold into another.
pub(super) const TIE: i64 = 1 << 9;

/// Contacts that come one by one.
pub(super) type Contacts = Few<Contact, 8>;

/// Where two outlines touch, at most `margin` apart along `normal`, which points from the first to
/// the second. There is always one point: where they are deepest.
pub(super) fn patch<W: Width>(
    normal: UnitVec3,
    [a, b]: [&Outline; 2],
    margin: i64,
    origin: [i64; 3],
) -> Option<Manifold> {
    let mut contacts = Contacts::new();
    clip::common::<W>(normal, [a, b], |contact| {
        if contact.separation.raw() <= margin {
            contacts.push(contact.moved(origin));
        }
    });
    let least = contacts.iter().map(|contact| contact.separation.raw()).min();
    let (corner, reach) = b.lowest::<W>(normal);
    let deepest = W::round(reach - a.reach::<W>(normal));
    if least.is_none_or(|least| least > deepest + TIE) {
        // The corner that is deepest has slipped past a side.
        let on_a = sub(corner.at, W::scale(normal.raw(), deepest));
        let features = [a.face, FeatureId::vertex(corner.vertex)];
        contacts = contacts.iter().filter(|kept| kept.features != features).copied().collect();
        contacts.push(contact(features, [on_a, corner.at], deepest).moved(origin));
    }
    reduce(normal, [0; 2], &contacts)
}

/// A contact of raw numbers.
#[inline]
pub(super) fn contact(features: [FeatureId; 2], on: [[i64; 3]; 2], separation: i64) -> Contact {
    let [on_a, on_b] = on.map(Vec3::from_raw);
    Contact { features, on_a, on_b, separation: Real::from_raw(separation) }
}
