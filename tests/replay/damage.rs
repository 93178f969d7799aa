//! Replays that were damaged on the way, or tampered with.

use verlock::replay::{Divergence, DivergenceKind, Replay, VerifyError, verify};
use verlock::snapshot::{DecodeReason, Snapshot};
use verlock::world::World;

use super::{commands, record};
use crate::support::alloc::peak;
use crate::support::container::{ENTRY, HEADER, Parts, seal};

const INFO: u32 = 1;
const START: u32 = 2;
const TICK: u32 = 3;
const INPUT: u32 = 4;
const KEYFRAME: u32 = 5;
const STATE: u32 = 6;

/// Bytes of a tick's record.
const TICK_SIZE: usize = 32;

/// Reading and verifying a small file takes no more memory than this, whatever it claims.
const MEMORY_MAX: u64 = 256 << 10;

/// What a file proves.
fn outcome(bytes: &[u8]) -> Result<(), VerifyError> {
    let (result, used) = peak(|| verify::<World>(&Replay::parse(bytes)?, |_| ()));
    if let Err(VerifyError::Decode(error)) = result {
        assert!(error.offset <= bytes.len() as u64, "{error}");
    }
    assert!(used <= MEMORY_MAX, "{used} bytes allocated");
    result
}

/// What a file with sound hashes proves, which must be the opposite.
fn divergence(parts: &Parts) -> Divergence {
    match outcome(&parts.file()) {
        Err(VerifyError::Diverged(divergence)) => divergence,
        other => unreachable!("{other:?}"),
    }
}

fn refusal(bytes: &[u8]) -> (u64, DecodeReason) {
    match outcome(bytes) {
        Err(VerifyError::Decode(error)) => (error.offset, error.reason),
        other => unreachable!("{other:?}"),
    }
}

/// No flipped bit, no missing end and no appended byte goes unnoticed.
#[test]
fn every_damage_is_found() {
    let sound = record(5, 2).replay();
    assert_eq!(outcome(&sound), Ok(()));
    for at in 0..sound.len() {
        for flip in [1, 2, 4, 8, 16, 32, 64, 128, 255] {
            let mut bytes = sound.clone();
            bytes[at] ^= flip;
            refusal(&bytes);
        }
        assert_eq!(refusal(&sound[..at]), (at as u64, DecodeReason::Truncated));
    }
    let length = sound.len() as u64;
    assert_eq!(refusal(&[&sound[..], &[0]].concat()), (length, DecodeReason::Trailing));
    let mut old = sound;
    old[12] = 0;
    let expected = (12, DecodeReason::SimVersion { found: 0 });
    assert_eq!(refusal(&old), expected);
    assert_eq!(refusal(&seal(old)), expected);
}

/// A snapshot is no replay, and a replay no snapshot.
#[test]
fn the_kinds_of_files_are_told_apart() {
    let replay = record(1, 0).replay();
    assert_eq!(refusal(&super::small().save()), (0, DecodeReason::NotThisKind));
    let error = Snapshot::parse(&replay).expect_err("no snapshot");
    assert_eq!((error.offset, error.reason), (0, DecodeReason::NotThisKind));
}

/// Whatever byte of the commands is changed, the tick is named: even where nothing comes of it,
/// as of a token.
#[test]
fn every_changed_command_is_found() {
    let sound = Parts::of(&record(7, 3).replay());
    let mut at = 0;
    for tick in 2..9 {
        let row = (tick - 2) * TICK_SIZE;
        let record = &sound.parts[2].bytes[row..row + TICK_SIZE];
        let [inputs, length] = [0, 4]
            .map(|k| u32::from_le_bytes(*record[k..].first_chunk().expect("4 bytes")) as usize);
        assert_eq!(inputs, commands(tick as u64).len());
        for at in at..at + length {
            for flip in [1, 0x80, 0xff] {
                let mut parts = sound.clone();
                parts.section(INPUT)[at] ^= flip;
                let found = divergence(&parts);
                let expected = (tick as u64, DivergenceKind::Inputs);
                assert_eq!((found.tick, found.kind), expected, "byte {at} ^ {flip}");
            }
        }
        at += length;
    }
    assert_eq!(at, sound.parts[3].bytes.len());
}

/// Whatever byte of a tick's record is changed, the tick is named, or the record.
#[test]
fn every_changed_record_is_found() {
    let sound = Parts::of(&record(7, 3).replay());
    let range = sound.range(TICK);
    for at in 0..range.len() {
        for flip in [1, 0x80, 0xff] {
            let mut parts = sound.clone();
            parts.section(TICK)[at] ^= flip;
            let tick = (2 + at / TICK_SIZE) as u64;
            let bytes = parts.file();
            match at % TICK_SIZE {
                // Another number of inputs than there are bytes for.
                0..4 => {
                    let (offset, reason) = refusal(&bytes);
                    let inputs = sound.range(INPUT);
                    let inputs = inputs.start as u64..=inputs.end as u64;
                    assert!(inputs.contains(&offset), "byte {at} ^ {flip}: offset {offset}");
                    assert_eq!(reason, DecodeReason::Record);
                }
                4..8 => assert_eq!(refusal(&bytes), (range.start as u64, DecodeReason::Layout)),
                8..16 => {
                    let found = divergence(&parts);
                    assert_eq!((found.tick, found.kind), (tick, DivergenceKind::Inputs));
                }
                _ => {
                    let found = divergence(&parts);
                    assert_eq!((found.tick, found.kind), (tick, DivergenceKind::State));
                    assert_ne!(found.recorded, found.found);
                }
            }
        }
    }
}

/// Another start, and a keyframe that is not the state: the first tick they show in is named.
#[test]
fn another_state_is_found() {
    let sound = Parts::of(&record(7, 3).replay());
    // The last particle, which nothing holds, a little elsewhere, hashes and all.
    let moved = |state: &[u8]| {
        let mut state = Parts::of(state);
        state.section(3)[4 * 24] ^= 1;
        state.file()
    };
    let mut parts = sound.clone();
    let start = parts.section(START);
    *start = moved(start);
    let found = divergence(&parts);
    assert_eq!((found.tick, found.kind), (2, DivergenceKind::State));

    let length = u64::from_le_bytes(*sound.parts[4].bytes[8..].first_chunk().expect("8 bytes"));
    let first = usize::try_from(length).expect("a length");
    for (tick, range) in [(4, 0..first), (7, first..sound.parts[5].bytes.len())] {
        let mut parts = sound.clone();
        let states = parts.section(STATE);
        let state = moved(&states[range.clone()]);
        states.splice(range, state);
        let found = divergence(&parts);
        assert_eq!((found.tick, found.kind), (tick, DivergenceKind::Keyframe));
    }
}

/// Keyframes of other ticks than they say, twice, out of order, or not there at all.
#[test]
fn keyframes_must_be_what_they_say() {
    let sound = Parts::of(&record(7, 3).replay());
    let layout = |parts: &Parts, kind| {
        let expected = (parts.range(kind).start as u64, DecodeReason::Layout);
        assert_eq!(refusal(&parts.file()), expected);
    };
    for (row, ticks) in [(0, [0, 2, 8, 10, u64::MAX]), (1, [0, 2, 5, 10, u64::MAX])] {
        for tick in ticks {
            let mut parts = sound.clone();
            parts.section(KEYFRAME)[16 * row..][..8].copy_from_slice(&tick.to_le_bytes());
            layout(&parts, KEYFRAME);
        }
    }
    let mut early = sound.clone();
    early.section(KEYFRAME)[0] -= 1;
    layout(&early, STATE);
    let mut missing = sound.clone();
    missing.section(KEYFRAME).truncate(16);
    layout(&missing, KEYFRAME);
    for length in [0, 1, 1 << 32, u64::MAX] {
        let mut parts = sound.clone();
        parts.section(KEYFRAME)[8..16].copy_from_slice(&length.to_le_bytes());
        layout(&parts, KEYFRAME);
    }
}

/// Other contents of the first record: refused without a panic, or another simulation's.
#[test]
fn any_other_info_is_answered() {
    let sound = Parts::of(&record(7, 3).replay());
    for (at, width) in [(16, 4), (24, 8), (32, 8)] {
        for value in [0, 1, 3, 6, 8, 1 << 31, 1 << 58, 1 << 59, 1 << 63, u64::MAX] {
            let mut parts = sound.clone();
            let field = &mut parts.section(INFO)[at..at + width];
            field.copy_from_slice(&value.to_le_bytes()[..width]);
            if parts.file() != sound.file() {
                assert!(outcome(&parts.file()).is_err(), "{value:#x} at {at}");
            }
        }
    }
    // How often keyframes were saved is only a note.
    let mut parts = sound.clone();
    parts.section(INFO)[20] ^= 1;
    assert_eq!(outcome(&parts.file()), Ok(()));
    for records in [0, 2] {
        let mut parts = sound.clone();
        let info = parts.section(INFO);
        *info = info.repeat(records);
        assert_eq!(refusal(&parts.file()).1, DecodeReason::Record);
    }
}

/// A table that claims more than there is, and ticks that do: refused before anything is allocated.
#[test]
fn any_claim_of_the_table_is_answered() {
    let sound = record(7, 3).replay();
    let sizes = [40, 1, 32, 1, 16, 1];
    for (row, size) in sizes.into_iter().enumerate() {
        let at = HEADER + row * ENTRY;
        for count in [1_u64 << 20, 1 << 32, 1 << 58] {
            let mut bytes = sound.clone();
            let length = count * size;
            bytes[at + 8..at + 16].copy_from_slice(&count.to_le_bytes());
            bytes[at + 16..at + 24].copy_from_slice(&length.to_le_bytes());
            let expected = (sound.len() as u64, DecodeReason::Truncated);
            assert_eq!(refusal(&seal(bytes)), expected);
        }
    }
    let sound = Parts::of(&sound);
    for index in 0..sound.parts.len() {
        let mut fewer = sound.clone();
        fewer.parts.remove(index);
        assert_eq!(refusal(&fewer.file()), (16, DecodeReason::Layout));
    }
}
