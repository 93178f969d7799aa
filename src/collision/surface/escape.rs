//! The way out for what is round and so deep in a surface that nothing near tells it.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::DEPTH_MAX;
use super::contains::is_within;
use super::feet::{Foot, normal_of};
use super::near::Near;
use super::proximity::{Proximity, along, scaled};
use super::round::{Round, step};
use crate::collision::{Contact, FeatureId};
use crate::geometry::{
    Surface, Triangle, closest_convex, closest_point_triangle, orient3d, overlap_triangle_triangle,
};
use crate::math::wide::{dot_wide, sub};
use crate::math::{Real, UnitVec3, Vec3};

/// A plane: what is in front of it is out.
#[derive(Clone, Copy, Debug)]
struct Exit {
    outward: UnitVec3,
    place: Vec3,
    feature: FeatureId,
}

/// Depths of one plane differ by no more than this.
const ROUNDED: Real = Real::from_raw(2);

impl Exit {
    /// Of a place to which something inside is nearest.
    fn of_foot(foot: &Foot) -> Self {
        Self { outward: -foot.normal, place: foot.position, feature: foot.feature }
    }

    /// Of a contact of something inside.
    fn of_contact(Proximity { normal, contact }: &Proximity) -> Self {
        Self { outward: -*normal, place: contact.on_b, feature: contact.features[1] }
    }
}

impl<S: Surface> Round<'_, S> {
    /// Adds the contact that leads all of it out, where those that were found do not.
    ///
    /// They do where all that is inside has its own nearest way out, and none of these ways leads
    /// against another, or against a face that the segment pierces. Else, of all planes in front of
    /// which it is free, the one that is reached first leads it, of two the one of the lower
    /// feature: those of the ways that were found, of the faces that are pierced, and at the
    /// nearest places to ends inside of what is closed; or, if there are none and nothing touches,
    /// of faces that it touches from behind. What leads against that way is left out.
    pub(super) fn escape(&self, found: &mut Vec<Proximity>) {
        let is_inside = |proximity: &Proximity| proximity.contact.separation < -self.radius;
        let ways = self.exits(found.iter().filter(|proximity| is_inside(proximity)), || {
            found.iter().any(|proximity| proximity.contact.separation <= Real::ZERO)
        });
        let ways = ways.iter().map(|exit| self.way_out(exit));
        let depth = |way: &Proximity| (-way.contact.separation, way.contact.features[1]);
        let Some(way) = ways.min_by_key(depth) else { return };
        let [end, _] = way.contact.features;
        found.retain(|other| {
            let is_of_end = self.surface.is_two_sided() && other.contact.features[0] == end;
            other.contact.features != way.contact.features
                && !(is_against(other.normal, way.normal) && (is_of_end || is_inside(other)))
        });
        // One of those found may say the same of another part.
        let is_same = |other: &Proximity| {
            let above = other.contact.separation - way.contact.separation;
            other.normal == way.normal && above <= ROUNDED
        };
        if !found.iter().any(is_same) {
            found.push(way);
        }
    }

    /// All ways out, if one is wanted beside those `inside`.
    fn exits<'b>(
        &self,
        inside: impl Iterator<Item = &'b Proximity> + Clone,
        touches: impl FnOnce() -> bool,
    ) -> Vec<Exit> {
        let mut exits: Vec<_> = inside.clone().map(Exit::of_contact).collect();
        let told = exits.len();
        let pierced = self.faces.iter().filter(|near| self.is_pierced(near));
        exits.extend(pierced.flat_map(|near| self.faced(near)).flatten());
        if told > 0 {
            let clash = |one: &Exit| exits.iter().any(|two| is_against(one.outward, two.outward));
            let is_whole = exits.len() > told || self.are_all(inside);
            if is_whole && !exits[..told].iter().any(clash) {
                return Vec::new();
            }
        } else if exits.is_empty() && touches() {
            return exits;
        }
        if self.surface.is_closed() && !self.surface.is_two_sided() {
            let ends = self.segment.ends().into_iter().take(self.ends_len());
            let inside = ends.filter(|end| is_within(self.surface, *end));
            let feet = inside
                .filter_map(|end| Foot::of_inside(self.surface, end, self.reach.max(DEPTH_MAX)));
            exits.extend(feet.map(|foot| Exit::of_foot(&foot)));
        }
        if exits.is_empty() {
            let touched = self.faces.iter().filter(|near| self.is_touched_from_behind(near));
            exits.extend(touched.flat_map(|near| self.faced(near)).flatten());
        }
        exits
    }

    /// Whether contacts of something inside are of every end, or of what is between them.
    fn are_all<'b>(&self, inside: impl Iterator<Item = &'b Proximity> + Clone) -> bool {
        let names = &self.names[..self.ends_len()];
        let mut inside = inside.map(|proximity| proximity.contact.features[0]);
        names.iter().all(|name| inside.clone().any(|own| own == *name))
            || inside.any(|own| !names.contains(&own))
    }

    /// How many ends there are: 1 if both are one point.
    fn ends_len(&self) -> usize {
        let [from, to] = self.segment.ends();
        if from == to { 1 } else { 2 }
    }

    /// To the front of a face, and of a two-sided one to its back.
    fn faced(&self, near: &Near) -> [Option<Exit>; 2] {
        let place = closest_point_triangle(self.segment.ends()[0], &near.triangle).position;
        let feature = FeatureId::face(near.face);
        let front =
            normal_of(self.surface, near.face).map(|outward| Exit { outward, place, feature });
        let back = front.filter(|_| self.surface.is_two_sided());
        [front, back.map(|exit| Exit { outward: -exit.outward, ..exit })]
    }

    /// The contact of the end that is deepest behind a plane.
    fn way_out(&self, exit: &Exit) -> Proximity {
        let Exit { outward, place, feature } = *exit;
        let ends = self.segment.ends();
        let depths = ends.map(|end| along(outward, sub(place.raw(), end.raw())));
        let deepest = usize::from(depths[1] > depths[0]);
        let (end, depth) = (ends[deepest], depths[deepest]);
        let contact = Contact {
            features: [self.names[deepest], feature],
            on_a: step(end, -outward, self.radius),
            on_b: end + Vec3::from_raw(scaled(outward, depth)),
            separation: -depth - self.radius,
        };
        Proximity { normal: -outward, contact }
    }

    /// On which side of a face each end is.
    fn heights(&self, near: &Near) -> [Ordering; 2] {
        let [a, b, c] = *near.triangle.corners();
        self.segment.ends().map(|end| orient3d(a, b, c, end))
    }

    /// Whether the segment goes through a face, from one side to the other or to its plane.
    fn is_pierced(&self, near: &Near) -> bool {
        if !near.bounds.overlaps(&self.segment.bounds()) {
            return false;
        }
        let heights = self.heights(near);
        let [from, to] = self.segment.ends();
        heights[0] != heights[1]
            && (self.surface.is_two_sided() || heights.contains(&Ordering::Less))
            && overlap_triangle_triangle(&near.triangle, &Triangle::between([from, to, to]))
    }

    /// Whether it overlaps a face behind which an end of it is.
    fn is_touched_from_behind(&self, near: &Near) -> bool {
        near.is_near(&self.segment.bounds(), self.radius)
            && self.heights(near).contains(&Ordering::Less)
            && {
                let (ends, corners) = (self.segment.ends(), near.triangle.corners());
                closest_convex(&ends, corners, Vec3::ZERO, self.radius).is_none()
            }
    }
}

/// Whether two ways lead against each other.
fn is_against(a: UnitVec3, b: UnitVec3) -> bool {
    dot_wide(a.raw(), b.raw()) < 0
}
