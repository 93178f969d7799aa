//! Scenes as recordings, so that they can be compared with others.

use verlock::replay::Recorder;
use verlock::scene::Scene;

use crate::failure::Failure;
use crate::input::{Input, Kind};
use crate::progress::Progress;
use crate::state::span;

/// No scene is recorded for longer, whatever the file claims with which it is to be compared.
const TICKS_MAX: u64 = 10_000_000;

/// The two files, with each scene recorded for as long as the other file goes, or for its own
/// length if that is a scene too.
pub(crate) fn recorded([a, b]: [Input; 2]) -> Result<[Input; 2], Failure> {
    let ends = [end(&a.open()?), end(&b.open()?)];
    Ok([record(a, ends[1])?, record(b, ends[0])?])
}

/// The last tick of which a file tells a state; `None` for a scene, which can go on for ever.
fn end(kind: &Kind<'_>) -> Option<u64> {
    match kind {
        Kind::Snapshot(snapshot) => Some(snapshot.tick()),
        Kind::Replay(replay) => Some(span(replay)[1]),
        Kind::Hashes(log) => Some(log.span().map_or(0, |[_, last]| last)),
        Kind::Scene(_) => None,
    }
}

fn record(input: Input, end: Option<u64>) -> Result<Input, Failure> {
    let Kind::Scene(scene) = input.open()? else { return Ok(input) };
    let ticks = end.unwrap_or(scene.ticks());
    if ticks > TICKS_MAX {
        return Err(input.unproven(format_args!("no scene is stepped for {ticks} ticks")));
    }
    let bytes = replay(&input, &scene, ticks)?;
    Ok(Input::new(input.name().to_owned(), bytes))
}

fn replay(input: &Input, scene: &Scene, ticks: u64) -> Result<Vec<u8>, Failure> {
    let world = input.world(scene)?;
    let mut recorder = Recorder::new(world, 0);
    let progress = Progress::new(input.name(), ticks, "ticks");
    for _ in 0..ticks {
        let commands = scene.commands(recorder.simulation());
        recorder.step(&commands);
        progress.step();
    }
    Ok(recorder.replay())
}
