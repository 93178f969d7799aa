//! `verlock run`: steps a scene.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;

use serde_json::{Value, json};
use verlock::replay::{HashLog, Recorder};
use verlock::scene::Scene;
use verlock::world::EventKind;
use verlock::{Event, World};

use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::Input;
use crate::progress::Progress;
use crate::report::Report;
use crate::target::Target;

/// Step a scene, and record it
///
/// Prints the tick, the number of objects of each kind, the events by kind, and the hash of the
/// last state. Says which commands of the timeline were refused, or not reached.
#[derive(Debug, clap::Args)]
pub(crate) struct Run {
    /// Scene to step
    scene: PathBuf,

    /// Number of ticks, if not the scene's own
    #[arg(long, value_name = "N")]
    ticks: Option<u64>,

    /// Write a replay
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,

    /// Ticks between two keyframes of the replay, 0 for none
    #[arg(long, value_name = "TICKS", default_value_t = 600)]
    keyframes: u32,

    /// Write a snapshot of the last state
    #[arg(long, value_name = "FILE")]
    save: Option<PathBuf>,

    /// Write the tick and hash of every state, a line each
    #[arg(long, value_name = "FILE")]
    hashes: Option<PathBuf>,

    /// Print every event
    #[arg(long)]
    events: bool,

    /// Overwrite files
    #[arg(long)]
    force: bool,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// The files that a run writes.
struct Targets {
    record: Option<Target>,
    save: Option<Target>,
    hashes: Option<Target>,
}

/// What is kept of a run besides the recording.
#[derive(Default)]
struct Journal {
    kinds: BTreeMap<&'static str, u64>,
    /// All events, if they are wanted.
    events: Vec<Event>,
    /// The hash of every state, if they are wanted.
    hashes: HashLog,
    /// What became of commands of the timeline that did nothing.
    idle: Vec<String>,
}

/// No more idle commands are told of.
const IDLE_MAX: usize = 20;

impl Run {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let targets = self.targets()?;
        let input = Input::read(&self.scene, limit)?;
        let scene = input.scene()?;
        let world = input.world(&scene)?;

        let interval = if self.record.is_some() { self.keyframes } else { 0 };
        let mut recorder = Recorder::new(world, interval);
        let journal = self.step(&scene, &mut recorder, input.name());

        if let Some(target) = &targets.record {
            target.write(&recorder.replay(), out)?;
        }
        if let Some(target) = &targets.save {
            target.write(&recorder.simulation().save(), out)?;
        }
        if let Some(target) = &targets.hashes {
            target.write(journal.hashes.to_string().as_bytes(), out)?;
        }
        // What is said about the run must not mix with a file on stdout.
        let mut aside = anstream::stderr();
        let out = if targets.use_stdout() { &mut aside } else { out };
        self.print(recorder.simulation(), &journal, out)?;
        journal.tell(input.name());
        Ok(Exit::Fine)
    }

    fn targets(&self) -> Result<Targets, Failure> {
        let paths: Vec<_> =
            [&self.record, &self.save, &self.hashes].into_iter().flatten().collect();
        if (1..paths.len()).any(|index| paths[..index].contains(&paths[index])) {
            return Err(Failure::usage("two outputs cannot go to the same file"));
        }
        let target = |path: &Option<PathBuf>| {
            path.as_ref().map(|path| Target::new(path.clone(), self.force)).transpose()
        };
        let targets = Targets {
            record: target(&self.record)?,
            save: target(&self.save)?,
            hashes: target(&self.hashes)?,
        };
        if targets.iter().any(|target| target.is(&self.scene)) {
            let scene = self.scene.display();
            return Err(Failure::usage(format!("{scene}: the scene itself would be overwritten")));
        }
        Ok(targets)
    }

    fn step(&self, scene: &Scene, recorder: &mut Recorder<World>, name: &str) -> Journal {
        let ticks = self.ticks.unwrap_or(scene.ticks());
        let progress = Progress::new(name, ticks, "ticks");
        let mut journal = Journal::default();
        if self.hashes.is_some() {
            journal.note_hash(recorder.simulation());
        }
        for _ in 0..ticks {
            let commands = scene.commands(recorder.simulation());
            recorder.step(&commands);
            let world = recorder.simulation();
            if self.hashes.is_some() {
                journal.note_hash(world);
            }
            journal.note_events(world.events(), self.events);
            journal.note_refusals(scene, world);
            progress.step();
        }
        journal.note_late(scene, recorder.simulation());
        journal
    }

    fn print(&self, world: &World, journal: &Journal, out: &mut dyn Write) -> Result<(), Failure> {
        let mut report = Report::default();
        report.add("tick", world.tick());
        report.add_counts("", world);
        report.add("events", json!(journal.kinds));
        report.add("hash", world.hash().to_string());
        if self.events && self.json {
            report.add("log", journal.events.iter().map(event).collect::<Vec<_>>());
        } else {
            journal.events.iter().try_for_each(|event| writeln!(out, "{event}"))?;
        }
        Ok(report.print(self.json, out)?)
    }
}

impl Targets {
    fn use_stdout(&self) -> bool {
        self.iter().any(Target::is_stdout)
    }

    fn iter(&self) -> impl Iterator<Item = &Target> {
        let Self { record, save, hashes } = self;
        [record, save, hashes].into_iter().flatten()
    }
}

impl Journal {
    fn note_hash(&mut self, world: &World) {
        self.hashes.insert(world.tick(), world.hash());
    }

    fn note_events(&mut self, events: &[Event], keep: bool) {
        for event in events {
            *self.kinds.entry(kind(event)).or_default() += 1;
        }
        if keep {
            self.events.extend_from_slice(events);
        }
    }

    /// Notes which commands of the timeline were refused in the last tick.
    fn note_refusals(&mut self, scene: &Scene, world: &World) {
        let refused = world.events().iter().filter_map(|event| match event.kind {
            EventKind::Refused { sequence, why, .. } => Some((event.tick, sequence, why)),
            _ => None,
        });
        let mut refused = refused.peekable();
        let Some(&(tick, ..)) = refused.peek() else { return };
        let due: Vec<_> = scene.timeline().filter(|(_, due)| *due == tick).collect();
        for (_, sequence, why) in refused {
            // What comes after the timeline's commands is the storm's.
            if let Some((place, _)) = due.get(sequence as usize) {
                self.idle.push(format!("{place}: tick {tick}: refused: {why}"));
            }
        }
    }

    /// Notes which commands of the timeline were not reached.
    fn note_late(&mut self, scene: &Scene, world: &World) {
        let end = world.tick();
        let late = scene.timeline().filter(|(_, tick)| *tick >= end);
        let late = late.map(|(place, tick)| format!("{place}: tick {tick} is not reached"));
        self.idle.extend(late);
    }

    /// Tells of commands that did nothing.
    fn tell(&self, name: &str) {
        self.idle.iter().take(IDLE_MAX).for_each(|idle| tell(format_args!("{name}: {idle}")));
        if let Some(more) = self.idle.len().checked_sub(IDLE_MAX).filter(|more| *more > 0) {
            tell(format_args!("{name}: {more} more commands of the timeline did nothing"));
        }
    }
}

fn event(event: &Event) -> Value {
    json!({ "tick": event.tick, "kind": kind(event), "text": event.to_string() })
}

fn kind(event: &Event) -> &'static str {
    match event.kind {
        EventKind::Spawned { .. } => "spawned",
        EventKind::Removed { .. } => "removed",
        EventKind::Broken { .. } => "broken",
        EventKind::Refused { .. } => "refused",
        EventKind::DisplacementClamped { .. } => "displacement-clamped",
        EventKind::WorldLimit { .. } => "world-limit",
        _ => "other",
    }
}
