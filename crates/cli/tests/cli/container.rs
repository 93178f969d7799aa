//! Files with changes that their hashes do not give away.

use std::ops::Range;

use verlock::Hash;

const HEADER: usize = 24;
const ROW: usize = 40;

/// Gives every section and the table the hash they should have.
pub(crate) fn repair(bytes: &mut [u8]) {
    for (index, section) in sections(bytes).into_iter().enumerate() {
        let hash = Hash::of(&bytes[section]).to_bytes();
        bytes[HEADER + index * ROW + 24..][..16].copy_from_slice(&hash);
    }
    let end = table_end(bytes);
    let hash = Hash::of(&bytes[..end]).to_bytes();
    bytes[end..][..16].copy_from_slice(&hash);
}

/// Where the sections are.
pub(crate) fn sections(bytes: &[u8]) -> Vec<Range<usize>> {
    let mut start = table_end(bytes) + 16;
    let rows = (HEADER..table_end(bytes)).step_by(ROW);
    rows.map(|row| {
        let length = u64::from_le_bytes(bytes[row + 16..][..8].try_into().expect("8 bytes"));
        let end = start + usize::try_from(length).expect("a small section");
        std::mem::replace(&mut start, end)..end
    })
    .collect()
}

fn table_end(bytes: &[u8]) -> usize {
    let count = u32::from_le_bytes(bytes[16..20].try_into().expect("4 bytes"));
    HEADER + ROW * count as usize
}
