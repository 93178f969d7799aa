//! The hash of the state, and of its parts.

use std::collections::BTreeSet;

use verlock::Hash;
use verlock::snapshot::{Section, Snapshot};
use verlock::world::{Action, ObjectId, World, WorldConfig};
use verlock::{Vec3, real};

use crate::support::container::Parts;
use crate::support::spot::Spot;
use crate::support::worlds::{
    actions, command, distance, face, half_space, other, particle, small, volume,
};

/// The hash of the bytes that a snapshot would have, without anything kept.
fn fresh(world: &World) -> Hash {
    let file = world.save();
    Snapshot::parse(&file).expect("a sound snapshot").hash()
}

/// The hash is that of the header and the table; a part's is that of the section.
#[test]
fn hashes_are_those_of_the_format() {
    for world in [small(), other()] {
        let file = world.save();
        let parts = Parts::of(&file);
        assert_eq!(world.hash(), Hash::of(&file[..parts.table_end()]));
        let snapshot = Snapshot::parse(&file).expect("a sound snapshot");
        assert_eq!(snapshot.hash(), world.hash());
        assert_eq!(snapshot.tick(), world.tick());
        for ((section, hash), part) in world.part_hashes().into_iter().zip(&parts.parts) {
            assert_eq!(section as u32, part.kind);
            assert_eq!(hash, Hash::of(&part.bytes), "{section}");
            assert_eq!(snapshot.part_hash(section), hash, "{section}");
            assert_eq!(snapshot.bytes(section), part.bytes, "{section}");
        }
    }
}

/// Kept hashes are dropped by whatever changes what they are of, in a clone too.
#[test]
fn kept_hashes_never_lag_behind() {
    let original = small();
    let hash = original.hash();
    for action in actions() {
        // Alone: nothing is copied before it is edited, so only forgetting keeps the hash true.
        let mut alone = small();
        assert_eq!(alone.hash(), hash);
        alone.step(&[command(0, action)]);
        assert_eq!(alone.hash(), fresh(&alone), "{action:?}");
        let mut world = original.clone();
        let mut copied = other();
        assert_ne!(copied.hash(), hash);
        copied.clone_from(&original);
        for world in [&mut world, &mut copied] {
            assert_eq!(world.hash(), hash);
            world.step(&[command(0, action)]);
            assert_eq!(world.hash(), fresh(world), "{action:?}");
            assert_ne!(world.hash(), hash, "{action:?}");
        }
        world.restore(&original.save()).expect("a sound snapshot");
        assert_eq!(world.hash(), hash, "{action:?}");
        assert_eq!(original.hash(), fresh(&original), "{action:?} changed what was cloned");
    }
}

/// Every field of the state moves the hash of its section and of the world, and of no other part.
#[test]
fn every_field_moves_the_hash() {
    let original = small();
    let parts = Parts::of(&original.save());
    let mut still: BTreeSet<_> = Section::ALL
        .into_iter()
        .flat_map(|section| section.fields().iter().map(move |field| (section, field.name)))
        .collect();
    for spot in Spot::all(&parts).into_iter().filter(|spot| spot.is_alive(&parts)) {
        let files = spot.other_bits(&parts).into_iter().map(|bits| spot.with(&parts, bits).file());
        for changed in files.filter_map(|file| World::load(&file).ok()) {
            assert_ne!(changed.hash(), original.hash(), "{spot}");
            assert_eq!(moved(&changed, &original), [spot.section], "{spot}");
            still.remove(&(spot.section, spot.field.name));
        }
    }
    // No other generation than that of the particle is valid; bytes are hashed all alike.
    let bound = |(section, name): &(Section, &str)| {
        name.ends_with(".generation") && *section != Section::ParticleSlot
    };
    assert_eq!(still.iter().filter(|field| bound(field)).count(), 2 + 4 + 3);
    assert!(still.iter().all(bound), "without another valid value: {still:?}");
}

/// The sections whose hashes differ.
fn moved(a: &World, b: &World) -> Vec<Section> {
    let parts = a.part_hashes().into_iter().zip(b.part_hashes());
    parts.filter(|(a, b)| a != b).map(|((section, _), _)| section).collect()
}

/// The part hashes tell which part of the world a command changed.
#[test]
fn part_hashes_name_the_part() {
    let user = |object| Action::SetUser { object, user: 1 };
    let slow = WorldConfig { iterations: 9, ..*small().config() };
    let velocity = Vec3::new(real!("0.5"), real!("0.25"), real!("0.125"));
    for (action, expected) in [
        (user(ObjectId::Particle(particle(4))), &[Section::Particle][..]),
        (user(ObjectId::Distance(distance(0))), &[Section::Distance]),
        (user(ObjectId::HalfSpace(half_space(1))), &[Section::HalfSpace]),
        (user(ObjectId::Volume(volume(1))), &[Section::Volume]),
        (user(ObjectId::Face(face(1))), &[Section::Face]),
        (
            Action::Remove { object: ObjectId::Face(face(1)) },
            &[
                Section::Position,
                Section::Displacement,
                Section::Distance,
                Section::Carry,
                Section::FaceSlot,
                Section::Face,
            ],
        ),
        (
            Action::Remove { object: ObjectId::Distance(distance(0)) },
            &[
                Section::Position,
                Section::Displacement,
                Section::DistanceSlot,
                Section::Distance,
                Section::Carry,
            ],
        ),
        (
            Action::SetVelocity { particle: particle(4), velocity },
            &[Section::Position, Section::Displacement],
        ),
    ] {
        let (mut plain, mut changed) = (small(), small());
        plain.step(&[]);
        changed.step(&[command(0, action)]);
        assert_eq!(moved(&changed, &plain), expected, "{action:?}");
    }
    let (mut plain, mut changed) = (other(), other());
    plain.step(&[]);
    changed.step(&[command(0, Action::Configure { config: slow })]);
    assert!(moved(&changed, &plain).contains(&Section::World));
}
