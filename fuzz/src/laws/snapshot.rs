//! Any bytes are a snapshot or are not.

use verlock::particle::ParticleSpec;
use verlock::snapshot::DecodeError;
use verlock::world::World;
use verlock::{Vec3, WorldBuilder, WorldConfig};

use super::world::{differences, is_small, is_sound};

/// Ticks for which a decoded world is stepped.
const TICKS: u64 = 3;

/// What decodes is encoded to the same bytes, and goes on as a world; what does not changes
/// nothing. True if the bytes are a snapshot.
pub fn snapshot(bytes: &[u8]) -> bool {
    let mut other = other_world();
    match World::load(bytes) {
        Ok(world) => accepted(bytes, world, other),
        Err(error) => {
            is_inside(error, bytes);
            let before = other.save();
            assert_eq!(other.restore(bytes), Err(error));
            assert!(other.save() == before, "a refused snapshot changed the world");
            false
        }
    }
}

fn accepted(bytes: &[u8], mut world: World, mut other: World) -> bool {
    assert!(world.save() == bytes, "a snapshot is saved with other bytes than it was loaded from");
    is_sound(&world);
    other.restore(bytes).expect("what loads can be restored");
    if !is_small(&world) {
        return true;
    }
    for _ in 0..TICKS {
        assert_eq!(world.step(&[]), other.step(&[]), "events");
        assert_eq!(world.hash(), other.hash(), "loaded and restored");
    }
    is_sound(&world);
    differences(bytes, &world.save());
    true
}

/// An error names a place in the bytes, or their end.
pub(super) fn is_inside(error: DecodeError, bytes: &[u8]) {
    assert!(error.offset <= bytes.len() as u64, "{error} in {} bytes", bytes.len());
}

/// A world with contents of its own, which must not show through.
pub(super) fn other_world() -> World {
    let config = WorldConfig { substeps: 3, ..WorldConfig::default() };
    let mut builder = WorldBuilder::new(config).expect("in range");
    builder.seed(7);
    for height in 0..5 {
        let spec = ParticleSpec::at(Vec3::from_ints(0, height, 0));
        builder.particle(&spec).expect("in range");
    }
    let mut world = builder.build();
    world.step(&[]);
    world
}
