//! Parts of an overlap that proximities tell of.

use alloc::vec::Vec;

use crate::collision::surface::proximity::Proximity;
use crate::collision::{FeatureId, FeatureKind};
use crate::math::Real;

/// The features of all proximities that are not apart.
pub(super) struct Told {
    /// Vertices of A (0) and of B (1), sorted.
    vertices: Vec<(u32, FeatureId)>,
    /// Edges of A with those of B, sorted.
    edges: Vec<[FeatureId; 2]>,
}

impl Told {
    pub(super) fn of(proximities: &[Proximity]) -> Self {
        let mut told = Self { vertices: Vec::new(), edges: Vec::new() };
        for Proximity { contact, .. } in proximities {
            if contact.separation <= Real::ZERO {
                let features = (0..).zip(contact.features);
                let kinds = contact.features.map(FeatureId::kind);
                told.vertices.extend(features.filter(|(_, f)| f.kind() == FeatureKind::Vertex));
                if kinds == [FeatureKind::Edge; 2] {
                    told.edges.push(contact.features);
                }
            }
        }
        told.vertices.sort_unstable();
        told.edges.sort_unstable();
        told
    }

    /// Whether any is of some features, which are sorted: of a vertex, or of both edges.
    pub(super) fn tell_of(&self, features: &[(u32, FeatureId)]) -> bool {
        features.iter().any(|feature| match feature.1.kind() {
            FeatureKind::Vertex => self.vertices.binary_search(feature).is_ok(),
            _ => feature.0 == 0 && self.tell_of_edge(feature.1, features),
        })
    }

    /// Whether any is of this edge of A and an edge of B among the features.
    fn tell_of_edge(&self, edge: FeatureId, features: &[(u32, FeatureId)]) -> bool {
        let first = self.edges.partition_point(|pair| pair[0] < edge);
        let mut same = self.edges[first..].iter().take_while(|pair| pair[0] == edge);
        same.any(|pair| features.binary_search(&(1, pair[1])).is_ok())
    }
}
