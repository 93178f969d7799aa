//! The way out for what is round and so deep in a surface that nothing near tells it.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::contains::{is_inside, is_within};
use super::exit::{Exit, TRIES_MAX, is_against};
use super::feet::normal_of;
use super::near::Near;
use super::proximity::{Proximity, scaled};
use super::round::{Round, step};
use super::tangle::beyond;
use crate::collision::{Contact, FeatureId};
use crate::geometry::{
    Surface, Triangle, closest_convex, closest_point_triangle, orient3d, overlap_triangle_triangle,
};
use crate::math::wide::add;
use crate::math::{Real, Vec3};

/// Depths of one plane differ by no more than this.
const ROUNDED: Real = Real::from_raw(2);

impl<S: Surface> Round<'_, S> {
    /// Adds the contact that leads all of it out, where those that were found do not.
    ///
    /// They do where all that is inside has its own nearest way out, and none of these ways leads
    /// against another, or against a face that the segment pierces, or into what is closed. Else,
    /// of all planes in front of which it is free, the one that is reached first leads it, of two
    /// the one of the lower feature: those of the ways that were found, of the faces that are
    /// pierced, and at places near to ends inside of what is closed; or, if there are none
    /// and nothing touches, of faces that it touches from behind. What leads against that way is
    /// left out.
    ///
    /// From what is closed only ways count that [lead all of it out](Self::leads_out).
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
        let is_solid = self.surface.is_closed() && !self.surface.is_two_sided();
        let mut exits: Vec<_> = inside.clone().map(Exit::of_contact).collect();
        let told = exits.len();
        let pierced = self.faces.iter().filter(|near| self.is_pierced(near));
        exits.extend(pierced.flat_map(|near| self.faced(near)).flatten());
        if told > 0 {
            let clash = |one: &Exit| exits.iter().any(|two| is_against(one.outward, two.outward));
            let is_whole = exits.len() > told || self.are_all(inside);
            let misleads = |exit: &Exit| is_solid && !self.leads_out_there(exit);
            if is_whole && !exits[..told].iter().any(|exit| clash(exit) || misleads(exit)) {
                return Vec::new();
            }
        }
        if is_solid {
            exits = self.exits_of_solid(exits);
        }
        if exits.is_empty() && !touches() {
            let touched = self.faces.iter().filter(|near| self.is_touched_from_behind(near));
            exits.extend(touched.flat_map(|near| self.faced(near)).flatten());
        }
        exits
    }

    /// Out of a closed surface: the first of some ways that leads all of it out, and the shortest
    /// that does from each end inside; or, if there are some ways but none of these do, out of the
    /// box around the surface.
    fn exits_of_solid(&self, mut ways: Vec<Exit>) -> Vec<Exit> {
        let body = self.segment.bounds();
        let leads_out = |exit: &Exit| self.leads_out(exit);
        ways.sort_unstable_by_key(|exit| (self.depth(exit), exit.feature));
        let first = ways.iter().copied().take(TRIES_MAX).find(leads_out);
        let ends = self.segment.ends().into_iter().take(self.ends_len());
        let inside = ends.filter(|end| is_inside(self.surface, *end));
        let depth = |exit: &Exit| self.depth(exit);
        let feet =
            inside.filter_map(|end| Exit::of_inside(self.surface, end, &body, depth, leads_out));
        let exits: Vec<_> = first.into_iter().chain(feet).collect();
        match ways.first() {
            Some(way) if exits.is_empty() => {
                vec![Exit::of_bounds(self.surface, &body, way.feature)]
            }
            _ => exits,
        }
    }

    /// Whether the segment in front of a plane meets no face of a closed surface, and is outside.
    fn leads_out(&self, exit: &Exit) -> bool {
        let out = beyond(exit.outward, self.depth(exit) + self.radius);
        // Ends are within 2^60, and move by less than 2^62.
        let [from, to] = self.segment.ends().map(|end| Vec3::from_raw(add(end.raw(), out)));
        let moved = Triangle::between([from, to, to]);
        let mut names = Vec::new();
        self.surface.faces_near(&moved.bounds(), &mut names);
        let meets = |&face: &u32| overlap_triangle_triangle(&self.surface.triangle(face), &moved);
        !names.iter().any(meets) && !is_within(self.surface, from)
    }

    /// Whether what is inside there, and nothing else of it, comes out of a closed surface.
    fn leads_out_there(&self, exit: &Exit) -> bool {
        let out = beyond(exit.outward, self.radius);
        !is_within(self.surface, Vec3::from_raw(add(exit.place.raw(), out)))
    }

    /// How deep the deepest of the segment is behind a plane.
    fn depth(&self, exit: &Exit) -> Real {
        let [from, to] = self.segment.ends().map(|end| exit.depth(end));
        from.max(to)
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
        let Exit { outward, feature, .. } = *exit;
        let ends = self.segment.ends();
        let depths = ends.map(|end| exit.depth(end));
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
