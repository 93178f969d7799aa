//! Recording while stepping.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use super::Simulation;
use super::format::{Info, KIND, Keyframe, Part, Tick};
use crate::snapshot::{ContainerWriter, Hash, encode_record};

/// Steps a simulation and records what it was given and what came of it.
///
/// The bytes depend on the simulation, its inputs and the ticks of the keyframes alone: all peers
/// record the same file.
#[derive(Debug)]
pub struct Recorder<S: Simulation> {
    simulation: S,
    info: Info,
    start: Vec<u8>,
    ticks: Vec<u8>,
    inputs: Vec<u8>,
    /// The saved states by their ticks, none of them the first.
    keyframes: BTreeMap<u64, Vec<u8>>,
}

impl<S: Simulation> Recorder<S> {
    /// Starts a recording at the simulation's present tick, with a keyframe every `interval` ticks;
    /// 0 for none.
    #[must_use]
    pub fn new(simulation: S, interval: u32) -> Self {
        let mut start = Vec::new();
        simulation.save_into(&mut start);
        let info = Info {
            name: S::NAME,
            version: S::VERSION,
            interval,
            first_tick: simulation.tick(),
            ticks: 0,
        };
        Self {
            simulation,
            info,
            start,
            ticks: Vec::new(),
            inputs: Vec::new(),
            keyframes: BTreeMap::new(),
        }
    }

    /// What is recorded, as it is now.
    #[must_use]
    pub fn simulation(&self) -> &S {
        &self.simulation
    }

    /// Advances by one tick and returns the hash of the state after it. Inputs may come in any
    /// order.
    ///
    /// # Panics
    /// When an input does not keep to what [`Simulation::Input`] demands, or those of one tick
    /// take 4 GiB or more.
    pub fn step(&mut self, inputs: &[S::Input]) -> Hash {
        let mut sorted = inputs.to_vec();
        sorted.sort_unstable();
        let before = self.inputs.len();
        for input in &sorted {
            encode_record(input, &mut self.inputs);
        }
        let bytes = &self.inputs[before..];
        self.simulation.step(&sorted);
        let hash = self.simulation.hash();
        let tick = Tick {
            inputs: count(sorted.len()),
            length: count(bytes.len()),
            input_hash: input_hash(bytes),
            state_hash: hash.0,
        };
        encode_record(&tick, &mut self.ticks);
        self.info.ticks += 1;
        if self.info.interval > 0 && self.info.ticks.is_multiple_of(u64::from(self.info.interval)) {
            self.keyframe();
        }
        hash
    }

    /// Keeps the present state as a keyframe, whatever the interval is.
    ///
    /// A game does so when it learns that another peer's hash of this tick is not its own: a hash
    /// only says that states differ, their bytes say in what.
    pub fn keyframe(&mut self) {
        Self::keep(&mut self.keyframes, &self.info, &self.simulation);
    }

    /// Keeps a state of an earlier tick as a keyframe, such as one from the ring of a rollback
    /// game. Returns whether its tick is among the recorded ones; otherwise nothing is kept.
    ///
    /// It is kept as it is, so that [`verify`](super::verify) can tell when it is not the state
    /// that was recorded.
    pub fn keyframe_of(&mut self, state: &S) -> bool {
        Self::keep(&mut self.keyframes, &self.info, state)
    }

    fn keep(keyframes: &mut BTreeMap<u64, Vec<u8>>, info: &Info, state: &S) -> bool {
        let Some(ticks) = state.tick().checked_sub(info.first_tick) else { return false };
        // The first state is the start, which is stored anyway.
        if (1..=info.ticks).contains(&ticks) {
            let mut bytes = Vec::new();
            state.save_into(&mut bytes);
            keyframes.insert(state.tick(), bytes);
        }
        ticks <= info.ticks
    }

    /// The replay so far.
    #[must_use]
    pub fn replay(&self) -> Vec<u8> {
        let Self { simulation: _, info, start, ticks, inputs, keyframes } = self;
        let mut record = Vec::new();
        encode_record(info, &mut record);
        let (mut rows, mut states) = (Vec::new(), Vec::new());
        for (tick, state) in keyframes {
            encode_record(&Keyframe { tick: *tick, length: state.len() as u64 }, &mut rows);
            states.extend_from_slice(state);
        }
        let parts = [
            (Part::Info, &record),
            (Part::Start, start),
            (Part::Tick, ticks),
            (Part::Input, inputs),
            (Part::Keyframe, &rows),
            (Part::State, &states),
        ];
        let mut table = ContainerWriter::new(KIND);
        for (part, bytes) in parts {
            let size = part.record_size();
            let count = bytes.len() as u64 / u64::from(size);
            table.entry(part as u32, size, count, Hash::of(bytes));
        }
        let mut out = table.finish();
        for (_, bytes) in parts {
            out.extend_from_slice(bytes);
        }
        out
    }

    /// Ends the recording.
    #[must_use]
    pub fn into_simulation(self) -> S {
        self.simulation
    }
}

/// The lower half of the hash: enough to notice a change.
#[allow(clippy::cast_possible_truncation, reason = "the lower half is wanted")]
pub(super) fn input_hash(bytes: &[u8]) -> u64 {
    Hash::of(bytes).0 as u64
}

/// A number or length of one tick's inputs.
fn count(length: usize) -> u32 {
    u32::try_from(length).expect("the inputs of a tick take less than 4 GiB")
}
