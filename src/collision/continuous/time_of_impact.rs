//! First contacts.

use alloc::vec::Vec;

use crate::collision::FeatureId;
use crate::geometry::sweep::Impact;
use crate::math::Unit;

/// That two moving shapes may touch, not before when, and with what.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct TimeOfImpact {
    /// They do not touch before, as a fraction of the step in 0..=1; see
    /// [`Impact::time`](crate::geometry::sweep::Impact::time).
    pub time: Unit,
    /// What may touch then, of A and of B, sorted: vertices and faces, two edges; or two faces that
    /// meet from the start.
    pub features: Vec<[FeatureId; 2]>,
    /// Whether a search has ended before it was certain: then the time may be much too early.
    pub is_cut: bool,
}

impl TimeOfImpact {
    /// What is known when a search begins: no contact up to the end.
    pub(super) const fn none() -> Self {
        Self { time: Unit::ONE, features: Vec::new(), is_cut: false }
    }

    /// Takes in a contact, if there is one, unless it is later than what has been found.
    pub(super) fn add(&mut self, impact: Option<Impact>, features: [FeatureId; 2]) {
        let Some(Impact { time, is_cut, .. }) = impact.filter(|impact| impact.time <= self.time)
        else {
            return;
        };
        if time < self.time {
            self.features.clear();
            self.is_cut = false;
        }
        self.time = time;
        self.features.push(features);
        self.is_cut |= is_cut;
    }

    /// All contacts, if there are any, each once.
    pub(super) fn found(mut self) -> Option<Self> {
        self.features.sort_unstable();
        self.features.dedup();
        (!self.features.is_empty()).then_some(self)
    }
}
