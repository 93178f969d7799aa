//! Surfaces that have gone through one another.
//!
//! What is nearest does not tell the way out of a deep overlap: neighbours disagree, and lock. The
//! line in which the surfaces intersect does. Its area, as a vector, is that of A's part inside B,
//! and so the direction in which moving B lessens the volume of the overlap fastest (divergence
//! theorem). All contacts of a component share it, and its depth: the extent along it of the line
//! and of the vertices inside.

mod component;
mod contour;
mod groups;
mod inside;

use alloc::vec::Vec;

use super::DEPTH_MAX;
use super::proximity::Proximity;
use crate::collision::{Contact, FeatureId, FeatureKind};
use crate::geometry::Surface;
use crate::math::{Real, UnitVec3};

use component::components;
use contour::Contour;

/// Parts in which two solids have gone through one another: for each a normal and contacts, and the
/// vertices and edges of both that lie in any, whose proximities mislead.
#[derive(Debug, Default)]
pub(super) struct Tangle {
    pub(super) parts: Vec<(UnitVec3, Vec<Contact>)>,
    /// Sorted, as pairs of which and what: 0 for A, 1 for B.
    drowned: Vec<(u32, FeatureId)>,
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
        if a.is_two_sided() || b.is_two_sided() {
            return tangle;
        }
        let contour = Contour::new(a, b, pairs);
        if contour.links.is_empty() {
            return tangle;
        }
        for component in components(a, b, &contour) {
            let (normal, depth) = component.way_out([a.bounds(), b.bounds()]);
            let own = component.features();
            let told = |p: &Proximity| p.contact.separation <= Real::ZERO && holds(&own, p);
            if depth > DEPTH_MAX || !proximities.iter().any(told) {
                tangle.parts.push((normal, component.contacts(normal, depth)));
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

/// Whether features, which are sorted, hold a vertex of a proximity, or both edges.
fn holds(features: &[(u32, FeatureId)], proximity: &Proximity) -> bool {
    let [a, b] = proximity.contact.features;
    let is_in = |k: u32, feature: FeatureId, kind: FeatureKind| {
        feature.kind() == kind && features.binary_search(&(k, feature)).is_ok()
    };
    let (vertex, edge) = (FeatureKind::Vertex, FeatureKind::Edge);
    is_in(0, a, vertex) || is_in(1, b, vertex) || is_in(0, a, edge) && is_in(1, b, edge)
}
