//! What every world keeps, however it came about.

use verlock::snapshot::{Section, Snapshot, diff};
use verlock::world::World;

/// Raw units: no position is farther from the origin.
const WORLD_LIMIT: u64 = 1 << 60;
/// Whoever saves a world later than this cannot load it again.
const TICK_MAX: u64 = u64::MAX >> 1;
/// Relaxed objects a tick: a world that needs more is not stepped.
const WORK_MAX: usize = 1 << 20;

/// Whether a tick of this world is soon done.
pub fn is_small(world: &World) -> bool {
    let particles = world.particles().positions_raw().len();
    let surfaces = world.half_spaces().count() + 1;
    let objects = particles * surfaces + world.distances().count();
    let config = world.config();
    let rounds = (config.substeps * config.iterations) as usize; // at most 64 * 64
    world.tick() < TICK_MAX && objects.saturating_mul(rounds) <= WORK_MAX
}

/// The invariants of a world: within its limits, and its bytes are its state.
pub fn is_sound(world: &World) {
    let particles = world.particles();
    let positions = particles.positions_raw().iter().flatten();
    assert!(positions.copied().all(|c| c.unsigned_abs() <= WORLD_LIMIT), "beyond the world");
    let most = world.config().displacement_max.raw().unsigned_abs();
    let displacements = particles.displacements_raw().iter().flatten();
    let mut sizes = displacements.map(|c| u64::from(c.unsigned_abs()));
    assert!(sizes.all(|size| size <= most), "faster than the maximum");
    for (index, position) in (0..).zip(particles.positions_raw()) {
        let id = particles.id_at(index);
        assert!(id.is_some() || *position == [0; 3], "free slot {index} is not empty");
        assert_eq!(id.and_then(|id| world.velocity(id)).is_some(), id.is_some());
    }

    let saved = world.save();
    let snapshot = Snapshot::parse(&saved).expect("a world is saved as a snapshot");
    assert_eq!(snapshot.hash(), world.hash(), "a kept hash is not that of the bytes");
    for (section, hash) in world.part_hashes() {
        assert_eq!(snapshot.part_hash(section), hash, "{section}");
    }
    if world.tick() <= TICK_MAX {
        let loaded = World::load(&saved).expect("what was saved loads");
        assert_eq!(loaded.save(), saved, "what was loaded is what was saved");
    }
}

/// Two snapshots differ exactly where their hashes do, and what they hold can be shown.
pub fn differences(a: &[u8], b: &[u8]) {
    let [a, b] = [a, b].map(|bytes| Snapshot::parse(bytes).expect("saved"));
    assert_eq!(diff(&a, &a).count(), 0);
    for section in Section::ALL {
        let differ = diff(&a, &b).filter(|difference| difference.section == section);
        let shown = differ.inspect(|difference| assert_ne!(difference.to_string(), "")).count();
        assert_eq!(shown == 0, a.part_hash(section) == b.part_hash(section), "{section}");
    }
}
