//! Floor 8: worlds as bytes, and their hashes.

mod damage;
mod difference;
mod hash;
mod hostile;

use verlock::snapshot::Section;
use verlock::world::World;

use crate::support::container::Parts;
use crate::support::worlds::{actions, command, other, small};

/// A loaded world saves to the same bytes, and steps like the one that was saved.
#[test]
fn a_world_survives_its_snapshot() {
    for mut world in [small(), other()] {
        let bytes = world.save();
        let mut loaded = World::load(&bytes).expect("a sound snapshot");
        assert_eq!(loaded.save(), bytes);
        for action in actions() {
            let commands = [command(0, action)];
            assert_eq!(loaded.step(&commands), world.step(&commands), "{action:?}");
            assert_eq!(loaded.hash(), world.hash(), "{action:?}");
        }
        assert_eq!(loaded.save(), world.save());
    }
}

/// What a world held before it was restored, cached and all, does not matter.
#[test]
fn a_world_is_restored_over_another() {
    let mut saved = small();
    let bytes = saved.save();
    let mut restored = other();
    restored.restore(&bytes).expect("a sound snapshot");
    let mut cloned = other();
    cloned.clone_from(&saved);
    assert!(restored.events().is_empty(), "events are not restored");
    for world in [&mut restored, &mut cloned] {
        assert_eq!(world.save(), bytes);
        assert_eq!(world.tick(), saved.tick());
    }
    for _ in 0..20 {
        saved.step(&[]);
        restored.step(&[]);
        cloned.step(&[]);
        assert_eq!(restored.hash(), saved.hash());
        assert_eq!(cloned.hash(), saved.hash());
    }
}

/// `save_into` appends, and the library reads back what a file made by `FORMAT.md` says.
#[test]
fn the_layout_is_that_of_the_format() {
    let world = small();
    let mut out = b"before".to_vec();
    world.save_into(&mut out);
    let file = world.save();
    assert_eq!(out, [b"before", &file[..]].concat());
    assert_eq!(Parts::of(&file).file(), file);
}

/// The fields of every section are as wide as what is written, and every section has records.
#[test]
fn the_schema_fits_the_bytes() {
    let parts = Parts::of(&small().save());
    assert_eq!(parts.parts.len(), Section::ALL.len());
    for (section, part) in Section::ALL.into_iter().zip(&parts.parts) {
        let width: u32 = section.fields().iter().map(|field| field.kind.width()).sum();
        assert_eq!((part.kind, part.size), (section as u32, width), "{section}");
        let counts = [1, 6, 6, 6, 6, 3, 3, 2, 2, 1, 2, 2, 2, 2];
        let count = part.bytes.len() / part.size as usize;
        assert_eq!(count, counts[part.kind as usize - 1], "{section}");
    }
}
