//! The frame of snapshots and replays, written a second time from its description, so that files
//! can be made whose hashes are right and whose contents are not.

use std::ops::Range;

use verlock::Hash;
use verlock::replay::{DivergenceKind, Replay, VerifyError, verify};
use verlock::snapshot::SIM_VERSION;
use verlock::world::World;

/// Bytes before the table.
pub const HEADER: usize = 24;
/// Bytes of a row of the table.
pub const ENTRY: usize = 40;
const HASH: usize = 16;
/// No file has more sections.
const SECTIONS_MAX: usize = 32;
/// The first bytes of a snapshot, of which a replay holds several.
const SNAPSHOT: &[u8] = b"\x89VLSNAP\n";
/// The first bytes of a replay.
const REPLAY: &[u8] = b"\x89VLREPL\n";
/// The section of a replay that holds the ticks, counted from 0.
const TICKS: usize = 2;
/// Bytes of its records, and where in them are the hashes of the inputs and of the state.
const TICK: usize = 32;
const INPUT_HASH: usize = 8;
const STATE_HASH: usize = 16;
/// No more ticks are repaired.
const REPAIRS_MAX: usize = 32;

/// Where the sections are, as far as the bytes reach.
#[must_use]
pub fn sections(bytes: &[u8]) -> Vec<Range<usize>> {
    let Some(end) = table_end(bytes) else { return vec![] };
    let mut start = end + HASH;
    let rows = bytes[HEADER..end].chunks(ENTRY);
    rows.map(|row| {
        let length = row[16..].first_chunk().map_or(0, |raw| u64::from_le_bytes(*raw));
        let rest = bytes.len() - start;
        let section = start..start + usize::try_from(length).unwrap_or(rest).min(rest);
        start = section.end;
        section
    })
    .collect()
}

/// Where the table ends and its hash begins; `None` if the bytes end before the sections.
fn table_end(bytes: &[u8]) -> Option<usize> {
    let count = u32::from_le_bytes(*bytes.get(16..)?.first_chunk()?);
    let count = usize::try_from(count).map_or(SECTIONS_MAX, |count| count.min(SECTIONS_MAX));
    Some(HEADER + count * ENTRY).filter(|end| end + HASH <= bytes.len())
}

/// Makes every hash of a file right, those of the snapshots in it first; returns how long it is.
pub fn repair(bytes: &mut [u8]) -> usize {
    let Some(table_end) = table_end(bytes) else { return bytes.len() };
    let mut end = table_end + HASH;
    for (index, section) in sections(bytes).into_iter().enumerate() {
        end = section.end;
        let payload = &mut bytes[section];
        let mut done = 0;
        while payload[done..].starts_with(SNAPSHOT) {
            done += repair(&mut payload[done..]);
        }
        let hash = Hash::of(payload).to_bytes();
        let row = HEADER + index * ENTRY;
        bytes[row + ENTRY - HASH..row + ENTRY].copy_from_slice(&hash);
    }
    let hash = Hash::of(&bytes[..table_end]).to_bytes();
    bytes[table_end..table_end + HASH].copy_from_slice(&hash);
    end
}

/// Writes into the ticks of a replay the hashes that stepping it finds, so that it verifies as far
/// as its inputs can be read.
pub fn record_again(bytes: &mut [u8]) {
    for _ in 0..REPAIRS_MAX {
        let (first, result) = match Replay::parse(bytes) {
            Ok(replay) if replay.len() <= super::replay::TICKS_MAX => {
                (replay.first_tick(), verify::<World>(&replay, |_| ()))
            }
            _ => return,
        };
        let Err(VerifyError::Diverged(divergence)) = result else { return };
        let found = divergence.found.to_bytes();
        let index = usize::try_from(divergence.tick - first).unwrap_or(0);
        let record = sections(bytes)[TICKS].start + index * TICK;
        match divergence.kind {
            DivergenceKind::Inputs => {
                bytes[record + INPUT_HASH..record + STATE_HASH].copy_from_slice(&found[..8]);
            }
            DivergenceKind::State => {
                bytes[record + STATE_HASH..record + TICK].copy_from_slice(&found);
            }
            _ => return,
        }
        repair(bytes);
    }
}

/// Says that a file was made by this version of the simulation, which must then bear it out.
pub fn restamp(bytes: &mut [u8]) {
    let stamp = |file: &mut [u8]| file[12..16].copy_from_slice(&SIM_VERSION.to_le_bytes());
    for at in 0..bytes.len().saturating_sub(HEADER) {
        if bytes[at..].starts_with(SNAPSHOT) || bytes[at..].starts_with(REPLAY) {
            stamp(&mut bytes[at..]);
        }
    }
    repair(bytes);
    record_again(bytes);
}
