//! Bytes to a replay, and the replay to its end.
#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use verlock::replay::Replay;
use verlock_fuzz::{laws, memory, mutator};

fuzz_target!(|data: &[u8]| {
    let _ = memory::is_bounded(8 * data.len() + (1 << 16), || Replay::parse(data));
    laws::replay(data);
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    mutator::mutate(data, size, max_size, seed, fuzzer_mutate)
});
