//! Where two recordings part.
//!
//! The two sides are machines that should have computed the same. What a recording knows of its
//! machine, from the surest to the least:
//!
//! - the **stored states**, its start and keyframes: the very bytes that the machine had;
//! - the **inputs** of every tick;
//! - the **hash** of the state after every tick, which names a state but does not contain it.
//!
//! So hashes and inputs find the tick, and only bytes can tell the field. Stepping a recording
//! again gives the state that *this* machine makes of it: where its hash is the recorded one, it is
//! the other machine's state to the bit; where it is not, the other machine's state is not in the
//! file. From the next keyframe on it is known again, since that is where stepping starts anew.
//! A game that notices a desync should therefore keep the states of that tick with
//! [`Recorder::keyframe`](super::Recorder::keyframe) or, if it is already past it,
//! [`keyframe_of`](super::Recorder::keyframe_of).
//!
//! Despite the name nothing is halved: different states may become equal again (a particle that
//! comes to rest), so that a search by halves could jump over the first difference. Comparing all
//! hashes is cheap.

use super::{HashLog, Replay};
use crate::snapshot::Hash;

/// Where two recordings part, if they do.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Bisection {
    /// How many states both have a hash of. 0: nothing was compared, and nothing is proven.
    pub compared: u64,
    /// How many of them differ: fewer than all that follow the first if they became equal again.
    pub differing: u64,
    /// The first and last tick of each; `None` for one without states.
    pub spans: [Option<[u64; 2]>; 2],
    /// The first state that differs.
    pub state: Option<Parting>,
    /// The first tick that was stepped with different inputs, whatever came of it.
    pub inputs: Option<u64>,
    /// The first tick of which both stored a state, with the same recorded hash but not the same
    /// bytes: at least one of the hashes is wrong.
    pub stored: Option<u64>,
}

/// The first state that differs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Parting {
    /// Its tick: the state is the one before this tick is stepped.
    pub tick: u64,
    /// Its two hashes.
    pub hashes: [Hash; 2],
    /// The tick of the last state before it that both have a hash of, which is the same.
    pub before: Option<u64>,
    /// What made it differ.
    pub cause: Cause,
}

/// What made a state differ.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Cause {
    /// It is the first that both have: they did not start from the same.
    Start,
    /// The state before it is the same, the inputs are not: the step is not to blame.
    Inputs,
    /// The state before it is the same and so are the inputs: the step came out differently, or the
    /// state was changed behind its back.
    Step,
    /// A hash log tells nothing of inputs.
    Unknown,
}

impl Bisection {
    /// Whether something was compared, all of it is the same, and both are equally long.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        let Self { compared, differing, spans: [a, b], state: _, inputs, stored } = self;
        *compared > 0 && *differing == 0 && a == b && inputs.is_none() && stored.is_none()
    }
}

/// Compares all hashes that two logs have in common. O(states).
#[must_use]
pub fn bisect(a: &HashLog, b: &HashLog) -> Bisection {
    let (mut compared, mut differing, mut before, mut state) = (0, 0, None, None);
    let both = a.iter().filter_map(|(tick, hash)| b.at(tick).map(|other| (tick, [hash, other])));
    for (tick, hashes) in both {
        compared += 1;
        if hashes[0] == hashes[1] {
            if state.is_none() {
                before = Some(tick);
            }
            continue;
        }
        differing += 1;
        let cause = if before.is_none() { Cause::Start } else { Cause::Unknown };
        state.get_or_insert(Parting { tick, hashes, before, cause });
    }
    Bisection {
        compared,
        differing,
        spans: [a.span(), b.span()],
        state,
        inputs: None,
        stored: None,
    }
}

/// Compares what two replays recorded: hashes, inputs and stored states, of whatever simulation,
/// without stepping. O(bytes).
#[must_use]
pub fn bisect_replays(a: &Replay<'_>, b: &Replay<'_>) -> Bisection {
    let [mut log_a, mut log_b] = [a, b].map(HashLog::of);
    let first = a.first_tick();
    if first == b.first_tick() && (log_a.at(first), log_b.at(first)) == (None, None) {
        // Only the games know the hashes of their starts, but equal bytes are equal states.
        log_a.insert(first, Hash::of(a.start_bytes()));
        log_b.insert(first, Hash::of(b.start_bytes()));
    }
    let mut found = bisect(&log_a, &log_b);
    found.inputs = first_different_inputs(a, b);
    found.stored = a.stored_ticks().find(|&tick| {
        let [a, b] = [a, b].map(|replay| replay.stored_bytes(tick));
        log_a.at(tick) == log_b.at(tick) && b.is_some() && a != b
    });
    if let Some(Parting { before: Some(before), cause, .. }) = &mut found.state {
        // Replays have a hash for every tick, so this is the tick whose step made the state.
        let [a, b] = [a, b].map(|replay| inputs_from(replay, *before).next());
        *cause = if a == b { Cause::Step } else { Cause::Inputs };
    }
    found
}

fn first_different_inputs(a: &Replay<'_>, b: &Replay<'_>) -> Option<u64> {
    let first = a.first_tick().max(b.first_tick());
    let mut both = inputs_from(a, first).zip(inputs_from(b, first));
    both.find(|(a, b)| a != b).map(|((tick, _), _)| tick)
}

/// The ticks from this one on, with the bytes of their inputs.
fn inputs_from<'a>(replay: &Replay<'a>, first: u64) -> impl Iterator<Item = (u64, &'a [u8])> {
    replay.input_slices().skip_while(move |(tick, _)| *tick < first)
}
