//! The `verlock` command: steps scenes, records and verifies replays, compares states.
//!
//! stdout is data, stderr is messages. What it returns is told by [`exit::Exit`].

mod args;
mod bisect;
mod completions;
mod contacts;
mod count;
mod diff;
mod dump;
mod exit;
mod failure;
mod files;
mod hash;
mod heavy;
mod info;
mod input;
mod jobs;
mod json;
mod man;
mod mesh;
mod number;
mod overlap;
mod pipe;
mod progress;
mod recording;
mod reduce;
mod render;
mod report;
mod run;
mod state;
mod tally;
mod target;
mod toi;
mod verdict;
mod verify;

#[cfg(test)]
mod damage;

use std::io::{BufWriter, Write as _};
use std::process::ExitCode;

use crate::args::Args;
use crate::failure::Failure;
use crate::pipe::Pipe;

fn main() -> ExitCode {
    let Args { command, limit } = Args::typed();
    let mut out = BufWriter::new(Pipe::stdout());
    let result = command.execute(limit, &mut out);
    // What was found before a failure is data all the same.
    let flushed = out.flush().map_err(Failure::from);
    match result.and_then(|exit| flushed.map(|()| exit)) {
        Ok(exit) => exit.into(),
        Err(failure) => {
            failure.tell();
            failure.exit().into()
        }
    }
}
