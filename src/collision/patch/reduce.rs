//! Few points that hold as many do.

use super::TIE;
use crate::collision::few::Few;
use crate::collision::{Contact, Manifold};
use crate::math::wide::{dot_wide, round_shift_wide, sub};
use crate::math::{UnitVec3, Vec3};

/// What is closer to the rest than this adds nothing, raw: 0.5 mm.
pub(in crate::collision) const NEAR_SQ: i128 = 1 << 26;

/// At most four of some contacts: the deepest, the one farthest from it, the one that makes the
/// largest triangle with both, and the one that adds most to that. Of equal ones the deeper, then
/// the one with lower features.
pub(in crate::collision) fn reduce(normal: UnitVec3, contacts: &[Contact]) -> Option<Manifold> {
    if contacts.len() <= Manifold::CONTACTS_MAX {
        return Manifold::new(normal, contacts);
    }
    let first = deepest(contacts)?;
    let shadow = Shadow::new(normal);
    let area = |p: &Contact, q: &Contact, r: &Contact| shadow.area([p, q, r].map(|c| c.on_a));
    let mut kept: Few<_, 4> = [first].into_iter().collect();
    let spread = |next: &Contact| flat_length_sq(normal, sub(next.on_a.raw(), first.on_a.raw()));
    if let Some(second) = best(contacts, spread) {
        kept.push(second);
        if let Some(third) = best(contacts, |next| area(&first, &second, next).abs()) {
            kept.push(third);
            let turn = area(&first, &second, &third).signum();
            let sides = [(first, second), (second, third), (third, first)];
            kept.extend(best(contacts, |next| {
                sides.iter().fold(0, |most, (p, q)| most.max(-turn * area(p, q, next)))
            }));
        }
    }
    Manifold::new(normal, &kept)
}

/// Of those that are as deep as any, up to noise, the one with the lowest features.
fn deepest(contacts: &[Contact]) -> Option<Contact> {
    let least = contacts.iter().map(|contact| contact.separation).min()?;
    let deep = contacts.iter().filter(|contact| contact.separation.raw() <= least.raw() + TIE);
    deep.min_by_key(|contact| contact.features).copied()
}

/// The contact with the greatest score, if that is worth a point.
fn best(contacts: &[Contact], score: impl Fn(&Contact) -> i128) -> Option<Contact> {
    let (_, best) = contacts
        .iter()
        .map(|contact| (score(contact), contact))
        .filter(|&(score, _)| score >= NEAR_SQ)
        .reduce(|best, next| {
            let rank =
                |(score, contact): (i128, &Contact)| (-score, contact.separation, contact.features);
            if rank(next) < rank(best) { next } else { best }
        })?;
    Some(*best)
}

/// The square of the part of `d` that is at right angles to the normal. Points of a mesh are within
/// 2^61 of one another along each axis: below 2^124.
fn flat_length_sq(normal: UnitVec3, d: [i64; 3]) -> i128 {
    let along = round_shift_wide(dot_wide(normal.raw(), d), 30);
    dot_wide(d, d) - along * along
}

/// Points of a plane as they are seen along the axis that is closest to its normal: all areas are
/// smaller by one factor.
struct Shadow([usize; 2]);

impl Shadow {
    fn new(normal: UnitVec3) -> Self {
        let [x, y, z] = normal.raw().map(i64::abs);
        Self(if x >= y.max(z) {
            [1, 2]
        } else if y >= z {
            [2, 0]
        } else {
            [0, 1]
        })
    }

    /// Twice the area of a triangle; its sign tells which way it turns. Below 2^124.
    #[inline]
    fn area(&self, [p, q, r]: [Vec3; 3]) -> i128 {
        let Self([u, v]) = *self;
        let [p, q, r] = [p, q, r].map(Vec3::raw);
        let [a, b] = [u, v].map(|k| i128::from(q[k] - p[k]));
        let [c, d] = [u, v].map(|k| i128::from(r[k] - p[k]));
        a * d - b * c
    }
}
