//! What moving air does to faces.
//!
//! ```text
//! F = drag A (u . n) n         u: wind minus the mean velocity of the corners
//! ```
//!
//! a third of it on each corner. It is evaluated once a tick, from the displacements of its last
//! substep, and acts alike in all substeps of the next: what rounding takes from one it gives to
//! another, so that a breeze that moves nothing by half a unit a substep is felt too.

use alloc::vec::Vec;

use super::Face;
use crate::math::root::root_nearest;
use crate::math::wide::{
    dot_narrow, is_narrow, round_div, round_div_wide, round_shift, round_shift_wide, sub, to_i64,
};
use crate::math::{Factor, Vec3};
use crate::particle::{DISPLACEMENT_LIMIT, Pace, Particle, ParticleSet};
use crate::store::Table;

/// Fractional bits of forces.
const FORCE_BITS: u32 = 32;

/// The greatest force of a face along an axis, 1,024 N.
const FORCE_MAX: i128 = 1 << (FORCE_BITS + 10);

/// Fractional bits of gusts.
const GUST_BITS: u32 = 12;

/// The wind's part of every substep's motion of a particle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gust {
    pub(crate) slot: u32,
    /// Raw units with [`GUST_BITS`] more fractional bits, at most 2^43.
    motion: [i64; 3],
}

impl Gust {
    /// The motion in the substep of this phase; phases repeat after a multiple of 2^16 substeps.
    pub(crate) fn motion(&self, phase: u64) -> [i64; 3] {
        let before = to_i64(i128::from(phase % (1 << GUST_BITS)));
        // 43 + 12 bits
        let until = |c: i64, phase: i64| round_shift(c * phase, GUST_BITS);
        self.motion.map(|c| until(c, before + 1) - until(c, before))
    }
}

/// What the air does in a tick. Scratch.
#[derive(Debug, Default)]
pub(crate) struct Air {
    /// Three times the force on each particle.
    forces: Vec<[i64; 3]>,
}

impl Air {
    /// The motions that a wind gives the particles. O(faces + particles) if a face has drag.
    pub(crate) fn blow(
        &mut self,
        faces: &Table<Face>,
        particles: &ParticleSet,
        wind: Vec3,
        pace: Pace,
        gusts: &mut Vec<Gust>,
    ) {
        gusts.clear();
        let dragged = |(_, face): &(_, &Face)| face.enabled && face.drag > Factor::ZERO;
        let mut dragged = faces.iter().filter(dragged).peekable();
        if dragged.peek().is_none() {
            return;
        }
        self.forces.clear();
        self.forces.resize(particles.position.len(), [0; 3]);
        for (_, face) in dragged {
            let slots = face.corners.map(|corner| corner.0.slot());
            let Some(force) = force(face.drag, slots, particles, wind, pace) else { continue };
            for slot in slots {
                for (sum, part) in self.forces[slot].iter_mut().zip(force) {
                    *sum += part; // at most 2^42 of 2^20 faces
                }
            }
        }
        for (slot, &force) in (0u32..).zip(&self.forces) {
            let particle = &particles.table.rows()[slot as usize];
            if force != [0; 3] && particle.is_movable() {
                gusts.push(Gust { slot, motion: motion(force, particle, pace) });
            }
        }
    }
}

/// The force on a face, 32 fractional bits. None on one that has no area or is wider than 64 m.
fn force(
    drag: Factor,
    slots: [usize; 3],
    particles: &ParticleSet,
    wind: Vec3,
    pace: Pace,
) -> Option<[i64; 3]> {
    let [a, b, c] = slots.map(|slot| particles.position[slot]);
    let (u, v) = (sub(b, a), sub(c, a));
    if !(is_narrow(u) && is_narrow(v)) {
        return None;
    }
    // Twice the area along the normal: components at most 2^61, then 30 bits of them.
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let longest = normal.iter().map(|c| c.unsigned_abs()).max().unwrap_or(0);
    let lost = (u64::BITS - longest.leading_zeros()).saturating_sub(30); // <= 32
    let short = normal.map(|c| if lost > 0 { round_shift(c, lost) } else { c });
    let length = root_nearest(dot_narrow(short, short).cast_unsigned()).cast_signed();
    if length == 0 {
        return None;
    }
    let rate = i64::from(pace.per_second());
    let sum = slots.map(|slot| particles.displacement[slot].map(i64::from));
    // Three times the flow, raw m/s, cut to 2^38: 1,000 m/s of wind, 64 m a substep of the corners.
    let flow = [0, 1, 2].map(|k| {
        let speed = (sum[0][k] + sum[1][k] + sum[2][k]) * rate; // 32 + 16 bits
        (3 * wind.raw()[k] - speed).clamp(-(1 << 38), 1 << 38)
    });
    // 38 + 30 bits over at least 2^29, but for tiny areas
    let along: i128 = (0..3).map(|k| i128::from(flow[k]) * i128::from(short[k])).sum();
    let through = round_div_wide(along, i128::from(length)); // below 2^40
    // drag 16, flow 24 and area 48 fractional bits, and 1/6 for three flows and twice the area.
    let part = i128::from(drag.raw()) * through; // 26 + 40 bits
    let force = short.map(|c| {
        let exact = round_div_wide(part * i128::from(c), 6); // 96 bits
        let force = round_shift_wide(exact, 16 + 24 + 48 - FORCE_BITS - lost);
        to_i64(force.clamp(-FORCE_MAX, FORCE_MAX))
    });
    Some(force)
}

/// `F / (3 m R^2)`: what a third of this force moves the particle in a substep, as [`Gust`] has it.
fn motion(force: [i64; 3], particle: &Particle, pace: Pace) -> [i64; 3] {
    // Force 32, mass 24, position 24 fractional bits: times 2^16, and the gust's.
    let shift = 16 + GUST_BITS;
    let divisor = 3 * i128::from(particle.mass.raw()) * i128::from(pace.per_second()).pow(2);
    let small = i64::try_from(divisor).ok();
    // More is cut at the end of the substep, with an event.
    let limit = i128::from(2 * DISPLACEMENT_LIMIT) << GUST_BITS;
    force.map(|f| {
        let small = small.filter(|_| f.unsigned_abs() < 1 << (62 - shift));
        let motion = match small {
            Some(divisor) => i128::from(round_div(f << shift, divisor)),
            None => round_div_wide(i128::from(f) << shift, divisor), // 62 + 28 bits
        };
        to_i64(motion.clamp(-limit, limit))
    })
}
