//! A world to bytes and to hashes.

use alloc::borrow::Cow;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use super::codec::{encode_numbers, encode_record, encode_rows};
use super::{ContainerKind, ContainerWriter, Hash, Section};
use crate::body::Face;
use crate::constraint::{Carry, Distance, HalfSpace, Volume};
use crate::math::Pcg;
use crate::particle::{Particle, ParticleSet};
use crate::store::Column;
use crate::world::{State, World, WorldConfig};

/// Snapshots.
pub(super) const KIND: ContainerKind = ContainerKind { magic: *b"\x89VLSNAP\n", format: 1 };

/// The record of the world section.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct WorldRecord {
    pub(super) tick: u64,
    pub(super) phase: u64,
    pub(super) config: WorldConfig,
    pub(super) random: Pcg,
}

/// The records of one section.
enum Rows<'a> {
    World(WorldRecord),
    Slots(&'a Column<u32>),
    Positions(&'a [[i64; 3]]),
    Displacements(&'a [[i32; 3]]),
    Particles(&'a Column<Particle>),
    Distances(&'a Column<Distance>),
    Carries(&'a [Carry]),
    HalfSpaces(&'a Column<HalfSpace>),
    Volumes(&'a Column<Volume>),
    Faces(&'a Column<Face>),
}

impl Rows<'_> {
    fn count(&self) -> usize {
        match self {
            Self::World(_) => 1,
            Self::Slots(rows) => rows.len(),
            Self::Positions(rows) => rows.len(),
            Self::Displacements(rows) => rows.len(),
            Self::Particles(rows) => rows.len(),
            Self::Distances(rows) => rows.len(),
            Self::Carries(rows) => rows.len(),
            Self::HalfSpaces(rows) => rows.len(),
            Self::Volumes(rows) => rows.len(),
            Self::Faces(rows) => rows.len(),
        }
    }

    fn bytes(&self) -> Cow<'_, [u8]> {
        match self {
            Self::World(record) => {
                let mut out = Vec::new();
                encode_record(record, &mut out);
                Cow::Owned(out)
            }
            Self::Slots(rows) => encode_numbers(rows),
            Self::Positions(rows) => encode_numbers(rows),
            Self::Displacements(rows) => encode_numbers(rows),
            Self::Particles(rows) => Cow::Owned(encode_rows(rows)),
            Self::Distances(rows) => Cow::Owned(encode_rows(rows)),
            Self::Carries(rows) => encode_numbers(rows),
            Self::HalfSpaces(rows) => Cow::Owned(encode_rows(rows)),
            Self::Volumes(rows) => Cow::Owned(encode_rows(rows)),
            Self::Faces(rows) => Cow::Owned(encode_rows(rows)),
        }
    }

    /// The hash of the bytes; of what did not change, the kept one.
    fn hash(&self) -> Hash {
        let fresh = || Hash::of(&self.bytes()).0;
        Hash(match self {
            Self::World(_) | Self::Positions(_) | Self::Displacements(_) | Self::Carries(_) => {
                fresh()
            }
            Self::Slots(column) => column.hash_or(fresh),
            Self::Particles(column) => column.hash_or(fresh),
            Self::Distances(column) => column.hash_or(fresh),
            Self::HalfSpaces(column) => column.hash_or(fresh),
            Self::Volumes(column) => column.hash_or(fresh),
            Self::Faces(column) => column.hash_or(fresh),
        })
    }
}

/// Every section of a state. Destructures all of it, so that no field can be forgotten.
fn sections(state: &State) -> [(Section, Rows<'_>); 14] {
    #[rustfmt::skip]
    let State {
        tick, phase, config, random, particles, distances, carries, half_spaces, volumes, faces,
    } = state;
    let ParticleSet { table, position, displacement } = particles;
    let world = WorldRecord { tick: *tick, phase: *phase, config: *config, random: *random };
    [
        (Section::World, Rows::World(world)),
        (Section::ParticleSlot, Rows::Slots(table.slots().generations())),
        (Section::Position, Rows::Positions(position)),
        (Section::Displacement, Rows::Displacements(displacement)),
        (Section::Particle, Rows::Particles(table.rows())),
        (Section::DistanceSlot, Rows::Slots(distances.slots().generations())),
        (Section::Distance, Rows::Distances(distances.rows())),
        (Section::HalfSpaceSlot, Rows::Slots(half_spaces.slots().generations())),
        (Section::HalfSpace, Rows::HalfSpaces(half_spaces.rows())),
        (Section::Carry, Rows::Carries(carries)),
        (Section::VolumeSlot, Rows::Slots(volumes.slots().generations())),
        (Section::Volume, Rows::Volumes(volumes.rows())),
        (Section::FaceSlot, Rows::Slots(faces.slots().generations())),
        (Section::Face, Rows::Faces(faces.rows())),
    ]
}

fn entry(table: &mut ContainerWriter, section: Section, count: usize, hash: Hash) {
    table.entry(section as u32, section.record_size(), count as u64, hash);
}

impl World {
    /// The hash of the whole state: equal worlds have equal hashes on every platform.
    ///
    /// It is the hash that a snapshot of this moment carries. O(particles); what did not change
    /// since it was last hashed costs nothing.
    #[must_use]
    pub fn hash(&self) -> Hash {
        let mut table = ContainerWriter::new(KIND);
        for (section, rows) in sections(&self.state) {
            entry(&mut table, section, rows.count(), rows.hash());
        }
        table.hash()
    }

    /// The hash of every section, to tell which part of two worlds differs.
    #[must_use]
    pub fn part_hashes(&self) -> [(Section, Hash); 14] {
        sections(&self.state).map(|(section, rows)| (section, rows.hash()))
    }

    /// A snapshot of the whole state.
    #[must_use]
    pub fn save(&self) -> Vec<u8> {
        let mut out = Vec::new();
        self.save_into(&mut out);
        out
    }

    /// Appends a snapshot of the whole state to `out`.
    pub fn save_into(&self, out: &mut Vec<u8>) {
        let sections = sections(&self.state);
        let mut table = ContainerWriter::new(KIND);
        let payloads = sections.each_ref().map(|(section, rows)| {
            let bytes = rows.bytes();
            // Of the bytes that are written, not a kept one.
            entry(&mut table, *section, rows.count(), Hash::of(&bytes));
            bytes
        });
        out.extend_from_slice(&table.finish());
        for bytes in &payloads {
            out.extend_from_slice(bytes);
        }
    }
}
