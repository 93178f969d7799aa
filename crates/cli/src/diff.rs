//! `verlock diff`: what differs between two states.

use std::collections::BTreeSet;
use std::io::Write;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use serde_json::{Value, json};
use verlock::replay::{Bisection, Parting, Replay, bisect_replays};
use verlock::snapshot::{Difference, diff};

use crate::count::counted;
use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::{Input, Kind};
use crate::json;
use crate::recording::recorded;
use crate::state::{Origin, State, recorded_hash, span};

/// Compare two states field by field
///
/// Prints every object and field that differs, with both values and their bits. Of two recordings,
/// the first tick with different hashes is compared: its stored states where there are any, what
/// stepping gives otherwise. Where that has not the recorded hash, the recording machine's own
/// state is not in the file, and the first later one that is known is compared. Returns 1 if
/// anything differs, be it only the recorded hashes, and 3 if those are equal but a state is not
/// the recorded one.
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
    /// Why not those of another tick.
    note: Option<String>,
    /// How two recordings differ, be it only in what they recorded.
    recordings: Option<String>,
}

/// What comparing two states proves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Finding {
    Equal,
    Different,
    /// The recorded hashes differ; the states that were found tell nothing of it.
    RecordedDifferent,
    /// The recorded hashes are equal, but a state that was found is another one.
    Unproven,
}

/// Two states compared.
struct Comparison {
    names: [String; 2],
    tick: [u64; 2],
    finding: Finding,
    states: [State; 2],
    differences: Vec<Difference>,
    /// Of them and those that were too many to keep.
    count: u64,
    /// What must be known to read them.
    notes: Vec<String>,
    exit: Exit,
}

impl Diff {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let files = Input::read_two(&self.a, &self.b, limit)?;
        let (files, choice) = match self.tick {
            Some(tick) => (files, Choice { tick: Some(tick), ..Choice::default() }),
            None => choose(files)?,
        };
        let comparison = self.compare(&files, choice)?;
        comparison.notes.iter().for_each(tell);
        if self.json {
            writeln!(out, "{:#}", comparison.json())?;
        } else {
            comparison.print(out)?;
        }
        Ok(comparison.exit)
    }

    fn compare(&self, [a, b]: &[Input; 2], choice: Choice) -> Result<Comparison, Failure> {
        let states = [State::at(a, choice.tick)?, State::at(b, choice.tick)?];
        let parsed = (states[0].snapshot(a)?, states[1].snapshot(b)?);
        let tick = [parsed.0.tick(), parsed.1.tick()];
        let mut all = diff(&parsed.0, &parsed.1);
        let differences: Vec<_> = all.by_ref().take(self.max).collect();
        let count = differences.len() as u64 + all.count() as u64;
        let mut notes: Vec<_> = choice.note.into_iter().collect();
        notes.extend(states[0].note(a, tick[0]));
        notes.extend(states[1].note(b, tick[1]));
        let finding = Finding::of(&states);
        if let Some(why) = choice.recordings.as_ref().filter(|_| finding == Finding::Equal) {
            notes.push(format!("the recordings differ, though not this state: {why}"));
        }
        let exit = match finding {
            Finding::Equal if choice.recordings.is_none() => Exit::Fine,
            Finding::Unproven if choice.recordings.is_none() => Exit::Unproven,
            _ => Exit::Different,
        };
        let names = [a, b].map(|input| input.name().to_owned());
        Ok(Comparison { names, tick, finding, states, differences, count, notes, exit })
    }
}

impl Finding {
    fn of(states: &[State; 2]) -> Self {
        let [a, b] = states;
        let as_recorded = states.iter().all(State::is_as_recorded);
        let known = states.iter().all(State::is_known);
        match a.hash() == b.hash() {
            true if as_recorded => Self::Equal,
            false if known => Self::Different,
            _ if a.told() != b.told() => Self::RecordedDifferent,
            _ => Self::Unproven,
        }
    }
}

impl Comparison {
    fn print(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let [a, b] = self.states.each_ref().map(State::hash);
        let [told_a, told_b] = self.states.each_ref().map(State::told);
        let (tick, differences) = (self.tick[0], counted(self.count, "difference"));
        match self.finding {
            Finding::Equal => writeln!(out, "equal at tick {tick}: {a}")?,
            Finding::Different => {
                writeln!(out, "{differences} at tick {tick}: {a} against {b}")?;
            }
            Finding::RecordedDifferent => {
                let told = format!("recorded hashes differ ({told_a} against {told_b})");
                writeln!(out, "tick {tick}: {told}; {}", self.unknown())?;
            }
            Finding::Unproven => {
                let told = format!("recorded hashes are equal ({told_a})");
                writeln!(out, "tick {tick}: {told}, but {}: nothing proven", self.unknown())?;
            }
        }
        let stepped = [Finding::RecordedDifferent, Finding::Unproven].contains(&self.finding);
        if stepped && self.count > 0 {
            writeln!(out, "{differences} in what was found instead: {a} against {b}")?;
        }
        Ok(self.differences.iter().try_for_each(|difference| writeln!(out, "{difference}"))?)
    }

    /// Which files do not hold the state that they recorded.
    fn unknown(&self) -> String {
        let sides = self.names.iter().zip(&self.states);
        let names: Vec<_> = sides
            .filter_map(|(name, state)| (!state.is_as_recorded()).then_some(name.as_str()))
            .collect();
        let hold = if names.len() == 1 { "holds" } else { "hold" };
        format!("{} {hold} no state of it", names.join(" and "))
    }

    fn json(&self) -> Value {
        let Self { names: _, tick, finding, states, differences, count, notes, exit: _ } = self;
        let equal = match finding {
            Finding::Equal => Some(true),
            Finding::Different | Finding::RecordedDifferent => Some(false),
            Finding::Unproven => None,
        };
        let origin = |state: &State| match state.origin() {
            Origin::Stored => "stored",
            Origin::Stepped => "stepped",
        };
        json!({
            "ticks": tick,
            "equal": equal,
            "recorded_hashes": states.each_ref().map(|state| state.told().to_string()),
            "hashes": states.each_ref().map(|state| state.hash().to_string()),
            "origins": states.each_ref().map(origin),
            "as_recorded": states.each_ref().map(State::is_as_recorded),
            "notes": notes,
            "count": count,
            "differences": differences.iter().map(json::difference).collect::<Vec<_>>(),
        })
    }
}

/// Chooses the states to compare; scenes are recorded if that is needed to know.
fn choose(files: [Input; 2]) -> Result<([Input; 2], Choice), Failure> {
    if let (Kind::Snapshot(snapshot), _) | (_, Kind::Snapshot(snapshot)) =
        (files[0].open()?, files[1].open()?)
    {
        let choice = Choice { tick: Some(snapshot.tick()), ..Choice::default() };
        return Ok((files, choice));
    }
    for file in &files {
        if matches!(file.open()?, Kind::Hashes(_)) {
            return Err(file.other_kind("a snapshot, a replay or a scene"));
        }
    }
    let files = recorded(files)?;
    let [a, b] = &files;
    let choice = Choice::of([a, b], &[a.replay()?, b.replay()?])?;
    Ok((files, choice))
}

impl Choice {
    /// The first tick in which two recordings differ, or else the last that both have.
    fn of(files: [&Input; 2], replays: &[Replay<'_>; 2]) -> Result<Self, Failure> {
        let [a, b] = replays;
        let found = bisect_replays(a, b);
        if found.compared == 0 {
            let why = format!("no tick in common with {}", files[1].name());
            return Err(files[0].unproven(why));
        }
        let last = span(a)[1].min(span(b)[1]);
        let recordings = recordings(&found, replays);
        let Some(Parting { tick, .. }) = found.state else {
            return Ok(Self { tick: found.stored.or(Some(last)), note: None, recordings });
        };
        let (later, note) = match later(files, replays, tick..=last)? {
            Some((later, note)) => (later, Some(note)),
            None => (tick, None),
        };
        Ok(Self { tick: Some(later), note, recordings })
    }
}

/// Where a state at the first of these ticks is unknown: the first later one at which both states
/// are known and differ, if there is any, and why it is compared instead.
fn later(
    files: [&Input; 2],
    replays: &[Replay<'_>; 2],
    ticks: RangeInclusive<u64>,
) -> Result<Option<(u64, String)>, Failure> {
    let first = *ticks.start();
    let sides = unknown(files, replays, first)?;
    // Stepping cannot find back to what the machine had: only from what it stored it goes on.
    let stored: BTreeSet<_> = sides.iter().flat_map(|&side| replays[side].stored_ticks()).collect();
    for tick in stored.into_iter().filter(|tick| ticks.contains(tick)) {
        let [a, b] = replays.each_ref().map(|replay| recorded_hash(replay, tick));
        if a != b && unknown(files, replays, tick)?.is_empty() {
            let names: Vec<_> = sides.iter().map(|&side| files[side].name()).collect();
            let names = names.join(" and ");
            let note = format!(
                "the recordings differ from tick {first} on, but the state that {names} had then \
                 is not in it, only its hash: tick {tick} is the first with states of both"
            );
            return Ok(Some((tick, note)));
        }
    }
    Ok(None)
}

/// Which of two recordings do not tell the state at a tick.
fn unknown(
    files: [&Input; 2],
    replays: &[Replay<'_>; 2],
    tick: u64,
) -> Result<Vec<usize>, Failure> {
    let mut unknown = Vec::new();
    for (side, replay) in replays.iter().enumerate() {
        if !State::replayed(files[side], replay, Some(tick))?.is_known() {
            unknown.push(side);
        }
    }
    Ok(unknown)
}

/// How two recordings differ; `None` if they do not.
fn recordings(found: &Bisection, replays: &[Replay<'_>; 2]) -> Option<String> {
    let text = |replay| {
        let [first, end] = span(replay);
        format!("{first} to {end}")
    };
    let [a, b] = replays.each_ref().map(text);
    if let Some(parting) = found.state {
        return Some(format!("stepped again, tick {} is not as recorded", parting.tick));
    }
    if let Some(tick) = found.inputs {
        return Some(format!("the inputs of tick {tick} differ"));
    }
    if let Some(tick) = found.stored {
        return Some(format!("the stored states of tick {tick} differ"));
    }
    (a != b).then(|| format!("ticks {a} against {b}"))
}
