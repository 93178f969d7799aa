//! Why a command could not do what it was asked.

use std::fmt::{self, Display};
use std::io::{self, Write as _};

use clap::builder::styling::AnsiColor;

use crate::exit::Exit;

/// A message for stderr, and what to return.
#[derive(Debug)]
pub(crate) struct Failure {
    exit: Exit,
    message: String,
}

impl Failure {
    /// The command line asks for something that makes no sense.
    pub(crate) fn usage(message: impl Into<String>) -> Self {
        Self { exit: Exit::Usage, message: message.into() }
    }

    /// A file could not be read or written.
    pub(crate) fn io(name: impl Display, error: &io::Error) -> Self {
        Self::usage(format!("{name}: {error}"))
    }

    /// A file cannot be used, of which a proof was wanted.
    pub(crate) fn unproven(name: impl Display, why: impl Display) -> Self {
        let mut failure = Self::unusable(name, why);
        // Some reasons say so themselves.
        if !failure.message.ends_with("nothing proven") {
            failure.message.push_str(": nothing proven");
        }
        failure
    }

    /// A file cannot be used.
    pub(crate) fn unusable(name: impl Display, why: impl Display) -> Self {
        Self { exit: Exit::Unproven, message: format!("{name}: {why}") }
    }

    pub(crate) fn exit(&self) -> Exit {
        self.exit
    }

    /// Says it on stderr.
    pub(crate) fn tell(&self) {
        tell(self);
    }
}

/// Says something on stderr. There is nobody to tell when even that fails.
pub(crate) fn tell(message: impl Display) {
    let style = AnsiColor::Red.on_default().bold();
    let _ = writeln!(anstream::stderr(), "{style}verlock:{style:#} {message}");
}

/// Only writing data to stdout fails without naming a file.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::io("stdout", &error)
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}
