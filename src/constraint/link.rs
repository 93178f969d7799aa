//! A distance constraint as the relaxation wants it.

use super::curve::LENGTHS;
use super::distance::{Distance, DistanceForm};
use crate::math::wide::{round_div_wide, to_i32, to_i64};
use crate::particle::Particle;
use crate::store::Table;

/// Fractional bits of gains.
pub(super) const GAIN_BITS: u32 = 30;

/// Fractional bits of [`Link::give`].
pub(super) const GIVE_BITS: u32 = 16;

/// No link gives more: its gains are then below half a unit.
const GIVE_MAX: i128 = 1 << (GIVE_BITS + 31);

/// A distance constraint, ready to be projected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Link {
    /// Slots of the two particles.
    pub(crate) ends: [u32; 2],
    /// Share of the error that each end takes, 0 to 2^30.
    pub(crate) gains: [i32; 2],
    /// Whether anything can move the ends: others may, even where the gain is rounded to 0.
    pub(crate) free: [bool; 2],
    /// The range of the distance: 0 to 2^34 raw, the greater not 0.
    pub(crate) shortest: i64,
    pub(crate) longest: i64,
    /// `a / (h^2 W)`, the compliance by that of the particles; 16 fractional bits, at most 2^47.
    pub(crate) give: i64,
    /// Where the carry of a start-of-step link, or what a compliant link has taken, is kept.
    pub(crate) memory: u32,
    pub(crate) form: DistanceForm,
}

impl Link {
    /// The working copy of a constraint, or `None` if it cannot move anything.
    pub(super) fn of(
        distance: &Distance,
        particles: &Table<Particle>,
        per_second: u32,
    ) -> Option<Self> {
        let Distance { a, b, rest_length, slack, stiffness, compliance, .. } = *distance;
        let Distance { form, enabled, tear_strain: _, toughness: _, damage: _, user: _, .. } =
            *distance;
        let (particle_a, particle_b) = (particles.get(a.0)?, particles.get(b.0)?);
        if !(enabled && particle_a.enabled && particle_b.enabled) {
            return None;
        }
        let ends = [particle_a, particle_b];
        let give = give(ends, i128::from(compliance.raw()), per_second);
        let gains = gains(ends, i128::from(stiffness.raw()), i128::from(give));
        let longest = rest_length.raw();
        let shortest = longest - slack.raw();
        let plain = give == 0 && (shortest == longest || shortest == 0);
        let form = match form {
            DistanceForm::DivisionFree if plain && LENGTHS.contains(&longest) => form,
            DistanceForm::DivisionFree => DistanceForm::Exact,
            _ if give > 0 => DistanceForm::Exact,
            _ => form,
        };
        let free = ends.map(Particle::is_movable);
        let ends = [a.0.index, b.0.index];
        let moves = gains.iter().any(|&gain| gain > 0);
        moves.then_some(Self { ends, gains, free, shortest, longest, give, memory: 0, form })
    }

    /// The ends that can move.
    pub(super) fn movable(&self) -> [Option<u32>; 2] {
        let end = |k: usize| self.free[k].then_some(self.ends[k]);
        [end(0), end(1)]
    }
}

/// `a R^2 m`, with `m` the reduced mass of the ends, or the mass of the only movable one.
fn give(ends: [&Particle; 2], compliance: i128, per_second: u32) -> i64 {
    let [a, b] = ends.map(|end| i128::from(end.mass.raw()));
    let mass = match ends.map(|end| end.pinned) {
        [false, false] => round_div_wide(a * b, a + b), // 88 over 45 bits
        [false, true] => a,
        [true, _] => b,
    };
    // Compliance 30 bits, R^2 at most 2^32, mass at most 2^44: 106 bits; 30 + 24 are fractional.
    let exact = compliance * i128::from(per_second).pow(2) * mass;
    to_i64((exact >> (30 + 24 - GIVE_BITS)).min(GIVE_MAX))
}

/// What each end takes of an error: `stiffness w_i / (W + a / h^2)`, where `w_a / W = m_b / (m_a +
/// m_b)`.
///
/// Exact from the masses and rounded once. The lightest against the heaviest particle gives one
/// unit of 2^30; only with a stiffness below a half is that rounded to nothing.
fn gains(ends: [&Particle; 2], stiffness: i128, give: i128) -> [i32; 2] {
    let masses = ends.map(|end| i128::from(end.mass.raw()));
    let one = 1 << GIVE_BITS;
    // Masses have 44 bits, the stiffness 30, `one + give` at most 48: 90 over 93 bits.
    let share = |numerator: i128, sum: i128| {
        to_i32(to_i64(round_div_wide(stiffness * numerator * one, sum * (one + give))))
    };
    let gain = |mine: usize, other: usize| match (ends[mine].pinned, ends[other].pinned) {
        (true, _) => 0,
        (false, true) => share(1, 1),
        (false, false) => share(masses[other], masses[0] + masses[1]),
    };
    [gain(0, 1), gain(1, 0)]
}
