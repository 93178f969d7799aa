//! Why bytes were refused.

use core::fmt;

use crate::particle::RangeError;

/// Bytes that are not what they should be; nothing was changed because of them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DecodeError {
    /// Where in the bytes.
    pub offset: u64,
    /// What is wrong there.
    pub reason: DecodeReason,
}

/// What can be wrong with bytes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum DecodeReason {
    /// The bytes end before this.
    Truncated,
    /// The first eight bytes are not those of this kind of file.
    NotThisKind,
    /// The format is of a version that this build cannot read.
    FormatVersion {
        /// The file's.
        found: u32,
    },
    /// The file was made by other rules of simulation: it proves nothing about this one.
    SimVersion {
        /// The file's.
        found: u32,
    },
    /// The bytes do not have the hash that the file gives for them.
    Damaged,
    /// The sections are not those of this format, or their sizes contradict one another.
    Layout,
    /// Bytes follow the last section.
    Trailing,
    /// A record holds something that it must not, such as a flag that is neither 0 nor 1.
    Record,
    /// A number is out of its range.
    OutOfRange(RangeError),
    /// The replay is of another simulation, or of another version of its rules: it proves nothing
    /// about this one.
    Simulation {
        /// The name of the simulation that made the file, filled up with zeros.
        name: [u8; 16],
        /// The version of that simulation's rules.
        version: u32,
    },
}

impl DecodeError {
    pub(crate) fn new(offset: u64, reason: DecodeReason) -> Self {
        Self { offset, reason }
    }

    /// The same error seen from bytes that contain these from `base` on.
    pub(crate) fn within(self, base: u64) -> Self {
        Self { offset: self.offset.saturating_add(base), ..self }
    }
}

impl fmt::Display for DecodeReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Truncated => f.write_str("the bytes end too early"),
            Self::NotThisKind => f.write_str("not this kind of file"),
            Self::FormatVersion { found } => {
                write!(f, "format version {found} is not supported by this build")
            }
            Self::SimVersion { found } => {
                let ours = super::SIM_VERSION;
                write!(f, "made by SIM_VERSION {found}, this build is {ours}: nothing proven")
            }
            Self::Damaged => f.write_str("damaged: the bytes do not have their hash"),
            Self::Layout => f.write_str("the table of sections is not that of this format"),
            Self::Trailing => f.write_str("bytes follow the last section"),
            Self::Record => f.write_str("a record holds something that it must not"),
            Self::OutOfRange(error) => error.fmt(f),
            Self::Simulation { name, version } => {
                let end = name.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
                let name = name[..end].escape_ascii();
                write!(f, "recorded by \"{name}\" version {version}: nothing proven")
            }
        }
    }
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "offset {}: {}", self.offset, self.reason)
    }
}

impl core::error::Error for DecodeError {}
