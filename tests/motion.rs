//! Particles on their own: Verlet integration against the textbook, and the limits of a world.

use verlock::math::{Factor, Real, Vec3};
use verlock::particle::{DISPLACEMENT_LIMIT, Particle, ParticleId, ParticleSpec, WORLD_LIMIT};
use verlock::world::{Action, EventKind};
use verlock::{World, WorldConfig, real};

use crate::support::blueprint::{Blueprint, act, first, run};
use crate::support::float::{ULP, factor, length, real, vec3};

const WEIGHTLESS: WorldConfig = WorldConfig {
    tick_rate: 60,
    substeps: 4,
    iterations: 1,
    gravity: Vec3::ZERO,
    damping: Real::ZERO,
    displacement_max: WorldConfig::DISPLACEMENT_MAX,
    wind: Vec3::ZERO,
};

/// A world of one particle.
fn alone(config: WorldConfig, spec: ParticleSpec) -> (World, ParticleId) {
    (Blueprint::new(config, &[spec]).build(), first(0))
}

fn position(world: &World, id: ParticleId) -> [f64; 3] {
    world.position(id).expect("the particle lives").to_f64()
}

fn velocity(world: &World, id: ParticleId) -> [f64; 3] {
    world.velocity(id).expect("the particle lives").to_f64()
}

/// `n / d` to nearest, ties away from zero.
fn nearest(n: i128, d: i128) -> i128 {
    n.signum() * ((2 * n.abs() + d) / (2 * d))
}

/// g t^2 / 2 in 2 s within 0.1 mm, whatever the substeps.
#[test]
fn a_fall_is_as_deep_as_in_the_textbook() {
    for substeps in [1, 4, 8] {
        let config = WorldConfig { substeps, ..WorldConfig::default() };
        let (mut world, id) = alone(config, ParticleSpec::default());
        run(&mut world, 120);
        let error = position(&world, id)[1] + 0.5 * 9.81 * 4.0;
        assert!(error.abs() < 1e-4, "{substeps} substeps: {error} m");
        let error = velocity(&world, id)[1] + 9.81 * 2.0;
        assert!(error.abs() < 1e-4, "{substeps} substeps: {error} m/s");
    }
}

/// Substep n of a fall moves by `d0 + R(a n / D)`, to the bit, for any scale and acceleration.
#[test]
fn every_acceleration_adds_up_exactly() {
    let scales = [0.0, 0.5, 1.0, 2.0, -1.0, 0.3];
    let own = [[0.0; 3], [0.0, 9.81, -0.001], [1.0 / 3.0, -7.0, 100_000.0]];
    let pull = vec3([0.1, -9.81, 2.5]);
    let config = WorldConfig { gravity: pull, ..WorldConfig::default() };
    for (scale, own) in scales.into_iter().flat_map(|scale| own.map(|own| (scale, own))) {
        let (scale, own) = (factor(scale), vec3(own));
        let particle = Particle { gravity_scale: scale, acceleration: own, ..Particle::default() };
        let (mut world, id) = alone(config, ParticleSpec { particle, ..ParticleSpec::default() });
        run(&mut world, 5);
        let expected = [0, 1, 2].map(|k| {
            // In 2^-40 m/s^2, over the square of 240 substeps a second.
            let a = i128::from(pull.raw()[k]) * i128::from(scale.raw())
                + (i128::from(own.raw()[k]) << 16);
            let d = (240 * 240) << 16;
            let start = nearest(-a, 2 * d);
            (1..=20).map(|n| start + nearest(a * n, d)).sum::<i128>()
        });
        let found = world.position(id).map(|x| x.raw().map(i128::from));
        assert_eq!(found, Some(expected), "scale {scale:?}, own {own:?}");
    }
}

/// A particle starts with the velocity it was given, up to the rounding of a displacement, and
/// keeps to the parabola.
#[test]
fn a_start_has_the_velocity_that_was_asked_for() {
    for v in [[0.0; 3], [3.0, 4.0, -5.0], [1e-4, 0.0, -1e-3], [-2000.0, 7000.0, 0.1]] {
        let config = WorldConfig::default();
        let (mut world, id) = alone(config, ParticleSpec::default().velocity(vec3(v)));
        let rounding = 240.0 * ULP;
        for k in 0..3 {
            assert!((velocity(&world, id)[k] - v[k]).abs() <= rounding, "{v:?} at spawn");
        }
        run(&mut world, 60);
        let gravity = [0.0, -9.81, 0.0];
        for k in 0..3 {
            let error = position(&world, id)[k] - (v[k] + 0.5 * gravity[k]);
            assert!(error.abs() <= 240.0 * ULP, "{v:?} after 1 s: {error} m");
            let error = velocity(&world, id)[k] - (v[k] + gravity[k]);
            assert!(error.abs() <= 2.0 * rounding, "{v:?} after 1 s: {error} m/s");
        }
    }
}

/// exp(-k t) within 1 %, and what is left of a speed too small for rounding still dies out.
#[test]
fn damping_is_exponential_down_to_microscopic_speeds() {
    let config = WorldConfig { damping: real!("1"), ..WEIGHTLESS };
    for speed in [1000.0, 1.0, 0.1, 0.01] {
        let (mut world, id) = alone(config, ParticleSpec::default().velocity(vec3([speed; 3])));
        for second in 1..=3 {
            run(&mut world, 60);
            let expected = speed * f64::exp(-f64::from(second));
            // A displacement is a whole number of units, and a loss is the right one on average.
            let tolerance = 0.01 * expected + 240.0 * ULP;
            let error = velocity(&world, id)[0] - expected;
            assert!(error.abs() < tolerance, "{speed} m/s after {second} s: {error} m/s");
        }
        // The way to the end is v / k; 240 units a second are 14 micrometres a second.
        run(&mut world, 60 * 27);
        assert_eq!(world.particles().displacement(id), Some(Vec3::ZERO), "{speed} m/s lives on");
        let error = position(&world, id)[0] / speed - 1.0;
        assert!(error.abs() < 0.01, "{speed} m/s went {error} too far");
    }
}

/// A displacement beyond the maximum is cut with an event and keeps its direction.
#[test]
fn a_displacement_is_cut_with_an_event() {
    let config = WorldConfig { displacement_max: Real::ONE, ..WEIGHTLESS };
    let pushes = [
        |particle| Action::Impulse { particle, impulse: vec3([3000.0, -1500.0, 750.0]) },
        |particle| Action::Impulse { particle, impulse: vec3([4e9, -2e9, 1e9]) },
        |particle| Action::Force { particle, force: vec3([100_000.0, -50_000.0, 25_000.0]) },
        |particle| {
            let acceleration = vec3([100_000.0, -50_000.0, 25_000.0]);
            Action::SetAcceleration { particle, acceleration }
        },
    ];
    for push in pushes {
        let (mut world, particle) = alone(config, ParticleSpec::default());
        let events = act(&mut world, &[push(particle)]);
        assert_eq!(events, [EventKind::DisplacementClamped { particle }], "{:?}", push(particle));
        let moved = world.particles().displacement(particle).expect("it lives").raw();
        assert_eq!(moved, [1 << 24, -1 << 23, 1 << 22], "{:?}", push(particle));
    }
}

/// What would leave the world stops at its limit, with an event, and can come back.
#[test]
fn the_world_ends_at_its_limit() {
    let edge = Vec3::from_raw([WORLD_LIMIT - (1 << 24), -WORLD_LIMIT + (1 << 24), 0]);
    let spec = ParticleSpec::at(edge).velocity(vec3([6.0, -12.0, 0.0]));
    let (mut world, particle) = alone(WEIGHTLESS, spec);
    let mut stops = vec![];
    for _ in 0..20 {
        let events = act(&mut world, &[]);
        if events.contains(&EventKind::WorldLimit { particle }) {
            stops.push(world.tick());
        }
        let inside = world.particles().positions_raw()[0].iter().all(|c| c.abs() <= WORLD_LIMIT);
        assert!(inside);
    }
    assert_eq!(stops, [5], "1 m at 12 m/s takes 5 ticks; then it is at rest");
    let [x, y, _] = world.particles().positions_raw()[0];
    assert!(x < WORLD_LIMIT && y == -WORLD_LIMIT);
    act(&mut world, &[Action::SetVelocity { particle, velocity: vec3([0.0, 6.0, 0.0]) }]);
    let [_, y, _] = world.particles().positions_raw()[0];
    assert_eq!(y - -WORLD_LIMIT, 4 * nearest(1 << 24, 40) as i64);
}

/// One tick of a force and one impulse change the velocity by F h / m and J / m.
#[test]
fn forces_and_impulses_obey_newton() {
    for mass in [0.001, 0.3, 1.0, 1e6] {
        let spec = ParticleSpec::default().mass(real(mass));
        let (mut world, particle) = alone(WEIGHTLESS, spec);
        let push = [0.6 * mass, -1.2 * mass, 0.3 * mass];
        let tolerance = 1e-4 + 240.0 * ULP;
        act(&mut world, &[Action::Impulse { particle, impulse: vec3(push) }]);
        for (v, expected) in velocity(&world, particle).into_iter().zip([0.6, -1.2, 0.3]) {
            assert!((v - expected).abs() < tolerance, "impulse on {mass} kg: {v} m/s");
        }
        let force = vec3(push.map(|p| 30.0 * p));
        act(&mut world, &[Action::Force { particle, force }, Action::Force { particle, force }]);
        run(&mut world, 1);
        for (v, expected) in velocity(&world, particle).into_iter().zip([1.2, -2.4, 0.6]) {
            assert!((v - expected).abs() < tolerance, "force on {mass} kg: {v} m/s");
        }
    }
}

/// A moved pin arrives to the bit, at even speed, and keeps that velocity when it is let go.
#[test]
fn a_pin_arrives_and_its_velocity_is_inherited() {
    let (mut world, particle) = alone(WorldConfig::default(), ParticleSpec::default().pinned());
    run(&mut world, 3);
    assert_eq!(world.velocity(particle), Some(Vec3::ZERO), "a pin at rest");
    let target = Vec3::from_raw([1_677_721, -1, 333_333]);
    act(&mut world, &[Action::MovePin { particle, target }]);
    assert_eq!(world.position(particle), Some(target));
    let before = velocity(&world, particle);
    assert!((before[0] - 6.0).abs() < 1e-4 && before[1].abs() < 1e-4, "{before:?}");
    act(&mut world, &[Action::SetPinned { particle, pinned: false }]);
    run(&mut world, 59);
    let expected = [0.1 + 6.0, -0.5 * 9.81, (333_333.0 * ULP) * 61.0];
    for (x, expected) in position(&world, particle).into_iter().zip(expected) {
        assert!((x - expected).abs() < 1e-4, "1 s after it was let go: {x} m, not {expected}");
    }
}

/// A pin that is sent too far goes as far as it may, straight, and says so.
#[test]
fn a_pin_is_not_faster_than_the_maximum() {
    let config = WorldConfig { displacement_max: Real::ONE, ..WEIGHTLESS };
    let (mut world, particle) = alone(config, ParticleSpec::default().pinned());
    let target = vec3([100.0, -50.0, 0.0]);
    let events = act(&mut world, &[Action::MovePin { particle, target }]);
    assert_eq!(events, [EventKind::DisplacementClamped { particle }]);
    assert_eq!(world.position(particle), Some(Vec3::from_ints(4, -2, 0)));
}

/// Another pace, mass, gravity or acceleration changes the forces from now on, not the velocity.
#[test]
fn velocity_survives_every_change_of_properties() {
    let start = ParticleSpec::default().velocity(vec3([1.5, -2.5, 0.75]));
    let config = WorldConfig::default();
    let particle = first(0);
    let changes = [
        Action::Configure { config: WorldConfig { substeps: 1, ..config } },
        Action::Configure { config: WorldConfig { tick_rate: 240, substeps: 8, ..config } },
        Action::Configure { config: WorldConfig { gravity: vec3([90.0, 0.0, 0.0]), ..config } },
        Action::SetMass { particle, mass: real!("1000") },
        Action::SetGravityScale { particle, scale: Factor::ZERO },
        Action::SetAcceleration { particle, acceleration: vec3([50.0, 0.0, 7.0]) },
        Action::Teleport { particle, position: vec3([5.0, 5.0, 5.0]) },
    ];
    let rate = |world: &World| f64::from(world.config().tick_rate * world.config().substeps);
    for change in changes {
        let (mut world, _) = alone(config, start);
        run(&mut world, 6);
        let before = velocity(&world, particle);
        assert_eq!(act(&mut world, &[change]), []);
        let row = world.particles().particle(particle).expect("it lives");
        let (gravity, scale) = (world.config().gravity.to_f64(), row.gravity_scale.to_f64());
        let (own, ticks) = (row.acceleration.to_f64(), f64::from(world.config().tick_rate));
        for k in 0..3 {
            let expected = before[k] + (gravity[k] * scale + own[k]) / ticks;
            let error = velocity(&world, particle)[k] - expected;
            // Half a unit each: the conversion's three roundings, and the sum of what a adds.
            assert!(error.abs() <= 2.5 * rate(&world) * ULP, "{change:?}: {k} off by {error} m/s");
        }
    }
}

/// A disabled particle stands where it is; enabled again it starts from rest.
#[test]
fn a_disabled_particle_stands_still() {
    use verlock::world::ObjectId;
    let (mut world, particle) =
        alone(WorldConfig::default(), ParticleSpec::default().velocity(vec3([9.0, 9.0, 9.0])));
    let object = ObjectId::Particle(particle);
    act(&mut world, &[Action::SetEnabled { object, enabled: false }]);
    let stands = world.position(particle);
    run(&mut world, 10);
    assert_eq!((world.position(particle), stands), (stands, Some(Vec3::ZERO)));
    assert_eq!(world.velocity(particle), Some(Vec3::ZERO));
    act(&mut world, &[Action::SetEnabled { object, enabled: true }]);
    run(&mut world, 59);
    let error = length(position(&world, particle)) - 0.5 * 9.81;
    assert!(error.abs() < 1e-4, "a fall of 1 s from rest is {error} m wrong");
}

/// The greatest legal velocity is accepted, the next is not.
#[test]
fn the_range_of_velocities_ends_at_the_maximal_displacement() {
    let fastest = DISPLACEMENT_LIMIT * 240;
    let (mut world, particle) = alone(WEIGHTLESS, ParticleSpec::default());
    for (raw, good) in [(fastest, true), (-fastest, true), (fastest + 240, false)] {
        let velocity = Vec3::from_raw([raw, 0, 0]);
        let events = act(&mut world, &[Action::SetVelocity { particle, velocity }]);
        assert_eq!(events.is_empty(), good, "{raw}: {events:?}");
    }
}
