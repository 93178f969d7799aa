//! Contacts one by one, and what is left of many.

use alloc::vec::Vec;

use crate::collision::patch::reduce;
use crate::collision::{Contact, FeatureId, Manifold};
use crate::math::wide::{dot_wide, round_shift_wide, sub, to_i64};
use crate::math::{Real, UnitVec3};

/// A contact with a normal of its own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Proximity {
    /// From A to B.
    pub(super) normal: UnitVec3,
    pub(super) contact: Contact,
}

impl Proximity {
    /// What they are sorted by: features first.
    pub(super) fn key(&self) -> ([FeatureId; 2], Real, UnitVec3) {
        (self.contact.features, self.contact.separation, self.normal)
    }

    /// With A and B exchanged.
    pub(super) fn flipped(self) -> Self {
        let Contact { features: [a, b], on_a, on_b, separation } = self.contact;
        let contact = Contact { features: [b, a], on_a: on_b, on_b: on_a, separation };
        Self { normal: -self.normal, contact }
    }
}

/// The most manifolds of a pair.
const MANIFOLDS_MAX: usize = 8;

/// Normals whose product is above this are one: a cosine of 0.996, 5 degrees.
const LIKE: i128 = (1 << 60) / 1000 * 996;

/// Adds the manifolds of some contacts, of which no two have the same features: those with like
/// normals share one, and of each at most four remain.
///
/// The deepest contact leads the first manifold, then, from deep to shallow, each that is like no
/// leader before leads another. What is like none of eight is dropped: it is shallower than each of
/// these, or as deep as one whose features are lower.
pub(super) fn manifolds(all: &[Proximity], out: &mut Vec<Manifold>) {
    let mut sorted: Vec<_> = all.iter().collect();
    sorted.sort_unstable_by_key(|p| (p.contact.separation, p.contact.features));
    let mut normals: Vec<UnitVec3> = Vec::new();
    let mut members: Vec<Vec<Contact>> = Vec::new();
    for Proximity { normal, contact } in sorted {
        let is_like = |other: &UnitVec3| dot_wide(other.raw(), normal.raw()) > LIKE;
        let place = match normals.iter().position(is_like) {
            Some(place) => place,
            None if normals.len() == MANIFOLDS_MAX => continue,
            None => {
                normals.push(*normal);
                members.push(Vec::new());
                normals.len() - 1
            }
        };
        let separation = if normals[place] == *normal {
            contact.separation
        } else {
            along(normals[place], sub(contact.on_b.raw(), contact.on_a.raw()))
        };
        members[place].push(Contact { separation, ..*contact });
    }
    let first = out.len();
    for (normal, contacts) in normals.into_iter().zip(members) {
        // Features are unique among all contacts of the pair: parts need no names.
        out.extend(reduce(normal, &contacts));
    }
    out[first..].sort_unstable_by_key(|manifold| manifold.contacts()[0].features);
}

/// How far a way leads along a unit vector: exact, rounded once. Ways are below 2^62.
pub(super) fn along(normal: UnitVec3, way: [i64; 3]) -> Real {
    Real::from_raw(to_i64(round_shift_wide(dot_wide(normal.raw(), way), 30)))
}

/// `normal * length`, by components to nearest.
pub(super) fn scaled(normal: UnitVec3, length: Real) -> [i64; 3] {
    let product = |c: i64| i128::from(c) * i128::from(length.raw());
    normal.raw().map(|c| to_i64(round_shift_wide(product(c), 30)))
}
