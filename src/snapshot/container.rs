//! The frame that snapshots and replays share.
//!
//! ```text
//! magic 8 | format u32 | SIM_VERSION u32 | sections u32 | 0 u32
//! per section: kind u32 | record size u32 | records u64 | length u64 | hash 16
//! hash of all of the above 16
//! the sections, in the order of the table, without gaps
//! ```

use alloc::vec::Vec;

use super::{DecodeError, DecodeReason, Hash, SIM_VERSION};

/// Bytes before the table.
const HEADER: usize = 24;
/// Bytes of a row of the table.
const ENTRY: usize = 40;
const HASH: usize = 16;
/// No format has more sections.
const SECTIONS_MAX: u32 = 32;

/// What tells one kind of file from another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContainerKind {
    pub(crate) magic: [u8; 8],
    pub(crate) format: u32,
}

/// A row of the table.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Entry {
    /// What the section holds.
    pub kind: u32,
    /// Bytes a record.
    pub size: u32,
    /// The number of records.
    pub count: u64,
    /// Bytes of the section: `size * count`.
    pub length: u64,
    /// Hash of the section.
    pub hash: Hash,
    /// Where the section starts in the file; not stored.
    pub offset: u64,
}

/// A file whose table and hashes have been checked; borrows the bytes.
#[derive(Clone, Debug)]
pub struct Container<'a> {
    entries: Vec<Entry>,
    /// The bytes of each section.
    payloads: Vec<&'a [u8]>,
    hash: Hash,
}

impl<'a> Container<'a> {
    /// Checks a file: kind, versions, table, every hash, and that nothing follows. O(bytes), and
    /// allocates only the table.
    pub(crate) fn parse(bytes: &'a [u8], kind: ContainerKind) -> Result<Self, DecodeError> {
        let error = |offset: usize, reason| Err(DecodeError::new(offset as u64, reason));
        match bytes.get(..8) {
            None if kind.magic.starts_with(bytes) => {
                return error(bytes.len(), DecodeReason::Truncated);
            }
            Some(magic) if magic == kind.magic => {}
            _ => return error(0, DecodeReason::NotThisKind),
        }
        let format = u32_at(bytes, 8)?;
        if format != kind.format {
            return error(8, DecodeReason::FormatVersion { found: format });
        }
        let found = u32_at(bytes, 12)?;
        if found != SIM_VERSION {
            return error(12, DecodeReason::SimVersion { found });
        }
        let count = u32_at(bytes, 16)?;
        if count > SECTIONS_MAX {
            return error(16, DecodeReason::Layout);
        }
        if u32_at(bytes, 20)? != 0 {
            return error(20, DecodeReason::Layout);
        }
        let table_end = HEADER + count as usize * ENTRY;
        let hash = Hash::from_bytes(array_at(bytes, table_end)?);
        if Hash::of(&bytes[..table_end]) != hash {
            return error(HEADER, DecodeReason::Damaged);
        }
        let mut container = Self { entries: Vec::new(), payloads: Vec::new(), hash };
        let mut offset = table_end + HASH;
        for index in 0..count as usize {
            offset += container.read_section(bytes, HEADER + index * ENTRY, offset)?;
        }
        if offset == bytes.len() { Ok(container) } else { error(offset, DecodeReason::Trailing) }
    }

    /// Reads and checks a row of the table and its section, which starts at `offset`; returns the
    /// section's length. Kinds ascend, sizes agree, the hash holds.
    fn read_section(
        &mut self,
        bytes: &'a [u8],
        at: usize,
        offset: usize,
    ) -> Result<usize, DecodeError> {
        let entry = Entry {
            kind: u32_at(bytes, at)?,
            size: u32_at(bytes, at + 4)?,
            count: u64::from_le_bytes(array_at(bytes, at + 8)?),
            length: u64::from_le_bytes(array_at(bytes, at + 16)?),
            hash: Hash::from_bytes(array_at(bytes, at + 24)?),
            offset: offset as u64,
        };
        let ascends = self.entries.last().is_none_or(|last| last.kind < entry.kind);
        let fits = entry.count.checked_mul(u64::from(entry.size)) == Some(entry.length);
        if !(ascends && fits && entry.size > 0) {
            return Err(DecodeError::new(at as u64, DecodeReason::Layout));
        }
        let rest = bytes.get(offset..).unwrap_or_default();
        let Some(payload) = usize::try_from(entry.length).ok().and_then(|n| rest.get(..n)) else {
            return Err(DecodeError::new(bytes.len() as u64, DecodeReason::Truncated));
        };
        if Hash::of(payload) != entry.hash {
            return Err(DecodeError::new(entry.offset, DecodeReason::Damaged));
        }
        self.entries.push(entry);
        self.payloads.push(payload);
        Ok(payload.len())
    }

    /// The hash of the header and the table, and through them of everything.
    #[must_use]
    pub fn hash(&self) -> Hash {
        self.hash
    }

    /// The table.
    #[must_use]
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The row of a kind and the bytes of its section.
    pub(crate) fn section(&self, kind: u32) -> Option<(&Entry, &'a [u8])> {
        let sections = self.entries.iter().zip(&self.payloads);
        sections.map(|(entry, bytes)| (entry, *bytes)).find(|(entry, _)| entry.kind == kind)
    }
}

fn array_at<const N: usize>(bytes: &[u8], at: usize) -> Result<[u8; N], DecodeError> {
    let found = bytes.get(at..).and_then(|rest| rest.first_chunk());
    found.copied().ok_or(DecodeError::new(bytes.len() as u64, DecodeReason::Truncated))
}

fn u32_at(bytes: &[u8], at: usize) -> Result<u32, DecodeError> {
    array_at(bytes, at).map(u32::from_le_bytes)
}

/// Collects the table of a file; sections come in ascending order of their kinds.
#[derive(Debug)]
pub(crate) struct ContainerWriter {
    head: Vec<u8>,
    sections: u32,
}

impl ContainerWriter {
    pub(crate) fn new(kind: ContainerKind) -> Self {
        let mut head = Vec::with_capacity(HEADER + 10 * ENTRY + HASH);
        head.extend_from_slice(&kind.magic);
        head.extend_from_slice(&kind.format.to_le_bytes());
        head.extend_from_slice(&SIM_VERSION.to_le_bytes());
        head.extend_from_slice(&[0; 8]);
        Self { head, sections: 0 }
    }

    /// Adds a row for `count` records of `size` bytes with this hash.
    pub(crate) fn entry(&mut self, kind: u32, size: u32, count: u64, hash: Hash) {
        self.head.extend_from_slice(&kind.to_le_bytes());
        self.head.extend_from_slice(&size.to_le_bytes());
        self.head.extend_from_slice(&count.to_le_bytes());
        // Records are in memory: their bytes are counted by 64 bits.
        self.head.extend_from_slice(&(u64::from(size) * count).to_le_bytes());
        self.head.extend_from_slice(&hash.to_bytes());
        self.sections += 1;
        self.head[16..20].copy_from_slice(&self.sections.to_le_bytes());
    }

    /// The hash of header and table.
    pub(crate) fn hash(&self) -> Hash {
        Hash::of(&self.head)
    }

    /// Header, table and their hash; the sections follow.
    pub(crate) fn finish(mut self) -> Vec<u8> {
        let hash = self.hash();
        self.head.extend_from_slice(&hash.to_bytes());
        self.head
    }
}
