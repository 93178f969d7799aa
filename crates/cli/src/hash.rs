//! `verlock hash`: the hash of a state.

use std::io::Write;
use std::path::PathBuf;

use serde_json::{Map, Value};
use verlock::snapshot::Section;

use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::{Input, Kind};
use crate::report::Report;
use crate::state::{State, check_tick, recorded_hash, span};

/// Print the hash of a state
///
/// Of a replay or hash log it is the recorded one, by default the last; with --parts the state is
/// stepped to, unless it is stored, and where it has another hash than recorded, that is printed
/// too and 1 returned.
#[derive(Debug, clap::Args)]
pub(crate) struct Hash {
    /// Snapshot, replay, scene or hash log
    path: PathBuf,

    /// Print the hash of every section of the state too
    #[arg(long)]
    parts: bool,

    /// Tick of the state
    #[arg(long, value_name = "T")]
    tick: Option<u64>,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// What is known of a state.
struct Found {
    tick: u64,
    hash: verlock::Hash,
    /// The one that the file gives instead.
    recorded: Option<verlock::Hash>,
    /// The sections' own, if they are wanted.
    parts: Vec<(Section, verlock::Hash)>,
}

impl Hash {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let input = Input::read(&self.path, limit)?;
        let found = if self.parts { self.computed(&input)? } else { self.recorded(&input)? };
        if self.json {
            found.report().print(true, out)?;
        } else if self.parts {
            if let Some(recorded) = found.recorded {
                writeln!(out, "{recorded} recorded")?;
            }
            writeln!(out, "{} state", found.hash)?;
            found.parts.iter().try_for_each(|(part, hash)| writeln!(out, "{hash} {part}"))?;
        } else {
            writeln!(out, "{}", found.hash)?;
        }
        Ok(if found.recorded.is_some() { Exit::Different } else { Exit::Fine })
    }

    /// What the file says, without stepping.
    fn recorded(&self, input: &Input) -> Result<Found, Failure> {
        let (tick, hash) = match input.open()? {
            Kind::Replay(replay) => {
                let tick = check_tick(input, self.tick, span(&replay))?;
                let hash = recorded_hash(&replay, tick);
                (tick, hash.ok_or_else(|| input.unproven("the start is not a world"))?)
            }
            Kind::Hashes(log) => {
                let span = log.span().ok_or_else(|| input.unproven("no hash is in it"))?;
                let tick = check_tick(input, self.tick, span)?;
                let hash = log.at(tick);
                let missing = || Failure::usage(format!("{}: no tick {tick}", input.name()));
                (tick, hash.ok_or_else(missing)?)
            }
            _ => return self.computed(input),
        };
        Ok(Found { tick, hash, recorded: None, parts: Vec::new() })
    }

    fn computed(&self, input: &Input) -> Result<Found, Failure> {
        let state = State::at(input, self.tick)?;
        let snapshot = state.snapshot(input)?;
        let tick = snapshot.tick();
        if let Some(note) = state.note(input, tick) {
            tell(note);
        }
        let parts = Section::ALL.into_iter().filter(|_| self.parts);
        let parts = parts.map(|part| (part, snapshot.part_hash(part))).collect();
        let recorded = (!state.is_as_recorded()).then(|| state.told());
        Ok(Found { tick, hash: snapshot.hash(), recorded, parts })
    }
}

impl Found {
    fn report(&self) -> Report {
        let mut report = Report::default();
        report.add("tick", self.tick);
        report.add("hash", self.hash.to_string());
        if let Some(recorded) = self.recorded {
            report.add("recorded_hash", recorded.to_string());
        }
        if !self.parts.is_empty() {
            let part = |(part, hash): &(Section, verlock::Hash)| {
                (part.name().to_owned(), Value::String(hash.to_string()))
            };
            report.add("parts", self.parts.iter().map(part).collect::<Map<_, _>>());
        }
        report
    }
}
