//! Snapshots and replays taken apart and put together again: by `FORMAT.md`, not by the library.

use std::ops::Range;

use verlock::Hash;

/// Bytes before the table of sections.
pub const HEADER: usize = 24;
/// Bytes of a row of the table.
pub const ENTRY: usize = 40;

/// A section of a file.
#[derive(Clone)]
pub struct Part {
    pub kind: u32,
    pub size: u32,
    pub bytes: Vec<u8>,
}

/// A file whose counts, lengths and hashes are made afresh when it is written.
#[derive(Clone)]
pub struct Parts {
    head: [u8; 16],
    pub parts: Vec<Part>,
}

impl Parts {
    /// Takes a sound file apart.
    pub fn of(file: &[u8]) -> Self {
        let count = u32_at(file, 16) as usize;
        let mut at = HEADER + count * ENTRY + 16;
        let part = |row: usize| {
            let (kind, size) = (u32_at(file, row), u32_at(file, row + 4));
            let length = usize::try_from(u64_at(file, row + 16)).expect("a length");
            let bytes = file[at..at + length].to_vec();
            at += length;
            Part { kind, size, bytes }
        };
        let parts = (0..count).map(|index| HEADER + index * ENTRY).map(part).collect();
        Self { head: *file.first_chunk().expect("a header"), parts }
    }

    /// The bytes of the section of this kind.
    pub fn section(&mut self, kind: u32) -> &mut Vec<u8> {
        let part = self.parts.iter_mut().find(|part| part.kind == kind);
        &mut part.expect("a section of this kind").bytes
    }

    /// Where in the file the section of this kind is.
    pub fn range(&self, kind: u32) -> Range<usize> {
        let index = self.parts.iter().position(|part| part.kind == kind).expect("a section");
        let before: usize = self.parts[..index].iter().map(|part| part.bytes.len()).sum();
        let start = self.table_end() + 16 + before;
        start..start + self.parts[index].bytes.len()
    }

    /// Where the table ends and its hash begins.
    pub fn table_end(&self) -> usize {
        HEADER + self.parts.len() * ENTRY
    }

    /// The file, with sound counts and hashes.
    pub fn file(&self) -> Vec<u8> {
        let mut out = self.head.to_vec();
        out.extend(u32::try_from(self.parts.len()).expect("few sections").to_le_bytes());
        out.extend([0; 4]);
        for Part { kind, size, bytes } in &self.parts {
            let length = bytes.len() as u64;
            out.extend(kind.to_le_bytes());
            out.extend(size.to_le_bytes());
            out.extend((length / u64::from(*size)).to_le_bytes());
            out.extend(length.to_le_bytes());
            out.extend(Hash::of(bytes).to_bytes());
        }
        out.extend(Hash::of(&out).to_bytes());
        self.parts.iter().for_each(|part| out.extend(&part.bytes));
        out
    }
}

/// Makes the hash of the table right again.
pub fn seal(mut file: Vec<u8>) -> Vec<u8> {
    let end = HEADER + u32_at(&file, 16) as usize * ENTRY;
    let hash = Hash::of(&file[..end]).to_bytes();
    file[end..end + 16].copy_from_slice(&hash);
    file
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(*bytes[at..].first_chunk().expect("4 bytes"))
}

fn u64_at(bytes: &[u8], at: usize) -> u64 {
    u64::from_le_bytes(*bytes[at..].first_chunk().expect("8 bytes"))
}
