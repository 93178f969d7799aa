//! Text to a scene, and the scene to a world that plays.
#![no_main]

use libfuzzer_sys::fuzz_target;
use verlock::scene::Scene;
use verlock_fuzz::{laws, memory};

fuzz_target!(|data: &[u8]| {
    if let Ok(text) = std::str::from_utf8(data) {
        // The shortest element of a list, `(),`, makes some 200 bytes, three times while it grows.
        let _ = memory::is_bounded(512 * text.len() + (1 << 16), || Scene::parse(text));
    }
    laws::scene(data);
});
