//! What players can make a world do.

use core::fmt;

use serde::{Deserialize, Serialize};

use super::WorldConfig;
use crate::body::{Face, FaceId};
use crate::constraint::{Distance, DistanceId, HalfSpace, HalfSpaceId, Volume, VolumeId};
use crate::math::{Factor, Real, Vec3};
use crate::particle::{ParticleId, ParticleSpec};

/// One order to a world.
///
/// The commands of a tick are carried out in order of `(player, sequence)`, whatever order they
/// arrive in; should a player number two alike, in order of their contents.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct Command {
    /// Who gives it; the game's own choice.
    pub player: u32,
    /// Counts the player's commands.
    pub sequence: u32,
    /// What is to be done.
    pub action: Action,
}

/// What a command does.
///
/// An action that is not possible when its turn comes (a stale id, a number out of its range) does
/// nothing and makes an [`EventKind::Refused`](super::EventKind::Refused): the same on every peer.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Action {
    /// Adds a particle; [`EventKind::Spawned`](super::EventKind::Spawned) tells its id.
    SpawnParticle {
        /// Comes back in the event.
        token: u64,
        /// How it starts.
        spec: ParticleSpec,
    },
    /// Adds a distance constraint between two living particles.
    SpawnDistance {
        /// Comes back in the event.
        token: u64,
        /// The constraint.
        distance: Distance,
    },
    /// Adds a half-space.
    SpawnHalfSpace {
        /// Comes back in the event.
        token: u64,
        /// The half-space.
        half_space: HalfSpace,
    },
    /// Removes an object, and with a particle the constraints on it.
    Remove {
        /// What to remove.
        object: ObjectId,
    },
    /// Pushes a particle during this tick; forces on the same particle add up.
    Force {
        /// Whom.
        particle: ParticleId,
        /// Newtons; the sum must not accelerate by more than 100,000 m/s^2.
        force: Vec3,
    },
    /// Changes a particle's momentum at once; its displacement stays within the maximum.
    Impulse {
        /// Whom.
        particle: ParticleId,
        /// Newton-seconds.
        impulse: Vec3,
    },
    /// Sets a particle's velocity.
    SetVelocity {
        /// Whom.
        particle: ParticleId,
        /// m/s.
        velocity: Vec3,
    },
    /// Sets a particle's own acceleration, which acts until changed.
    SetAcceleration {
        /// Whom.
        particle: ParticleId,
        /// m/s^2.
        acceleration: Vec3,
    },
    /// Sets a particle's mass; its velocity stays.
    SetMass {
        /// Whom.
        particle: ParticleId,
        /// kg.
        mass: Real,
    },
    /// Sets the share of gravity that acts on a particle.
    SetGravityScale {
        /// Whom.
        particle: ParticleId,
        /// -16 to 16.
        scale: Factor,
    },
    /// Pins a particle where it is, or lets it go with the velocity it was moved with.
    SetPinned {
        /// Whom.
        particle: ParticleId,
        /// Whether it is pinned from now on.
        pinned: bool,
    },
    /// Moves a pinned particle to a position, evenly over the substeps of this tick, at most the
    /// maximal displacement in each.
    MovePin {
        /// Whom.
        particle: ParticleId,
        /// Metres.
        target: Vec3,
    },
    /// Puts a particle elsewhere; its velocity stays.
    Teleport {
        /// Whom.
        particle: ParticleId,
        /// Metres.
        position: Vec3,
    },
    /// Changes the length that a distance constraint keeps. A rope stays one; other slack is cut to
    /// the new length.
    SetRestLength {
        /// Which.
        distance: DistanceId,
        /// Metres.
        rest_length: Real,
    },
    /// Switches an object on or off.
    SetEnabled {
        /// Which.
        object: ObjectId,
        /// Whether it is enabled from now on.
        enabled: bool,
    },
    /// Stores the game's own number with an object.
    SetUser {
        /// Which.
        object: ObjectId,
        /// The number.
        user: u64,
    },
    /// Replaces the configuration.
    Configure {
        /// The new one.
        config: WorldConfig,
    },
    /// Adds a volume constraint between four living particles.
    SpawnVolume {
        /// Comes back in the event.
        token: u64,
        /// The constraint.
        volume: Volume,
    },
    /// Adds a face between three living particles.
    SpawnFace {
        /// Comes back in the event.
        token: u64,
        /// The face.
        face: Face,
    },
    /// Changes how the air moves.
    SetWind {
        /// m/s.
        wind: Vec3,
    },
}

/// Names any object of a world.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[non_exhaustive]
pub enum ObjectId {
    /// A particle.
    Particle(ParticleId),
    /// A distance constraint.
    Distance(DistanceId),
    /// A half-space.
    HalfSpace(HalfSpaceId),
    /// A volume constraint.
    Volume(VolumeId),
    /// A face.
    Face(FaceId),
}

impl From<ParticleId> for ObjectId {
    fn from(id: ParticleId) -> Self {
        Self::Particle(id)
    }
}

impl From<DistanceId> for ObjectId {
    fn from(id: DistanceId) -> Self {
        Self::Distance(id)
    }
}

impl From<HalfSpaceId> for ObjectId {
    fn from(id: HalfSpaceId) -> Self {
        Self::HalfSpace(id)
    }
}

impl From<VolumeId> for ObjectId {
    fn from(id: VolumeId) -> Self {
        Self::Volume(id)
    }
}

impl From<FaceId> for ObjectId {
    fn from(id: FaceId) -> Self {
        Self::Face(id)
    }
}

impl fmt::Display for ObjectId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Particle(id) => id.fmt(f),
            Self::Distance(id) => id.fmt(f),
            Self::HalfSpace(id) => id.fmt(f),
            Self::Volume(id) => id.fmt(f),
            Self::Face(id) => id.fmt(f),
        }
    }
}
