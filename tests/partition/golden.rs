//! The same pairs on every machine.

use verlock::Hash;

use super::all;
use super::crowd::{Crowd, apply};

#[test]
fn pairs_are_as_accepted() {
    for (name, mut partition) in all() {
        let mut crowd = Crowd::new(4);
        let mut bytes = vec![];
        for _ in 0..50 {
            apply(&mut *partition, &crowd.tick());
            let ids = partition.pairs().as_flattened();
            bytes.extend(ids.iter().flat_map(|id| id.to_le_bytes()));
        }
        let hash = Hash::of(&bytes).to_string();
        assert_eq!(hash, "24d151a2143590b535525341385b9a30", "{name}");
    }
}
