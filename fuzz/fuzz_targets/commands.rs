//! A small world, and whatever players order in it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use verlock_fuzz::laws;

fuzz_target!(|data: &[u8]| {
    laws::commands(data);
});
