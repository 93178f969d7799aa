//! The relaxation's working copy of the constraints: a cache.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::colour::{OVERFLOW, colour};
use super::correction::Link;
use super::distance::{Distance, DistanceForm};
use crate::math::wide::{round_div_wide, to_i32, to_i64};
use crate::particle::Particle;
use crate::store::Table;

/// All active distance constraints, sorted by colour, then by slot.
///
/// A function of the constraints and of the particles' properties, rebuilt when either changes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Plan {
    links: Vec<Link>,
    /// Where each colour ends in `links`.
    ends: Vec<u32>,
    /// How many of the constraints, active or not, have a carry.
    carried: usize,
}

impl Plan {
    pub(crate) fn new(distances: &Table<Distance>, particles: &Table<Particle>) -> Self {
        // Those that nothing moves have no link, but keep their place among the carries.
        let mut carried = 0;
        let numbered = |(_, distance): (_, &Distance)| {
            let carry = carried;
            carried += u32::from(distance.is_carried());
            link(distance, carry, particles)
        };
        let links: Vec<Link> = distances.iter().filter_map(numbered).collect();
        let movable = |link: &Link| {
            let end = |k: usize| (link.gains[k] > 0).then_some(link.ends[k]);
            [end(0), end(1)]
        };
        let movable: Vec<_> = links.iter().map(movable).collect();
        let colours = colour(&movable, particles.rows().len());
        Self::sorted(&links, &colours, carried as usize)
    }

    /// Counting sort by colour; stable, so that slots stay in order.
    fn sorted(links: &[Link], colours: &[u8], carried: usize) -> Self {
        let mut ends = vec![0_u32; usize::from(OVERFLOW) + 1];
        for &colour in colours {
            ends[usize::from(colour)] += 1;
        }
        let mut sum = 0;
        let mut next = ends.clone();
        for (next, end) in next.iter_mut().zip(&mut ends) {
            *next = sum;
            sum += *end;
            *end = sum;
        }
        let form = DistanceForm::Exact;
        let empty = Link { ends: [0; 2], gains: [0; 2], rest_length: 0, carry: 0, form };
        let mut sorted = vec![empty; links.len()];
        for (link, &colour) in links.iter().zip(colours) {
            let place = &mut next[usize::from(colour)];
            sorted[*place as usize] = *link;
            *place += 1;
        }
        Self { links: sorted, ends, carried }
    }

    /// All links, colour by colour.
    pub(crate) fn links(&self) -> &[Link] {
        &self.links
    }

    /// How many carries the state must hold.
    pub(crate) fn carried(&self) -> usize {
        self.carried
    }

    /// The colours in order: where their links are, and whether no two share a movable end.
    pub(crate) fn colours(&self) -> impl Iterator<Item = (Range<usize>, bool)> {
        let mut start = 0;
        self.ends.iter().enumerate().filter_map(move |(colour, &end)| {
            let links = start..end as usize;
            start = links.end;
            (!links.is_empty()).then_some((links, colour < usize::from(OVERFLOW)))
        })
    }
}

/// The working copy of one constraint, or `None` if it cannot move anything.
fn link(distance: &Distance, carry: u32, particles: &Table<Particle>) -> Option<Link> {
    let Distance { a, b, rest_length, stiffness, form, enabled, user: _ } = *distance;
    let (particle_a, particle_b) = (particles.get(a.0)?, particles.get(b.0)?);
    if !(enabled && particle_a.enabled && particle_b.enabled) {
        return None;
    }
    let gains = gains([particle_a, particle_b], i64::from(stiffness.raw()));
    let moves = gains.iter().any(|&gain| gain > 0);
    let ends = [a.0.index, b.0.index];
    moves.then_some(Link { ends, gains, rest_length: rest_length.raw(), carry, form })
}

/// What each end takes of an error: `stiffness w_i / W`, where `w_a / W = m_b / (m_a + m_b)`.
///
/// Exact from the masses and rounded once. The lightest against the heaviest particle gives one
/// unit of 2^30; only with a stiffness below a half is that rounded to nothing.
fn gains(ends: [&Particle; 2], stiffness: i64) -> [i32; 2] {
    // Masses are at most 2^44 raw, the stiffness 2^30: 74 bits; a gain is at most 2^30.
    let masses = ends.map(|end| i128::from(end.mass.raw()));
    let share = |mine: usize, other: usize| match (ends[mine].pinned, ends[other].pinned) {
        (true, _) => 0,
        (false, true) => to_i32(stiffness),
        (false, false) => {
            let numerator = i128::from(stiffness) * masses[other];
            to_i32(to_i64(round_div_wide(numerator, masses[0] + masses[1])))
        }
    };
    [share(0, 1), share(1, 0)]
}
