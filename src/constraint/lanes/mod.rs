//! The division-free form, four links or eight at a time.
//!
//! Positions are 32-bit differences from an anchor (`local.rs`), one particle in four lanes of
//! which the last is 0. The four links of a batch share no movable particle. Whatever the
//! processor, the result is what `Link::correct` gives, to the bit.

#[cfg(any(test, not(all(target_arch = "x86_64", target_feature = "sse2"))))]
mod portable;
#[cfg(test)]
mod tests;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
mod x86;

#[cfg(not(all(target_arch = "x86_64", target_feature = "sse2")))]
use portable as processor;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use x86 as processor;

use alloc::vec::Vec;

use super::correction::lane_gain;
use super::curve::Scale;
use super::link::Link;

/// A position: x, y, z, 0.
pub(super) type Place = [i32; 4];

/// Links of one shift that share no movable particle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Group {
    /// Rods whose ends take equal shares.
    Even(u32, Vec<Batch>),
    /// Everything else.
    Uneven(u32, Vec<UnevenBatch>),
}

/// Four rods whose ends take equal shares.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Batch {
    /// Where the ends are among the positions.
    pub(super) a: [u32; 4],
    pub(super) b: [u32; 4],
    /// [`Scale::inverse`].
    pub(super) inverse: [u32; 4],
    /// The share of either end, 32 fractional bits.
    pub(super) gain: [u32; 4],
}

/// Four rods or ropes with any gains.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct UnevenBatch {
    /// Ends, scale, and the shares of the first ends.
    pub(super) even: Batch,
    /// The shares of the second ends.
    pub(super) gain_b: [u32; 4],
    /// All ones if the link may push its ends apart.
    pub(super) push: [u32; 4],
}

/// A link of the division-free form, and where its particles are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lane {
    places: [u32; 2],
    gains: [i32; 2],
    scale: Scale,
    push: bool,
}

impl Lane {
    /// The lane of a rod or a rope.
    pub(super) fn of(link: &Link, places: [u32; 2]) -> Self {
        let Link { gains, shortest, longest, .. } = *link;
        Self { places, gains, scale: Scale::of(longest), push: shortest > 0 }
    }

    /// Which group of its colour it belongs to.
    fn key(&self) -> (u32, bool) {
        let even = self.push && self.gains[0] == self.gains[1];
        (self.scale.shift, !even)
    }
}

/// The groups of the lanes of one colour.
pub(super) fn groups(lanes: &mut [Lane]) -> impl Iterator<Item = Group> {
    lanes.sort_by_key(Lane::key);
    lanes.chunk_by(|a, b| a.key() == b.key()).map(|lanes| match lanes[0].key() {
        (shift, false) => Group::Even(shift, lanes.chunks(4).map(even).collect()),
        (shift, true) => Group::Uneven(shift, lanes.chunks(4).map(uneven).collect()),
    })
}

/// Lanes without a link repeat the first and take no share.
fn even(lanes: &[Lane]) -> Batch {
    let mut batch = Batch::default();
    for k in 0..4 {
        let lane = lanes.get(k).unwrap_or(&lanes[0]);
        [batch.a[k], batch.b[k]] = lane.places;
        batch.inverse[k] = lane.scale.inverse;
        batch.gain[k] = lanes.get(k).map_or(0, |lane| lane_gain(lane.gains[0]));
    }
    batch
}

fn uneven(lanes: &[Lane]) -> UnevenBatch {
    let mut batch = UnevenBatch { even: even(lanes), ..UnevenBatch::default() };
    for (k, lane) in lanes.iter().enumerate() {
        batch.gain_b[k] = lane_gain(lane.gains[1]);
        batch.push[k] = if lane.push { u32::MAX } else { 0 };
    }
    batch
}

/// Projects all links of some groups, one group after the other.
pub(super) fn relax(groups: &[Group], places: &mut [Place]) {
    for group in groups {
        match group {
            Group::Even(shift, batches) => processor::relax_even(*shift, batches, places),
            Group::Uneven(shift, batches) => processor::relax_uneven(*shift, batches, places),
        }
    }
}
