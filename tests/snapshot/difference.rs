//! What `diff` says about two snapshots.

use verlock::math::Factor;
use verlock::snapshot::{Difference, Snapshot, Values, diff};
use verlock::world::{Action, ObjectId};
use verlock::{Real, Vec3, real};

use crate::support::container::Parts;
use crate::support::spot::Spot;
use crate::support::worlds::{command, distance, other, particle, small};

fn texts(a: &[u8], b: &[u8]) -> Vec<String> {
    let [a, b] = [a, b].map(|bytes| Snapshot::parse(bytes).expect("a sound snapshot"));
    diff(&a, &b).map(|difference| difference.to_string()).collect()
}

/// A difference tells section, object, field, and both values as numbers and as bits.
#[test]
fn a_difference_is_named() {
    let free = particle(4);
    let [a, b] = [("-3", 0), ("-3.5", 255)].map(|(z, user)| {
        let mut world = small();
        let z = z.parse().expect("a decimal");
        let actions = [
            Action::SetGravityScale { particle: free, scale: Factor::ZERO },
            Action::SetVelocity { particle: free, velocity: Vec3::ZERO },
            Action::Teleport { particle: free, position: Vec3::new(Real::ONE, real!("2"), z) },
            Action::SetUser { object: ObjectId::Distance(distance(0)), user },
        ];
        let commands: Vec<_> = (0..).zip(actions).map(|(i, action)| command(i, action)).collect();
        world.step(&commands);
        world.save()
    });
    let expected = [
        "position 4 z: -3 against -3.5 (raw 0xfffffffffd000000 against 0xfffffffffc800000)",
        "distance 0 user: 0 against 255 (raw 0x0000000000000000 against 0x00000000000000ff)",
    ];
    assert_eq!(texts(&a, &b), expected);
}

/// Whatever single field differs, that one is named, with its bits.
#[test]
fn every_field_can_be_named() {
    let parts = Parts::of(&small().save());
    let file = parts.file();
    let original = Snapshot::parse(&file).expect("a sound snapshot");
    assert_eq!(diff(&original, &original).count(), 0);
    for spot in Spot::all(&parts) {
        let bits = spot.other_bits(&parts)[0];
        let file = spot.with(&parts, bits).file();
        let changed = Snapshot::parse(&file).expect("a sound snapshot");
        let found: Vec<Difference> = diff(&original, &changed).collect();
        let [Difference { section, values: Values::Field { index, field, a, b } }] = found[..]
        else {
            unreachable!("{spot}: {found:?}");
        };
        assert_eq!((section, index, field), (spot.section, spot.index as u64, spot.field.name));
        assert_eq!((a.raw, b.raw), (spot.read(&parts), bits), "{spot}");
        assert_eq!((a.kind, b.kind), (spot.field.kind, spot.field.kind), "{spot}");
    }
}

/// Worlds of different sizes: the counts are told, then how the records differ that both have.
#[test]
fn different_counts_are_named() {
    let texts = texts(&small().save(), &other().save());
    let about = |start: &str| texts.iter().filter(|line| line.starts_with(start)).count();
    let ticks = "(raw 0x0000000000000002 against 0x0000000000000001)";
    assert_eq!(about(&format!("world 0 tick: 2 against 1 {ticks}")), 1);
    assert_eq!(about("particle-slot: 6 records against 40"), 1);
    assert_eq!(about("distance: 3 records against 39"), 1);
    assert_eq!(about("half-space: 2 records against 0"), 1);
    assert_eq!(about("particle 4 mass: "), 0, "both have 1 there");
    assert_eq!(about("position 4 z: "), 1);
    assert_eq!(about("position 6 "), 0, "only one of them has it");
}
