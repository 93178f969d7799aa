//! Hashes of states as text.

use alloc::collections::BTreeMap;
use core::fmt;
use core::str::FromStr;

use super::{Replay, Simulation};
use crate::snapshot::{Hash, Snapshot};
use crate::world::World;

/// The hashes of states by their ticks: what a machine can write down or send where a replay is
/// too much. Tick `n` stands for the state before tick `n` is stepped.
///
/// As text it has a line for every state, in the order of their ticks: the tick, a space, the hash
/// in 32 hexadecimal digits. A reader skips empty lines and those that begin with `#`, and ignores
/// what follows the hash after a space.
///
/// ```
/// use verlock::Hash;
/// use verlock::replay::HashLog;
///
/// let mut log = HashLog::default();
/// log.insert(60, Hash(1));
/// let text = "# the machine in the corner\n60 00000000000000000000000000000001 first\n";
/// assert_eq!(text.parse(), Ok(log));
/// ```
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct HashLog {
    states: BTreeMap<u64, Hash>,
}

impl HashLog {
    /// The recorded hashes of a replay. The hash of the start is among them if it is a world: that
    /// of a game is known only to the game. O(ticks).
    #[must_use]
    pub fn of(replay: &Replay<'_>) -> Self {
        let first = replay.first_tick();
        let start = Snapshot::parse(replay.start_bytes()).ok();
        let start = start.filter(|_| replay.name() == World::NAME);
        let start = start.map(|start| (first, start.hash()));
        let recorded = (first..first + replay.len())
            .filter_map(|tick| replay.hash_after(tick).map(|hash| (tick + 1, hash)));
        Self { states: start.into_iter().chain(recorded).collect() }
    }

    /// Notes the hash of a state. One that is hashed again, after a rollback, replaces what was
    /// there.
    pub fn insert(&mut self, tick: u64, hash: Hash) {
        self.states.insert(tick, hash);
    }

    /// The hash of the state at a tick. O(log states).
    #[must_use]
    pub fn at(&self, tick: u64) -> Option<Hash> {
        self.states.get(&tick).copied()
    }

    /// All ticks and hashes, in order.
    pub fn iter(&self) -> impl Iterator<Item = (u64, Hash)> + '_ {
        self.states.iter().map(|(tick, hash)| (*tick, *hash))
    }

    /// The first and the last tick; `None` for a log without states.
    #[must_use]
    pub fn span(&self) -> Option<[u64; 2]> {
        let (first, last) = (self.states.first_key_value()?, self.states.last_key_value()?);
        Some([*first.0, *last.0])
    }
}

/// A line of a hash log is not one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct HashLogError {
    /// The line, counted from 1.
    pub line: u64,
    /// What is wrong there.
    pub reason: HashLogReason,
}

/// What can be wrong with a line of a hash log.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum HashLogReason {
    /// It does not begin with a tick.
    Tick,
    /// The tick is not followed by a hash.
    Hash,
    /// Its tick is not later than the one before it.
    Order,
}

impl FromStr for HashLog {
    type Err = HashLogError;

    fn from_str(text: &str) -> Result<Self, HashLogError> {
        let mut log = Self::default();
        for (line, text) in (1..).zip(text.lines()) {
            if text.trim().is_empty() || text.starts_with('#') {
                continue;
            }
            let bad = |reason| HashLogError { line, reason };
            let mut words = text.split_whitespace();
            let tick = words.next().and_then(|word| word.parse().ok());
            let tick: u64 = tick.ok_or(bad(HashLogReason::Tick))?;
            let hash = words.next().and_then(|word| word.parse().ok());
            let hash: Hash = hash.ok_or(bad(HashLogReason::Hash))?;
            if log.span().is_some_and(|[_, last]| tick <= last) {
                return Err(bad(HashLogReason::Order));
            }
            log.insert(tick, hash);
        }
        Ok(log)
    }
}

impl fmt::Display for HashLog {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.iter().try_for_each(|(tick, hash)| writeln!(f, "{tick} {hash}"))
    }
}

impl fmt::Display for HashLogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what = match self.reason {
            HashLogReason::Tick => "it does not begin with a tick",
            HashLogReason::Hash => "a hash of 32 hexadecimal digits must follow the tick",
            HashLogReason::Order => "its tick is not later than the one before it",
        };
        write!(f, "line {}: {what}", self.line)
    }
}

impl core::error::Error for HashLogError {}
