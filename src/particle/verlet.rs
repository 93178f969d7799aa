//! Verlet integration, exact where exactness is cheap.
//!
//! ```text
//! x' = x + (x - x_prev) - damping + a h^2          (Verlet 1967; Jakobsen 2003)
//! start: x - x_prev = v h - a h^2 / 2              (without the last term: 38 mm wrong in 2 s)
//! ```
//!
//! **No remainder is lost.** `a h^2` is a few thousand raw units, so rounding it alike in every
//! substep loses 9 mm in a fall of 2 s at 8 substeps. Instead substep `n` adds
//! `R(a (n+1) / D) - R(a n / D)`, with `R` the one rounding rule and `D = 1 / h^2`: the sum after
//! any number of substeps is the exact sum, rounded once. The only state this needs is the counter
//! `n` (the *phase*), for every particle with whatever gravity scale and acceleration.
//!
//! **Small velocities are damped too.** `k |d|` below half a unit would round to nothing and leave
//! up to 17 mm/s undamped for ever. The loss is `floor(k |d| + u)`, with `u` in [0, 1) a sequence
//! that is spread evenly over the substeps (Weyl's, by the golden ratio): exact on average, odd in
//! `d`, and the same for all particles.

use alloc::vec::Vec;

use super::{DISPLACEMENT_LIMIT, Particle, ParticleId, ParticleSet, WORLD_LIMIT};
use crate::math::wide::{add, round_div, round_div_wide, sub, to_i32, to_i64};
use crate::math::{Real, Vec3};

/// Accelerations carry 16 more fractional bits than a [`Real`]: gravity scales have 16.
const ACCELERATION_SHIFT: u32 = 16;

/// Substeps per second: all that integration must know of time.
///
/// At most 64,000, so that `R^2` fits 32 bits and `D = R^2 2^16` fits 48.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Pace {
    per_second: u32,
}

/// An acceleration in 2^-40 m/s^2, at most 2^58 in magnitude.
pub(crate) type Acceleration = [i64; 3];

/// Something that the limits of a world stopped.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Fault {
    /// The displacement of a substep was cut to the configured maximum.
    DisplacementClamped,
    /// The particle reached the limit of the world and was stopped there.
    WorldLimit,
}

/// Where a pinned particle has to be at the end of the tick.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct PinMotion {
    /// The particle.
    pub(crate) particle: ParticleId,
    /// The position to reach, raw.
    pub(crate) target: [i64; 3],
}

/// What every particle of one substep shares.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Substep {
    /// Substeps per second.
    pub(crate) pace: Pace,
    /// Which substep this is, counted modulo [`Pace::phases`].
    pub(crate) phase: u64,
    /// Gravity in raw units, each component at most 1,000 m/s^2.
    pub(crate) gravity: [i64; 3],
    /// Share of the displacement that damping takes, 32 fractional bits, at most 1.
    pub(crate) damping: u64,
    /// The greatest displacement, at most [`DISPLACEMENT_LIMIT`].
    pub(crate) displacement_max: i64,
}

impl Pace {
    /// `per_second` substeps a second, 1 to 64,000.
    #[must_use]
    pub(crate) const fn new(per_second: u32) -> Self {
        Self { per_second }
    }

    /// Substeps a second.
    #[must_use]
    pub(crate) const fn per_second(self) -> u32 {
        self.per_second
    }

    /// `D`: phases repeat after so many substeps.
    #[must_use]
    pub(crate) const fn phases(self) -> u64 {
        (self.per_second as u64).pow(2) << ACCELERATION_SHIFT
    }

    /// What `acceleration` adds to the displacement in the substep of this `phase`.
    pub(crate) fn fall(self, acceleration: Acceleration, phase: u64) -> [i64; 3] {
        let phases = i128::from(self.phases());
        // |a| <= 2^58 and n < 2^48: the product has 106 bits.
        let total = |a: i64, n: u64| round_div_wide(i128::from(a) * i128::from(n), phases);
        // The difference is a / D within 1, below 2^43.
        acceleration.map(|a| to_i64(total(a, phase + 1) - total(a, phase)))
    }

    /// The displacement with which a particle of this velocity starts, or `None` beyond `limit`.
    pub(crate) fn start(
        self,
        velocity: [i64; 3],
        acceleration: Acceleration,
        limit: i64,
    ) -> Option<[i32; 3]> {
        let rate = i128::from(self.per_second);
        let mut out = [0; 3];
        for (out, (v, a)) in out.iter_mut().zip(velocity.into_iter().zip(acceleration)) {
            // v h - a h^2 / 2 = (2 R v - a) / (2 R^2); 2 R v in 2^-40 has 63 + 17 + 16 bits.
            let numerator = ((2 * rate * i128::from(v)) << ACCELERATION_SHIFT) - i128::from(a);
            let raw = round_div_wide(numerator, 2 * i128::from(self.phases()));
            let raw = i32::try_from(raw).ok().filter(|d| i64::from(*d).abs() <= limit)?;
            *out = raw;
        }
        Some(out)
    }

    /// The displacement of a start from rest, `-a h^2 / 2`: at most 2^41.
    fn rest(self, acceleration: Acceleration) -> [i64; 3] {
        // |a| <= 2^58, over at least 2^17.
        let twice = 2 * i128::from(self.phases());
        acceleration.map(|a| to_i64(round_div_wide(-i128::from(a), twice)))
    }

    /// The velocity at the end of a substep that moved by `displacement`: `d / h + a h / 2`.
    pub(crate) fn velocity(self, displacement: [i32; 3], acceleration: Acceleration) -> Vec3 {
        let rate = i128::from(self.per_second);
        let component = |d: i32, a: i64| {
            // (2 R^2 d + a) / (2 R) with d in 2^-40: 31 + 33 + 16 bits; the quotient has 48.
            let numerator = 2 * i128::from(self.phases()) * i128::from(d) + i128::from(a);
            to_i64(round_div_wide(numerator, (2 * rate) << ACCELERATION_SHIFT))
        };
        let [dx, dy, dz] = displacement;
        let [ax, ay, az] = acceleration;
        Vec3::from_raw([component(dx, ax), component(dy, ay), component(dz, az)])
    }

    /// The displacement that an impulse makes, cut to the length `2^40` of its longest component.
    pub(crate) fn kick(self, impulse: [i64; 3], mass: Real) -> [i64; 3] {
        // dv / R with dv = J / m: (J 2^24) / (m R); J 2^24 has 87 bits.
        let divisor = i128::from(mass.raw()) * i128::from(self.per_second);
        let kick = impulse.map(|j| round_div_wide(i128::from(j) << Real::FRACTION_BITS, divisor));
        let bound = 1 << 40;
        let longest = kick[0].abs().max(kick[1].abs()).max(kick[2].abs()).max(bound);
        // Masses are above 2^14 raw, so a kick is below 2^73: 113 bits, and at most 2^40 again.
        kick.map(|k| to_i64(round_div_wide(k * bound, longest)))
    }

    /// The displacement, at pace `to` and under `after`, of the velocity that `displacement` is at
    /// this pace under `before`: within 2^60.
    pub(crate) fn convert(
        self,
        displacement: [i32; 3],
        before: Acceleration,
        to: Self,
        after: Acceleration,
    ) -> [i64; 3] {
        // Without what a start from rest has: v h, below 2^43.
        let steady = sub(displacement.map(i64::from), self.rest(before));
        let (from_rate, to_rate) = (i64::from(self.per_second), i64::from(to.per_second));
        let scaled = steady.map(|d| round_div(d * from_rate, to_rate)); // 43 + 16 bits
        add(scaled, to.rest(after))
    }
}

/// The acceleration of a particle: its share of gravity and its own.
pub(crate) fn acceleration(particle: &Particle, gravity: [i64; 3]) -> Acceleration {
    let own = particle.acceleration.raw();
    let scale = i64::from(particle.gravity_scale.raw());
    // |g| <= 1,000 m/s^2 = 2^34, scale <= 2^20, own <= 100,000 m/s^2 < 2^41: below 2^58.
    [0, 1, 2].map(|k| gravity[k] * scale + (own[k] << ACCELERATION_SHIFT))
}

impl ParticleSet {
    /// Moves every particle by its displacement, damping and acceleration; `start` receives the
    /// positions before the move. Displacements themselves are settled by [`Self::close`].
    pub(crate) fn integrate(
        &mut self,
        substep: &Substep,
        drive: &[Drive],
        start: &mut Vec<[i64; 3]>,
        mut report: impl FnMut(ParticleId, Fault),
    ) {
        let Self { table, position, displacement } = self;
        start.clone_from(position);
        let gravity = substep.gravity.map(|g| g << ACCELERATION_SHIFT);
        let uniform = substep.pace.fall(gravity, substep.phase);
        let dither = dither(substep.phase);
        let moving = position.iter_mut().zip(displacement).zip(drive);
        for (index, ((position, displacement), drive)) in (0u32..).zip(moving) {
            let fall = match drive {
                Drive::Still => continue,
                Drive::Gravity => uniform,
                Drive::Own => {
                    let own = acceleration(&table.rows()[index as usize], substep.gravity);
                    substep.pace.fall(own, substep.phase)
                }
            };
            let mut motion = [0; 3];
            for k in 0..3 {
                let d = i64::from(displacement[k]);
                // |d| <= 2^30, damping <= 2^32, dither < 2^32: below 2^63.
                let lost = (d.unsigned_abs() * substep.damping + dither) >> 32;
                motion[k] = d - d.signum() * lost.cast_signed() + fall[k];
            }
            if let Some(cut) = clamp_longest(motion, substep.displacement_max) {
                // What is driven is alive.
                if let Some(handle) = table.slots().tenant(index) {
                    report(ParticleId(handle), Fault::DisplacementClamped);
                }
                motion = cut;
            }
            *position = add(*position, motion);
        }
    }

    /// Adds what forces make of this substep: pairs of a slot and an acceleration.
    pub(crate) fn push(&mut self, substep: &Substep, pushes: &[(u32, Acceleration)]) {
        for &(index, acceleration) in pushes {
            let position = &mut self.position[index as usize];
            *position = add(*position, substep.pace.fall(acceleration, substep.phase));
        }
    }

    /// Moves pinned particles their share of the way, `left` substeps before the end of the tick.
    pub(crate) fn move_pins(
        &mut self,
        pins: &[PinMotion],
        left: u32,
        limit: i64,
        mut report: impl FnMut(ParticleId, Fault),
    ) {
        for PinMotion { particle, target } in pins {
            let position = &mut self.position[particle.0.slot()];
            let mut motion = sub(*target, *position).map(|d| round_div(d, i64::from(left)));
            if let Some(cut) = clamp_longest(motion, limit) {
                report(*particle, Fault::DisplacementClamped);
                motion = cut;
            }
            *position = add(*position, motion);
        }
    }

    /// Ends a substep: what each particle moved becomes its displacement, within the limits.
    pub(crate) fn close(
        &mut self,
        start: &[[i64; 3]],
        displacement_max: i64,
        mut report: impl FnMut(ParticleId, Fault),
    ) {
        let Self { table, position, displacement } = self;
        // Only what lives moves, so only what lives can meet a limit.
        let mut report = |index, fault| {
            if let Some(handle) = table.slots().tenant(index) {
                report(ParticleId(handle), fault);
            }
        };
        let all = position.iter_mut().zip(displacement).zip(start);
        for (index, ((position, displacement), start)) in (0u32..).zip(all) {
            let moved = sub(*position, *start);
            let mut kept = moved;
            if let Some(cut) = clamp_longest(moved, displacement_max) {
                report(index, Fault::DisplacementClamped);
                kept = cut;
                *position = add(*start, cut);
            }
            if position.iter().any(|c| c.abs() > WORLD_LIMIT) {
                report(index, Fault::WorldLimit);
                *position = position.map(|c| c.clamp(-WORLD_LIMIT, WORLD_LIMIT));
                kept = [0; 3];
            }
            // Within displacement_max <= 2^30.
            *displacement = kept.map(to_i32);
        }
    }
}

/// Which acceleration drives a particle; derived from its properties.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Drive {
    /// None: the slot is free, or the particle is pinned or disabled.
    Still,
    /// The world's gravity as it is.
    Gravity,
    /// Its own share of gravity, or an acceleration of its own.
    Own,
}

impl Drive {
    pub(crate) fn of(particle: &Particle) -> Self {
        let plain = Particle::default();
        if !particle.is_movable() {
            Self::Still
        } else if particle.gravity_scale == plain.gravity_scale
            && particle.acceleration == plain.acceleration
        {
            Self::Gravity
        } else {
            Self::Own
        }
    }
}

/// Shortens a vector so that its longest component does not exceed `limit`, keeping its direction;
/// `None` if it need not be shortened.
pub(crate) fn clamp_longest(v: [i64; 3], limit: i64) -> Option<[i64; 3]> {
    debug_assert!((0..=DISPLACEMENT_LIMIT).contains(&limit));
    let longest = v[0].abs().max(v[1].abs()).max(v[2].abs());
    // |v| <= 2^62, limit <= 2^30: the product has 92 bits, the quotient is at most the limit.
    let shorten = |c| {
        let product = i128::from(c) * i128::from(limit);
        to_i64(round_div_wide(product, i128::from(longest)))
    };
    (longest > limit).then(|| v.map(shorten))
}

/// `u`, 32 fractional bits: multiples of the golden ratio modulo 1.
fn dither(phase: u64) -> u64 {
    // Only the low 32 bits count, and a product's low bits wrap alike on every target.
    phase.wrapping_mul(0x9E37_79B9) & 0xFFFF_FFFF
}
