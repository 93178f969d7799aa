//! `verlock bisect`: where two recordings part.

use std::io::Write;
use std::path::PathBuf;

use serde_json::{Value, json};
use verlock::replay::{Bisection, Cause, HashLog, Parting, Replay, bisect, bisect_replays, seek};
use verlock::snapshot::Section;
use verlock::{Hash, World};

use crate::exit::Exit;
use crate::failure::Failure;
use crate::input::{Input, Kind};
use crate::recording::recorded;
use crate::report::Report;
use crate::state::{State, recorded_hash, simulation};

/// Find the first tick in which two recordings differ
///
/// Compares all hashes that both have, and the inputs and stored states of replays. Tells the first
/// different state, the last equal one before it, and whether the inputs between the two already
/// differ: then they are to blame, otherwise the step is. Stepping again tells with which of the
/// two this machine agrees. Hash logs are what `run --hashes` writes: a line for every state, its
/// tick and its hash. Returns 1 if anything differs.
#[derive(Debug, clap::Args)]
#[command(after_long_help = KEYS)]
pub(crate) struct Bisect {
    /// Replay, hash log or scene
    a: PathBuf,

    /// What to compare it with
    b: PathBuf,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

const KEYS: &str = "\
What is told, as far as it is known:
  equal                  whether nothing differs
  compared_states        states whose hash both have
  different_states       those of them that differ
  a, b                   the first and the last tick of each
  simulations            their names and versions, if those differ
  tick, hashes           the first state that differs
  last_equal_tick        the last state before it that does not
  cause, why             start, inputs, step or unknown
  different_inputs_tick  the first tick that was stepped with different inputs
  different_stored_tick  the first tick of which both hold a state, with different bytes
  known_states           whether each file holds or gives the state that differs, not only its hash
  missing_states         what to do about a state that is not known
  this_machine           whose hash stepping the last equal state gives here
  sections               the parts of the state that differ
  next                   the command that tells more";

/// What a file recorded.
enum Recording<'a> {
    Replay(Replay<'a>),
    Hashes(HashLog),
}

impl Bisect {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let files = recorded(Input::read_two(&self.a, &self.b, limit)?)?;
        let [a, b] = [Recording::of(&files[0])?, Recording::of(&files[1])?];
        let found = match (&a, &b) {
            (Recording::Replay(a), Recording::Replay(b)) => bisect_replays(a, b),
            _ => bisect(&a.log(), &b.log()),
        };
        if found.compared == 0 {
            let why = format!("no tick in common with {}", files[1].name());
            return Err(files[0].unproven(why));
        }
        let mut report = report(&found);
        if let (Recording::Replay(a), Recording::Replay(b)) = (&a, &b) {
            add_simulations(&mut report, [a, b]);
        }
        if let Some(parting) = &found.state {
            add_states(&mut report, &files, parting);
        }
        report.print(self.json, out)?;
        Ok(if found.is_equal() { Exit::Fine } else { Exit::Different })
    }
}

impl<'a> Recording<'a> {
    fn of(input: &'a Input) -> Result<Self, Failure> {
        match input.open()? {
            Kind::Replay(replay) => Ok(Self::Replay(replay)),
            Kind::Hashes(log) => Ok(Self::Hashes(log)),
            _ => Err(input.other_kind("a replay, a hash log or a scene")),
        }
    }

    fn log(&self) -> HashLog {
        match self {
            Self::Replay(replay) => HashLog::of(replay),
            Self::Hashes(log) => log.clone(),
        }
    }
}

fn report(found: &Bisection) -> Report {
    let Bisection { compared, differing, spans, state, inputs, stored } = found;
    let mut report = Report::default();
    report.add("equal", found.is_equal());
    report.add("compared_states", *compared);
    report.add("different_states", *differing);
    for (name, span) in ["a", "b"].into_iter().zip(spans) {
        let span = span.map(|[first, last]| json!({ "first_tick": first, "last_tick": last }));
        report.add(name, span);
    }
    if let Some(Parting { tick, hashes: [a, b], before, cause }) = state {
        report.add("tick", *tick);
        report.add("hashes", json!({ "a": a.to_string(), "b": b.to_string() }));
        report.add("last_equal_tick", *before);
        let (cause, why) = tell(*cause);
        report.add("cause", cause);
        report.add("why", why);
    }
    report.add("different_inputs_tick", *inputs);
    report.add("different_stored_tick", *stored);
    report
}

/// Adds whose recordings these are, if that differs.
fn add_simulations(report: &mut Report, replays: [&Replay<'_>; 2]) {
    let [a, b] = replays.map(|replay| format!("{} {}", simulation(replay), replay.version()));
    if a != b {
        report.add("simulations", json!({ "a": a, "b": b }));
    }
}

fn tell(cause: Cause) -> (&'static str, &'static str) {
    match cause {
        Cause::Start => ("start", "the first states that both have already differ"),
        Cause::Inputs => ("inputs", "the last equal state was stepped with different inputs"),
        Cause::Step => (
            "step",
            "the last equal state was stepped with the same inputs: the step came out differently, \
             or the state was changed behind its back",
        ),
        _ => ("unknown", "hash logs do not tell the inputs"),
    }
}

/// Adds what can be known of the states that differ, if both files are replays of worlds.
fn add_states(report: &mut Report, files: &[Input; 2], parting: &Parting) {
    let state = |input| State::at(input, Some(parting.tick)).ok();
    let states = files.each_ref().map(state);
    // Whether what stepping gives here, or what was stored, is what was recorded there.
    let known = states.each_ref().map(|state| state.as_ref().map(State::is_known));
    let [a, b] = known;
    report.add("known_states", json!({ "a": a, "b": b }));
    if parting.cause == Cause::Step {
        let found = files[0].replay().ok().and_then(|replay| step_again(&replay, parting));
        report.add("this_machine", found.map(|found| agreement(found, parting)));
    }
    let tick = parting.tick;
    let missing = files.iter().zip(known).filter(|(_, known)| *known == Some(false));
    let missing = missing.map(|(file, _)| {
        let name = file.name();
        Value::from(format!(
            "{name} holds no state of tick {tick}: record it again with a keyframe there \
             (`run --keyframes {tick}`, `Recorder::keyframe`)"
        ))
    });
    let missing: Vec<_> = missing.collect();
    if !missing.is_empty() {
        report.add("missing_states", missing);
    }
    let [Some(a), Some(b)] = states else { return };
    let states = [a, b];
    let mut next = format!("verlock diff {} {}", files[0].name(), files[1].name());
    if known == [Some(true); 2] {
        next = format!("{next} --tick {}", parting.tick);
        let sections = different_sections(&states, files).unwrap_or_default();
        let names = sections.into_iter().map(|section| Value::from(section.name()));
        report.add("sections", names.collect::<Vec<_>>());
    }
    report.add("next", next);
}

/// The sections in which two states differ.
fn different_sections(states: &[State; 2], files: &[Input; 2]) -> Result<Vec<Section>, Failure> {
    let [a, b] = [states[0].snapshot(&files[0])?, states[1].snapshot(&files[1])?];
    let differs = |section: &Section| a.part_hash(*section) != b.part_hash(*section);
    Ok(Section::ALL.into_iter().filter(differs).collect())
}

/// The hash that this machine comes to from the last equal state; `None` if that is not known.
fn step_again(replay: &Replay<'_>, parting: &Parting) -> Option<Hash> {
    let before = parting.before?;
    let mut world: World = seek(replay, before).ok()?;
    if recorded_hash(replay, before) != Some(world.hash()) {
        return None;
    }
    world.step(&replay.inputs_at::<World>(before).ok()?);
    Some(world.hash())
}

fn agreement(found: Hash, parting: &Parting) -> &'static str {
    match parting.hashes.map(|hash| hash == found) {
        [true, _] => "agrees with a",
        [_, true] => "agrees with b",
        _ => "agrees with neither",
    }
}
