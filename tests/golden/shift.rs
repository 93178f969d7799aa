//! A world behaves the same wherever it stands.

use verlock::Vec3;
use verlock::particle::WORLD_LIMIT;
use verlock::snapshot::Section;
use verlock::world::{Action, Command, World};

use crate::support::container::Parts;
use crate::support::fixture::{EMULATED, Fixture};

/// Scenes that run into the limit of the world, which does not move with them.
const AT_THE_LIMIT: [&str; 1] = ["overflow"];

/// Raw: the least step, 10^9 m and odd, and most of the way to the limit.
const SHIFTS: [[i64; 3]; 3] =
    [[1, -1, 3], [16_777_216_000_000_001, -16_777_216_000_000_000, 5], [-(1 << 59), 1 << 59, 7]];

/// Shifted by any vector, every scene has the same displacements and events on every tick, and
/// positions shifted by that vector.
#[test]
fn shifted_scenes_move_alike() {
    for fixture in Fixture::all() {
        if AT_THE_LIMIT.contains(&&*fixture.name) || EMULATED && fixture.is_large() {
            continue;
        }
        let Fixture { name, scene } = fixture;
        let mut world = scene.build().expect("a good scene");
        let shifts = if EMULATED { &SHIFTS[1..2] } else { &SHIFTS };
        let mut shifted: Vec<_> = shifts.iter().map(|&by| (by, shift_world(&world, by))).collect();
        for tick in 0..scene.ticks() {
            let commands = scene.commands(&world);
            world.step(&commands);
            for (by, shifted) in &mut shifted {
                let commands: Vec<_> = commands.iter().map(|c| shift_command(*c, *by)).collect();
                shifted.step(&commands);
                assert!(shifted.events() == world.events(), "{name}, tick {tick}, by {by:?}");
                same_motion(&world, shifted, *by).unwrap_or_else(|slot| {
                    unreachable!("{name}, tick {tick}, by {by:?}: particle {slot}")
                });
            }
        }
    }
}

/// Two scenes that differ in nothing but the origin.
#[test]
fn a_scene_far_away_moves_alike() {
    let [near, far] = ["near", "far"].map(Fixture::read);
    let [mut near_world, mut far_world] =
        [&near, &far].map(|fixture| fixture.scene.build().expect("a good scene"));
    let origin = 1_000_000_000 << 24;
    for tick in 0..near.scene.ticks() {
        near_world.step(&near.scene.commands(&near_world));
        far_world.step(&far.scene.commands(&far_world));
        assert_eq!(same_motion(&near_world, &far_world, [origin; 3]), Ok(()), "tick {tick}");
    }
}

/// The slot of a particle that does not move in one world as it does in the other.
fn same_motion(world: &World, shifted: &World, by: [i64; 3]) -> Result<(), usize> {
    let [a, b] = [world, shifted].map(World::particles);
    assert_eq!(a.ids().collect::<Vec<_>>(), b.ids().collect::<Vec<_>>());
    let different = a.ids().map(|id| id.0.slot()).find(|&slot| {
        let position = shift(a.positions_raw()[slot], by);
        position != b.positions_raw()[slot]
            || a.displacements_raw()[slot] != b.displacements_raw()[slot]
    });
    different.map_or(Ok(()), Err)
}

/// The same world elsewhere, by way of its snapshot.
fn shift_world(world: &World, by: [i64; 3]) -> World {
    let mut parts = Parts::of(&world.save());
    for (slots, rows) in
        [(Section::ParticleSlot, Section::Position), (Section::HalfSpaceSlot, Section::HalfSpace)]
    {
        let generations = parts.section(slots as u32).clone();
        let size = rows.record_size() as usize;
        let records = parts.section(rows as u32).chunks_mut(size).zip(generations.chunks(4));
        for (record, _) in records.filter(|(_, generation)| generation[0] % 2 == 1) {
            for (bytes, by) in record.chunks_mut(8).zip(by) {
                let raw = i64::from_le_bytes(*bytes.first_chunk().expect("8 bytes"));
                bytes.copy_from_slice(&(raw + by).to_le_bytes());
            }
        }
    }
    World::load(&parts.file()).expect("within the limit")
}

/// A command with its places shifted. Those outside the world stay outside.
fn shift_command(mut command: Command, by: [i64; 3]) -> Command {
    let place = match &mut command.action {
        Action::SpawnParticle { spec, .. } => &mut spec.position,
        Action::SpawnHalfSpace { half_space, .. } => &mut half_space.point,
        Action::MovePin { target, .. } => target,
        Action::Teleport { position, .. } => position,
        _ => return command,
    };
    if place.raw().iter().all(|c| c.unsigned_abs() <= WORLD_LIMIT.unsigned_abs()) {
        *place = Vec3::from_raw(shift(place.raw(), by));
    }
    command
}

fn shift(v: [i64; 3], by: [i64; 3]) -> [i64; 3] {
    [0, 1, 2].map(|k| v[k] + by[k])
}
