//! Why a replay did not verify.

use core::fmt;

use crate::snapshot::{DecodeError, Hash};

/// A replay did not verify.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum VerifyError {
    /// The file cannot be replayed: nothing is proven.
    Decode(DecodeError),
    /// No tick was recorded: nothing is proven.
    Empty,
    /// Stepping again came out differently.
    Diverged(Divergence),
}

/// The first tick that came out differently.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Divergence {
    /// The tick.
    pub tick: u64,
    /// What differs.
    pub kind: DivergenceKind,
    /// What the replay says.
    pub recorded: Hash,
    /// What was found.
    pub found: Hash,
}

/// What differs first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum DivergenceKind {
    /// The inputs are not those that were recorded. Only the lower 64 bits of their hash are kept.
    Inputs,
    /// The state after the tick.
    State,
    /// The keyframe saved after the tick is not the state after it.
    Keyframe,
}

impl From<DecodeError> for VerifyError {
    fn from(error: DecodeError) -> Self {
        Self::Decode(error)
    }
}

impl fmt::Display for Divergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what = match self.kind {
            DivergenceKind::Inputs => "the inputs differ",
            DivergenceKind::State => "the state differs",
            DivergenceKind::Keyframe => "the keyframe differs",
        };
        let Self { tick, recorded, found, .. } = self;
        write!(f, "tick {tick}: {what}: recorded {recorded}, found {found}")
    }
}

impl fmt::Display for VerifyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Decode(error) => error.fmt(f),
            Self::Empty => f.write_str("no tick was recorded: nothing proven"),
            Self::Diverged(divergence) => divergence.fmt(f),
        }
    }
}

impl core::error::Error for VerifyError {}
