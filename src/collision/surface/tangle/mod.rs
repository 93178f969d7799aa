//! Surfaces that have gone through one another.
//!
//! What is nearest does not tell the way out of a deep overlap: neighbours disagree, and lock. The
//! line in which the surfaces intersect does. Its area, as a vector, is that of A's part inside B,
//! and so the direction in which moving B lessens the volume of the overlap fastest (divergence
//! theorem). Around it are directions that lead out sooner: normals of the faces that the line goes
//! through. All contacts of a component share the direction, and its depth is the extent along it
//! of the line and of the vertices inside.
//!
//! What has no inside may have it on either side: of both, the side from which the way is shorter.
//!
//! Where an edge meets an edge or a vertex, what goes in and what comes out cannot be told apart.
//! Then one surface is looked at a few micrometres beside where it is.

mod component;
mod contour;
mod groups;
mod inside;
mod told;
mod view;
mod way;
mod wholes;

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use super::DEPTH_MAX;
use super::proximity::Proximity;
use crate::collision::{Contact, FeatureId, FeatureKind};
use crate::geometry::{Aabb, Surface, is_in_range};
use crate::math::{Real, UnitVec3, Vec3};

use component::{Component, components};
use contour::Contour;
use groups::Groups;
use told::Told;
use view::View;
use way::{Way, way_out};
use wholes::Wholes;

pub(super) use way::beyond;

/// Raw: up to 10 micrometres.
const SHIFT: [i64; 3] = [3, 23, 167];

/// Parts in which two surfaces have gone through one another: for each a normal and contacts, and
/// the vertices and edges of both that lie in any, whose proximities mislead.
#[derive(Debug, Default)]
pub(super) struct Tangle {
    pub(super) parts: Vec<(UnitVec3, Vec<Contact>)>,
    /// Sorted, as pairs of which and what: 0 for A, 1 for B.
    drowned: Vec<(u32, FeatureId)>,
    /// The faces of A and of B at which they intersect in lines, sorted.
    pub(super) rims: [Vec<u32>; 2],
}

impl Tangle {
    /// Of pairs of faces, of which some may intersect. Parts no deeper than [`DEPTH_MAX`] are left
    /// to the proximities, if they have any.
    pub(super) fn new<A: Surface, B: Surface>(
        (a, b): (&A, &B),
        pairs: &[[u32; 2]],
        proximities: &[Proximity],
    ) -> Self {
        let mut tangle = Self::default();
        let (a, mut b) = (View::new(a), View::new(b));
        let mut contour = Contour::new(&a, &b, pairs);
        if contour.is_degenerate {
            b.shift = shift(&a, &b, pairs);
            contour = Contour::new(&a, &b, pairs);
        }
        if contour.links.is_empty() {
            return tangle;
        }
        tangle.rims = contour.rims();
        let told = Told::of(proximities);
        for (component, way) in parts(a, b, &contour) {
            let own = component.features();
            if way.depth > DEPTH_MAX || !told.tell_of(&own) {
                tangle.parts.push((way.normal, component.contacts(&way)));
                tangle.drowned.extend(own);
            }
        }
        tangle.drowned.sort_unstable();
        tangle
    }

    /// Whether a proximity is one of a part that has contacts of its own.
    pub(super) fn covers(&self, proximity: &Proximity) -> bool {
        holds(&self.drowned, proximity)
    }
}

/// How far B is looked at beside where it is: the opposite if the surfaces are exchanged, unless
/// both are alike there. Nothing, where that is out of range.
///
/// It is within no plane whose normal is three whole numbers up to 3: those in which the surfaces
/// of what stands on a grid lie.
fn shift<A: Surface, B: Surface>(a: &A, b: &B, pairs: &[[u32; 2]]) -> Vec3 {
    let corners = |bounds: &Aabb| [bounds.min(), bounds.max()];
    let ends = [corners(&a.bounds()), corners(&b.bounds())];
    let is_first = if ends[0] == ends[1] {
        let of_a = pairs.iter().map(|&[face, _]| *a.triangle(face).corners());
        let of_b = pairs.iter().map(|&[_, face]| *b.triangle(face).corners());
        of_a.min() < of_b.min()
    } else {
        ends[0] < ends[1]
    };
    let sign = if is_first { 1 } else { -1 };
    let shift = Vec3::from_raw(SHIFT.map(|c| sign * c));
    let is_possible = ends[1].into_iter().all(|corner| is_in_range(corner + shift));
    if is_possible { shift } else { Vec3::ZERO }
}

/// The components of a contour, and their ways out.
///
/// Where a surface has no inside, what belongs together depends on which side is taken for it.
/// Where components that differ share lines, those are taken whose deepest is least.
fn parts<A: Surface, B: Surface>(
    a: View<A>,
    b: View<B>,
    contour: &Contour,
) -> Vec<(Component, Way)> {
    let mut groups = Groups::new(contour.knots.len());
    let mut found = Vec::new();
    let mut wholes_a = Wholes::new(a);
    let mut wholes_b = Wholes::new(View { shift: Vec3::ZERO, ..b });
    for turns in 0..4 {
        let [turn_a, turn_b] = [turns & 1 == 1, turns & 2 == 2];
        if turn_a && !a.is_two_sided() || turn_b && !b.is_two_sided() {
            continue;
        }
        let (a, b) = (View { is_turned: turn_a, ..a }, View { is_turned: turn_b, ..b });
        for component in components(&a, &b, contour) {
            let way = way_out((&a, &b), &component, (&mut wholes_a, &mut wholes_b));
            let knots = component.knots.iter().map(|knot| contour.place(knot));
            let first = knots.reduce(|first, knot| {
                groups.join(first, knot);
                first
            });
            found.push((first.unwrap_or(0), turns, component, way));
        }
    }
    let mut deepest: BTreeMap<(u32, u32), Real> = BTreeMap::new();
    for (knot, turns, _, way) in &mut found {
        *knot = groups.root(*knot);
        let depth = deepest.entry((*knot, *turns)).or_insert(way.depth);
        *depth = way.depth.max(*depth);
    }
    let mut least: BTreeMap<u32, (Real, u32)> = BTreeMap::new();
    for ((knot, turns), depth) in deepest {
        let least = least.entry(knot).or_insert((depth, turns));
        *least = (depth, turns).min(*least);
    }
    found.retain(|(knot, turns, ..)| least[knot].1 == *turns);
    found.into_iter().map(|(.., component, way)| (component, way)).collect()
}

/// Whether features, which are sorted, hold a vertex of a proximity, or both edges.
fn holds(features: &[(u32, FeatureId)], proximity: &Proximity) -> bool {
    let [a, b] = proximity.contact.features;
    let is_in = |k: u32, feature: FeatureId, kind: FeatureKind| {
        feature.kind() == kind && features.binary_search(&(k, feature)).is_ok()
    };
    let (vertex, edge) = (FeatureKind::Vertex, FeatureKind::Edge);
    is_in(0, a, vertex) || is_in(1, b, vertex) || is_in(0, a, edge) && is_in(1, b, edge)
}
