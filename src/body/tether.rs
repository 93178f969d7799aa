//! Long-range attachments.

use alloc::collections::BinaryHeap;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;

use super::Assembly;
use crate::constraint::{Distance, DistanceForm};
use crate::math::Real;

/// A rope from every particle to the pinned one that is nearest along the distances, as long as
/// that way (Kim, Chentanez and Mueller, *Long Range Attachments*, 2012): what hangs cannot
/// stretch, in one relaxation. Particles that no pinned one holds get none, nor do those whose way
/// is longer than a distance can be. O(n log n).
pub(super) fn tethers(assembly: &Assembly) -> Vec<Distance> {
    let count = assembly.particles.len();
    let mut neighbours = vec![Vec::new(); count];
    for Distance { a, b, rest_length, .. } in &assembly.distances {
        neighbours[a.0.slot()].push((b.0.index, *rest_length));
        neighbours[b.0.slot()].push((a.0.index, *rest_length));
    }
    let mut nearest: Vec<Option<(Real, u32)>> = vec![None; count];
    let pinned = (0u32..).zip(&assembly.particles).filter(|(_, spec)| spec.particle.pinned);
    // Dijkstra from all pinned particles at once; ties go to the lower anchor, then particle.
    let mut open: BinaryHeap<_> =
        pinned.map(|(place, _)| Reverse((Real::ZERO, place, place))).collect();
    while let Some(Reverse((way, anchor, place))) = open.pop() {
        if nearest[place as usize].is_some() {
            continue;
        }
        nearest[place as usize] = Some((way, anchor));
        for &(next, length) in &neighbours[place as usize] {
            let further = way + length; // at most two lengths
            if further <= Distance::REST_LENGTH_MAX && nearest[next as usize].is_none() {
                open.push(Reverse((further, anchor, next)));
            }
        }
    }
    let tether = |(place, nearest): (u32, &Option<(Real, u32)>)| {
        let (way, anchor) = (*nearest)?;
        let rope = Distance::rope(Assembly::id(anchor), Assembly::id(place), way);
        (way > Real::ZERO).then(|| rope.form(DistanceForm::DivisionFree))
    };
    (0u32..).zip(&nearest).filter_map(tether).collect()
}
