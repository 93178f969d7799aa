//! What a step tells the game.

use core::fmt;

use super::ObjectId;
use crate::constraint::DistanceId;
use crate::particle::{ParticleId, RangeError};

/// Something that happened in a tick.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Event {
    /// The tick, counted from 0.
    pub tick: u64,
    /// What happened.
    pub kind: EventKind,
}

/// The kinds of events, in the order in which a tick lists them.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[non_exhaustive]
pub enum EventKind {
    /// An object was added.
    Spawned {
        /// The command's token.
        token: u64,
        /// Its id from now on.
        object: ObjectId,
    },
    /// An object was removed, by a command or with a particle that it needed.
    Removed {
        /// Its id until now.
        object: ObjectId,
    },
    /// A distance tore: it is disabled, and so are the faces along it.
    Broken {
        /// Which.
        distance: DistanceId,
    },
    /// A command did nothing.
    Refused {
        /// Whose.
        player: u32,
        /// Which.
        sequence: u32,
        /// Why.
        why: Refusal,
    },
    /// A particle would have moved farther in a substep than the configuration allows.
    DisplacementClamped {
        /// Whose motion was cut.
        particle: ParticleId,
    },
    /// A particle reached the limit of the world and was stopped there.
    WorldLimit {
        /// Who was stopped.
        particle: ParticleId,
    },
}

/// Why something was not done.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[non_exhaustive]
pub enum Refusal {
    /// The id names nothing alive.
    Stale {
        /// The field that holds the id.
        field: &'static str,
    },
    /// A number is out of its range.
    OutOfRange(RangeError),
    /// There are as many objects of this kind as there can be.
    Full,
    /// The particle is pinned or disabled.
    NotMovable,
    /// The particle is not pinned.
    NotPinned,
}

impl From<RangeError> for Refusal {
    fn from(error: RangeError) -> Self {
        Self::OutOfRange(error)
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stale { field } => write!(f, "{field} names nothing alive"),
            Self::OutOfRange(error) => error.fmt(f),
            Self::Full => f.write_str("there are as many objects of this kind as there can be"),
            Self::NotMovable => f.write_str("the particle is pinned or disabled"),
            Self::NotPinned => f.write_str("the particle is not pinned"),
        }
    }
}

impl core::error::Error for Refusal {}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "tick {}: ", self.tick)?;
        match &self.kind {
            EventKind::Spawned { token, object } => write!(f, "{object} spawned for token {token}"),
            EventKind::Removed { object } => write!(f, "{object} removed"),
            EventKind::Broken { distance } => write!(f, "{distance} broke"),
            EventKind::Refused { player, sequence, why } => {
                write!(f, "command {sequence} of player {player} refused: {why}")
            }
            EventKind::DisplacementClamped { particle } => {
                write!(f, "{particle} moved too fast and was cut to the maximum")
            }
            EventKind::WorldLimit { particle } => {
                write!(f, "{particle} reached the limit of the world and was stopped")
            }
        }
    }
}
