//! Where two shapes touch, or nearly do.

use super::FeatureId;
use crate::math::{Real, UnitVec3, Vec3};

/// One point of contact: a point of either shape, and how far apart they are along the normal.
///
/// Where surfaces of triangles are deep in one another, one of the points is a vertex or a place
/// where they intersect. The other is before it along the normal, in the plane up to which its
/// shape reaches there: on the shape if that is flat, as faces of boxes are, else before it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Contact {
    /// The feature of A and that of B which make the contact. Unique in its manifold.
    pub features: [FeatureId; 2],
    /// The point on A, metres.
    pub on_a: Vec3,
    /// The point on B, metres.
    pub on_b: Vec3,
    /// From A to B along the normal, metres; negative where they overlap.
    pub separation: Real,
}

/// All points of contact of a patch: up to four that share a normal.
///
/// Points are sorted by their features, never by position or depth: it is the order in which they
/// are relaxed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Manifold {
    /// From A to B.
    pub normal: UnitVec3,
    contacts: [Contact; Self::CONTACTS_MAX],
    len: u8,
}

impl Manifold {
    /// The most points.
    pub const CONTACTS_MAX: usize = 4;

    /// The manifold of some points, at least one and at most
    /// [`CONTACTS_MAX`](Self::CONTACTS_MAX), which it sorts. `None` of none.
    #[must_use]
    pub(super) fn new(normal: UnitVec3, contacts: &[Contact]) -> Option<Self> {
        let mut all = [*contacts.first()?; Self::CONTACTS_MAX];
        debug_assert!(contacts.len() <= all.len(), "Manifold: more than four points");
        let (used, _) = all.split_at_mut_checked(contacts.len())?;
        used.copy_from_slice(contacts);
        used.sort_unstable_by_key(|contact| contact.features);
        let first = used[0];
        all[contacts.len()..].fill(first);
        // At most 4.
        let len = contacts.len() as u8;
        Some(Self { normal, contacts: all, len })
    }

    /// The points, sorted by their features; at least one.
    #[inline]
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts[..usize::from(self.len)]
    }

    /// The smallest separation of its points.
    #[must_use]
    pub fn separation(&self) -> Real {
        let smallest = |least: Real, contact: &Contact| least.min(contact.separation);
        self.contacts().iter().fold(self.contacts[0].separation, smallest)
    }

    /// The same manifold with A and B exchanged.
    #[must_use]
    pub fn flipped(&self) -> Self {
        let flip = |contact: Contact| {
            let Contact { features: [a, b], on_a, on_b, separation } = contact;
            Contact { features: [b, a], on_a: on_b, on_b: on_a, separation }
        };
        let mut flipped = Self { normal: -self.normal, ..*self };
        flipped.contacts = self.contacts.map(flip);
        flipped.contacts[..usize::from(self.len)].sort_unstable_by_key(|c| c.features);
        // What is unused repeats the first, so that equal manifolds are equal.
        let first = flipped.contacts[0];
        flipped.contacts[usize::from(self.len)..].fill(first);
        flipped
    }
}
