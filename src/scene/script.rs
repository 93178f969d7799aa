//! What happens in a scene.

use alloc::vec::Vec;

use super::parse::Description;
use crate::world::{Command, World};

/// The commands of the coming tick, numbered through.
pub(super) fn commands(description: &Description, world: &World) -> Vec<Command> {
    let Description { timeline, storm, .. } = description;
    let start = timeline.partition_point(|entry| entry.tick < world.tick());
    let due = timeline[start..].iter().take_while(|entry| entry.tick == world.tick());
    let due = due.map(|entry| (entry.player, entry.action(world)));
    let storm = storm
        .iter()
        .flat_map(|storm| storm.actions(world).into_iter().map(|action| (storm.player, action)));
    (0u32..)
        .zip(due.chain(storm))
        .map(|(sequence, (player, action))| Command { player, sequence, action })
        .collect()
}
