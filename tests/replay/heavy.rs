//! Every tick in every way there is to come to it, and games that get one of the ways wrong.

use std::cell::Cell;

use verlock::Hash;
use verlock::replay::{Heavy, HeavyError, Mismatch, Simulation, Way};
use verlock::snapshot::{DecodeError, DecodeReason};

use super::commands;
use crate::support::worlds::{other, small};

/// A game has none of these bugs, or one.
const NONE: u8 = 0;
const NOT_SAVED: u8 = 1;
const NOT_HASHED: u8 = 2;
const NOT_CLONED: u8 = 3;
const NOT_RESTORED: u8 = 4;
const STALE_HASH: u8 = 5;
const STALE_CACHE: u8 = 6;
const NOT_LOADED: u8 = 7;

/// Counts what it is given, from its third tick on with what it hides.
#[derive(Debug)]
struct Game<const BUG: u8> {
    tick: u64,
    count: u64,
    hidden: u64,
    /// Derived from `count`.
    double: u64,
    kept: Cell<Option<Hash>>,
}

impl<const BUG: u8> Game<BUG> {
    fn new(count: u64) -> Self {
        Self { tick: 0, count, hidden: count, double: 2 * count, kept: Cell::new(None) }
    }

    fn numbers(&self) -> [u64; 3] {
        [self.tick, self.count, if BUG == NOT_SAVED { 0 } else { self.hidden }]
    }
}

impl<const BUG: u8> Clone for Game<BUG> {
    fn clone(&self) -> Self {
        Self { kept: self.kept.clone(), ..*self }
    }

    fn clone_from(&mut self, source: &Self) {
        let hidden = self.hidden;
        *self = source.clone();
        if BUG == NOT_CLONED {
            self.hidden = hidden;
        }
    }
}

impl<const BUG: u8> Simulation for Game<BUG> {
    type Input = u64;
    const NAME: [u8; 16] = *b"verlock.counting";
    const VERSION: u32 = 0;

    fn tick(&self) -> u64 {
        self.tick
    }

    fn step(&mut self, inputs: &[u64]) {
        assert!(inputs.is_sorted());
        self.count += inputs.iter().sum::<u64>() + self.double;
        if self.tick >= 2 {
            self.count += self.hidden;
        }
        self.hidden += 1;
        if BUG != STALE_CACHE || self.tick < 2 {
            self.double = 2 * self.count;
        }
        self.tick += 1;
        if BUG != STALE_HASH || self.tick < 3 {
            self.kept.set(None);
        }
    }

    fn hash(&self) -> Hash {
        let mut numbers = self.numbers();
        if BUG == NOT_HASHED {
            numbers[1] = 0;
        }
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        let hash = self.kept.get().unwrap_or_else(|| Hash::of(&bytes));
        self.kept.set(Some(hash));
        hash
    }

    fn save_into(&self, out: &mut Vec<u8>) {
        out.extend(self.numbers().iter().flat_map(|number| number.to_le_bytes()));
    }

    fn load(bytes: &[u8]) -> Result<Self, DecodeError> {
        let number = |at: usize| u64::from_le_bytes(*bytes[8 * at..].first_chunk().expect("three"));
        let [tick, count, hidden] = [0, 1, 2].map(number);
        if BUG == NOT_LOADED && tick == 4 {
            return Err(DecodeError { offset: 0, reason: DecodeReason::Record });
        }
        Ok(Self { tick, count, hidden, ..Self::new(count) })
    }

    fn restore(&mut self, bytes: &[u8]) -> Result<(), DecodeError> {
        let hidden = self.hidden;
        *self = Self::load(bytes)?;
        if BUG == NOT_RESTORED {
            self.hidden = hidden;
        }
        Ok(())
    }
}

/// Ten ticks of a game; what differs first.
fn play<const BUG: u8>(exact: bool) -> Option<HeavyError> {
    let heavy = Heavy::new(Game::<BUG>::new(1), Game::new(50));
    let mut heavy = if exact { heavy.exact() } else { heavy };
    (0..10).find_map(|tick| heavy.step(&[tick, 3, 1]).err())
}

fn mismatch<const BUG: u8>(exact: bool) -> Mismatch {
    match play::<BUG>(exact) {
        Some(HeavyError::Differs(mismatch)) => *mismatch,
        other => unreachable!("{other:?}"),
    }
}

/// Every bug is found in the tick in which it first matters, in the way that has it.
#[test]
fn every_bug_is_found() {
    for exact in [false, true] {
        assert_eq!(play::<NONE>(exact), None);
        let found = mismatch::<NOT_SAVED>(exact);
        assert_eq!((found.tick, found.way), (3, Way::LoadedAndStepped), "tick 2 uses it");
        let found = mismatch::<NOT_CLONED>(exact);
        assert_eq!((found.tick, found.way), (1, Way::ClonedAndStepped));
        let found = mismatch::<NOT_RESTORED>(exact);
        assert_eq!((found.tick, found.way), (1, Way::RestoredAndStepped));
        let found = mismatch::<STALE_CACHE>(exact);
        assert_eq!((found.tick, found.way), (4, Way::LoadedAndStepped), "from tick 2 on");
        assert_ne!(found.states[0], found.states[1]);
        let found = mismatch::<STALE_HASH>(exact);
        assert_eq!((found.tick, found.way), (3, Way::RestoredAndStepped), "never hashed before");
        assert_eq!(found.states[0], found.states[1], "the hash alone is wrong");
        assert_ne!(found.hashes[0], found.hashes[1]);
        let error = DecodeError { offset: 0, reason: DecodeReason::Record };
        assert_eq!(play::<NOT_LOADED>(exact), Some(HeavyError::Refused { tick: 4, error }));
    }
}

/// What is saved but not hashed shows in the bytes alone.
#[test]
fn bytes_are_compared_on_request() {
    let stale = |exact| {
        let heavy = Heavy::new(Unhashed(Game::<NOT_HASHED>::new(1)), Unhashed(Game::new(50)));
        let mut heavy = if exact { heavy.exact() } else { heavy };
        (0..10).find_map(|tick| heavy.step(&[tick]).err())
    };
    assert_eq!(stale(false), None);
    let Some(HeavyError::Differs(found)) = stale(true) else { unreachable!("{:?}", stale(true)) };
    assert_eq!((found.tick, found.way), (1, Way::ClonedAndStepped));
    assert_eq!(found.hashes[0], found.hashes[1]);
}

/// A game that does not clone what it does not hash.
#[derive(Debug)]
struct Unhashed(Game<NOT_HASHED>);

impl Clone for Unhashed {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }

    fn clone_from(&mut self, source: &Self) {
        let count = self.0.count;
        self.0 = Game { count, ..source.0.clone() };
    }
}

impl Simulation for Unhashed {
    type Input = u64;
    const NAME: [u8; 16] = *b"verlock.unhashed";
    const VERSION: u32 = 0;

    fn tick(&self) -> u64 {
        self.0.tick
    }

    fn step(&mut self, inputs: &[u64]) {
        self.0.step(inputs);
    }

    fn hash(&self) -> Hash {
        self.0.hash()
    }

    fn save_into(&self, out: &mut Vec<u8>) {
        self.0.save_into(out);
    }

    fn load(bytes: &[u8]) -> Result<Self, DecodeError> {
        Game::load(bytes).map(Self)
    }
}

/// A world comes to every tick in every way, and arrives where it does alone.
#[test]
fn a_world_is_the_same_in_every_way() {
    let mut heavy = Heavy::new(small(), other()).exact();
    let mut world = small();
    for tick in 2..40 {
        world.step(&commands(tick));
        assert_eq!(heavy.step(&commands(tick)), Ok(world.hash()), "tick {tick}");
        for way in [Way::LoadedAndStepped, Way::RestoredAndStepped, Way::ClonedAndStepped] {
            assert_eq!(heavy.other(way).save(), world.save(), "tick {tick}, {way}");
        }
    }
    assert_eq!(heavy.simulation().save(), world.save());
}
