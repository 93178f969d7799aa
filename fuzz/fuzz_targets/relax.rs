//! A few particles, and any constraints on them.
#![no_main]

use libfuzzer_sys::fuzz_target;
use verlock_fuzz::laws;

fuzz_target!(|data: &[u8]| {
    laws::relax(data);
});
