//! Where two recordings part.

use verlock::Hash;
use verlock::replay::{Cause, HashLog, Parting, Recorder, Replay, bisect, bisect_replays};
use verlock::world::{Action, ObjectId, World};

use super::game::record as record_game;
use super::{commands, record};
use crate::support::container::Parts;
use crate::support::worlds::{command, distance, particle, small};

fn log(states: &[(u64, u128)]) -> HashLog {
    let mut log = HashLog::default();
    states.iter().for_each(|&(tick, hash)| log.insert(tick, Hash(hash)));
    log
}

fn replay(bytes: &[u8]) -> Replay<'_> {
    Replay::parse(bytes).expect("a sound replay")
}

/// Ten ticks of the recording that is tested here, with other commands in one of them.
fn record_with(tick: u64, action: Action) -> Vec<u8> {
    let mut recorder = Recorder::new(small(), 3);
    for now in 2..12 {
        let mut commands = commands(now);
        if now == tick {
            commands.push(command(77, action));
        }
        recorder.step(&commands);
    }
    recorder.replay()
}

/// The first difference counts, even where states become equal again; what only one of the logs
/// has is not compared.
#[test]
fn the_first_difference_is_found() {
    let a = log(&[(0, 1), (1, 2), (2, 3), (4, 5), (5, 6), (6, 7)]);
    let b = log(&[(0, 1), (2, 3), (3, 9), (4, 8), (5, 6), (6, 9)]);
    let found = bisect(&a, &b);
    assert_eq!((found.compared, found.differing), (5, 2));
    assert_eq!(found.spans, [Some([0, 6]); 2]);
    let (hashes, cause) = ([Hash(5), Hash(8)], Cause::Unknown);
    assert_eq!(found.state, Some(Parting { tick: 4, hashes, before: Some(2), cause }));
    assert!(!found.is_equal());
    assert!(bisect(&a, &a).is_equal());

    let start = bisect(&a, &log(&[(1, 3), (2, 3)])).state.expect("a difference");
    assert_eq!((start.tick, start.before, start.cause), (1, None, Cause::Start));
}

/// Logs of different lengths are not equal, and those without a common tick prove nothing.
#[test]
fn the_end_counts_too() {
    let a = log(&[(0, 1), (1, 2)]);
    let found = bisect(&a, &log(&[(0, 1), (1, 2), (2, 3)]));
    assert!(!found.is_equal() && found.state.is_none());
    assert_eq!((found.compared, found.spans), (2, [Some([0, 1]), Some([0, 2])]));
    for other in [log(&[(7, 1)]), HashLog::default()] {
        let found = bisect(&a, &other);
        assert!(!found.is_equal() && found.compared == 0 && found.state.is_none());
    }
    assert!(!bisect(&HashLog::default(), &HashLog::default()).is_equal());
}

/// Other inputs are to blame for another state, not the step.
#[test]
fn inputs_are_blamed() {
    let velocity = verlock::Vec3::Y;
    let push = Action::SetVelocity { particle: particle(4), velocity };
    let [a, b] = [record(10, 3).replay(), record_with(6, push)];
    let found = bisect_replays(&replay(&a), &replay(&b));
    assert_eq!((found.inputs, found.stored), (Some(6), None));
    let parting = found.state.expect("a difference");
    assert_eq!((parting.tick, parting.before, parting.cause), (7, Some(6), Cause::Inputs));
    assert_eq!(parting.hashes[1], replay(&b).hash_after(6).expect("a recorded tick"));
    assert!(bisect_replays(&replay(&a), &replay(&a)).is_equal());
}

/// Other inputs without effect are a difference, and are not blamed for a later one.
#[test]
fn inputs_without_effect_are_told() {
    let stale = Action::Remove { object: ObjectId::Distance(distance(1000)) };
    let [a, mut b] = [record(10, 0).replay(), record_with(5, stale)];
    let found = bisect_replays(&replay(&a), &replay(&b));
    assert_eq!((found.inputs, found.differing), (Some(5), 0));
    assert!(found.state.is_none() && !found.is_equal());

    let mut parts = Parts::of(&b);
    parts.section(3)[32 * 6 + 31] ^= 1; // the hash after tick 8
    b = parts.file();
    let found = bisect_replays(&replay(&a), &replay(&b));
    let parting = found.state.expect("a difference");
    assert_eq!((parting.tick, parting.before, parting.cause), (9, Some(8), Cause::Step));
    assert_eq!((found.inputs, found.differing), (Some(5), 1));
}

/// Stored states with equal hashes and other bytes: one of the hashes lies.
#[test]
fn stored_states_are_compared() {
    let sound = record(10, 3).replay();
    let mut parts = Parts::of(&sound);
    let last = parts.section(6).len() - 1;
    parts.section(6)[last] ^= 1; // of the keyframe before tick 11
    let changed = parts.file();
    let found = bisect_replays(&replay(&sound), &replay(&changed));
    assert_eq!((found.stored, found.differing), (Some(11), 0));
    assert!(!found.is_equal());
}

/// A recording that begins later is compared from there.
#[test]
fn later_recordings_are_compared() {
    let all = record(10, 3).replay();
    let mut recorder = Recorder::new(record(4, 0).into_simulation(), 0);
    (6..12).for_each(|tick| _ = recorder.step(&commands(tick)));
    let late = recorder.replay();
    let found = bisect_replays(&replay(&all), &replay(&late));
    assert_eq!((found.compared, found.differing, found.inputs), (7, 0, None));
    assert_eq!(found.spans, [Some([2, 12]), Some([6, 12])]);
    assert!(!found.is_equal());
}

/// Recordings of a game are compared without knowing the game.
#[test]
fn games_are_compared() {
    let bytes = record_game().replay();
    assert!(bisect_replays(&replay(&bytes), &replay(&bytes)).is_equal());
    let mut parts = Parts::of(&bytes);
    parts.section(2)[0] ^= 1; // the score at the start
    let changed = parts.file();
    let parting = bisect_replays(&replay(&bytes), &replay(&changed)).state.expect("a difference");
    assert_eq!((parting.tick, parting.before, parting.cause), (2, None, Cause::Start));
    assert_eq!(World::load(&small().save()).map(|world| world.tick()), Ok(2));
}
