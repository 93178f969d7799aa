//! Every tick in every way there is to come to it.

use alloc::boxed::Box;
use alloc::vec::Vec;
use core::fmt;

use super::Simulation;
use crate::snapshot::{DecodeError, Hash};

/// Steps a simulation, and beside it three others that came to the same state in other ways: one
/// loaded from its bytes, one that held something else and restored them, one that held something
/// else and became its clone. All of them must step to the same.
///
/// Those that were loaded have made all they derive from the state anew and kept no hash, so a
/// stale cache, a stale hash and anything that is not saved come to light in the tick in which they
/// first matter. A game puts this in the place of its simulation while it is tested; a tick costs
/// about four steps, five hashes, a save, two loads and four clones.
#[derive(Debug)]
pub struct Heavy<S> {
    simulation: S,
    /// What the others hold before they become the simulation.
    dirt: S,
    loaded: S,
    restored: S,
    cloned: S,
    exact: bool,
    /// What the simulation is now.
    own: Own,
}

/// How the state that differs came to be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Way {
    /// Loaded, not stepped yet.
    Loaded,
    /// Loaded, then stepped.
    LoadedAndStepped,
    /// Restored over something else, then stepped.
    RestoredAndStepped,
    /// Cloned over something else, then stepped.
    ClonedAndStepped,
}

/// A state that differs from the simulation's own.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mismatch {
    /// Its tick: the state is the one before this tick is stepped.
    pub tick: u64,
    /// How it came to be.
    pub way: Way,
    /// The hash of the simulation, and that of this state.
    pub hashes: [Hash; 2],
    /// What the simulation saves, and what this state does. If they are equal, one of the hashes
    /// is not that of the bytes.
    pub states: [Vec<u8>; 2],
}

/// Why a tick is not the same in every way.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum HeavyError {
    /// The simulation does not load what it saved at this tick.
    Refused {
        /// The tick.
        tick: u64,
        /// Why not.
        error: DecodeError,
    },
    /// It came out differently.
    Differs(Box<Mismatch>),
}

impl<S: Simulation + Clone> Heavy<S> {
    /// Begins at the simulation's present tick. `dirt` is a simulation with other contents: what is
    /// forgotten to be replaced is found only where it differs.
    #[must_use]
    pub fn new(simulation: S, dirt: S) -> Self {
        let [loaded, restored, cloned] = [(); 3].map(|()| dirt.clone());
        let own = Own::new(&simulation);
        Self { simulation, dirt, loaded, restored, cloned, exact: false, own }
    }

    /// Compares the bytes of all states too, not their hashes alone: finds also what is saved but
    /// not hashed.
    #[must_use]
    pub fn exact(self) -> Self {
        Self { exact: true, ..self }
    }

    /// The simulation as it is now.
    #[must_use]
    pub fn simulation(&self) -> &S {
        &self.simulation
    }

    /// The one that came to the state in this way, as it is now.
    #[must_use]
    pub fn other(&self, way: Way) -> &S {
        match way {
            Way::Loaded | Way::LoadedAndStepped => &self.loaded,
            Way::RestoredAndStepped => &self.restored,
            Way::ClonedAndStepped => &self.cloned,
        }
    }

    /// Advances by one tick and returns the hash of the state after it. Inputs may come in any
    /// order.
    ///
    /// # Errors
    /// What differs first; the simulation is then where it was found.
    pub fn step(&mut self, inputs: &[S::Input]) -> Result<Hash, HeavyError> {
        let mut sorted = inputs.to_vec();
        sorted.sort_unstable();
        let Self { simulation, dirt, loaded, restored, cloned, exact, own } = self;
        let tick = own.tick;
        let refused = |error| HeavyError::Refused { tick, error };
        *loaded = S::load(&own.bytes).map_err(refused)?;
        own.compare(Way::Loaded, loaded, *exact)?;
        restored.clone_from(dirt);
        restored.restore(&own.bytes).map_err(refused)?;
        cloned.clone_from(dirt);
        cloned.clone_from(simulation);

        simulation.step(&sorted);
        *own = Own::new(simulation);
        let ways = [
            (Way::LoadedAndStepped, loaded),
            (Way::RestoredAndStepped, restored),
            (Way::ClonedAndStepped, cloned),
        ];
        for (way, other) in ways {
            other.step(&sorted);
            own.compare(way, other, *exact)?;
        }
        Ok(own.hash)
    }
}

/// What the others must be.
#[derive(Debug)]
struct Own {
    tick: u64,
    hash: Hash,
    bytes: Vec<u8>,
}

impl Own {
    fn new<S: Simulation>(simulation: &S) -> Self {
        let (tick, hash) = (simulation.tick(), simulation.hash());
        Self { tick, hash, bytes: save(simulation) }
    }

    fn compare<S: Simulation>(&self, way: Way, other: &S, exact: bool) -> Result<(), HeavyError> {
        let found = other.hash();
        if found == self.hash && !(exact && save(other) != self.bytes) {
            return Ok(());
        }
        let hashes = [self.hash, found];
        let states = [self.bytes.clone(), save(other)];
        let mismatch = Mismatch { tick: self.tick, way, hashes, states };
        Err(HeavyError::Differs(Box::new(mismatch)))
    }
}

fn save<S: Simulation>(simulation: &S) -> Vec<u8> {
    let mut bytes = Vec::new();
    simulation.save_into(&mut bytes);
    bytes
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Loaded => "loaded",
            Self::LoadedAndStepped => "loaded and stepped",
            Self::RestoredAndStepped => "restored and stepped",
            Self::ClonedAndStepped => "cloned and stepped",
        })
    }
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { tick, way, hashes: [own, found], states: _ } = self;
        write!(f, "state of tick {tick}: {own}, but {way} it is {found}")
    }
}

impl fmt::Display for HeavyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused { tick, error } => {
                write!(f, "state of tick {tick}: what was saved is refused: {error}")
            }
            Self::Differs(mismatch) => mismatch.fmt(f),
        }
    }
}

impl core::error::Error for HeavyError {}
