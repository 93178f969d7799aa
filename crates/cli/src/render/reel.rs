//! The worlds that are shown.

use verlock::World;
use verlock::replay::seek;
use verlock::scene::Scene;

use crate::failure::{Failure, tell};
use crate::input::{Input, Kind};
use crate::progress::Progress;
use crate::state::{Origin, check_tick, recorded_hash, span};

/// Ticks at equal distances.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Ticks {
    pub(super) from: u64,
    pub(super) to: u64,
    /// At least 1.
    pub(super) every: u64,
}

/// What a file tells of some ticks; it can be played again and again.
pub(super) struct Reel<'a> {
    input: &'a Input,
    kind: Kind<'a>,
    ticks: Ticks,
    /// The world at the first tick.
    start: World,
}

impl Ticks {
    pub(super) fn iter(self) -> impl Iterator<Item = u64> {
        let mut next = Some(self.from);
        std::iter::from_fn(move || {
            let tick = next.filter(|&tick| tick <= self.to)?;
            next = tick.checked_add(self.every);
            Some(tick)
        })
    }

    /// How many there are.
    pub(super) fn count(self) -> u64 {
        (self.to - self.from) / self.every + 1
    }

    fn contains(self, tick: u64) -> bool {
        (tick - self.from).is_multiple_of(self.every)
    }
}

impl<'a> Reel<'a> {
    /// One tick, by default a snapshot's only, a replay's last, a scene's first.
    pub(super) fn still(input: &'a Input, tick: Option<u64>) -> Result<Self, Failure> {
        let kind = input.open()?;
        tell_beyond(&kind, input, tick.unwrap_or(0));
        let start = world_at(input, &kind, tick)?;
        let (from, to) = (start.tick(), start.tick());
        Ok(Self { input, kind, ticks: Ticks { from, to, every: 1 }, start })
    }

    /// Several ticks, by default all that the file tells of.
    pub(super) fn moving(
        input: &'a Input,
        from: Option<u64>,
        to: Option<u64>,
        every: u64,
    ) -> Result<Self, Failure> {
        let kind = input.open()?;
        let (from, to) = match &kind {
            Kind::Scene(scene) => (from.unwrap_or(0), to.unwrap_or(scene.ticks())),
            Kind::Snapshot(snapshot) => {
                (from.unwrap_or(snapshot.tick()), to.unwrap_or(snapshot.tick()))
            }
            Kind::Replay(replay) => {
                let to = check_tick(input, to, span(replay))?;
                (from.unwrap_or(replay.first_tick()), to)
            }
            Kind::Hashes(_) => return Err(input.other_kind(PICTURED)),
        };
        if from > to {
            return Err(Failure::usage(format!("--from {from} is later than --to {to}")));
        }
        if let Kind::Snapshot(snapshot) = &kind {
            check_tick(input, Some(to), [snapshot.tick(); 2])?;
        }
        tell_beyond(&kind, input, to);
        let start = world_at(input, &kind, Some(from))?;
        Ok(Self { input, kind, ticks: Ticks { from, to, every }, start })
    }

    pub(super) fn ticks(&self) -> Ticks {
        self.ticks
    }

    /// Shows the world of each tick; returns the one it ended with.
    pub(super) fn play(
        &self,
        progress: &Progress,
        mut show: impl FnMut(&World) -> Result<(), Failure>,
    ) -> Result<World, Failure> {
        let mut world = self.start.clone();
        loop {
            if self.ticks.contains(world.tick()) {
                show(&world)?;
            }
            if world.tick() >= self.ticks.to {
                return Ok(world);
            }
            self.step(&mut world)?;
            progress.step();
        }
    }

    fn step(&self, world: &mut World) -> Result<(), Failure> {
        let commands = match &self.kind {
            Kind::Scene(scene) => Scene::commands(scene, world),
            Kind::Replay(replay) => {
                let inputs = replay.inputs_at::<World>(world.tick());
                inputs.map_err(|error| self.input.undecoded(error))?
            }
            // A snapshot has one tick only, and hashes make no pictures.
            Kind::Snapshot(_) | Kind::Hashes(_) => Vec::new(),
        };
        world.step(&commands);
        Ok(())
    }

    /// What must be said of a world that is not the recorded one.
    pub(super) fn note(&self, world: &World) -> Option<String> {
        let Kind::Replay(replay) = &self.kind else { return None };
        let tick = world.tick();
        let other = recorded_hash(replay, tick) != Some(world.hash());
        // Playing goes on from the first world; that one may be in the file.
        let stored = tick == self.ticks.from && replay.stored_ticks().any(|stored| stored == tick);
        let origin = if stored { Origin::Stored } else { Origin::Stepped };
        other.then(|| origin.another(self.input, tick))
    }
}

/// Says that a tick is later than those that a scene describes.
fn tell_beyond(kind: &Kind<'_>, input: &Input, tick: u64) {
    if let Kind::Scene(scene) = kind
        && tick > scene.ticks()
    {
        let (name, end) = (input.name(), scene.ticks());
        tell(format_args!("{name}: tick {tick} is beyond its end at tick {end}"));
    }
}

/// What can be shown.
const PICTURED: &str = "a scene, a replay or a snapshot";

/// The world at a tick; by default a snapshot's, a replay's last, a scene's first.
fn world_at(input: &Input, kind: &Kind<'_>, tick: Option<u64>) -> Result<World, Failure> {
    match kind {
        Kind::Scene(scene) => {
            let mut world = input.world(scene)?;
            while world.tick() < tick.unwrap_or(0) {
                let commands = scene.commands(&world);
                world.step(&commands);
            }
            Ok(world)
        }
        Kind::Snapshot(snapshot) => {
            check_tick(input, tick, [snapshot.tick(); 2])?;
            snapshot.load().map_err(|error| input.undecoded(error))
        }
        Kind::Replay(replay) => {
            let tick = check_tick(input, tick, span(replay))?;
            seek(replay, tick).map_err(|error| input.undecoded(error))
        }
        Kind::Hashes(_) => Err(input.other_kind(PICTURED)),
    }
}
