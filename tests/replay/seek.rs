//! Going to any tick of a recording.

use verlock::replay::{Replay, seek};
use verlock::snapshot::DecodeReason;
use verlock::world::World;

use super::{commands, record};
use crate::support::worlds::small;

/// Wherever one goes, the world is the one that stepping there makes.
#[test]
fn seeking_equals_stepping() {
    for interval in [0, 1, 4, 7, 30] {
        let bytes = record(20, interval).replay();
        let replay = Replay::parse(&bytes).expect("a sound replay");
        let frames = 20_u32.checked_div(interval).unwrap_or(0);
        assert_eq!(replay.keyframe_ticks().count(), frames as usize);
        let mut world = small();
        for tick in 2..=22 {
            let mut found: World = seek(&replay, tick).expect("a recorded tick");
            assert_eq!(found.save(), world.save(), "tick {tick}, keyframes every {interval}");
            world.step(&commands(tick));
            found.step(&commands(tick));
            assert_eq!(found.hash(), world.hash(), "after tick {tick}");
        }
    }
}

/// A keyframe is what one starts from: were it another, one would arrive elsewhere.
#[test]
fn seeking_uses_the_keyframe() {
    let [plain, other] = [record(20, 5), record(20, 5)].map(|recorder| recorder.replay());
    let parts = crate::support::container::Parts::of(&plain);
    let range = parts.range(6);
    assert!(range.len() > 4 && plain == other);
    let mut damaged = parts.clone();
    damaged.section(6)[0] ^= 1; // the magic number of the first
    let bytes = damaged.file();
    let replay = Replay::parse(&bytes).expect("keyframes are looked at when they are used");
    for tick in 2..=22 {
        let found = seek::<World>(&replay, tick).map(|world| world.tick());
        match found {
            Ok(found) => assert!(found == tick && !(7..12).contains(&tick), "tick {tick}"),
            Err(error) => {
                assert!((7..12).contains(&tick), "tick {tick}: {error}");
                assert_eq!(error.offset, range.start as u64);
                assert_eq!(error.reason, DecodeReason::NotThisKind);
            }
        }
    }
}

/// Outside the recording there is nothing to go to.
#[test]
fn seeking_beyond_the_recording_is_refused() {
    let bytes = record(20, 5).replay();
    let replay = Replay::parse(&bytes).expect("a sound replay");
    for tick in [0, 1, 23, u64::MAX] {
        let error = seek::<World>(&replay, tick).expect_err("not recorded");
        match error.reason {
            DecodeReason::OutOfRange(range) => assert_eq!(range.field, "tick"),
            reason => unreachable!("{reason}"),
        }
    }
}
