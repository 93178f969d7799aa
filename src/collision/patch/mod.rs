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

pub(super) use clip::{between, clip};
pub(super) use outline::{Corner, Outline};
pub(super) use reduce::{NEAR_SQ, reduce};

use super::few::Few;
use super::width::Width;
use super::{Contact, FeatureId, Manifold};
use crate::geometry::ClosestConvex;
use crate::math::wide::{add, sub};
use crate::math::{Real, UnitVec3, Vec3};

/// Lengths that differ by less count as one where a choice depends on it, raw: 31 um. So the noise
/// of a stack at rest does not turn one manifold into another.
pub(super) const TIE: i64 = 1 << 9;

/// What another axis must separate by more than, to be taken before one that separates by so much.
/// An axis that parts two shapes is always taken before one that does not.
#[inline]
pub(super) const fn to_beat(separation: i64) -> i64 {
    // Separations are far below 2^62.
    let least = separation + TIE;
    if separation <= 0 && least > 0 { 0 } else { least }
}

/// Contacts that come one by one.
pub(super) type Contacts = Few<Contact, 8>;

/// Along what two shapes touch.
#[derive(Clone, Copy)]
pub(super) struct Seam {
    /// From A to B.
    pub(super) normal: UnitVec3,
    /// How far the surfaces are in front of what is clipped, raw.
    pub(super) radii: [i64; 2],
    /// What is farther apart does not touch, raw.
    pub(super) margin: i64,
    /// What positions are measured from.
    pub(super) origin: [i64; 3],
}

impl Seam {
    /// With A and B exchanged.
    pub(super) fn flipped(self) -> Self {
        let Self { normal, radii: [a, b], margin, origin } = self;
        Self { normal: -normal, radii: [b, a], margin, origin }
    }

    /// The contact of two points of what is clipped, in the world.
    #[inline]
    pub(super) fn contact<W: Width>(
        &self,
        features: [FeatureId; 2],
        [on_a, on_b]: [[i64; 3]; 2],
        separation: i64,
    ) -> Contact {
        let [up_a, up_b] = self.radii;
        let ahead = |up: i64| if up == 0 { [0; 3] } else { W::scale(self.normal.raw(), up) };
        let [on_a, on_b] = [add(on_a, ahead(up_a)), sub(on_b, ahead(up_b))];
        let [on_a, on_b] = [on_a, on_b].map(|point| Vec3::from_raw(add(self.origin, point)));
        Contact { features, on_a, on_b, separation: Real::from_raw(separation - up_a - up_b) }
    }

    /// The contact of a point of what is clipped of B, that far above A.
    #[inline]
    pub(super) fn above<W: Width>(
        &self,
        features: [FeatureId; 2],
        on_b: [i64; 3],
        separation: i64,
    ) -> Contact {
        let on_a = sub(on_b, W::scale(self.normal.raw(), separation));
        self.contact::<W>(features, [on_a, on_b], separation)
    }

    /// The contact of the nearest points of two cores.
    pub(super) fn nearest<W: Width>(
        &self,
        features: [FeatureId; 2],
        nearest: &ClosestConvex,
    ) -> Contact {
        let on = [nearest.on_a.raw(), nearest.on_b.raw()];
        let separation = W::round(W::along(self.normal, sub(on[1], on[0])));
        self.contact::<W>(features, on, separation)
    }
}

/// Where two outlines touch. Where they do not lie over one another, though the shapes are nearer
/// than the margin along the normal, it is where they are deepest; or if they are apart, where they
/// are nearest.
pub(super) fn patch<W: Width>(
    seam: &Seam,
    [a, b]: [&Outline; 2],
    nearest: impl FnOnce() -> Option<ClosestConvex>,
) -> Option<Manifold> {
    let mut contacts = clip::<W>(seam, [a, b]);
    let (corner, reach) = b.lowest::<W>(seam.normal);
    let deepest = W::round(reach - a.reach::<W>(seam.normal));
    if contacts.is_empty()
        && deepest > 0
        && let Some(nearest) = nearest()
    {
        let seam = Seam { normal: nearest.normal, ..*seam };
        let contact = seam.nearest::<W>([a.face, b.face], &nearest);
        let is_near = contact.separation.raw() <= seam.margin;
        return Manifold::new(seam.normal, is_near.then_some(contact).as_slice());
    }
    if deepest <= 0 || contacts.is_empty() {
        // It may have slipped past a side, or touch though the normal, which is rounded, parts it.
        let deepest = seam.above::<W>([a.face, corner.name], corner.at, deepest);
        keep_deepest(&mut contacts, deepest);
    }
    reduce(seam.normal, &contacts)
}

/// Adds the contact that is known to be the deepest, unless one is as deep; and leaves out what is
/// deeper still, which is wrong: a face so steep that the rounding of its normal shows.
pub(super) fn keep_deepest(contacts: &mut Contacts, deepest: Contact) {
    let above = |contact: &Contact| contact.separation.raw() - deepest.separation.raw();
    if contacts.iter().all(|contact| !(-TIE..=TIE).contains(&above(contact))) {
        let is_other = |kept: &&Contact| kept.features != deepest.features && above(kept) > 0;
        *contacts = contacts.iter().filter(is_other).copied().collect();
        contacts.push(deepest);
    } else if contacts.iter().any(|contact| above(contact) < -TIE) {
        *contacts = contacts.iter().filter(|kept| above(kept) >= -TIE).copied().collect();
    }
}
