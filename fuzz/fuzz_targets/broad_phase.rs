//! Objects that come, move and go, in every partition.
#![no_main]

use libfuzzer_sys::fuzz_target;
use verlock_fuzz::laws;

fuzz_target!(|data: &[u8]| {
    laws::broad_phase(data);
});
