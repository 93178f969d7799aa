//! Any bytes are a replay or are not, and any replay verifies or does not.

use verlock::replay::{
    Divergence, DivergenceKind, HashLog, Replay, VerifyError, bisect_replays, seek, verify,
};
use verlock::world::World;

use super::snapshot::is_inside;
use super::world::{is_small, is_sound};

/// Replays that are longer are only parsed.
pub(super) const TICKS_MAX: u64 = 16;

/// A replay that verifies is what stepping gives, at every tick and from every keyframe; one that
/// does not says where. True if the replay verifies.
pub fn replay(bytes: &[u8]) -> bool {
    let replay = match Replay::parse(bytes) {
        Ok(replay) => replay,
        Err(error) => {
            is_inside(error, bytes);
            return false;
        }
    };
    is_consistent(&replay);
    let small = World::load(replay.start_bytes()).is_ok_and(|world| is_small(&world));
    if replay.len() > TICKS_MAX || !small {
        return false;
    }
    let mut next = replay.first_tick();
    let result = verify::<World>(&replay, |world| {
        next += 1;
        assert_eq!(world.tick(), next, "ticks are verified one by one");
        assert_eq!(Some(world.hash()), replay.hash_after(next - 1));
        is_sound(world);
    });
    match result {
        Ok(()) => {
            assert!(next == replay.first_tick() + replay.len() && !replay.is_empty());
            can_be_sought(&replay);
            return true;
        }
        Err(VerifyError::Decode(error)) => is_inside(error, bytes),
        Err(VerifyError::Empty) => assert!(replay.is_empty()),
        Err(VerifyError::Diverged(divergence)) => is_first(&replay, divergence, next),
        Err(error) => unreachable!("{error}"),
    }
    false
}

/// What a replay tells about itself without being stepped.
fn is_consistent(replay: &Replay<'_>) {
    let (first, last) = (replay.first_tick(), replay.first_tick() + replay.len());
    let keyframes: Vec<u64> = replay.keyframe_ticks().collect();
    assert!(keyframes.is_sorted_by(|a, b| a < b), "keyframes in order");
    assert!(keyframes.iter().all(|&tick| first < tick && tick <= last), "keyframes inside");
    assert_eq!(replay.hash_after(last), None);
    assert_eq!(replay.is_empty(), replay.hash_after(first).is_none());
    assert!(replay.input_count() <= u64::from(u32::MAX) * replay.len());
    let log = HashLog::of(replay);
    assert!(log.to_string().parse() == Ok(log), "a hash log survives its text");
    assert!(bisect_replays(replay, replay).is_equal(), "a replay is equal to itself");
}

/// Seeking gives the state that was verified.
fn can_be_sought(replay: &Replay<'_>) {
    let (first, last) = (replay.first_tick(), replay.first_tick() + replay.len());
    for tick in first..=last {
        let world: World = seek(replay, tick).expect("what was verified can be sought");
        assert_eq!(world.tick(), tick);
        if tick > first {
            assert_eq!(Some(world.hash()), replay.hash_after(tick - 1), "sought tick {tick}");
        }
    }
    assert!(seek::<World>(replay, last + 1).is_err(), "sought beyond the end");
}

/// A divergence names the first tick that was not verified, and what differs.
fn is_first(replay: &Replay<'_>, divergence: Divergence, next: u64) {
    let Divergence { tick, kind, recorded, found } = divergence;
    assert_ne!(recorded, found, "{divergence}");
    assert_eq!(tick, next, "{divergence}");
    match kind {
        DivergenceKind::State => assert_eq!(Some(recorded), replay.hash_after(tick)),
        DivergenceKind::Keyframe => assert!(replay.keyframe_ticks().any(|at| at == tick + 1)),
        _ => assert!(recorded.0 >> 64 == 0, "{divergence}"),
    }
}
