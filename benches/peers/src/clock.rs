//! How times are taken.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// Ticks of a round.
pub const TICKS: u32 = 20;
const ROUNDS: u32 = 15;

/// Rounds of a measurement: with `--test` one, which only shows that it runs.
pub fn rounds() -> u32 {
    if std::env::args().any(|argument| argument == "--test") { 1 } else { ROUNDS }
}

/// The shortest time of a tick over all rounds; every round starts from the same state.
pub fn shortest<S: Clone>(start: &S, mut tick: impl FnMut(&mut S)) -> Duration {
    let round = |_| {
        let mut state = start.clone();
        let clock = Instant::now();
        (0..TICKS).for_each(|_| tick(&mut state));
        let time = clock.elapsed() / TICKS;
        black_box(state);
        time
    };
    (0..rounds()).map(round).min().unwrap_or_default()
}
