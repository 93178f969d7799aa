//! Ways out of a surface.

use alloc::vec::Vec;

use super::feet::{Feet, Foot};
use super::manifolds::grown;
use super::near::Near;
use super::proximity::{Proximity, along};
use super::{DEPTH_MAX, REACH_MAX};
use crate::collision::FeatureId;
use crate::geometry::{Aabb, Surface};
use crate::math::wide::{dot_wide, sub};
use crate::math::{Real, UnitVec3, Vec3};

/// A plane: what is in front of it is out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exit {
    pub(super) outward: UnitVec3,
    pub(super) place: Vec3,
    /// Of the surface.
    pub(super) feature: FeatureId,
}

/// So many places are tried, before the box around the surface.
pub(super) const TRIES_MAX: usize = 16;

/// Of so many the depth is looked at.
const LOOKS_MAX: usize = 256;

impl Exit {
    /// Of a contact of something inside.
    pub(super) fn of_contact(Proximity { normal, contact }: &Proximity) -> Self {
        Self { outward: -*normal, place: contact.on_b, feature: contact.features[1] }
    }

    /// Of a place to which something inside is nearest.
    fn of_foot(foot: &Foot) -> Self {
        Self { outward: -foot.normal, place: foot.position, feature: foot.feature }
    }

    /// The way out of a closed one-sided surface for what is in a box, of which a point is inside:
    /// through a place behind which this point is. Of the first 256, from near to far, up to 16 are
    /// tried: those that are no deeper than the way out of the box around the surface, and
    /// shallower than those that were found. It is the one that `leads_out` and has the least
    /// `depth`, or else the way out of the box. `None` if the point is behind no place within
    /// [`REACH_MAX`].
    ///
    /// What is nearest may not lead out: another shell may be there, or not enough room.
    pub(super) fn of_inside<S: Surface>(
        surface: &S,
        point: Vec3,
        body: &Aabb,
        depth: impl Fn(&Self) -> Real,
        leads_out: impl Fn(&Self) -> bool,
    ) -> Option<Self> {
        let (mut feet, mut names) = (Feet::default(), Vec::new());
        let bounds = surface.bounds();
        let (mut least, outward, place) = out_of(&bounds, body);
        let mut reach = Real::from_raw(least.raw() >> 6).clamp(DEPTH_MAX, REACH_MAX);
        let (mut seen, mut tries, mut looks) = (Real::ZERO, 0, 0);
        let mut best: Option<Self> = None;
        loop {
            let around = grown(&Aabb::of_point(point), reach);
            surface.faces_near(&around, &mut names);
            let faces: Vec<_> = names.iter().map(|&face| Near::of(surface, face)).collect();
            let feet = feet.of_inside(surface, point, faces.iter(), reach).iter();
            for exit in feet.filter(|foot| -foot.separation > seen).map(Self::of_foot) {
                let way = best.get_or_insert(Self { outward, place, ..exit });
                if tries == TRIES_MAX || looks == LOOKS_MAX {
                    return best;
                }
                looks += 1;
                let depth = depth(&exit);
                if depth <= least {
                    tries += 1;
                    if leads_out(&exit) {
                        (*way, least) = (exit, depth - Real::ULP);
                    }
                }
            }
            let is_tired = tries == TRIES_MAX || looks == LOOKS_MAX;
            let is_done = is_tired || best.is_some() && reach >= least;
            if is_done || reach == REACH_MAX || around.contains(&bounds) {
                return best;
            }
            seen = reach;
            reach = (reach + reach).min(REACH_MAX);
        }
    }

    /// The shortest way out of the box around a surface for what is in a box.
    pub(super) fn of_bounds<S: Surface>(surface: &S, body: &Aabb, feature: FeatureId) -> Self {
        let (_, outward, place) = out_of(&surface.bounds(), body);
        Self { outward, place, feature }
    }

    /// How far behind it a point is. Both are within 2^60.
    pub(super) fn depth(&self, point: Vec3) -> Real {
        along(self.outward, sub(self.place.raw(), point.raw()))
    }
}

/// The least depth, and the plane, of all sides of a box around another one; of equal ones the
/// first, x before y and the upper before the lower.
fn out_of(bounds: &Aabb, body: &Aabb) -> (Real, UnitVec3, Vec3) {
    let ways = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z].map(|axis| {
        let up = along(axis, sub(bounds.max().raw(), body.min().raw()));
        let down = along(axis, sub(body.max().raw(), bounds.min().raw()));
        if down < up { (down, -axis, bounds.min()) } else { (up, axis, bounds.max()) }
    });
    let [x, y, z] = ways;
    let least = if y.0 < x.0 { y } else { x };
    if z.0 < least.0 { z } else { least }
}

/// Whether two ways lead against each other.
pub(super) fn is_against(a: UnitVec3, b: UnitVec3) -> bool {
    dot_wide(a.raw(), b.raw()) < 0
}
