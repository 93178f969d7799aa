//! The world that a file tells of.

use verlock::replay::{Replay, seek};
use verlock::scene::Scene;
use verlock::snapshot::Snapshot;
use verlock::{Hash, World};

use crate::failure::{Failure, tell};
use crate::input::{Input, Kind};

/// The world at a tick. Without one: a snapshot's only world, a replay's last, a scene's first.
pub(crate) fn world_at(input: &Input, tick: Option<u64>) -> Result<World, Failure> {
    match input.open()? {
        Kind::Snapshot(snapshot) => {
            check_tick(input, tick, snapshot.tick(), snapshot.tick())?;
            snapshot.load().map_err(|error| input.unproven(error))
        }
        Kind::Replay(replay) => replayed(input, &replay, tick),
        Kind::Scene(scene) => stepped(input, &scene, tick.unwrap_or(0)),
    }
}

/// The hash of the state at a tick, as it was recorded.
pub(crate) fn recorded_hash(replay: &Replay<'_>, tick: u64) -> Option<Hash> {
    if tick == replay.first_tick() {
        Snapshot::parse(replay.start_bytes()).ok().map(|start| start.hash())
    } else {
        replay.hash_after(tick.checked_sub(1)?)
    }
}

/// The tick after the last recorded one.
pub(crate) fn end(replay: &Replay<'_>) -> u64 {
    // `Replay::parse` has checked the sum.
    replay.first_tick() + replay.len()
}

/// The tick that was asked for, which must be one that the file tells of, or else the last.
pub(crate) fn check_tick(
    input: &Input,
    tick: Option<u64>,
    first: u64,
    last: u64,
) -> Result<u64, Failure> {
    let tick = tick.unwrap_or(last);
    if (first..=last).contains(&tick) {
        return Ok(tick);
    }
    let name = input.name();
    Err(Failure::usage(format!("{name}: tick {tick} is not in it, it goes from {first} to {last}")))
}

fn replayed(input: &Input, replay: &Replay<'_>, tick: Option<u64>) -> Result<World, Failure> {
    let tick = check_tick(input, tick, replay.first_tick(), end(replay))?;
    let world: World = seek(replay, tick).map_err(|error| input.unproven(error))?;
    if recorded_hash(replay, tick) != Some(world.hash()) {
        let name = input.name();
        tell(format_args!("{name}: tick {tick}: stepping again gives another state than recorded"));
    }
    Ok(world)
}

fn stepped(input: &Input, scene: &Scene, tick: u64) -> Result<World, Failure> {
    let mut world = scene.build().map_err(|error| input.unproven(error))?;
    while world.tick() < tick {
        let commands = scene.commands(&world);
        world.step(&commands);
    }
    Ok(world)
}
