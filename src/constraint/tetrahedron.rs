//! A volume constraint as the relaxation wants it.
//!
//! ```text
//! C = (x1 - x0) . ((x2 - x0) x (x3 - x0)) - 6 V        g1 = (x2 - x0) x (x3 - x0), ...
//! x_i -= stiffness w_i C g_i / sum w_j |g_j|^2          g0 = -(g1 + g2 + g3)
//! ```
//!
//! (Mueller, Heidelberger, Hennix and Ratcliff, *Position Based Dynamics*, 2007.) Gradients are
//! shortened to 40 bits, a relative error of 2^-40; each correction is rounded once to a position.
//! With four equal masses the last corner takes what the others leave, so that momentum is exact.

use super::volume::Volume;
use crate::math::wide::{
    dot_wide, is_narrow, round_div_wide, round_shift, round_shift_wide, sub, to_i64,
};
use crate::particle::{DISPLACEMENT_LIMIT, Particle};
use crate::store::Table;

/// Fractional bits of weights.
const WEIGHT_BITS: u32 = 30;

/// Bits that are left of the components of gradients.
const GRADIENT_BITS: u32 = 40;

/// Fractional bits of the multiplier, besides those that gradients lost.
const MULTIPLIER_BITS: u32 = 33;

/// A volume constraint, ready to be projected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tetrahedron {
    /// Slots of the corners.
    pub(super) corners: [u32; 4],
    /// Inverse masses by the greatest of them, 0 to 2^30.
    weights: [i64; 4],
    /// Six times the volume, below 2^100.
    rest: i128,
    /// 0 to 2^30.
    stiffness: i64,
}

impl Tetrahedron {
    /// The working copy of a constraint, or `None` if it cannot move anything.
    pub(crate) fn of(volume: &Volume, particles: &Table<Particle>) -> Option<Self> {
        let mut corners = [None; 4];
        for (corner, id) in corners.iter_mut().zip(volume.corners) {
            *corner = particles.get(id.0).filter(|particle| particle.enabled);
        }
        let [Some(a), Some(b), Some(c), Some(d)] = corners else { return None };
        let corners = [a, b, c, d];
        let movable = corners.iter().filter(|corner| corner.is_movable());
        let lightest = movable.map(|corner| corner.mass.raw()).min()?;
        let weights = corners.map(|corner| {
            let lightest = i128::from(lightest) << WEIGHT_BITS; // 44 + 30 bits
            let weight = round_div_wide(lightest, i128::from(corner.mass.raw()));
            if corner.is_movable() { to_i64(weight) } else { 0 }
        });
        let stiffness = i64::from(volume.stiffness.raw());
        let corners = volume.corners.map(|id| id.0.index);
        let rest = volume.rest_sextuple();
        (volume.enabled && stiffness > 0).then_some(Self { corners, weights, rest, stiffness })
    }

    /// Projects the constraint once.
    pub(crate) fn relax(&self, position: &mut [[i64; 3]]) {
        let now = self.corners.map(|slot| position[slot as usize]);
        let Some(moves) = self.correct(now) else { return };
        for (slot, by) in self.corners.into_iter().zip(moves) {
            for (x, by) in position[slot as usize].iter_mut().zip(by) {
                *x += by; // below 2^60.9, see VOLUMES_MAX
            }
        }
    }

    /// What is added to the corners: at most 3 * 2^30 along each axis.
    fn correct(&self, corners: [[i64; 3]; 4]) -> Option<[[i64; 3]; 4]> {
        let [e1, e2, e3] = edges(corners)?;
        let (g1, g2, g3) = (cross(e2, e3), cross(e3, e1), cross(e1, e2));
        let g0 = [0, 1, 2].map(|k| -(g1[k] + g2[k] + g3[k])); // below 2^62.6
        let exact = dot_wide(e1, g1) - self.rest;
        // No more than a volume that can be there.
        let error = exact.clamp(-(1 << 93), 1 << 93);
        let gradients = [g0, g1, g2, g3];
        let longest = gradients.iter().flatten().map(|c| c.unsigned_abs()).max().unwrap_or(0);
        let lost = (u64::BITS - longest.leading_zeros()).saturating_sub(GRADIENT_BITS); // <= 23
        let shorten = |c: i64| if lost > 0 { round_shift(c, lost) } else { c };
        let gradients = gradients.map(|g| g.map(shorten));
        // 4 * 3 * 2^(80 + 30)
        let sum: i128 = self
            .weights
            .iter()
            .zip(&gradients)
            .map(|(&weight, &gradient)| i128::from(weight) * dot_wide(gradient, gradient))
            .sum();
        let sum = sum >> WEIGHT_BITS;
        if sum == 0 {
            return None;
        }
        // C 2^33 / sum, for C / 2^lost times 2^(33 + lost): 126 bits.
        let multiplier = round_div_wide(error << MULTIPLIER_BITS, sum);
        let scaled =
            [0, 1, 2, 3].map(|k| gradients[k].map(|c| i128::from(self.weights[k]) * i128::from(c)));
        let shift = WEIGHT_BITS + MULTIPLIER_BITS + lost; // at most 86
        // All corners together, so that a cut keeps momentum: 30 + 86 bits over at most 70.
        let farthest = scaled.iter().flatten().map(|c| c.abs()).max().unwrap_or(0).max(1);
        let limit = ((i128::from(DISPLACEMENT_LIMIT) << shift) / farthest).min(1 << 56);
        let multiplier = multiplier.clamp(-limit, limit) * i128::from(self.stiffness);
        let multiplier = round_shift_wide(multiplier, WEIGHT_BITS);
        // 30 + 40 + 56 bits; at most DISPLACEMENT_LIMIT.
        let mut moves = scaled.map(|g| g.map(|c| to_i64(-round_shift_wide(c * multiplier, shift))));
        if self.weights == [1 << WEIGHT_BITS; 4] {
            moves[3] = [0, 1, 2].map(|k| -(moves[0][k] + moves[1][k] + moves[2][k]));
        }
        Some(moves)
    }
}

/// The edges from the first corner, components at most 2^30; `None` if one is longer.
pub(super) fn edges([x0, x1, x2, x3]: [[i64; 3]; 4]) -> Option<[[i64; 3]; 3]> {
    let edges = [sub(x1, x0), sub(x2, x0), sub(x3, x0)];
    edges.iter().all(|&edge| is_narrow(edge)).then_some(edges)
}

/// Of vectors whose components are at most 2^30: components at most 2^61.
pub(super) fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Pcg;

    /// Four corners within 2^bits.
    fn corners(random: &mut Pcg, bits: u32) -> [[i64; 3]; 4] {
        [(); 4].map(|()| {
            [(); 3].map(|()| i64::from(random.next_u32() >> (32 - bits)) - (1 << (bits - 1)))
        })
    }

    #[test]
    fn projections_reach_the_volume_and_keep_momentum() {
        let mut random = Pcg::new(3, 0);
        let mut near = 0;
        for case in 0..2000 {
            let bits = 12 + case % 18;
            let corners = corners(&mut random, bits);
            let volume = super::super::volume::sextuple(corners).expect("within 64 m");
            let rest = volume + volume / 64;
            let corner_slots = [0, 1, 2, 3];
            let stiffness = 1 << 30;
            let equal =
                Tetrahedron { corners: corner_slots, weights: [1 << 30; 4], rest, stiffness };
            let mut moved = corners;
            equal.relax(&mut moved);
            let sum = |all: [[i64; 3]; 4]| [0, 1, 2].map(|k| all.iter().map(|x| x[k]).sum::<i64>());
            assert_eq!(sum(moved), sum(corners), "momentum");
            let left = super::super::volume::sextuple(moved).expect("within 64 m") - rest;
            // Newton's method on a cubic: what is left is of second order, but for flat ones.
            near += u32::from(left.abs() * 8 < (volume - rest).abs());
        }
        assert!(near > 1700, "{near} of 2000 came near");
    }

    #[test]
    fn the_hostile_is_bounded() {
        let mut random = Pcg::new(4, 0);
        for case in 0..5000 {
            let corners = corners(&mut random, 2 + case % 29);
            let weights = [(); 4].map(|()| i64::from(random.next_u32() >> 2 >> random.below(31)));
            let rest = (i128::from(random.next_u64()) - (1 << 63)) << random.below(36);
            let tetrahedron =
                Tetrahedron { corners: [0, 1, 2, 3], weights, rest, stiffness: 1 << 30 };
            if let Some(moves) = tetrahedron.correct(corners) {
                assert!(moves.iter().flatten().all(|by| by.abs() <= 3 << 30));
            }
        }
    }
}
