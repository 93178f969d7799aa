//! What a world can be set to.

use serde::{Deserialize, Serialize};

use crate::constraint::{HalfSpace, ITERATIONS_MAX};
use crate::math::wide::{dot_wide, round_div, round_div_wide, to_i64};
use crate::math::{Real, Vec3};
use crate::particle::{
    DISPLACEMENT_LIMIT, Pace, Particle, RangeError, acceleration, check_in, check_within,
};
use crate::real;

/// Configuration of a world: state that only [`Action::Configure`](super::Action::Configure)
/// changes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct WorldConfig {
    /// Ticks per second, 1 to 1,000. Default 60. Velocities survive a change, rounded once.
    pub tick_rate: u32,
    /// Substeps per tick, 1 to 64. Default 4: better than more iterations at the same cost.
    pub substeps: u32,
    /// Relaxations per substep, 1 to 64. Default 1.
    pub iterations: u32,
    /// m/s^2, each component within +-1,000. Default (0, -9.81, 0).
    pub gravity: Vec3,
    /// Share of its velocity that a particle loses in a second, as a rate: 0 to 1,000 per second,
    /// at most `tick_rate`. Default 0.
    pub damping: Real,
    /// Metres that a particle may move along each axis in one substep, more than 0, at most 64.
    /// Default 64. What would go further is cut, keeping its direction, with an event.
    pub displacement_max: Real,
    /// How the air moves, m/s, each component within +-1,000: it drags faces along. Default 0.
    pub wind: Vec3,
}

impl WorldConfig {
    /// Greatest tick rate.
    pub const TICK_RATE_MAX: u32 = 1000;
    /// Greatest number of substeps.
    pub const SUBSTEPS_MAX: u32 = 64;
    /// Greatest component of gravity.
    pub const GRAVITY_MAX: Real = Real::from_int(1000);
    /// Greatest component of the wind.
    pub const WIND_MAX: Real = Real::from_int(1000);
    /// Greatest displacement in a substep.
    pub const DISPLACEMENT_MAX: Real = Real::from_raw(DISPLACEMENT_LIMIT);

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { tick_rate, substeps, iterations, gravity, damping, .. } = self;
        let Self { displacement_max, wind, .. } = self;
        check_in(*tick_rate, 1..=Self::TICK_RATE_MAX, "tick_rate")?;
        check_in(*substeps, 1..=Self::SUBSTEPS_MAX, "substeps")?;
        check_in(*iterations, 1..=ITERATIONS_MAX, "iterations")?;
        check_within(*gravity, Self::GRAVITY_MAX.raw(), "gravity")?;
        let whole = Real::from_raw(i64::from(*tick_rate) << Real::FRACTION_BITS);
        check_in(*damping, Real::ZERO..=whole, "damping")?;
        check_in(*displacement_max, Real::ULP..=Self::DISPLACEMENT_MAX, "displacement_max")?;
        check_within(*wind, Self::WIND_MAX.raw(), "wind")
    }

    /// Substeps per second.
    pub(crate) const fn pace(&self) -> Pace {
        Pace::new(self.tick_rate * self.substeps) // at most 64,000
    }

    /// Share of the displacement that a substep loses, 32 fractional bits, at most 1.
    pub(crate) fn damping_per_substep(&self) -> u64 {
        let rate = i64::from(self.tick_rate * self.substeps);
        // damping <= 2^34 raw: 42 bits.
        let shift = 32 - Real::FRACTION_BITS;
        round_div(self.damping.raw() << shift, rate).unsigned_abs()
    }

    /// Approaches to a surface slower than this do not bounce, raw units a substep: what the
    /// particle's acceleration makes in two ticks, `2 |n.a| dt h`.
    pub(crate) fn bounce_min(&self, particle: &Particle, surface: &HalfSpace) -> i64 {
        // 31 + 59 bits; the acceleration has 16 more fractional bits than a position, n has 30.
        let along = dot_wide(surface.normal.raw(), self.acceleration(particle)).abs();
        let per_second_sq = i128::from(self.tick_rate).pow(2) * i128::from(self.substeps);
        to_i64(round_div_wide(2 * along, per_second_sq << (30 + 16)))
    }

    /// The acceleration of a particle under this gravity; none if it cannot move.
    pub(crate) fn acceleration(&self, particle: &Particle) -> [i64; 3] {
        let free = particle.is_movable();
        if free { acceleration(particle, self.gravity.raw()) } else { [0; 3] }
    }
}

impl Default for WorldConfig {
    fn default() -> Self {
        Self {
            tick_rate: 60,
            substeps: 4,
            iterations: 1,
            gravity: Vec3::new(Real::ZERO, real!("-9.81"), Real::ZERO),
            damping: Real::ZERO,
            displacement_max: Self::DISPLACEMENT_MAX,
            wind: Vec3::ZERO,
        }
    }
}
