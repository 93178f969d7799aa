//! `verlock diff`: what differs between two states.

use std::io::Write;
use std::path::PathBuf;

use serde_json::{Value, json};
use verlock::replay::Replay;
use verlock::snapshot::{Difference, Snapshot, diff};

use crate::count::counted;
use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::{Input, Kind, is_dash};
use crate::json;
use crate::state::{end, recorded_hash, world_at};

/// Compare two states field by field
///
/// Prints every object and field that differs, with both values and their bits. Of two replays,
/// the first tick with different recorded hashes is compared. Returns 1 if anything differs.
#[derive(Debug, clap::Args)]
pub(crate) struct Diff {
    /// Snapshot, replay or scene
    a: PathBuf,

    /// What to compare it with
    b: PathBuf,

    /// Tick of the states
    #[arg(long, value_name = "T")]
    tick: Option<u64>,

    /// Print no more differences
    #[arg(long, value_name = "N", default_value_t = 100)]
    max: usize,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Which states of two files to compare.
#[derive(Default)]
struct Choice {
    tick: Option<u64>,
    /// How two recordings differ, be it only in what they recorded.
    recordings: Option<String>,
}

/// Two states compared.
struct Comparison {
    ticks: [u64; 2],
    hashes: [String; 2],
    differences: Vec<Difference>,
    /// Of them and those that were too many to keep.
    count: u64,
}

impl Diff {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        if is_dash(&self.a) && is_dash(&self.b) {
            return Err(Failure::usage("only one of two files can be stdin"));
        }
        let a = Input::read(&self.a, limit)?;
        let b = Input::read(&self.b, limit)?;
        let choice = match self.tick {
            Some(tick) => Choice { tick: Some(tick), ..Choice::default() },
            None => Choice::of(&a, &b)?,
        };
        let comparison = self.compare(&a, &b, choice.tick)?;
        self.print(&comparison, out)?;
        let equal = comparison.hashes[0] == comparison.hashes[1];
        if let Some(why) = choice.recordings.filter(|_| equal) {
            tell(format_args!("the recordings differ, though not this state: {why}"));
            return Ok(Exit::Different);
        }
        Ok(if equal { Exit::Fine } else { Exit::Different })
    }

    fn compare(&self, a: &Input, b: &Input, tick: Option<u64>) -> Result<Comparison, Failure> {
        let save = |input| world_at(input, tick).map(|world| world.save());
        let bytes = [save(a)?, save(b)?];
        let parse =
            |input: &Input, bytes| Snapshot::parse(bytes).map_err(|error| input.unproven(error));
        let (a, b) = (parse(a, &bytes[0])?, parse(b, &bytes[1])?);
        let mut all = diff(&a, &b);
        let differences: Vec<_> = all.by_ref().take(self.max).collect();
        Ok(Comparison {
            ticks: [a.tick(), b.tick()],
            hashes: [a.hash().to_string(), b.hash().to_string()],
            count: differences.len() as u64 + all.count() as u64,
            differences,
        })
    }

    fn print(&self, comparison: &Comparison, out: &mut dyn Write) -> Result<(), Failure> {
        let Comparison { ticks, hashes: [a, b], differences, count } = comparison;
        if self.json {
            writeln!(out, "{:#}", comparison.json())?;
        } else if a == b {
            writeln!(out, "equal at tick {}: {a}", ticks[0])?;
        } else {
            writeln!(
                out,
                "{} at tick {}: {a} against {b}",
                counted(*count, "difference"),
                ticks[0]
            )?;
            differences.iter().try_for_each(|difference| writeln!(out, "{difference}"))?;
        }
        Ok(())
    }
}

impl Comparison {
    fn json(&self) -> Value {
        let Self { ticks, hashes, differences, count } = self;
        json!({
            "ticks": ticks,
            "hashes": hashes,
            "count": count,
            "differences": differences.iter().map(json::difference).collect::<Vec<_>>(),
        })
    }
}

impl Choice {
    fn of(a: &Input, b: &Input) -> Result<Self, Failure> {
        match (a.open()?, b.open()?) {
            (Kind::Replay(first), Kind::Replay(second)) => Self::of_replays(&first, &second)
                .ok_or_else(|| a.unproven(format_args!("no tick in common with {}", b.name()))),
            (Kind::Snapshot(snapshot), _) | (_, Kind::Snapshot(snapshot)) => {
                Ok(Self { tick: Some(snapshot.tick()), recordings: None })
            }
            _ => Ok(Self::default()),
        }
    }

    /// The first tick at which the recorded hashes differ, or else the last that both have; `None`
    /// if they have none.
    fn of_replays(a: &Replay<'_>, b: &Replay<'_>) -> Option<Self> {
        let first = a.first_tick().max(b.first_tick());
        let last = end(a).min(end(b));
        let differs = |&tick: &u64| recorded_hash(a, tick) != recorded_hash(b, tick);
        let span = |replay: &Replay<'_>| format!("{} to {}", replay.first_tick(), end(replay));
        let (tick, recordings) = match (first..=last).find(differs) {
            Some(tick) => (tick, Some(format!("stepped again, tick {tick} is not as recorded"))),
            None if span(a) == span(b) => (last, None),
            None => (last, Some(format!("ticks {} against {}", span(a), span(b)))),
        };
        (first <= last).then_some(Self { tick: Some(tick), recordings })
    }
}
