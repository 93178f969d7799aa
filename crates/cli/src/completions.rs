//! `verlock completions`: scripts for shells.

use std::io::Write;

use clap::CommandFactory as _;
use clap_complete::{Shell, generate};

use crate::args::Args;
use crate::exit::Exit;
use crate::failure::Failure;

/// Print the completion script of a shell
#[derive(Debug, clap::Args)]
pub(crate) struct Completions {
    shell: Shell,
}

impl Completions {
    pub(crate) fn execute(self, out: &mut dyn Write) -> Result<Exit, Failure> {
        // Made in memory: the generator panics where a pipe may fail.
        let mut script = Vec::new();
        generate(self.shell, &mut Args::command(), "verlock", &mut script);
        out.write_all(&script)?;
        Ok(Exit::Fine)
    }
}
