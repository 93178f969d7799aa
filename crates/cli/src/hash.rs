//! `verlock hash`: the hash of a state.

use std::io::Write;
use std::path::PathBuf;

use crate::exit::Exit;
use crate::failure::Failure;
use crate::input::{Input, Kind};
use crate::state::{check_tick, end, recorded_hash, world_at};

/// Print the hash of a state
///
/// Of a replay it is the recorded one, by default the last; with --parts the replay is stepped.
#[derive(Debug, clap::Args)]
pub(crate) struct Hash {
    /// Snapshot, replay or scene
    path: PathBuf,

    /// Print the hash of every section of the state too
    #[arg(long)]
    parts: bool,

    /// Tick of the state
    #[arg(long, value_name = "T")]
    tick: Option<u64>,
}

impl Hash {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let input = Input::read(&self.path, limit)?;
        if !self.parts
            && let Kind::Replay(replay) = input.open()?
        {
            let tick = check_tick(&input, self.tick, replay.first_tick(), end(&replay))?;
            let hash = recorded_hash(&replay, tick);
            let hash = hash.ok_or_else(|| input.unproven("the start is not a world"))?;
            writeln!(out, "{hash}")?;
            return Ok(Exit::Fine);
        }
        let world = world_at(&input, self.tick)?;
        if self.parts {
            writeln!(out, "{} state", world.hash())?;
            for (section, hash) in world.part_hashes() {
                writeln!(out, "{hash} {section}")?;
            }
        } else {
            writeln!(out, "{}", world.hash())?;
        }
        Ok(Exit::Fine)
    }
}
