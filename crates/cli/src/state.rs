//! The state at some tick of a file.

use verlock::replay::{Replay, seek};
use verlock::scene::Scene;
use verlock::snapshot::Snapshot;
use verlock::{Hash, World};

use crate::failure::Failure;
use crate::input::{Input, Kind};

/// A state as bytes, and how it was come by.
#[derive(Debug)]
pub(crate) struct State {
    bytes: Vec<u8>,
    hash: Hash,
    origin: Origin,
    /// The hash that the file gives for it.
    recorded: Option<Hash>,
}

/// How a state was come by.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Origin {
    /// Its bytes are in the file.
    Stored,
    /// It was stepped to, from bytes that are in the file or from the start of a scene.
    Stepped,
}

impl Origin {
    /// What must be said of a state that was come by like this and is not the recorded one.
    pub(crate) fn another(self, input: &Input, tick: u64) -> String {
        let how = match self {
            Self::Stored => "the stored state is another one than recorded",
            Self::Stepped => "stepping again gives another state than recorded",
        };
        format!("{}: tick {tick}: {how}", input.name())
    }
}

impl State {
    /// The state at a tick. Without one: a snapshot's only state, a replay's last, a scene's first.
    ///
    /// Bytes that are in the file are taken before the state is stepped to: what a machine stored
    /// is what it had, while stepping gives what this one makes of it.
    pub(crate) fn at(input: &Input, tick: Option<u64>) -> Result<Self, Failure> {
        match input.open()? {
            Kind::Snapshot(snapshot) => {
                check_tick(input, tick, [snapshot.tick(); 2])?;
                Ok(Self::stored(input.bytes(), &snapshot, None))
            }
            Kind::Replay(replay) => Self::replayed(input, &replay, tick),
            Kind::Scene(scene) => stepped(input, &scene, tick.unwrap_or(0)),
            Kind::Hashes(_) => Err(input.other_kind("a snapshot, a replay or a scene")),
        }
    }

    /// The state at a tick of a replay.
    pub(crate) fn replayed(
        input: &Input,
        replay: &Replay<'_>,
        tick: Option<u64>,
    ) -> Result<Self, Failure> {
        let tick = check_tick(input, tick, span(replay))?;
        let recorded = recorded_hash(replay, tick);
        if let Some(bytes) = replay.stored_bytes(tick)
            && let Ok(snapshot) = Snapshot::parse(bytes)
            && snapshot.tick() == tick
        {
            // It may be out of range, as only a faulty machine stores it: all the more wanted.
            return Ok(Self::stored(bytes, &snapshot, recorded));
        }
        // Tells what is wrong with a stored state too.
        let world: World = seek(replay, tick).map_err(|error| input.undecoded(error))?;
        Ok(Self::stepped(&world, recorded))
    }

    fn stored(bytes: &[u8], snapshot: &Snapshot<'_>, recorded: Option<Hash>) -> Self {
        let (bytes, hash) = (bytes.to_vec(), snapshot.hash());
        Self { bytes, hash, origin: Origin::Stored, recorded }
    }

    fn stepped(world: &World, recorded: Option<Hash>) -> Self {
        Self { bytes: world.save(), hash: world.hash(), origin: Origin::Stepped, recorded }
    }

    pub(crate) fn hash(&self) -> Hash {
        self.hash
    }

    pub(crate) fn origin(&self) -> Origin {
        self.origin
    }

    /// The hash that the file gives for it, or else its own.
    pub(crate) fn told(&self) -> Hash {
        self.recorded.unwrap_or(self.hash)
    }

    /// Whether it is the state that the file is about: what was stored, or what was stepped to and
    /// has the recorded hash. If not, the hash is all that is known of the state.
    pub(crate) fn is_known(&self) -> bool {
        self.origin == Origin::Stored || self.is_as_recorded()
    }

    /// Whether it has the hash that the file gives for it, if it gives one.
    pub(crate) fn is_as_recorded(&self) -> bool {
        self.recorded.is_none_or(|recorded| recorded == self.hash)
    }

    /// What must be said if the file gives another hash.
    pub(crate) fn note(&self, input: &Input, tick: u64) -> Option<String> {
        (!self.is_as_recorded()).then(|| self.origin.another(input, tick))
    }

    pub(crate) fn snapshot(&self, input: &Input) -> Result<Snapshot<'_>, Failure> {
        Snapshot::parse(&self.bytes).map_err(|error| input.undecoded(error))
    }
}

/// The name of the simulation that a replay is of.
pub(crate) fn simulation(replay: &Replay<'_>) -> String {
    String::from_utf8_lossy(&replay.name()).trim_end_matches('\0').to_owned()
}

/// The hash of the state at a tick, as it was recorded.
pub(crate) fn recorded_hash(replay: &Replay<'_>, tick: u64) -> Option<Hash> {
    if tick == replay.first_tick() {
        Snapshot::parse(replay.start_bytes()).ok().map(|start| start.hash())
    } else {
        replay.hash_after(tick.checked_sub(1)?)
    }
}

/// The first tick of a replay, and the one after its last.
pub(crate) fn span(replay: &Replay<'_>) -> [u64; 2] {
    // `Replay::parse` has checked the sum.
    [replay.first_tick(), replay.first_tick() + replay.len()]
}

/// The tick that was asked for, which must be one that the file tells of, or else the last.
pub(crate) fn check_tick(
    input: &Input,
    tick: Option<u64>,
    [first, last]: [u64; 2],
) -> Result<u64, Failure> {
    let tick = tick.unwrap_or(last);
    if (first..=last).contains(&tick) {
        return Ok(tick);
    }
    let name = input.name();
    Err(Failure::usage(format!("{name}: tick {tick} is not in it, it goes from {first} to {last}")))
}

fn stepped(input: &Input, scene: &Scene, tick: u64) -> Result<State, Failure> {
    let mut world = input.world(scene)?;
    while world.tick() < tick {
        let commands = scene.commands(&world);
        world.step(&commands);
    }
    Ok(State::stepped(&world, None))
}
