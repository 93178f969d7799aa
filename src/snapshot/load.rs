//! Bytes to a world.

use alloc::vec::Vec;

use serde::de::DeserializeOwned;

use super::codec::decode_rows;
use super::save::{KIND, WorldRecord};
use super::{Container, DecodeError, DecodeReason, Field, Hash, Section, Value};
use crate::particle::{ParticleSet, RangeError};
use crate::store::Table;
use crate::world::{State, World};

/// Snapshot bytes whose layout and hashes have been checked. Borrows them.
#[derive(Clone, Debug)]
pub struct Snapshot<'a> {
    container: Container<'a>,
}

impl<'a> Snapshot<'a> {
    /// The first eight bytes of every snapshot.
    pub const MAGIC: [u8; 8] = KIND.magic;

    /// The version of the format that this build reads and writes.
    pub const FORMAT: u32 = KIND.format;

    /// Checks layout and hashes, but not yet the values.
    ///
    /// # Errors
    /// What is wrong, and at which offset.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        let container = Container::parse(bytes, KIND)?;
        let snapshot = Self { container };
        let table = snapshot.container.entries();
        let complete = table.len() == Section::ALL.len();
        let expected = Section::ALL.into_iter().zip(table);
        let mut same = expected.map(|(section, entry)| {
            entry.kind == section as u32 && entry.size == section.record_size()
        });
        if complete && same.all(|same| same) {
            Ok(snapshot)
        } else {
            Err(DecodeError::new(16, DecodeReason::Layout))
        }
    }

    /// The hash of the state.
    #[must_use]
    pub fn hash(&self) -> Hash {
        self.container.hash()
    }

    /// The hash of a section.
    #[must_use]
    pub fn part_hash(&self, section: Section) -> Hash {
        self.container.section(section as u32).map(|(entry, _)| entry.hash).unwrap_or_default()
    }

    /// The number of records in a section.
    #[must_use]
    pub fn count(&self, section: Section) -> u64 {
        self.container.section(section as u32).map_or(0, |(entry, _)| entry.count)
    }

    /// The bytes of a section.
    #[must_use]
    pub fn bytes(&self, section: Section) -> &'a [u8] {
        self.container.section(section as u32).map_or(&[], |(_, bytes)| bytes)
    }

    /// The fields of one record with their values; nothing beyond the last record.
    pub fn record(
        &self,
        section: Section,
        index: u64,
    ) -> impl Iterator<Item = (&'static Field, Value)> + use<'a> {
        let size = section.record_size() as usize;
        let record =
            usize::try_from(index).ok().and_then(|i| self.bytes(section).chunks(size).nth(i));
        let fields = if record.is_some() { section.fields() } else { &[] };
        let mut rest = record.unwrap_or_default();
        fields.iter().map(move |field| {
            let (bytes, after) = rest.split_at(field.kind.width() as usize);
            rest = after;
            let mut raw = [0; 8];
            raw[..bytes.len()].copy_from_slice(bytes);
            (field, Value { raw: u64::from_le_bytes(raw), kind: field.kind })
        })
    }

    /// The tick at which the snapshot was taken.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.record(Section::World, 0).next().map_or(0, |(_, value)| value.raw)
    }

    /// Makes the world.
    ///
    /// # Errors
    /// What is out of its range, and at which offset.
    pub fn load(&self) -> Result<World, DecodeError> {
        self.state().map(World::from_state)
    }

    fn offset(&self, section: Section) -> u64 {
        self.container.section(section as u32).map_or(0, |(entry, _)| entry.offset)
    }

    fn rows<T: DeserializeOwned>(&self, section: Section) -> Result<Vec<T>, DecodeError> {
        let rows = decode_rows(self.bytes(section), section.record_size() as usize);
        rows.map_err(|at| DecodeError::new(self.offset(section) + at, DecodeReason::Record))
    }

    fn table<T>(&self, slots: Section, rows: Section) -> Result<Table<T>, DecodeError>
    where
        T: Clone + Default + PartialEq + DeserializeOwned,
    {
        let table = Table::from_parts(self.rows(slots)?, self.rows(rows)?);
        table.ok_or(DecodeError::new(self.offset(slots), DecodeReason::Record))
    }

    fn state(&self) -> Result<State, DecodeError> {
        let worlds: Vec<WorldRecord> = self.rows(Section::World)?;
        let [world] = worlds[..] else {
            return Err(DecodeError::new(16, DecodeReason::Layout));
        };
        let WorldRecord { tick, phase, config, random } = world;
        let state = State {
            tick,
            phase,
            config,
            random,
            particles: ParticleSet {
                table: self.table(Section::ParticleSlot, Section::Particle)?,
                position: self.rows(Section::Position)?,
                displacement: self.rows(Section::Displacement)?,
            },
            distances: self.table(Section::DistanceSlot, Section::Distance)?,
            carries: self.rows(Section::Carry)?,
            half_spaces: self.table(Section::HalfSpaceSlot, Section::HalfSpace)?,
            volumes: self.table(Section::VolumeSlot, Section::Volume)?,
            faces: self.table(Section::FaceSlot, Section::Face)?,
        };
        let good = |section, result: Result<(), RangeError>| {
            let reason = |error| DecodeReason::OutOfRange(error);
            result.map_err(|error| DecodeError::new(self.offset(section), reason(error)))
        };
        good(Section::World, state.validate_world())?;
        good(Section::ParticleSlot, state.validate_particles())?;
        good(Section::Distance, state.validate_distances())?;
        good(Section::Carry, state.validate_carries())?;
        good(Section::HalfSpace, state.validate_half_spaces())?;
        good(Section::Volume, state.validate_volumes())?;
        good(Section::Face, state.validate_faces())?;
        Ok(state)
    }
}

impl World {
    /// The world that [`save`](Self::save) made these bytes of.
    ///
    /// # Errors
    /// What is wrong with the bytes, and at which offset.
    pub fn load(bytes: &[u8]) -> Result<Self, DecodeError> {
        Snapshot::parse(bytes)?.load()
    }

    /// Becomes the world of a snapshot.
    ///
    /// # Errors
    /// What is wrong with the bytes, and at which offset; the world is then as it was.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), DecodeError> {
        let state = Snapshot::parse(bytes)?.state()?;
        self.replace_state(state);
        Ok(())
    }
}
