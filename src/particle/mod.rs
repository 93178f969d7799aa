//! Floor 3: particles and their motion.
//!
//! A particle is a point with a mass. Its motion is kept as a position and the displacement of the
//! last substep, which is all that Verlet integration needs: there is no velocity to disagree with.
//!
//! | array | unit | range |
//! |---|---|---|
//! | position | metres, 24 fractional bits in `i64` | +-2^36 m ([`WORLD_LIMIT`]) |
//! | displacement | metres a substep, likewise in `i32` | +-64 m ([`DISPLACEMENT_LIMIT`]) |

mod attributes;
mod range;
mod set;
mod verlet;

pub use attributes::{Particle, ParticleSpec};
pub use range::{RangeError, RangeFault};
pub(crate) use range::{check, check_in, check_not_negative, check_within, within};
pub use set::{ParticleId, ParticleSet};
pub(crate) use verlet::{Drive, Fault, Pace, PinMotion, Substep, acceleration, clamp_longest};

/// No position component leaves +-2^36 m (raw: 2^60). Sums of three such numbers fit 64 bits.
pub const WORLD_LIMIT: i64 = 1 << 60;

/// No displacement component of one substep exceeds 64 m (raw: 2^30), so that it fits 32 bits and
/// products of two of them fit 62.
pub const DISPLACEMENT_LIMIT: i64 = 1 << 30;

/// The most particle slots a world may have: 2^22.
// While fuzzing fewer, so that no world takes long.
pub const PARTICLES_MAX: usize = if cfg!(fuzzing) { 1 << 12 } else { 1 << 22 };
