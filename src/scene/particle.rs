//! Particles in a scene file.

use serde::{Deserialize, Deserializer};

use super::number::{decimal, vector};
use crate::math::{Factor, Real, Vec3};
use crate::particle::{Particle, ParticleId, ParticleSpec};
use crate::store::Handle;

/// A particle as an element of a list.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(transparent)]
pub(super) struct ParticleEntry(#[serde(deserialize_with = "particle")] pub(super) ParticleSpec);

/// How a scene file spells a [`ParticleSpec`].
#[derive(Deserialize)]
#[serde(rename = "Particle", default, deny_unknown_fields)]
struct ParticleFields {
    #[serde(deserialize_with = "vector")]
    position: Vec3,
    #[serde(deserialize_with = "vector")]
    velocity: Vec3,
    #[serde(deserialize_with = "decimal")]
    mass: Real,
    #[serde(deserialize_with = "decimal")]
    gravity_scale: Factor,
    #[serde(deserialize_with = "vector")]
    acceleration: Vec3,
    pinned: bool,
    enabled: bool,
    user: u64,
}

/// Reads a particle.
pub(super) fn particle<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<ParticleSpec, D::Error> {
    let fields = ParticleFields::deserialize(deserializer)?;
    let ParticleFields { position, velocity, mass, gravity_scale, acceleration, .. } = fields;
    let ParticleFields { pinned, enabled, user, .. } = fields;
    let particle = Particle { mass, gravity_scale, acceleration, pinned, enabled, user };
    Ok(ParticleSpec { position, velocity, particle })
}

/// The id of a particle from its number: the first tenant of that slot.
pub(super) fn particle_id<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<ParticleId, D::Error> {
    u32::deserialize(deserializer).map(|number| ParticleId(Handle::new(number, 1)))
}

impl Default for ParticleFields {
    fn default() -> Self {
        let ParticleSpec { position, velocity, particle } = ParticleSpec::default();
        let Particle { mass, gravity_scale, acceleration, pinned, enabled, user } = particle;
        Self { position, velocity, mass, gravity_scale, acceleration, pinned, enabled, user }
    }
}
