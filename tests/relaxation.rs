//! Constraints against the textbook: pendulums, momentum, bounces, friction.

use verlock::body::Face;
use verlock::constraint::{Distance, DistanceForm, HalfSpace, Volume};
use verlock::math::{Pcg, Real, Unit, Vec3};
use verlock::particle::ParticleSpec;
use verlock::{World, WorldConfig, real};

use crate::support::blueprint::{Blueprint, first, run};
use crate::support::float::{direction, dot, factor, length, sub, unit, vec3};
use crate::support::momentum::momentum;
use crate::support::random::FORMS;
use crate::support::twin::Twin;

fn position(world: &World, index: u32) -> [f64; 3] {
    world.position(first(index)).expect("the particle lives").to_f64()
}

/// 1 m, released at 90 degrees.
fn pendulum() -> Blueprint {
    let ends = [ParticleSpec::default().pinned(), ParticleSpec::at(Vec3::X)];
    let mut blueprint = Blueprint::new(WorldConfig::default(), &ends);
    blueprint.distances = vec![Distance::new(first(0), first(1), Real::ONE)];
    blueprint
}

/// The peaks in metres above the start, over windows that hold a peak each.
fn peaks(ticks: u32) -> Vec<f64> {
    // A swing of 90 degrees takes 2.37 s and has two peaks.
    let window = 150;
    let mut world = pendulum().build();
    let mut peak = || {
        let heights = (0..window).map(|_| {
            world.step(&[]);
            position(&world, 1)[1]
        });
        heights.fold(f64::MIN, f64::max)
    };
    (0..ticks / window).map(|_| peak()).collect()
}

#[test]
fn a_pendulum_keeps_its_height() {
    for peak in peaks(10_000) {
        assert!(peak.abs() < 1e-3, "{peak} m");
    }
}

/// What rounding leaves over is carried on; otherwise the energy would wander by 0.2 %.
#[test]
fn a_pendulum_keeps_its_height_for_hours() {
    let ticks = if cfg!(debug_assertions) { 100_000 } else { 1_000_000 };
    for peak in peaks(ticks) {
        assert!((-6e-4..1e-4).contains(&peak), "{peak} m");
    }
}

/// Particles in a ball of 2 m that drift apart slowly, linked at random in every form, and volumes.
fn net(seed: u64, masses: &[Real]) -> Blueprint {
    let mut random = Pcg::new(seed, 3);
    let mut within = |reach: Real| {
        let mut one = || random.real(-reach, reach);
        Vec3::new(one(), one(), one())
    };
    let specs: Vec<_> = masses
        .iter()
        .map(|&mass| ParticleSpec::at(within(real!("2"))).velocity(within(Real::ONE)).mass(mass))
        .collect();
    let config = WorldConfig { gravity: Vec3::ZERO, iterations: 2, ..WorldConfig::default() };
    let mut blueprint = Blueprint::new(config, &specs);
    let count = specs.len() as u32;
    for link in 0..2 * count {
        let a = link % count;
        let b = (a + 1 + random.below(count - 1)) % count;
        let rest = random.real(Real::ONE, real!("2"));
        let distance = Distance::new(first(a), first(b), rest).form(FORMS[(link % 4) as usize]);
        let slack = [Real::ZERO, Real::ZERO, real!("0.5"), rest][random.below(4) as usize];
        let compliance = [Unit::ZERO, Unit::from_raw(1 << 20)][random.below(2) as usize];
        blueprint.distances.push(distance.slack(slack).compliance(compliance));
    }
    for corner in 0..count {
        let corners = [0, 1, 2, 3].map(|k| first((corner + k) % count));
        let litres = Volume::of(corners.map(|id| specs[id.0.slot()].position));
        let more = random.real(real!("-99"), real!("99"));
        blueprint.volumes.push(Volume::new(corners, litres + more).stiffness(unit(0.3)));
    }
    blueprint
}

#[test]
fn equal_masses_keep_their_momentum_to_the_bit() {
    let mut world = net(1, &[real!("0.7"); 8]).build();
    let before = momentum(&world);
    for _ in 0..10_000 {
        world.step(&[]);
        assert_eq!(momentum(&world), before, "tick {}", world.tick());
    }
}

/// What a tick may change of the momentum, in raw mass times raw length, for arms and corrections
/// within 2^29 (32 m).
///
/// Each end moves by `R(arm g)`, with `g = R(gain e)` and `gain = R(w / W)`, the roundings being
/// half a unit of 2^-24, of 2^-30 and of 2^-30, and `|e arm|` at most the arm itself. An end is
/// therefore wrong by at most 1/2 + 2^29 2^-31 + 2^29 2^-31 = 1 unit. A volume's corner is wrong
/// by half a unit and by that of its weight, 2^29 2^-31, and what its gradients lost is nothing.
fn slack(blueprint: &Blueprint) -> i128 {
    let mass = |end: usize| i128::from(blueprint.particles[end].particle.mass.raw());
    let links = blueprint.distances.iter();
    let links = links.map(|row| mass(row.a.0.slot()) + mass(row.b.0.slot())).sum::<i128>();
    let corners = blueprint.volumes.iter().flat_map(|row| row.corners);
    let projection = links + corners.map(|id| mass(id.0.slot())).sum::<i128>();
    let WorldConfig { substeps, iterations, .. } = blueprint.config;
    projection * i128::from(substeps * iterations)
}

#[test]
fn unequal_masses_keep_their_momentum_within_the_proved_bound() {
    let masses = [real!("0.001"), real!("1000000"), real!("0.7"), real!("3"), real!("50")];
    for seed in 0..8 {
        let blueprint = net(seed, &masses);
        let (mut world, slack) = (blueprint.build(), slack(&blueprint));
        for _ in 0..200 {
            let before = momentum(&world);
            world.step(&[]);
            let reach = world.particles().positions_raw().iter().flatten().map(|x| x.abs()).max();
            assert!(reach < Some(1 << 28), "arms are longer than the bound allows");
            for (after, before) in momentum(&world).into_iter().zip(before) {
                let change = (after - before).abs();
                assert!(change <= slack, "seed {seed}, tick {}: {change}", world.tick());
            }
        }
    }
}

/// A ball dropped from 1 m comes back to e^2 m, then to e^4 m.
#[test]
fn bounces_reach_the_height_of_their_restitution() {
    for e in [0.3, 0.5, 0.8, 1.0] {
        let mut blueprint = Blueprint::new(WorldConfig::default(), &[ParticleSpec::at(Vec3::Y)]);
        let floor = HalfSpace { restitution: unit(e), ..HalfSpace::default() };
        blueprint.half_spaces = vec![floor];
        let mut world = blueprint.build();
        let mut heights = vec![];
        let (mut rising, mut last) = (false, 1.0);
        while heights.len() < 2 {
            world.step(&[]);
            let height = position(&world, 0)[1];
            if rising && height < last {
                heights.push(last);
            }
            (rising, last) = (height > last, height);
        }
        // An impact is timed to a substep: 18 mm of way at first, less and less of the height.
        let expected = [(e.powi(2), 0.03), (e.powi(4), 0.12)];
        for (found, (expected, tolerance)) in heights.iter().zip(expected) {
            let error = found / expected - 1.0;
            assert!(error.abs() < tolerance, "e = {e}: {found} m, not {expected} m");
        }
    }
}

/// How far a particle slides down a slope of sin 0.6 in 1 s.
fn slide(friction: f64) -> f64 {
    let floor = HalfSpace {
        normal: direction([0.6, 0.8, 0.0]),
        friction: factor(friction),
        ..HalfSpace::default()
    };
    let mut blueprint = Blueprint::new(WorldConfig::default(), &[ParticleSpec::default()]);
    blueprint.half_spaces = vec![floor];
    let mut world = blueprint.build();
    run(&mut world, 60);
    dot(position(&world, 0), [0.8, -0.6, 0.0])
}

/// tan = 0.75: it sticks with more friction, and slides with g (sin - mu cos) with less.
#[test]
fn friction_holds_or_brakes_on_a_slope() {
    for friction in [0.76, 0.8, 2.0, 16.0] {
        let slid = slide(friction);
        assert!(slid.abs() < 1e-3, "friction {friction}: slid {slid} m");
    }
    for friction in [0.0, 0.2, 0.5, 0.7] {
        let expected = 0.5 * 9.81 * (0.6 - friction * 0.8);
        let error = slide(friction) / expected - 1.0;
        assert!(error.abs() < 0.02, "friction {friction}: {error} off {expected} m");
    }
}

/// A particle that is found deep behind a surface is put on it and stays there.
#[test]
fn a_deep_overlap_does_not_pop() {
    for depth in [0.01, 1.0, 60.0] {
        let deep = ParticleSpec::at(vec3([0.0, -depth, 0.0]));
        let mut blueprint = Blueprint::new(WorldConfig::default(), &[deep]);
        blueprint.half_spaces = vec![HalfSpace { restitution: unit(1.0), ..HalfSpace::default() }];
        let mut world = blueprint.build();
        for _ in 0..60 {
            world.step(&[]);
            let height = position(&world, 0)[1];
            assert!(height.abs() < 1e-3, "found {depth} m deep, jumps to {height} m");
        }
    }
}

/// Rope, pendulum and bouncing particles stay as close to their naive twin as is stated here.
#[test]
fn the_step_follows_its_naive_twin() {
    let leaning = HalfSpace { normal: direction([1.0, 0.2, -0.3]), ..ground(0.0, 0.3) };
    let cases = [
        ("pendulum", pendulum(), 1000, 1e-3),
        ("rope", rope(DistanceForm::StartOfStep), 100, 1e-4),
        ("damped rope", rope(DistanceForm::Exact), 300, 1e-4),
        ("root-free rope", rope(DistanceForm::RootFree), 100, 1e-4),
        ("soft rope", soft_rope(), 300, 1e-4),
        ("jelly", jelly(), 100, 1e-4),
        ("kite", kite(), 300, 1e-3),
        ("bouncing", falling(&[ground(0.7, 0.0)]), 300, 1e-3),
        ("sliding", falling(&[ground(0.0, 0.3), leaning]), 300, 1e-3),
    ];
    for (name, blueprint, ticks, tolerance) in cases {
        let (mut world, mut twin) = (blueprint.build(), Twin::new(&blueprint));
        let mut worst = 0.0_f64;
        for _ in 0..ticks {
            world.step(&[]);
            twin.step();
            for (index, twin) in (0..blueprint.particles.len()).map(|k| (k, twin.position(k))) {
                worst = worst.max(length(sub(position(&world, index as u32), twin)));
            }
        }
        assert!(worst < tolerance, "{name}: {worst} m apart");
    }
}

/// 20 particles of growing mass, 0.1 m apart, held at one end.
fn rope(form: DistanceForm) -> Blueprint {
    let bead = |k: i32| {
        let place = vec3([0.1 * f64::from(k), 0.0, 0.02 * f64::from(k % 3)]);
        ParticleSpec::at(place).mass(Real::ONE + Real::from_ratio(k.into(), 10).unwrap_or_default())
    };
    let mut specs: Vec<_> = (0..20).map(bead).collect();
    specs[0] = specs[0].pinned();
    let config = WorldConfig { iterations: 4, damping: real!("0.5"), ..WorldConfig::default() };
    let mut blueprint = Blueprint::new(config, &specs);
    let tenth = real!("0.1");
    blueprint.distances = (1..20)
        .map(|k| Distance::new(first(k - 1), first(k), tenth).form(form).stiffness(unit(0.9)))
        .collect();
    blueprint
}

/// The rope between elastic and loose.
fn soft_rope() -> Blueprint {
    let mut blueprint = rope(DistanceForm::Exact);
    for (k, link) in blueprint.distances.iter_mut().enumerate() {
        link.compliance = unit([0.0, 1e-4][k % 2]);
        link.slack = real!("0.03");
        link.stiffness = unit(1.0);
    }
    blueprint
}

/// A tetrahedron that is too small and lopsided, with elastic edges, one corner held.
fn jelly() -> Blueprint {
    let places = [[0.0; 3], [1.0, 0.0, 0.0], [0.2, 0.9, 0.1], [0.0, 0.2, 1.1]];
    let mut specs: Vec<_> = places.map(|place| ParticleSpec::at(vec3(place))).to_vec();
    specs[0] = specs[0].pinned();
    specs[2] = specs[2].mass(real!("2.5"));
    let mut blueprint = Blueprint::new(WorldConfig::default(), &specs);
    for (a, b) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
        let edge = Distance::new(first(a), first(b), Real::ONE).compliance(unit(1e-4));
        blueprint.distances.push(edge);
    }
    let volume = Volume::new([0, 1, 2, 3].map(first), real!("250")).stiffness(unit(0.8));
    blueprint.volumes = vec![volume];
    blueprint
}

/// Two faces that share an edge, held at one corner in a wind.
fn kite() -> Blueprint {
    let places = [[0.0, 2.0, 0.0], [0.6, 1.0, 0.0], [-0.6, 1.0, 0.1], [0.0, 0.1, 0.0]];
    let mut specs: Vec<_> = places.map(|place| ParticleSpec::at(vec3(place))).to_vec();
    specs[0] = specs[0].pinned();
    let wind = Vec3::new(Real::ONE, real!("-0.5"), real!("6"));
    let config = WorldConfig { wind, damping: Real::ONE, ..WorldConfig::default() };
    let mut blueprint = Blueprint::new(config, &specs);
    for (a, b) in [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3)] {
        let length = specs[a as usize].position.distance(specs[b as usize].position);
        blueprint.distances.push(Distance::new(first(a), first(b), length));
    }
    let faces = [[0, 1, 2], [1, 3, 2]].map(|corners| Face::new(corners.map(first)));
    blueprint.faces = faces.map(|face| face.drag(factor(1.5))).to_vec();
    blueprint
}

/// A floor with restitution or with friction.
///
/// Not with both: where in its last substep a particle met the floor would become a speed, so that
/// every bounce would multiply an error by some 40, and no two implementations stay together.
fn ground(restitution: f64, friction: f64) -> HalfSpace {
    let (restitution, friction) = (unit(restitution), factor(friction));
    HalfSpace { restitution, friction, ..HalfSpace::default() }
}

/// 50 particles above the ground.
fn falling(half_spaces: &[HalfSpace]) -> Blueprint {
    let mut random = Pcg::new(5, 5);
    let mut within = |lo: Real, hi: Real| {
        let mut one = || random.real(lo, hi);
        Vec3::new(one(), one(), one())
    };
    let specs: Vec<_> = (0..50)
        .map(|_| {
            ParticleSpec::at(within(real!("0.5"), real!("3")))
                .velocity(within(real!("-3"), real!("3")))
        })
        .collect();
    let mut blueprint = Blueprint::new(WorldConfig::default(), &specs);
    blueprint.half_spaces = half_spaces.to_vec();
    blueprint
}
