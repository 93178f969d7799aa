//! Text to a mesh, and back.
#![no_main]

use libfuzzer_sys::fuzz_target;
use verlock::scene::Obj;
use verlock_fuzz::{laws, memory};

fuzz_target!(|data: &[u8]| {
    if let Ok(text) = std::str::from_utf8(data) {
        // A corner of two bytes makes a face of twelve, three times while the list grows.
        let _ = memory::is_bounded(32 * text.len() + (1 << 16), || Obj::parse(text));
    }
    laws::obj(data);
});
