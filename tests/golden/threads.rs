//! The number of threads reaches no result.

use super::{Run, hashes_path};
use crate::support::fixture::{Fixture, is_blessing, read};

/// With 1, 2 and 8 threads every scene comes out as accepted.
#[test]
fn threads_change_nothing() {
    if is_blessing() {
        return; // the hashes are being written
    }
    for threads in [1, 2, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        for fixture in Fixture::all() {
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
