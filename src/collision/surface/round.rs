//! Where spheres and capsules touch a surface.

use alloc::vec::Vec;

use super::feet::Feet;
use super::manifolds::grown;
use super::near::{Near, is_near};
use super::proximity::{Proximity, along, manifolds, scaled};
use super::ridges::{Ridge, crossing};
use super::side::{Side, side};
use crate::collision::margin::counted;
use crate::collision::{Contact, FeatureId, Manifold};
use crate::geometry::{
    Aabb, Capsule, Feature, Segment, Sphere, Surface, closest_point_segment, normal_point_segment,
};
use crate::math::wide::sub;
use crate::math::{Real, UnitVec3, Vec3};

/// Adds the manifolds of a sphere and a surface that are nearer than `margin`.
///
/// A center that is inside a one-sided surface is pushed out the nearest way, if that is no longer
/// than radius and margin. Of a surface that [is closed](Surface::is_closed) it is pushed out from
/// whatever depth: the nearest way that ends outside, or, if 16 do not, out of the box around the
/// surface; nothing is farther away than 65,536 m.
///
/// The margin counts as in [`collide`](crate::collision::collide). O(k log k) for k faces near the
/// sphere; where its center is within the bounds of a closed surface, also O(log n) and a little
/// for each face that a ray meets; and if it is inside, O(m log m) for m faces within its depth.
pub fn manifolds_sphere_surface<S: Surface>(
    sphere: &Sphere,
    surface: &S,
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    let round = Round {
        names: [FeatureId::face(0); 2],
        ..Round::new(surface, [sphere.center(); 2], sphere.radius(), margin)
    };
    let mut found = Vec::new();
    round.ball(0, &mut found);
    round.escape(&mut found);
    found.sort_unstable_by_key(Proximity::key);
    manifolds(&found, out);
}

/// Adds the manifolds of a capsule and a surface that are nearer than `margin`.
///
/// An end that is inside a one-sided surface is pushed out the nearest way, if that is no longer
/// than radius and margin.
///
/// Deeper, and where the segment between the ends goes through faces, one contact leads the whole
/// capsule to the front of a plane: of a face that it goes through or, in a surface that
/// [is closed](Surface::is_closed), at a place near to an end inside; of several, where that is
/// nearest, and of a two-sided face to the nearer side. That contact's point of the surface is
/// on this plane, maybe beyond the face. Of a closed surface the segment is outside then, and meets
/// no face: if 16 places do not lead there, it is led out of the box around the surface.
///
/// The margin counts as in [`collide`](crate::collision::collide). O(k log k) for k faces near the
/// capsule; where an end is within the bounds of a closed surface, also O(log n) and a little for
/// each face that a ray meets; and if one is inside, or the segment goes through faces, O(m log m)
/// for m faces within its depth.
pub fn manifolds_capsule_surface<S: Surface>(
    capsule: &Capsule,
    surface: &S,
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    let round = Round::new(surface, capsule.ends(), capsule.radius(), margin);
    let mut found = Vec::new();
    round.ball(0, &mut found);
    if capsule.ends()[0] != capsule.ends()[1] {
        round.ball(1, &mut found);
        round.wire(&mut found);
    }
    round.escape(&mut found);
    found.sort_unstable_by_key(Proximity::key);
    manifolds(&found, out);
}

/// Something round, and the faces near it.
pub(super) struct Round<'a, S> {
    pub(super) surface: &'a S,
    pub(super) segment: Segment,
    pub(super) radius: Real,
    /// From the segment as far as anything touches.
    pub(super) reach: Real,
    pub(super) faces: Vec<Near>,
    /// What its ends are called.
    pub(super) names: [FeatureId; 2],
}

impl<'a, S: Surface> Round<'a, S> {
    fn new(surface: &'a S, ends: [Vec3; 2], radius: Real, margin: Real) -> Self {
        let reach = radius + counted(margin);
        let segment = Segment::between(ends);
        let mut names = Vec::new();
        surface.faces_near(&grown(&segment.bounds(), reach), &mut names);
        let faces = names.into_iter().map(|face| Near::of(surface, face)).collect();
        let names = [0, 1].map(FeatureId::vertex);
        Self { surface, segment, radius, reach, faces, names }
    }

    /// The feet of an end.
    fn ball(&self, end: usize, found: &mut Vec<Proximity>) {
        let center = self.segment.ends()[end];
        let mut feet = Feet::default();
        for foot in feet.of(self.surface, center, self.faces.iter(), self.reach) {
            let contact = Contact {
                features: [self.names[end], foot.feature],
                on_a: step(center, foot.normal, self.radius),
                on_b: foot.position,
                separation: foot.separation - self.radius,
            };
            found.push(Proximity { normal: foot.normal, contact });
        }
    }

    /// Where the inside of the segment is nearest to edges and vertices.
    fn wire(&self, found: &mut Vec<Proximity>) {
        let wire = Ridge { edge: 0, segment: self.segment, bounds: self.segment.bounds() };
        for near in &self.faces {
            for side in near.sides() {
                let ridge = Ridge::of(self.surface, near, side);
                let (a, b) = ((None::<&S>, &wire), (Some(self.surface), &ridge));
                found.extend(crossing(a, b, [self.radius, self.reach]).map(|proximity| {
                    let Proximity { normal, mut contact } = proximity;
                    contact.on_a = step(contact.on_a, normal, self.radius);
                    contact.separation -= self.radius;
                    Proximity { normal, contact }
                }));
            }
            for corner in near.corners() {
                let vertex = self.surface.corners(near.face)[corner];
                found.extend(self.over(vertex, &wire.bounds));
            }
        }
    }

    /// A vertex below the inside of the segment, if no face there is nearer, and seen from outside.
    fn over(&self, vertex: u32, bounds: &Aabb) -> Option<Proximity> {
        let position = self.surface.position(vertex);
        if !is_near(&Aabb::of_point(position), bounds, self.reach) {
            return None;
        }
        let foot = closest_point_segment(position, &self.segment);
        let distance = position.distance(foot.position);
        if foot.feature != Feature::Edge(0) || distance > self.reach {
            return None;
        }
        let outward = normal_point_segment(position, &self.segment, foot.feature)?;
        let mut neighbours = self.surface.faces_at_vertex(vertex).flat_map(|face| {
            self.surface.corners(face).map(|corner| self.surface.position(corner))
        });
        let falls = |end: Vec3| along(outward, sub(end.raw(), position.raw())) <= Real::ZERO;
        let feature = FeatureId::vertex(vertex);
        if !neighbours.all(falls) || side(self.surface, foot.position, feature) == Side::Inside {
            return None;
        }
        let normal = -outward;
        let contact = Contact {
            features: [FeatureId::edge(0), feature],
            on_a: step(foot.position, normal, self.radius),
            on_b: position,
            separation: distance - self.radius,
        };
        Some(Proximity { normal, contact })
    }
}

/// A point moved along a unit vector.
pub(super) fn step(point: Vec3, normal: UnitVec3, length: Real) -> Vec3 {
    point + Vec3::from_raw(scaled(normal, length))
}
