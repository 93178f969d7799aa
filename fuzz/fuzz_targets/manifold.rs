//! Any two convex shapes.
#![no_main]

use libfuzzer_sys::fuzz_target;
use verlock_fuzz::laws;

fuzz_target!(|data: &[u8]| {
    laws::manifold(data);
});
