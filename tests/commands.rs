//! What each command does, what it is refused for, and which ids objects get.

use proptest::prelude::*;
use verlock::constraint::{Distance, DistanceId, HalfSpace, HalfSpaceId};
use verlock::math::{Factor, Real, UnitVec3, Vec3};
use verlock::particle::{Particle, ParticleId, ParticleSpec, RangeError, RangeFault, WORLD_LIMIT};
use verlock::store::Handle;
use verlock::world::{Action, Command, Event, EventKind, ObjectId, Refusal};
use verlock::{World, WorldConfig, real};

use crate::support::blueprint::{Blueprint, act, run};
use crate::support::random::{Size, everyday};

const FREE: ParticleId = ParticleId(Handle::new(0, 1));
const OTHER: ParticleId = ParticleId(Handle::new(1, 1));
const PIN: ParticleId = ParticleId(Handle::new(2, 1));
const OFF: ParticleId = ParticleId(Handle::new(3, 1));
const GONE: ParticleId = ParticleId(Handle::new(1, 3));
const ROD: DistanceId = DistanceId(Handle::new(0, 1));
const FLOOR: HalfSpaceId = HalfSpaceId(Handle::new(0, 1));

/// Two particles joined by a rod, a pin, a disabled particle, and a floor far below.
fn stage() -> World {
    let specs = [
        ParticleSpec::default(),
        ParticleSpec::at(Vec3::X).velocity(Vec3::Y),
        ParticleSpec::at(Vec3::Z).pinned(),
        ParticleSpec {
            particle: Particle { enabled: false, ..Particle::default() },
            ..ParticleSpec::at(Vec3::Y)
        },
    ];
    let mut blueprint = Blueprint::new(WorldConfig::default(), &specs);
    blueprint.distances = vec![Distance::new(FREE, OTHER, Real::ONE)];
    let point = Vec3::from_ints(0, -100, 0);
    blueprint.half_spaces = vec![HalfSpace { point, ..HalfSpace::default() }];
    let mut world = blueprint.build();
    run(&mut world, 2);
    world
}

#[test]
fn properties_are_set() {
    let mut world = stage();
    let (mass, user, length) = (real!("2.5"), u64::MAX, real!("1.25"));
    let (scale, acceleration) = (Factor::from_raw(-7), Vec3::from_ints(1, 2, 3));
    let events = act(
        &mut world,
        &[
            Action::SetMass { particle: FREE, mass },
            Action::SetGravityScale { particle: FREE, scale },
            Action::SetAcceleration { particle: FREE, acceleration },
            Action::SetPinned { particle: FREE, pinned: true },
            Action::SetEnabled { object: ObjectId::Particle(FREE), enabled: false },
            Action::SetUser { object: ObjectId::Particle(FREE), user },
            Action::SetRestLength { distance: ROD, rest_length: length },
            Action::SetEnabled { object: ObjectId::Distance(ROD), enabled: false },
            Action::SetUser { object: ObjectId::Distance(ROD), user },
            Action::SetEnabled { object: ObjectId::HalfSpace(FLOOR), enabled: false },
            Action::SetUser { object: ObjectId::HalfSpace(FLOOR), user },
        ],
    );
    assert_eq!(events, []);
    let expected =
        Particle { mass, gravity_scale: scale, acceleration, pinned: true, enabled: false, user };
    assert_eq!(world.particles().particle(FREE), Some(&expected));
    let rod = world.distance(ROD).map(|row| (row.rest_length, row.enabled, row.user));
    assert_eq!(rod, Some((length, false, user)));
    let floor = world.half_space(FLOOR).map(|row| (row.enabled, row.user));
    assert_eq!(floor, Some((false, user)));
}

/// A rod that is disabled, or has a disabled end, lets its ends go; a disabled floor lets through.
#[test]
fn what_is_disabled_does_nothing() {
    let off = |object| Action::SetEnabled { object, enabled: false };
    type Fell = fn(&World) -> bool;
    let cases: [(Action, u32, Fell); 3] = [
        (off(ObjectId::Distance(ROD)), 60, |world| length(world) > real!("1.01")),
        (off(ObjectId::Particle(FREE)), 60, |world| length(world) > real!("1.01")),
        (off(ObjectId::HalfSpace(FLOOR)), 600, |world| {
            world.position(FREE).is_some_and(|x| x.y < Real::from_int(-200))
        }),
    ];
    for (action, ticks, fell) in cases {
        let (mut kept, mut freed) = (stage(), stage());
        act(&mut freed, &[action]);
        act(&mut kept, &[]);
        run(&mut kept, ticks);
        run(&mut freed, ticks);
        assert!(fell(&freed) && !fell(&kept), "{action:?}");
    }
}

fn length(world: &World) -> Real {
    let end = |id| world.position(id).expect("both ends live");
    end(FREE).distance(end(OTHER))
}

/// A teleported particle is elsewhere at once and moves on as if nothing had been.
#[test]
fn a_teleport_keeps_the_motion() {
    let mut blueprint = Blueprint::new(WorldConfig::default(), &[ParticleSpec::default()]);
    blueprint.config.gravity = Vec3::from_ints(1, -2, 3);
    let (mut stays, mut goes) = (blueprint.build(), blueprint.build());
    let far = Vec3::from_raw([WORLD_LIMIT - (1 << 30), 5, -WORLD_LIMIT + (1 << 30)]);
    act(&mut stays, &[]);
    act(&mut goes, &[Action::Teleport { particle: FREE, position: far }]);
    let moved = |world: &World| world.particles().displacement(FREE);
    assert_eq!(moved(&goes), moved(&stays));
    assert_eq!(goes.position(FREE), stays.position(FREE).map(|x| x + far));
}

/// A longer rest length pushes the ends apart.
#[test]
fn a_rest_length_is_reached() {
    let mut world = stage();
    act(&mut world, &[Action::SetRestLength { distance: ROD, rest_length: real!("3") }]);
    run(&mut world, 120);
    let error = (length(&world) - real!("3")).abs();
    assert!(error < real!("0.001"), "{error} m");
}

/// Steps the stage with one command, which must be refused for this reason and change nothing: the
/// state is that of a step without it.
fn is_refused(action: Action, why: Refusal) {
    assert_eq!(refusal(action), why, "{action:?}");
}

/// Why an action is refused, which changes nothing.
fn refusal(action: Action) -> Refusal {
    let (mut world, mut plain) = (stage(), stage());
    let events = world.step(&[Command { player: 7, sequence: 9, action }]);
    let [Event { kind: EventKind::Refused { player: 7, sequence: 9, why }, .. }] = *events else {
        panic!("{action:?}: {events:?}");
    };
    plain.step(&[]);
    assert_eq!(world.hash(), plain.hash(), "{action:?} changed the state");
    why
}

#[test]
fn stale_ids_are_refused() {
    let stale = |field| Refusal::Stale { field };
    let (particle, zero, one) = (GONE, Vec3::ZERO, Real::ONE);
    let actions = [
        Action::Force { particle, force: zero },
        Action::Impulse { particle, impulse: zero },
        Action::SetVelocity { particle, velocity: zero },
        Action::SetAcceleration { particle, acceleration: zero },
        Action::SetMass { particle, mass: one },
        Action::SetGravityScale { particle, scale: Factor::ZERO },
        Action::SetPinned { particle, pinned: true },
        Action::MovePin { particle, target: zero },
        Action::Teleport { particle, position: zero },
        Action::SetUser { object: ObjectId::Particle(GONE), user: 1 },
        Action::SetEnabled { object: ObjectId::Particle(GONE), enabled: false },
    ];
    for action in actions {
        is_refused(action, stale("particle"));
    }
    for (a, b, field) in [(GONE, FREE, "a"), (FREE, GONE, "b")] {
        let distance = Distance::new(a, b, one);
        is_refused(Action::SpawnDistance { token: 0, distance }, stale(field));
    }
    let distance = DistanceId::default();
    is_refused(Action::SetRestLength { distance, rest_length: one }, stale("distance"));
    for object in [
        ObjectId::Distance(DistanceId(Handle::new(0, 3))),
        ObjectId::HalfSpace(HalfSpaceId(Handle::new(9, 1))),
    ] {
        is_refused(Action::SetUser { object, user: 1 }, stale("object"));
        is_refused(Action::SetEnabled { object, enabled: false }, stale("object"));
        is_refused(Action::Remove { object }, stale("object"));
    }
    is_refused(Action::Remove { object: ObjectId::Particle(GONE) }, stale("object"));
}

#[test]
fn particles_that_cannot_move_are_not_moved() {
    for particle in [PIN, OFF] {
        is_refused(Action::Force { particle, force: Vec3::X }, Refusal::NotMovable);
        is_refused(Action::Impulse { particle, impulse: Vec3::X }, Refusal::NotMovable);
        is_refused(Action::SetVelocity { particle, velocity: Vec3::X }, Refusal::NotMovable);
    }
    for particle in [FREE, OFF] {
        is_refused(Action::MovePin { particle, target: Vec3::X }, Refusal::NotPinned);
    }
}

#[test]
fn numbers_out_of_range_are_refused() {
    let (particle, token) = (FREE, 0);
    let far = Vec3::from_raw([0, WORLD_LIMIT + 1, 0]);
    let fast = Vec3::from_ints(0, 64 * 240 + 1, 0);
    let strong = Vec3::from_ints(0, 0, -100_001);
    let spawn = |spec| Action::SpawnParticle { token, spec };
    let join =
        |b, length| Action::SpawnDistance { token, distance: Distance::new(FREE, b, length) };
    let wall = |half_space| Action::SpawnHalfSpace { token, half_space };
    let bent = UnitVec3::from_raw([1 << 30, 1 << 29, 0]);
    let config = WorldConfig::default();
    let cases = [
        (spawn(ParticleSpec::at(far)), "position"),
        (spawn(ParticleSpec::default().velocity(fast)), "velocity"),
        (spawn(ParticleSpec::default().mass(Particle::MASS_MAX + Real::ULP)), "mass"),
        (join(FREE, Real::ONE), "b"),
        (join(OTHER, Real::ZERO), "rest_length"),
        (wall(HalfSpace { normal: bent, ..HalfSpace::default() }), "normal"),
        (wall(HalfSpace { friction: Factor::from_raw(-1), ..HalfSpace::default() }), "friction"),
        (Action::Force { particle, force: strong }, "force"),
        (Action::SetVelocity { particle, velocity: fast }, "velocity"),
        (Action::SetAcceleration { particle, acceleration: strong }, "acceleration"),
        (Action::SetMass { particle, mass: Particle::MASS_MIN - Real::ULP }, "mass"),
        (
            Action::SetGravityScale { particle, scale: Factor::from_raw((16 << 16) + 1) },
            "gravity_scale",
        ),
        (Action::MovePin { particle: PIN, target: far }, "target"),
        (Action::Teleport { particle, position: far }, "position"),
        (Action::SetRestLength { distance: ROD, rest_length: real!("1024.5") }, "rest_length"),
        (Action::Configure { config: WorldConfig { substeps: 65, ..config } }, "substeps"),
        (Action::Configure { config: WorldConfig { tick_rate: 0, ..config } }, "tick_rate"),
        (Action::Configure { config: WorldConfig { damping: real!("61"), ..config } }, "damping"),
    ];
    for (action, field) in cases {
        match refusal(action) {
            Refusal::OutOfRange(error) => assert_eq!(error.field, field, "{action:?}"),
            why => panic!("{action:?}: {why}"),
        }
    }
}

/// Two forces whose sum is too much: the first acts, the second is refused.
#[test]
fn the_sum_of_forces_has_a_limit() {
    let (mut world, mut single) = (stage(), stage());
    let force = |x| Action::Force { particle: FREE, force: Vec3::from_ints(x, 0, 0) };
    let why = Refusal::OutOfRange(RangeError { field: "force", fault: RangeFault::OutOfRange });
    let events = act(&mut world, &[force(99_999), force(2)]);
    assert_eq!(events, [EventKind::Refused { player: 0, sequence: 1, why }]);
    act(&mut single, &[force(99_999)]);
    assert_eq!(world.hash(), single.hash());
}

/// The lowest free slot is reused first, with a new generation; the old id stays stale.
#[test]
fn slots_are_reused_lowest_first() {
    let mut world = stage();
    let remove = |particle| Action::Remove { object: ObjectId::Particle(particle) };
    act(&mut world, &[remove(PIN), remove(FREE)]);
    assert!(world.position(FREE).is_none() && world.velocity(PIN).is_none());
    let spawn = |token| Action::SpawnParticle { token, spec: ParticleSpec::default() };
    let spawned = |token, index, generation| {
        let object = ObjectId::Particle(ParticleId(Handle::new(index, generation)));
        EventKind::Spawned { token, object }
    };
    let events = act(&mut world, &[spawn(8), spawn(7), spawn(6)]);
    // Events are sorted by token, ids are given in order of the commands.
    assert_eq!(events, [spawned(6, 4, 1), spawned(7, 2, 3), spawned(8, 0, 3)]);
    assert!(world.position(FREE).is_none(), "the slot has another tenant");
}

/// With a particle its constraints go, each with an event; those spawned in the same tick too.
#[test]
fn removing_a_particle_removes_its_constraints() {
    let mut world = stage();
    let object = ObjectId::Particle(FREE);
    let new = |a, b| Action::SpawnDistance { token: 1, distance: Distance::new(a, b, Real::ONE) };
    let events = act(&mut world, &[new(FREE, PIN), new(OTHER, PIN), Action::Remove { object }]);
    let rod = |index| ObjectId::Distance(DistanceId(Handle::new(index, 1)));
    let spawned = |index| EventKind::Spawned { token: 1, object: rod(index) };
    let removed = |object| EventKind::Removed { object };
    let expected = [spawned(1), spawned(2), removed(object), removed(rod(0)), removed(rod(1))];
    assert_eq!(events, expected);
    assert_eq!(
        world.distances().map(|(id, _)| ObjectId::Distance(id)).collect::<Vec<_>>(),
        [rod(2)]
    );
    run(&mut world, 10);
}

/// Commands are carried out by player, then by sequence.
#[test]
fn the_last_player_wins() {
    let set = |player, sequence, user| {
        let action = Action::SetUser { object: ObjectId::Particle(FREE), user };
        Command { player, sequence, action }
    };
    let mut world = stage();
    world.step(&[set(2, 0, 20), set(1, 9, 19), set(1, 3, 13)]);
    let user = |world: &World| world.particles().particle(FREE).map(|row| row.user);
    assert_eq!(user(&world), Some(20));
    world.step(&[set(1, 9, 19), set(1, 3, 13)]);
    assert_eq!(user(&world), Some(19));
}

/// Removing and pinning in the tick of a force or of a pin's motion: nobody else is moved.
#[test]
fn what_is_gone_or_pinned_is_not_pushed() {
    let (mut world, mut plain) = (stage(), stage());
    let remove = Action::Remove { object: ObjectId::Particle(FREE) };
    let spawn = Action::SpawnParticle { token: 0, spec: ParticleSpec::default() };
    let force = Action::Force { particle: FREE, force: Vec3::from_ints(1000, 0, 0) };
    act(&mut world, &[force, remove, spawn]);
    act(&mut plain, &[remove, spawn]);
    assert_eq!(world.hash(), plain.hash(), "the force found the slot's next tenant");
    let (mut world, mut plain) = (stage(), stage());
    let (unpin, target) = (Action::SetPinned { particle: PIN, pinned: false }, Vec3::X);
    act(&mut world, &[Action::MovePin { particle: PIN, target }, unpin]);
    act(&mut plain, &[unpin]);
    assert_eq!(world.hash(), plain.hash(), "a pin that was let go was moved on");
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 32,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// A clone, a `clone_from` over another world, and the original stay equal; events are sorted
    /// and carry their tick.
    #[test]
    fn clones_do_the_same(seed in any::<u64>(), other in any::<u64>()) {
        let size = Size { particles: 8, links: 10, walls: 2, ticks: 30 };
        let blueprint = everyday(seed, size);
        let mut world = blueprint.build();
        let mut copy = everyday(other, size).build();
        run(&mut copy, 3);
        for tick in 0..30 {
            copy.clone_from(&world);
            let mut clone = world.clone();
            let mut commands = blueprint.commands(tick);
            world.step(&commands);
            commands.reverse();
            prop_assert_eq!(clone.step(&commands), world.events());
            let half = commands.len() / 2;
            commands.rotate_left(half);
            prop_assert_eq!(copy.step(&commands), world.events());
            prop_assert_eq!([clone.hash(), copy.hash()], [world.hash(); 2], "tick {}", tick);
            prop_assert!(world.events().is_sorted());
            prop_assert!(world.events().iter().all(|event| event.tick == tick));
        }
    }
}

/// A full world refuses, and says so.
#[test]
fn the_number_of_half_spaces_is_limited() {
    let mut world = stage();
    let spawn = Action::SpawnHalfSpace { token: 3, half_space: HalfSpace::default() };
    let events = act(&mut world, &[spawn; 64]);
    let refused = EventKind::Refused { player: 0, sequence: 63, why: Refusal::Full };
    assert_eq!((events.len(), events.last()), (64, Some(&refused)));
    assert_eq!(world.half_spaces().count(), 64);
}
