//! The number of threads reaches no result.

use super::{Run, hashes_path};
use crate::support::fixture::{EMULATED, Fixture, is_blessing, read};

/// With 1, 2 and 8 threads every scene comes out as accepted.
#[test]
fn threads_change_nothing() {
    if is_blessing() {
        return; // the hashes are being written
    }
    let counts: &[usize] = if EMULATED { &[2] } else { &[1, 2, 8] };
    for &threads in counts {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        // Small scenes have no work for threads, and other machines have no time for them.
        for fixture in Fixture::all().into_iter().filter(|it| !EMULATED || it.is_large()) {
            let name = &fixture.name;
            let run = pool.install(|| Run::of(&fixture));
            assert_eq!(
                read(&hashes_path(name)),
                run.hashes.as_bytes(),
                "{name}, {threads} threads"
            );
        }
    }
}
