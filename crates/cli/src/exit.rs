//! What the command returns to the shell.

use std::process::ExitCode;

/// The exit codes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Exit {
    /// Verified, equal or simply done.
    Fine = 0,
    /// A divergence or difference was found.
    Different = 1,
    /// Wrong usage, or a file could not be read or written.
    Usage = 2,
    /// Damaged, unsupported, over a limit: nothing is proven.
    Unproven = 3,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}
