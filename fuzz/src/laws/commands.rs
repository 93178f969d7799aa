//! Any world and any commands.

use verlock::world::{Command, World};

use super::draw::Draw;
use super::snapshot::other_world;
use super::world::is_sound;

/// No more ticks are played.
const TICKS_MAX: usize = 12;

/// A world, one restored from its bytes and one that became its clone stay the same, whatever
/// commands they are given, in whatever order. True if anything was ordered.
pub fn commands(bytes: &[u8]) -> bool {
    let mut draw = Draw::new(bytes);
    let mut world = draw.world();
    let mut restored = other_world();
    // Like a rollback game's ring of saved worlds: each is two ticks old when it is overwritten.
    let mut ring = [world.clone(), other_world()];
    let mut ordered = false;
    for tick in 0..TICKS_MAX {
        let commands = draw.commands(&world);
        ordered |= !commands.is_empty();
        restored.restore(&world.save()).expect("what was saved can be restored");
        let cloned = &mut ring[tick % 2];
        cloned.clone_from(&world);
        assert_eq!(cloned.hash(), world.hash(), "cloned at tick {tick}");
        step_alike(&commands, &mut world, [&mut restored, cloned]);
        is_sound(&world);
        if draw.is_done() {
            break;
        }
    }
    ordered
}

/// Steps all worlds with the same commands in different orders.
fn step_alike(commands: &[Command], world: &mut World, others: [&mut World; 2]) {
    let mut order = commands.to_vec();
    world.step(commands);
    for other in others {
        // Backwards for the first; for the second forwards, from the middle on.
        order.reverse();
        other.step(&order);
        assert_eq!(other.events(), world.events(), "events");
        assert_eq!(other.part_hashes(), world.part_hashes(), "parts");
        assert_eq!(other.hash(), world.hash(), "hash");
        order.rotate_left(commands.len() / 2);
    }
}
