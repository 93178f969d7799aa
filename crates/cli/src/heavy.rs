//! `verlock heavy`: every tick in every way there is to come to it.

use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use verlock::replay::{Heavy as Stepper, HeavyError, Mismatch, seek};
use verlock::scene::Scene;
use verlock::snapshot::{DecodeError, Difference, Section, Snapshot, diff};
use verlock::{Command, Hash, World};

use crate::count::counted;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::files::{REPLAY, SCENE, files};
use crate::input::{Input, Kind};
use crate::jobs::in_order;
use crate::json;
use crate::progress::Progress;
use crate::tally::Tally;

/// No more differences are told of one file.
const DIFFERENCES_MAX: usize = 20;

/// Step every tick in every way, and compare
///
/// Steps scenes and replays. At every tick the world is also loaded from its own bytes, restored
/// over another world, and cloned over another world; each of them is stepped, and all must have
/// the hash of the world that simply went on. So a stale cache, a stale hash or a field that is
/// not saved is found in the tick in which it first matters. Of replays the recorded hashes are
/// compared too. Goes on with the next file whatever it finds.
#[derive(Debug, clap::Args)]
pub(crate) struct Heavy {
    /// Scenes and replays, or folders with *.scene.ron and *.replay
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// Compare all bytes of every state too
    #[arg(long)]
    exact: bool,

    /// Number of files to step at once
    #[arg(long, value_name = "N", default_value = "1")]
    jobs: NonZeroUsize,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// What came of a file.
struct Outcome {
    /// The file's.
    name: String,
    /// Ticks that were the same in every way.
    ticks: u64,
    fault: Option<Fault>,
}

/// What was not the same.
struct Fault {
    /// Its state is the one before this tick is stepped.
    tick: u64,
    what: String,
    /// The sections of which a hash was kept that is not that of their bytes.
    stale: Vec<Section>,
    differences: Vec<Difference>,
}

impl Heavy {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let mut tally = Tally::new("sound");
        let mut paths = Vec::new();
        for path in &self.paths {
            match files(path, &[REPLAY, SCENE]) {
                Ok(files) => paths.extend(files),
                Err(failure) => tally.note_failure(path, &failure),
            }
        }
        let mut ticks = 0;
        let work = |path: &PathBuf| self.step(path, limit);
        // Of many at once, the files are counted instead of their ticks.
        let progress =
            (self.jobs.get() != 1).then(|| Progress::new("heavy", paths.len() as u64, "files"));
        in_order(&paths, self.jobs.get(), work, |path, outcome| {
            progress.iter().for_each(Progress::step);
            match outcome {
                Ok(outcome) => {
                    ticks += outcome.ticks;
                    if !self.json {
                        outcome.print(out)?;
                    }
                    tally.note(&outcome.name, outcome.fault.is_none(), outcome.json());
                }
                Err(failure) => tally.note_failure(path, &failure),
            }
            Ok::<(), Failure>(())
        })?;
        let exit = tally.exit();
        if self.json {
            let mut report = tally.into_json("files");
            report.insert("ticks".into(), ticks.into());
            writeln!(out, "{:#}", Value::Object(report))?;
        } else {
            let ticks = counted(ticks, "tick");
            writeln!(out, "{}: {ticks} in 4 ways each", tally.line("file"))?;
        }
        Ok(exit)
    }

    fn step(&self, path: &Path, limit: u64) -> Result<Outcome, Failure> {
        let input = Input::read(path, limit)?;
        match input.open()? {
            Kind::Scene(scene) => {
                let world = input.world(&scene)?;
                let commands = |world: &World| {
                    (world.tick() < scene.ticks()).then(|| Ok(scene.commands(world)))
                };
                self.go(&input, world, scene.ticks(), commands, |_| None)
            }
            Kind::Replay(replay) => {
                let world = seek(&replay, replay.first_tick());
                let world = world.map_err(|error| input.undecoded(error))?;
                let mut inputs = replay.inputs_by_tick::<World>();
                let recorded = |tick| replay.hash_after(tick);
                self.go(&input, world, replay.len(), |_| inputs.next(), recorded)
            }
            _ => Err(input.other_kind("a scene or a replay")),
        }
    }

    /// Steps a world with the commands of each tick until there are no more, or something differs.
    fn go(
        &self,
        input: &Input,
        world: World,
        ticks: u64,
        mut commands: impl FnMut(&World) -> Option<Result<Vec<Command>, DecodeError>>,
        recorded: impl Fn(u64) -> Option<Hash>,
    ) -> Result<Outcome, Failure> {
        if ticks == 0 {
            return Err(input.unproven("it has no ticks"));
        }
        let progress = (self.jobs.get() == 1).then(|| Progress::new(input.name(), ticks, "ticks"));
        let heavy = Stepper::new(world, dirt());
        let mut heavy = if self.exact { heavy.exact() } else { heavy };
        let mut outcome = Outcome { name: input.name().to_owned(), ticks: 0, fault: None };
        while let Some(commands) = commands(heavy.simulation()) {
            let commands = commands.map_err(|error| input.undecoded(error))?;
            let tick = heavy.simulation().tick();
            outcome.fault = match heavy.step(&commands) {
                Ok(found) => recorded(tick)
                    .filter(|recorded| *recorded != found)
                    .map(|recorded| Fault::recorded(tick + 1, recorded, found)),
                Err(error) => Some(Fault::of(&error, &heavy)),
            };
            if outcome.fault.is_some() {
                break;
            }
            outcome.ticks += 1;
            progress.iter().for_each(Progress::step);
        }
        Ok(outcome)
    }
}

/// A world that has little in common with others: objects of every kind, freed slots, hashes that
/// are kept and caches that are filled.
fn dirt() -> World {
    let scene = Scene::parse(DIRT).expect("a scene");
    let mut world = scene.build().expect("a world");
    for _ in 0..scene.ticks() {
        let commands = scene.commands(&world);
        world.step(&commands);
    }
    let _ = world.hash();
    world
}

const DIRT: &str = "(
    version: 1,
    ticks: 2,
    particles: [
        (pinned: true), (position: (1, 0, 0)), (position: (2, 0, 0)), (position: (3, 0, 0)),
        (position: (4, 0, 0)), (position: (5, 0, 0)), (position: (6, 0, 0)),
    ],
    distances: [(a: 0, b: 1), (a: 1, b: 2), (a: 2, b: 3), (a: 4, b: 5), (a: 5, b: 6)],
    volumes: [(corners: (0, 1, 2, 3)), (corners: (0, 4, 5, 6))],
    faces: [(corners: (1, 2, 3), drag: 1), (corners: (4, 5, 6), drag: 1)],
    half_spaces: [(point: (0, -1, 0))],
    timeline: [(tick: 1, action: Remove(object: Particle(3)))],
)";

impl Fault {
    fn recorded(tick: u64, recorded: Hash, found: Hash) -> Self {
        let what = format!("state of tick {tick}: {found}, but {recorded} was recorded");
        Self { tick, what, stale: Vec::new(), differences: Vec::new() }
    }

    fn of(error: &HeavyError, heavy: &Stepper<World>) -> Self {
        let what = error.to_string();
        let (mut stale, mut differences) = (Vec::new(), Vec::new());
        if let HeavyError::Differs(mismatch) = error {
            let Mismatch { way, states: [own, found], .. } = &**mismatch;
            if let (Ok(own), Ok(found)) = (Snapshot::parse(own), Snapshot::parse(found)) {
                stale = stale_hashes(heavy.simulation(), &own);
                stale.extend(stale_hashes(heavy.other(*way), &found));
                differences = diff(&own, &found).take(DIFFERENCES_MAX).collect();
            }
        }
        Self { tick: heavy.simulation().tick(), what, stale, differences }
    }
}

/// The sections of which a world keeps another hash than that of the bytes it saves.
fn stale_hashes(world: &World, saved: &Snapshot<'_>) -> Vec<Section> {
    let kept = world.part_hashes().into_iter();
    let wrong = kept.filter(|(section, hash)| saved.part_hash(*section) != *hash);
    wrong.map(|(section, _)| section).collect()
}

impl Outcome {
    fn print(&self, out: &mut dyn Write) -> io::Result<()> {
        let name = &self.name;
        let Some(Fault { tick: _, what, stale, differences }) = &self.fault else {
            return writeln!(out, "{name}: sound: {}", counted(self.ticks, "tick"));
        };
        writeln!(out, "{name}: diverged: {what}")?;
        for section in stale {
            writeln!(out, "  {section}: the hash that was kept is not that of the bytes")?;
        }
        differences.iter().try_for_each(|difference| writeln!(out, "  {difference}"))
    }

    fn json(&self) -> Value {
        let mut row = json!({ "ticks": self.ticks });
        if let Some(Fault { tick, what, stale, differences }) = &self.fault {
            row["divergence"] = json!({
                "tick": tick,
                "what": what,
                "stale_hashes": stale.iter().map(|section| section.name()).collect::<Vec<_>>(),
                "differences": differences.iter().map(json::difference).collect::<Vec<_>>(),
            });
        }
        row
    }
}
