//! Laws for random worlds: the frame of reference and the order of commands do not matter, and no
//! world, however hostile, leaves its limits.

use proptest::prelude::*;
use verlock::World;
use verlock::constraint::{Distance, DistanceForm};
use verlock::math::{Real, Vec3};
use verlock::particle::{ParticleSpec, WORLD_LIMIT};
use verlock::world::EventKind;

use crate::support::blueprint::{Blueprint, first};
use crate::support::frame::Frame;
use crate::support::momentum::momentum;
use crate::support::random::{Size, everyday, hostile};

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// Random worlds, small enough to shrink to something readable.
fn world() -> impl Strategy<Value = Blueprint> {
    let size = (2..12_u32, 0..20_u32, 0..4_u32, 1..30_u32);
    (any::<u64>(), size).prop_map(|(seed, (particles, links, walls, ticks))| {
        everyday(seed, Size { particles, links, walls, ticks })
    })
}

/// Up to 10^9 m, and so near to the limits that a world of 2^13 m just fits.
fn shift() -> impl Strategy<Value = [i64; 3]> {
    let billion = 1_000_000_000_i64 << 24;
    let edge = WORLD_LIMIT - (1 << 37);
    prop::array::uniform3(prop_oneof![
        3 => -billion..=billion,
        1 => prop::sample::select(vec![-edge, edge]),
        1 => -2..=2_i64,
    ])
}

/// The world as it was built and as it looks in the frame do the same, tick by tick, to the bit.
fn looks_alike(blueprint: &Blueprint, frame: &Frame) -> Result<(), TestCaseError> {
    let seen = frame.blueprint(blueprint);
    let (mut plain, mut moved) = (blueprint.build(), seen.build());
    for tick in 0..30 {
        let events = plain.step(&blueprint.commands(tick)).to_vec();
        prop_assert_eq!(&events[..], moved.step(&seen.commands(tick)), "{:?}", frame);
        for id in plain.particles().ids() {
            let place = |world: &World| world.position(id);
            let motion = |world: &World| world.particles().displacement(id);
            let expected = place(&plain).map(|x| frame.point(x));
            prop_assert_eq!(place(&moved), expected, "{} at tick {}, {:?}", id, tick, frame);
            let expected = motion(&plain).map(|d| frame.vector(d));
            prop_assert_eq!(motion(&moved), expected, "{} at tick {}, {:?}", id, tick, frame);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn a_shifted_world_moves_alike(blueprint in world(), shift in shift()) {
        looks_alike(&blueprint, &Frame::shifted(shift))?;
    }

    #[test]
    fn a_mirrored_world_moves_alike(blueprint in world(), axis in 0..3_usize) {
        looks_alike(&blueprint, &Frame::mirror(axis))?;
    }

    #[test]
    fn a_turned_world_moves_alike(blueprint in world(), axis in 0..3_usize) {
        looks_alike(&blueprint, &Frame::turn(axis))?;
    }

    /// However a world came to be at a tick, the next one is the same: what is kept besides the
    /// state changes nothing.
    #[test]
    fn a_restored_world_moves_alike(blueprint in world()) {
        let mut world = blueprint.build();
        let mut restored = world.clone();
        for tick in 0..30 {
            restored.restore(&world.save()).expect("what was saved can be restored");
            let commands = blueprint.commands(tick);
            prop_assert_eq!(world.step(&commands), restored.step(&commands));
            prop_assert_eq!(world.part_hashes(), restored.part_hashes(), "tick {}", tick);
        }
    }

    #[test]
    fn the_order_of_commands_in_the_slice_does_not_matter(
        blueprint in world(),
        order in Just((0..30_usize).collect::<Vec<_>>()).prop_shuffle(),
    ) {
        let shuffle = |tick| {
            let commands = blueprint.commands(tick);
            let order = order.iter().filter(|&&at| at < commands.len());
            order.map(|&at| commands[at]).collect::<Vec<_>>()
        };
        let mut sorted = blueprint.build();
        let mut shuffled = sorted.clone();
        for tick in 0..30 {
            sorted.step(&blueprint.commands(tick));
            shuffled.step(&shuffle(tick));
            prop_assert_eq!(sorted.events(), shuffled.events());
            prop_assert_eq!(sorted.hash(), shuffled.hash(), "tick {}", tick);
            prop_assert!(sorted.events().is_sorted(), "{:?}", sorted.events());
        }
    }
}

proptest! {
    #![proptest_config(cases(64))]

    /// Nothing overflows, which debug assertions would turn into a panic, and nothing gets out.
    #[test]
    fn a_hostile_world_stays_within_its_limits(seed in any::<u64>(), walls in 0..4_u32) {
        let size = Size { particles: 100, links: 200, walls, ticks: 8 };
        let blueprint = hostile(seed, size);
        let mut world = blueprint.build();
        for tick in 0..u64::from(size.ticks) {
            world.step(&blueprint.commands(tick));
            let particles = world.particles();
            let inside = |c: &i64| c.abs() <= WORLD_LIMIT;
            prop_assert!(particles.positions_raw().iter().flatten().all(inside));
            let limit = world.config().displacement_max.raw();
            let short = |c: &i32| i64::from(*c).abs() <= limit;
            prop_assert!(particles.displacements_raw().iter().flatten().all(short));
        }
    }
}

/// A heavy hub with 200 light spokes, all far from their rest lengths: what no limit cut keeps its
/// momentum within twice the sum of the masses of every link, in units of length.
#[test]
fn a_hub_keeps_its_momentum() {
    for (hub, spoke) in [(Real::from_raw(16_778), 1_000_000), (Real::from_int(1_000_000), 1)] {
        let mut specs = vec![ParticleSpec::default().mass(hub)];
        specs.extend((0..200).map(|k| {
            let place = Vec3::from_ints(k % 7 - 3, k % 5 - 2, k % 9 - 4) * Real::from_int(2);
            ParticleSpec::at(place + Vec3::X).mass(Real::from_int(spoke))
        }));
        let mut blueprint = Blueprint::new(verlock::WorldConfig::default(), &specs);
        blueprint.config.gravity = Vec3::ZERO;
        blueprint.config.iterations = 2;
        let form = |k: u32| [DistanceForm::Exact, DistanceForm::StartOfStep][(k % 2) as usize];
        blueprint.distances = (1..=200)
            .map(|k| Distance::new(first(0), first(k), Real::from_int(5)).form(form(k)))
            .collect();
        let mut world = blueprint.build();
        let mut before = [0; 3];
        for _ in 0..20 {
            let cut = world
                .step(&[])
                .iter()
                .any(|event| matches!(event.kind, EventKind::DisplacementClamped { .. }));
            let after = momentum(&world);
            // Arms and corrections below 2^31: an end errs by at most 1/2 + 1 + 1/2 units.
            let links = (hub.raw() + (i64::from(spoke) << 24)) * 200;
            let slack = i128::from(links) * 2 * 2 * 4;
            for (after, before) in after.into_iter().zip(before) {
                assert!(cut || (after - before).abs() <= slack, "{hub:?} kg: {after} {before}");
            }
            before = after;
        }
    }
}
