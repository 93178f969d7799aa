//! Save and restore, on every tick of every scene.

use verlock::snapshot::Snapshot;
use verlock::world::World;

use crate::support::fixture::{EMULATED, Fixture};
use crate::support::worlds::other;

/// From one tick that is saved to the next.
const STRIDE: u64 = if EMULATED { 15 } else { 1 };

/// The same for large snapshots in a debug build; `cargo test --release` saves every tick.
const LARGE_STRIDE: u64 = if cfg!(debug_assertions) { 15 } else { STRIDE };

/// What is large, bytes.
const LARGE: usize = 1 << 18;

/// However a world comes to be at a tick, the next one is the same, events included: by stepping,
/// by `clone_from` into a world with other contents, by decoding, by `restore` over another.
#[test]
fn saving_changes_no_tick() {
    let alien = other();
    let mut ticks = 0;
    for Fixture { name, scene } in Fixture::all() {
        let mut world = scene.build().expect("a good scene");
        let mut cloned = alien.clone();
        let stride = if world.save().len() < LARGE { STRIDE } else { LARGE_STRIDE };
        for tick in 0..scene.ticks() {
            if !tick.is_multiple_of(stride) {
                let commands = scene.commands(&world);
                world.step(&commands);
                continue;
            }
            let bytes = world.save();
            let snapshot = Snapshot::parse(&bytes).expect("a sound snapshot");
            assert_eq!(snapshot.hash(), world.hash(), "{name}, tick {tick}: a kept hash");
            let mut loaded = alien.clone();
            if tick % 2 == 0 {
                loaded = snapshot.load().expect("a sound snapshot");
            } else {
                loaded.restore(&bytes).expect("a sound snapshot");
            }
            cloned.clone_from(&alien);
            cloned.clone_from(&world);
            let commands = scene.commands(&world);
            assert_eq!(scene.commands(&loaded), commands, "{name}, tick {tick}: the script");
            world.step(&commands);
            same_step(&mut cloned, &commands, &world, (&name, tick));
            same_step(&mut loaded, &commands, &world, (&name, tick));
            ticks += 1;
        }
    }
    assert!(ticks > 1000 / STRIDE, "only {ticks} ticks");
}

fn same_step(world: &mut World, commands: &[verlock::Command], expected: &World, at: (&str, u64)) {
    world.step(commands);
    let (name, tick) = at;
    assert_eq!(world.hash(), expected.hash(), "{name}, tick {tick}");
    assert!(world.events() == expected.events(), "{name}, tick {tick}: events");
}
