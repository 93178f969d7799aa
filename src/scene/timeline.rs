//! Commands at set times.

use serde::Deserialize;

use super::config::ConfigFields;
use super::distance::{DistanceFields, as_placed, distance_id};
use super::face::{FaceFields, face_id};
use super::half_space::{HalfSpaceFields, half_space_id};
use super::number::{decimal, shift, vector};
use super::particle::{particle, particle_id};
use super::volume::{self, VolumeFields, volume_id};
use crate::body::{Face, FaceId};
use crate::constraint::{Distance, DistanceId, HalfSpace, HalfSpaceId, Volume, VolumeId};
use crate::math::{Factor, Real, Vec3};
use crate::particle::{ParticleId, ParticleSpec, RangeError};
use crate::world::{Action, ObjectId, World, WorldConfig};

/// One command of a timeline. Those of one tick are given in the order of the file.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename = "Command", deny_unknown_fields)]
pub(super) struct Entry {
    /// Its place in the file, counted from 0.
    #[serde(skip)]
    pub(super) index: u32,
    pub(super) tick: u64,
    #[serde(default)]
    pub(super) player: u32,
    #[serde(with = "ActionFields")]
    action: Action,
}

impl Entry {
    /// Moves it by the scene's origin.
    pub(super) fn shift(&mut self, origin: Vec3) -> Result<(), RangeError> {
        match &mut self.action {
            Action::SpawnParticle { spec, .. } => shift(&mut spec.position, origin, "position"),
            Action::SpawnHalfSpace { half_space, .. } => {
                shift(&mut half_space.point, origin, "point")
            }
            Action::MovePin { target, .. } => shift(target, origin, "target"),
            Action::Teleport { position, .. } => shift(position, origin, "position"),
            _ => Ok(()),
        }
    }

    /// The action, for this state of the world.
    pub(super) fn action(&self, world: &World) -> Action {
        match self.action {
            Action::SpawnDistance { token, distance } => {
                let distance = as_placed(&distance, |id| world.position(id));
                Action::SpawnDistance { token, distance }
            }
            Action::SpawnVolume { token, volume } => {
                let volume = volume::as_placed(&volume, |id| world.position(id));
                Action::SpawnVolume { token, volume }
            }
            action => action,
        }
    }
}

/// How a scene file spells an [`Action`].
#[derive(Deserialize)]
#[serde(remote = "Action", rename = "Action", deny_unknown_fields)]
enum ActionFields {
    SpawnParticle {
        #[serde(default)]
        token: u64,
        #[serde(rename = "particle", deserialize_with = "particle")]
        spec: ParticleSpec,
    },
    SpawnDistance {
        #[serde(default)]
        token: u64,
        #[serde(with = "DistanceFields")]
        distance: Distance,
    },
    SpawnHalfSpace {
        #[serde(default)]
        token: u64,
        #[serde(with = "HalfSpaceFields")]
        half_space: HalfSpace,
    },
    Remove {
        #[serde(with = "ObjectFields")]
        object: ObjectId,
    },
    Force {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "vector")]
        force: Vec3,
    },
    Impulse {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "vector")]
        impulse: Vec3,
    },
    SetVelocity {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "vector")]
        velocity: Vec3,
    },
    SetAcceleration {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "vector")]
        acceleration: Vec3,
    },
    SetMass {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "decimal")]
        mass: Real,
    },
    SetGravityScale {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "decimal")]
        scale: Factor,
    },
    SetPinned {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        pinned: bool,
    },
    MovePin {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "vector")]
        target: Vec3,
    },
    Teleport {
        #[serde(deserialize_with = "particle_id")]
        particle: ParticleId,
        #[serde(deserialize_with = "vector")]
        position: Vec3,
    },
    SetRestLength {
        #[serde(deserialize_with = "distance_id")]
        distance: DistanceId,
        #[serde(deserialize_with = "decimal")]
        rest_length: Real,
    },
    SetEnabled {
        #[serde(with = "ObjectFields")]
        object: ObjectId,
        enabled: bool,
    },
    SetUser {
        #[serde(with = "ObjectFields")]
        object: ObjectId,
        user: u64,
    },
    /// What is left out gets its default, not its present value.
    Configure {
        #[serde(with = "ConfigFields")]
        config: WorldConfig,
    },
    SpawnVolume {
        #[serde(default)]
        token: u64,
        #[serde(with = "VolumeFields")]
        volume: Volume,
    },
    SpawnFace {
        #[serde(default)]
        token: u64,
        #[serde(with = "FaceFields")]
        face: Face,
    },
    SetWind {
        #[serde(deserialize_with = "vector")]
        wind: Vec3,
    },
}

/// How a scene file names an object.
#[derive(Deserialize)]
#[serde(remote = "ObjectId", rename = "Object")]
enum ObjectFields {
    Particle(#[serde(deserialize_with = "particle_id")] ParticleId),
    Distance(#[serde(deserialize_with = "distance_id")] DistanceId),
    HalfSpace(#[serde(deserialize_with = "half_space_id")] HalfSpaceId),
    Volume(#[serde(deserialize_with = "volume_id")] VolumeId),
    Face(#[serde(deserialize_with = "face_id")] FaceId),
}
