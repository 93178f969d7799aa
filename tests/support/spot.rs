//! Every field of every record of a snapshot.

use std::fmt;

use verlock::snapshot::{Field, Section};

use super::container::Parts;

/// One field of one record.
pub struct Spot {
    pub section: Section,
    pub index: usize,
    pub field: &'static Field,
    at: usize,
}

impl Spot {
    /// All of a snapshot.
    pub fn all(parts: &Parts) -> Vec<Self> {
        Section::ALL.into_iter().flat_map(|section| Self::of(parts, section)).collect()
    }

    /// Those of a section.
    pub fn of(parts: &Parts, section: Section) -> Vec<Self> {
        let part = parts.parts.iter().find(|part| part.kind == section as u32);
        let part = part.expect("a section");
        let size = part.size as usize;
        let mut spots = vec![];
        for index in 0..part.bytes.len() / size {
            let mut at = index * size;
            for field in section.fields() {
                spots.push(Self { section, index, field, at });
                at += field.kind.width() as usize;
            }
        }
        spots
    }

    /// The bits of the field.
    pub fn read(&self, parts: &Parts) -> u64 {
        let part = parts.parts.iter().find(|part| part.kind == self.section as u32);
        let bytes = &part.expect("a section").bytes[self.at..][..self.width()];
        bytes.iter().rev().fold(0, |bits, byte| bits << 8 | u64::from(*byte))
    }

    /// The snapshot with other bits in the field, and sound hashes.
    pub fn with(&self, parts: &Parts, bits: u64) -> Parts {
        let mut parts = parts.clone();
        let width = self.width();
        let bytes = &mut parts.section(self.section as u32)[self.at..][..width];
        bytes.copy_from_slice(&bits.to_le_bytes()[..width]);
        parts
    }

    /// Other bits: near the present ones, at the ends of the range, and every power of two.
    pub fn other_bits(&self, parts: &Parts) -> Vec<u64> {
        let now = self.read(parts);
        let bits = 8 * self.field.kind.width();
        let mask = u64::MAX >> (64 - bits);
        let sign = 1 << (bits - 1);
        let near = [1, 2].into_iter().flat_map(|n| [now.wrapping_add(n), now.wrapping_sub(n)]);
        let ends = [0, mask, mask - 1, sign - 1, !now, now ^ sign];
        let powers = (0..bits).flat_map(|bit| [1 << bit, (1_u64 << bit).wrapping_neg()]);
        let all = near.chain(ends).chain(powers).map(|bits| bits & mask);
        let mut others: Vec<u64> = vec![];
        all.filter(|bits| *bits != now).for_each(|bits| {
            if !others.contains(&bits) {
                others.push(bits);
            }
        });
        others
    }

    /// Whether the record belongs to something alive.
    pub fn is_alive(&self, parts: &Parts) -> bool {
        let slots = match self.section {
            Section::Position | Section::Displacement | Section::Particle => Section::ParticleSlot,
            Section::Distance => Section::DistanceSlot,
            Section::HalfSpace => Section::HalfSpaceSlot,
            Section::Volume => Section::VolumeSlot,
            Section::Face => Section::FaceSlot,
            _ => return true,
        };
        let slots = parts.parts.iter().find(|part| part.kind == slots as u32);
        slots.expect("a section").bytes[4 * self.index] % 2 == 1
    }

    fn width(&self) -> usize {
        self.field.kind.width() as usize
    }
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {}", self.section, self.index, self.field.name)
    }
}
