//! Snapshots that were damaged on the way.

use verlock::snapshot::{DecodeError, DecodeReason};

use crate::support::container::{HEADER, Parts};
use crate::support::worlds::{other, small};

/// Tries to restore the bytes; the world must stay as it is.
fn refusal(bytes: &[u8]) -> DecodeError {
    let mut world = other();
    let (before, events) = (world.save(), world.events().to_vec());
    let error = world.restore(bytes).expect_err("damaged bytes");
    assert!(world.save() == before && world.events() == events, "{error}: world was touched");
    error
}

fn pair(error: DecodeError) -> (u64, DecodeReason) {
    (error.offset, error.reason)
}

/// No flipped bit goes unnoticed, and the error says where.
#[test]
fn every_flipped_byte_is_found() {
    let sound = small().save();
    let parts = Parts::of(&sound);
    let table_end = parts.table_end();
    for at in 0..sound.len() {
        for flip in [1, 2, 4, 8, 16, 32, 64, 128, 255] {
            let mut bytes = sound.clone();
            bytes[at] ^= flip;
            let (offset, reason) = pair(refusal(&bytes));
            let section = parts.parts.iter().map(|part| parts.range(part.kind));
            let expected = match at {
                0..8 => (0, "not this kind"),
                8..12 => (8, "format version"),
                12..16 => (12, "nothing proven"),
                // Another number of sections moves the end of the table.
                16..20 => (offset.clamp(16, sound.len() as u64), ""),
                20..HEADER => (20, "table"),
                _ if at < table_end + 16 => (HEADER as u64, "damaged"),
                _ => {
                    let mut all = section.filter(|range| range.contains(&at));
                    (all.next().expect("a section").start as u64, "damaged")
                }
            };
            assert_eq!(offset, expected.0, "byte {at} ^ {flip}: {reason}");
            assert!(reason.to_string().contains(expected.1), "byte {at} ^ {flip}: {reason}");
        }
    }
}

/// No missing end goes unnoticed, not even a whole section's.
#[test]
fn every_truncation_is_found() {
    let sound = small().save();
    for length in 0..sound.len() {
        let expected = (length as u64, DecodeReason::Truncated);
        assert_eq!(pair(refusal(&sound[..length])), expected);
    }
}

/// No appended byte goes unnoticed.
#[test]
fn every_appended_byte_is_found() {
    let sound = small().save();
    for more in [&[0][..], &[255], &sound] {
        let expected = (sound.len() as u64, DecodeReason::Trailing);
        assert_eq!(pair(refusal(&[&sound, more].concat())), expected);
    }
}

/// Another format and another simulation are told apart from damage.
#[test]
fn versions_are_refused_as_such() {
    let sound = small().save();
    for (at, reason) in
        [(8, DecodeReason::FormatVersion { found: 7 }), (12, DecodeReason::SimVersion { found: 7 })]
    {
        let mut bytes = sound.clone();
        bytes[at] = 7;
        assert_eq!(pair(refusal(&bytes)), (at as u64, reason));
        let repaired = Parts::of(&bytes).file();
        assert_eq!(pair(refusal(&repaired)), (at as u64, reason));
        assert_eq!(pair(refusal(&bytes[..at + 4])), (at as u64, reason), "from the header alone");
    }
}
