//! What a particle is, apart from where it is.

use serde::{Deserialize, Serialize};

use super::range::{check_in, check_within};
use super::{RangeError, WORLD_LIMIT};
use crate::math::{Factor, Real, Vec3};
use crate::real;

/// The properties of a particle that seldom change.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct Particle {
    /// Kilograms, 0.001 to 1,000,000. Default 1.
    pub mass: Real,
    /// Share of the world's gravity that acts on the particle, -16 to 16. Default 1.
    pub gravity_scale: Factor,
    /// Acceleration of its own, besides gravity, until changed: m/s^2, each component at most
    /// 100,000. Default 0.
    pub acceleration: Vec3,
    /// A pinned particle moves only by [`Action::MovePin`](crate::world::Action::MovePin) and
    /// takes part in constraints as if its mass were infinite. Default `false`.
    pub pinned: bool,
    /// A disabled particle stands still and no constraint acts on it or through it. Default `true`.
    pub enabled: bool,
    /// Whatever the game wants to keep here. Default 0.
    pub user: u64,
}

/// How a particle starts.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct ParticleSpec {
    /// Metres; each component within +-2^36.
    pub position: Vec3,
    /// Metres a second; the displacement of the first substep must not exceed the configured
    /// maximum. What is pinned or disabled starts at rest.
    pub velocity: Vec3,
    /// Everything else.
    pub particle: Particle,
}

impl Particle {
    /// Least mass: 1 g.
    pub const MASS_MIN: Real = real!("0.001");
    /// Greatest mass: 1,000 t.
    pub const MASS_MAX: Real = real!("1000000");
    /// Greatest gravity scale, either sign.
    pub const GRAVITY_SCALE_MAX: Factor = Factor::from_raw(16 << 16);
    /// Greatest component of a particle's own acceleration, either sign, m/s^2.
    pub const ACCELERATION_MAX: Real = real!("100000");

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { mass, gravity_scale, acceleration, pinned: _, enabled: _, user: _ } = self;
        check_in(*mass, Self::MASS_MIN..=Self::MASS_MAX, "mass")?;
        let scale = Self::GRAVITY_SCALE_MAX;
        check_in(*gravity_scale, Factor::from_raw(-scale.raw())..=scale, "gravity_scale")?;
        check_within(*acceleration, Self::ACCELERATION_MAX.raw(), "acceleration")
    }

    /// Whether forces and constraints can move it.
    #[must_use]
    pub const fn is_movable(&self) -> bool {
        self.enabled && !self.pinned
    }
}

impl ParticleSpec {
    /// A particle of 1 kg at rest.
    #[must_use]
    pub fn at(position: Vec3) -> Self {
        Self { position, ..Self::default() }
    }

    /// The same with a velocity, m/s.
    #[must_use]
    pub fn velocity(self, velocity: Vec3) -> Self {
        Self { velocity, ..self }
    }

    /// The same with a mass, kg.
    #[must_use]
    pub fn mass(mut self, mass: Real) -> Self {
        self.particle.mass = mass;
        self
    }

    /// The same with a share of gravity, -16 to 16.
    #[must_use]
    pub fn gravity_scale(mut self, scale: Factor) -> Self {
        self.particle.gravity_scale = scale;
        self
    }

    /// The same with an acceleration of its own, m/s^2.
    #[must_use]
    pub fn acceleration(mut self, acceleration: Vec3) -> Self {
        self.particle.acceleration = acceleration;
        self
    }

    /// The same with the game's own number.
    #[must_use]
    pub fn user(mut self, user: u64) -> Self {
        self.particle.user = user;
        self
    }

    /// The same, pinned in place.
    #[must_use]
    pub fn pinned(mut self) -> Self {
        self.particle.pinned = true;
        self
    }

    /// Checks every declared range that does not depend on a world's configuration.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { position, velocity: _, particle } = self;
        check_within(*position, WORLD_LIMIT, "position")?;
        particle.validate()
    }
}

impl Default for Particle {
    fn default() -> Self {
        Self {
            mass: Real::ONE,
            gravity_scale: Factor::ONE,
            acceleration: Vec3::ZERO,
            pinned: false,
            enabled: true,
            user: 0,
        }
    }
}

impl Default for ParticleSpec {
    fn default() -> Self {
        Self { position: Vec3::ZERO, velocity: Vec3::ZERO, particle: Particle::default() }
    }
}
