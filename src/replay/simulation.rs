//! What can be recorded.

use alloc::vec::Vec;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::snapshot::{DecodeError, Hash};
use crate::world::{Command, World};

/// Something that is advanced tick by tick by inputs alone.
///
/// Implement it for a game that owns a [`World`]: its inputs are then what is recorded, and its
/// state (the world's snapshot and the game's own) is what is hashed. Its `step` must be a function
/// of state and inputs: no clock, no floats, no order of a hash map.
pub trait Simulation: Sized {
    /// One input of one player, encoded in 1 to 4,096 bytes of fixed width: without strings, lists
    /// or maps.
    type Input: Clone + Ord + Serialize + DeserializeOwned;

    /// Tells this kind of simulation from others.
    const NAME: [u8; 16];

    /// Version of the game's own rules. Replays of another version are refused.
    const VERSION: u32;

    /// The number of ticks stepped so far.
    fn tick(&self) -> u64;

    /// Advances by one tick. The inputs arrive sorted.
    fn step(&mut self, inputs: &[Self::Input]);

    /// The hash of the whole state.
    fn hash(&self) -> Hash;

    /// Appends the whole state to `out`.
    fn save_into(&self, out: &mut Vec<u8>);

    /// The simulation that was saved.
    ///
    /// # Errors
    /// What is wrong with the bytes, and at which offset.
    fn load(bytes: &[u8]) -> Result<Self, DecodeError>;

    /// Becomes the simulation that was saved: [`load`](Self::load), unless buffers can be reused.
    ///
    /// # Errors
    /// Those of `load`; the simulation is then as it was.
    fn restore(&mut self, bytes: &[u8]) -> Result<(), DecodeError> {
        *self = Self::load(bytes)?;
        Ok(())
    }
}

impl Simulation for World {
    type Input = Command;

    const NAME: [u8; 16] = *b"verlock.world\0\0\0";

    /// A world's rules are those of [`SIM_VERSION`](crate::snapshot::SIM_VERSION).
    const VERSION: u32 = 0;

    fn tick(&self) -> u64 {
        self.tick()
    }

    fn step(&mut self, inputs: &[Command]) {
        self.step(inputs);
    }

    fn hash(&self) -> Hash {
        self.hash()
    }

    fn save_into(&self, out: &mut Vec<u8>) {
        self.save_into(out);
    }

    fn load(bytes: &[u8]) -> Result<Self, DecodeError> {
        Self::load(bytes)
    }

    fn restore(&mut self, bytes: &[u8]) -> Result<(), DecodeError> {
        self.restore(bytes)
    }
}
