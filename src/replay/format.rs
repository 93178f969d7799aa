//! A replay as bytes.

use alloc::vec::Vec;
use core::iter;

use serde::{Deserialize, Serialize};

use super::Simulation;
use crate::snapshot::{
    Container, ContainerKind, DecodeError, DecodeReason, Entry, Hash, decode_record, decode_rows,
};

/// Replays.
pub(super) const KIND: ContainerKind = ContainerKind { magic: *b"\x89VLREPL\n", format: 1 };

/// The sections of a replay, in the order of the file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u32)]
pub(super) enum Part {
    /// [`Info`]: one record.
    Info = 1,
    /// The saved start.
    Start = 2,
    /// [`Tick`]: one record a tick.
    Tick = 3,
    /// The inputs of all ticks, one after the other.
    Input = 4,
    /// [`Keyframe`]: one record a keyframe.
    Keyframe = 5,
    /// The saved states of the keyframes, one after the other.
    State = 6,
}

impl Part {
    const ALL: [Self; 6] =
        [Self::Info, Self::Start, Self::Tick, Self::Input, Self::Keyframe, Self::State];

    const fn name(self) -> &'static str {
        match self {
            Self::Info => "info",
            Self::Start => "start",
            Self::Tick => "tick",
            Self::Input => "input",
            Self::Keyframe => "keyframe",
            Self::State => "state",
        }
    }

    /// Bytes of a record.
    pub(super) const fn record_size(self) -> u32 {
        match self {
            Self::Info => 40,
            Self::Start | Self::Input | Self::State => 1,
            Self::Tick => 32,
            Self::Keyframe => 16,
        }
    }
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Info {
    /// [`Simulation::NAME`].
    pub(super) name: [u8; 16],
    /// [`Simulation::VERSION`].
    pub(super) version: u32,
    /// Ticks from one keyframe to the next; 0: there are none.
    pub(super) interval: u32,
    /// Tick of the start.
    pub(super) first_tick: u64,
    /// The number of ticks recorded.
    pub(super) ticks: u64,
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Tick {
    /// The number of inputs.
    pub(super) inputs: u32,
    /// Their length in bytes.
    pub(super) length: u32,
    /// The lower half of their hash: an input without effect is verified too.
    pub(super) input_hash: u64,
    /// Hash of the state after the tick.
    pub(super) state_hash: u128,
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Keyframe {
    /// The tick that is stepped next from here.
    pub(super) tick: u64,
    /// Length of the saved state.
    pub(super) length: u64,
}

/// A keyframe in the bytes.
#[derive(Clone, Copy, Debug)]
struct Saved<'a> {
    tick: u64,
    offset: u64,
    bytes: &'a [u8],
}

/// A replay whose layout and hashes have been checked. Borrows the bytes.
#[derive(Clone, Debug)]
pub struct Replay<'a> {
    container: Container<'a>,
    pub(super) info: Info,
    info_offset: u64,
    start: &'a [u8],
    start_offset: u64,
    ticks: &'a [u8],
    inputs: &'a [u8],
    input_offset: u64,
    keyframes: Vec<Saved<'a>>,
}

impl<'a> Replay<'a> {
    /// The first eight bytes of every replay.
    pub const MAGIC: [u8; 8] = KIND.magic;

    /// The version of the format that this build reads and writes.
    pub const FORMAT: u32 = KIND.format;

    /// Checks layout and hashes. O(bytes); allocates no more than the table of keyframes.
    ///
    /// # Errors
    /// What is wrong, and at which offset.
    pub fn parse(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        let container = Container::parse(bytes, KIND)?;
        let layout = |offset| DecodeError::new(offset, DecodeReason::Layout);
        let expected = Part::ALL.map(|part| (part as u32, part.record_size()));
        let table = container.entries().iter().map(|entry| (entry.kind, entry.size));
        if !table.eq(expected) {
            return Err(layout(16));
        }
        let section = |part: Part| {
            let (entry, bytes) = container.section(part as u32).ok_or(layout(16))?;
            Ok((entry.offset, bytes))
        };
        let (info_offset, info_bytes) = section(Part::Info)?;
        let (start_offset, start) = section(Part::Start)?;
        let (tick_offset, ticks) = section(Part::Tick)?;
        let (input_offset, inputs) = section(Part::Input)?;
        let (keyframe_offset, keyframes) = section(Part::Keyframe)?;
        let (state_offset, states) = section(Part::State)?;
        let record = || DecodeError::new(info_offset, DecodeReason::Record);
        let (info, read): (Info, usize) = decode_record(info_bytes).ok_or(record())?;
        let sound = info.first_tick.checked_add(info.ticks).is_some();
        if read != info_bytes.len() || !sound {
            return Err(record());
        }
        // The container has seen to it that only whole records are there.
        if ticks.len() as u64 / u64::from(Part::Tick.record_size()) != info.ticks {
            return Err(layout(tick_offset));
        }
        let rows = decode_rows(keyframes, Part::Keyframe.record_size() as usize)
            .map_err(|at| DecodeError::new(keyframe_offset + at, DecodeReason::Record))?;
        let keyframes =
            slice_keyframes(&info, &rows, states, state_offset).ok_or(layout(keyframe_offset))?;
        let replay = Self {
            container,
            info,
            info_offset,
            start,
            start_offset,
            ticks,
            inputs,
            input_offset,
            keyframes,
        };
        let lengths: u64 = (0..info.ticks).map(|tick| u64::from(replay.tick(tick).length)).sum();
        if lengths != inputs.len() as u64 {
            return Err(layout(tick_offset));
        }
        Ok(replay)
    }

    /// Name of the simulation that was recorded.
    #[must_use]
    pub fn name(&self) -> [u8; 16] {
        self.info.name
    }

    /// Version of the recorded game's own rules.
    #[must_use]
    pub fn version(&self) -> u32 {
        self.info.version
    }

    /// The first recorded tick.
    #[must_use]
    pub fn first_tick(&self) -> u64 {
        self.info.first_tick
    }

    /// The number of recorded ticks.
    #[must_use]
    pub fn len(&self) -> u64 {
        self.info.ticks
    }

    /// Whether no tick was recorded.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.info.ticks == 0
    }

    /// The number of inputs in the whole replay.
    #[must_use]
    pub fn input_count(&self) -> u64 {
        (0..self.len()).map(|tick| u64::from(self.tick(tick).inputs)).sum()
    }

    /// The recorded hash after a tick; `None` outside the recording.
    #[must_use]
    pub fn hash_after(&self, tick: u64) -> Option<Hash> {
        let index = tick.checked_sub(self.first_tick()).filter(|&index| index < self.len())?;
        Some(Hash(self.tick(index).state_hash))
    }

    /// The ticks for which there is a keyframe.
    pub fn keyframe_ticks(&self) -> impl Iterator<Item = u64> + '_ {
        self.keyframes.iter().map(|saved| saved.tick)
    }

    /// The names of the sections and their rows of the table, in the order of the file.
    pub fn sections(&self) -> impl Iterator<Item = (&'static str, &Entry)> {
        Part::ALL.iter().map(|part| part.name()).zip(self.container.entries())
    }

    /// The inputs that were given to a tick; none outside the recording. O(ticks before it).
    ///
    /// # Errors
    /// The offset of bytes that are not inputs of this kind of simulation.
    pub fn inputs_at<S: Simulation>(&self, tick: u64) -> Result<Vec<S::Input>, DecodeError> {
        let index = tick.checked_sub(self.first_tick()).filter(|&index| index < self.len());
        let Some(index) = index else { return Ok(Vec::new()) };
        let from = (0..index).map(|before| self.tick(before).length as usize).sum();
        self.inputs::<S>(index, from)
    }

    /// The inputs of every tick, in order. Each costs O(its bytes).
    pub fn inputs_by_tick<S: Simulation>(
        &self,
    ) -> impl Iterator<Item = Result<Vec<S::Input>, DecodeError>> + '_ {
        let mut from = 0;
        (0..self.len()).map(move |index| {
            let inputs = self.inputs::<S>(index, from);
            from += self.tick(index).length as usize;
            inputs
        })
    }

    /// The bytes of the saved start.
    #[must_use]
    pub fn start_bytes(&self) -> &'a [u8] {
        self.start
    }

    /// The ticks whose states are stored: the first one, and those of the keyframes.
    pub fn stored_ticks(&self) -> impl Iterator<Item = u64> + '_ {
        iter::once(self.first_tick()).chain(self.keyframe_ticks())
    }

    /// The bytes of the stored state of a tick, as they were when it was recorded; `None` if it
    /// has to be stepped to. O(log keyframes).
    #[must_use]
    pub fn stored_bytes(&self, tick: u64) -> Option<&'a [u8]> {
        if tick == self.first_tick() {
            return Some(self.start);
        }
        self.keyframe(tick).map(|saved| saved.bytes)
    }

    /// Every tick with the bytes of its inputs, in order. Each costs O(1).
    pub(super) fn input_slices(&self) -> impl Iterator<Item = (u64, &'a [u8])> + use<'a, '_> {
        let mut from = 0;
        (0..self.len()).map(move |index| {
            let bytes = self.input_bytes(index, from);
            from += bytes.len();
            (self.first_tick() + index, bytes)
        })
    }

    /// The record of the `index`th tick, which must be recorded.
    pub(super) fn tick(&self, index: u64) -> Tick {
        let size = Part::Tick.record_size() as usize;
        let index = usize::try_from(index).ok();
        let record = index.and_then(|index| self.ticks.chunks(size).nth(index));
        let record = record.and_then(decode_record);
        // `parse` counted the records, and any 32 bytes are one.
        record.map_or(EMPTY, |(tick, _)| tick)
    }

    /// The bytes of the inputs of the `index`th tick, which begin at `from`.
    pub(super) fn input_bytes(&self, index: u64, from: usize) -> &'a [u8] {
        // `parse` saw to it that the lengths of all ticks add up.
        let rest = self.inputs.get(from..).unwrap_or_default();
        rest.get(..self.tick(index).length as usize).unwrap_or_default()
    }

    /// The inputs of the `index`th tick, whose bytes begin at `from`.
    pub(super) fn inputs<S: Simulation>(
        &self,
        index: u64,
        from: usize,
    ) -> Result<Vec<S::Input>, DecodeError> {
        let all = self.input_bytes(index, from);
        let mut rest = all;
        let bad = |rest: &[u8]| {
            let at = from + all.len() - rest.len();
            DecodeError::new(self.input_offset + at as u64, DecodeReason::Record)
        };
        let mut inputs = Vec::new();
        for _ in 0..self.tick(index).inputs {
            // An input that takes no bytes could be repeated without limit, and `step` is promised
            // sorted ones.
            let last: Option<&S::Input> = inputs.last();
            let fits = |(input, read): &(S::Input, usize)| {
                *read > 0 && last.is_none_or(|last| last <= input)
            };
            let (input, read) = decode_record(rest).filter(fits).ok_or(bad(rest))?;
            inputs.push(input);
            rest = &rest[read..];
        }
        if rest.is_empty() { Ok(inputs) } else { Err(bad(rest)) }
    }

    /// The start of a simulation of this kind and version.
    pub(super) fn start<S: Simulation>(&self) -> Result<S, DecodeError> {
        let simulation = self.load_at::<S>(self.start, self.start_offset)?;
        if simulation.tick() == self.first_tick() {
            Ok(simulation)
        } else {
            Err(DecodeError::new(self.start_offset, DecodeReason::Layout))
        }
    }

    /// The last keyframe at or before a tick.
    pub(super) fn keyframe_before<S: Simulation>(
        &self,
        tick: u64,
    ) -> Result<Option<S>, DecodeError> {
        let count = self.keyframes.partition_point(|saved| saved.tick <= tick);
        count.checked_sub(1).map(|index| self.load_keyframe(&self.keyframes[index])).transpose()
    }

    /// The keyframe of exactly this tick.
    pub(super) fn keyframe_at<S: Simulation>(&self, tick: u64) -> Result<Option<S>, DecodeError> {
        self.keyframe(tick).map(|saved| self.load_keyframe(saved)).transpose()
    }

    fn keyframe(&self, tick: u64) -> Option<&Saved<'a>> {
        let found = self.keyframes.binary_search_by_key(&tick, |saved| saved.tick);
        found.ok().map(|index| &self.keyframes[index])
    }

    fn load_keyframe<S: Simulation>(&self, saved: &Saved<'_>) -> Result<S, DecodeError> {
        let simulation = self.load_at::<S>(saved.bytes, saved.offset)?;
        if simulation.tick() == saved.tick {
            Ok(simulation)
        } else {
            Err(DecodeError::new(saved.offset, DecodeReason::Layout))
        }
    }

    fn load_at<S: Simulation>(&self, bytes: &[u8], offset: u64) -> Result<S, DecodeError> {
        if (self.info.name, self.info.version) != (S::NAME, S::VERSION) {
            let Info { name, version, .. } = self.info;
            return Err(DecodeError::new(
                self.info_offset,
                DecodeReason::Simulation { name, version },
            ));
        }
        S::load(bytes).map_err(|error| error.within(offset))
    }
}

const EMPTY: Tick = Tick { inputs: 0, length: 0, input_hash: 0, state_hash: 0 };

/// Cuts the states apart, which start at `offset`; `None` unless the ticks ascend within the
/// recording and all bytes are used.
fn slice_keyframes<'a>(
    info: &Info,
    rows: &[Keyframe],
    states: &'a [u8],
    mut offset: u64,
) -> Option<Vec<Saved<'a>>> {
    let mut rest = states;
    let mut keyframes: Vec<Saved<'_>> = Vec::with_capacity(rows.len());
    for &Keyframe { tick, length } in rows {
        let ascends = keyframes.last().is_none_or(|last| last.tick < tick);
        // The start itself needs no keyframe, and no tick would verify one.
        let inside = tick > info.first_tick && tick - info.first_tick <= info.ticks;
        let (bytes, after) = rest.split_at_checked(usize::try_from(length).ok()?)?;
        if !(ascends && inside) {
            return None;
        }
        keyframes.push(Saved { tick, offset, bytes });
        offset += length;
        rest = after;
    }
    rest.is_empty().then_some(keyframes)
}
