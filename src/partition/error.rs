//! What a partition refuses.

use core::fmt;

use super::ID_MAX;

/// Why a partition refuses a change.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum PartitionError {
    /// The id is above [`ID_MAX`].
    IdTooLarge,
    /// Another object has this id.
    IdTaken,
    /// No object has this id.
    UnknownId,
    /// A coordinate is beyond +-2^36 m (raw: 2^60).
    OutOfRange {
        /// `bounds` or `centre`.
        field: &'static str,
    },
}

impl fmt::Display for PartitionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::IdTooLarge => write!(f, "id: above {ID_MAX}"),
            Self::IdTaken => f.write_str("id: taken by another object"),
            Self::UnknownId => f.write_str("id: no object has it"),
            Self::OutOfRange { field } => write!(f, "{field}: beyond 2^36 m"),
        }
    }
}

impl core::error::Error for PartitionError {}
