//! Springs, ropes, what tears, volumes, and faces in the wind: against their formulas.

use verlock::body::{Face, FaceId};
use verlock::constraint::{Distance, DistanceForm, DistanceId, HalfSpace, Volume, VolumeId};
use verlock::math::{Factor, Real, Vec3};
use verlock::particle::ParticleSpec;
use verlock::store::Handle;
use verlock::world::{Action, EventKind, ObjectId};
use verlock::{World, WorldConfig, real};

use crate::support::blueprint::{Blueprint, act, first, run};
use crate::support::float::{ULP, cross, dot, factor, length, real, sub, unit, vec3};
use crate::support::random::FORMS;

const NOTHING: WorldConfig = WorldConfig {
    tick_rate: 60,
    substeps: 4,
    iterations: 1,
    gravity: Vec3::ZERO,
    damping: Real::ZERO,
    displacement_max: WorldConfig::DISPLACEMENT_MAX,
    wind: Vec3::ZERO,
};

fn distance(slot: u32) -> DistanceId {
    DistanceId(Handle::new(slot, 1))
}

fn face(slot: u32) -> FaceId {
    FaceId(Handle::new(slot, 1))
}

fn place(world: &World, slot: u32) -> [f64; 3] {
    world.position(first(slot)).expect("the particle lives").to_f64()
}

fn apart(world: &World) -> f64 {
    length(sub(place(world, 1), place(world, 0)))
}

/// Two particles this far apart that approach each other with this speed, and nothing else.
fn pair(metres: f64, speed: f64) -> Blueprint {
    let specs = [
        ParticleSpec::at(Vec3::ZERO).velocity(vec3([speed / 2.0, 0.0, 0.0])),
        ParticleSpec::at(vec3([metres, 0.0, 0.0])).velocity(vec3([speed / -2.0, 0.0, 0.0])),
    ];
    Blueprint::new(NOTHING, &specs)
}

/// A weight of 2 kg stretches 10 mm/N by 0.196 m, whatever the substeps and iterations, but for the
/// `g h^2` that it falls in a substep.
#[test]
fn compliance_is_metres_per_newton() {
    for (substeps, iterations) in [(1, 1), (1, 8), (2, 3), (4, 1), (4, 8)] {
        for form in FORMS {
            let ends =
                [ParticleSpec::default().pinned(), ParticleSpec::at(-Vec3::Y).mass(real!("2"))];
            let gravity = Vec3::new(Real::ZERO, real!("-9.81"), Real::ZERO);
            let damping = real!("5");
            let config = WorldConfig { substeps, iterations, gravity, damping, ..NOTHING };
            let mut blueprint = Blueprint::new(config, &ends);
            let spring = Distance::new(first(0), first(1), Real::ONE).compliance(unit(0.01));
            blueprint.distances = vec![spring.form(form)];
            let mut world = blueprint.build();
            run(&mut world, 600);
            let stretched = apart(&world) - 1.0;
            let fallen = 9.81 / f64::from(60 * substeps).powi(2);
            let error = stretched - 0.01 * 2.0 * 9.81;
            let at = format!("{substeps} x {iterations}, {form:?}");
            assert!((-1e-5..fallen + 1e-5).contains(&error), "{at}: {error} m off");
        }
    }
}

/// Within its range nothing acts, to the bit; from beyond, it comes back into the range.
#[test]
fn a_range_is_kept() {
    for form in FORMS {
        for (start, speed) in [(0.8, 0.1), (0.8, -0.1), (0.5, 0.0), (1.2, 0.0)] {
            let at = format!("{form:?} from {start} m at {speed} m/s");
            let mut blueprint = pair(start, speed);
            blueprint.config.damping = Real::ONE;
            let mut free = blueprint.build();
            let range = Distance::new(first(0), first(1), Real::ONE).slack(real!("0.4"));
            blueprint.distances = vec![range.form(form)];
            let mut world = blueprint.build();
            for tick in 0..600 {
                free.step(&[]);
                world.step(&[]);
                if speed != 0.0 && tick < 90 {
                    assert_eq!(world.position(first(1)), free.position(first(1)), "{at}");
                }
                if speed != 0.0 || tick > 60 {
                    let now = apart(&world);
                    assert!((0.6 - 1e-3..1.0 + 1e-3).contains(&now), "{at}: {now} m");
                }
            }
        }
    }
}

/// As long as a rope is loose it is not there, to the bit; then it holds.
#[test]
fn a_rope_pulls_and_never_pushes() {
    for form in FORMS {
        let mut blueprint = pair(0.5, 1.0);
        blueprint.particles[1].position += Vec3::Y * real!("0.1");
        let mut free = blueprint.build();
        blueprint.distances = vec![Distance::rope(first(0), first(1), Real::ONE).form(form)];
        let mut bound = blueprint.build();
        let (mut loose, mut tight) = (0, 0);
        for _ in 0..180 {
            free.step(&[]);
            bound.step(&[]);
            if apart(&free) <= 1.0 {
                assert_eq!(bound.position(first(1)), free.position(first(1)), "{form:?}");
                loose += 1;
            } else {
                assert!(apart(&bound) < 1.0 + 1e-3, "{form:?}: {} m", apart(&bound));
                tight += 1;
            }
        }
        assert!(loose > 60 && tight > 60, "{loose} ticks loose, {tight} tight");
    }
}

/// What has no root or division in it still ends at the very length.
#[test]
fn every_form_comes_to_its_length() {
    for form in FORMS {
        for rest in [0.01, 1.0, 20.0] {
            for start in [0.4, 0.95, 1.05, 3.0, 9.0] {
                let mut blueprint = pair(rest * start, 0.0);
                blueprint.config.damping = real!("30");
                blueprint.distances =
                    vec![Distance::new(first(0), first(1), real(rest)).form(form)];
                let mut world = blueprint.build();
                run(&mut world, 240);
                // The square of the ratio has 26 fractional bits in the division-free form.
                let error = (apart(&world) - real(rest).to_f64()).abs() / ULP;
                let most = 1.5 + rest / ULP / 2.0_f64.powi(26);
                assert!(error <= most, "{form:?}, {start} of {rest} m: {error} ulp");
            }
        }
    }
}

/// Damage is the strain above the bearable one, summed over the ticks; what stood enough breaks,
/// and opens the faces along it.
#[test]
fn what_is_torn_breaks() {
    let places = [[0.0; 3], [1.5, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let specs = places.map(|place| ParticleSpec::at(vec3(place)).pinned());
    let mut blueprint = Blueprint::new(NOTHING, &[&specs[..], &specs[..1]].concat());
    let link = |strain, toughness| Distance {
        toughness: factor(toughness),
        ..Distance::new(first(0), first(1), Real::ONE).tear_strain(factor(strain))
    };
    // A strain of 0.5: no limit, not above it, above it by a quarter in every tick.
    blueprint.distances = vec![link(0.0, 0.0), link(0.5, 0.0), link(0.25, 1.0), link(0.25, 0.0)];
    blueprint.faces = [[1, 2, 0], [0, 2, 3]].map(|ends| Face::new(ends.map(first))).to_vec();
    let mut world = blueprint.build();
    let broken = |slot| EventKind::Broken { distance: distance(slot) };
    for (tick, expected) in
        [vec![broken(3)], vec![], vec![], vec![], vec![broken(2)], vec![]].into_iter().enumerate()
    {
        assert_eq!(act(&mut world, &[]), expected, "tick {tick}");
        let row = |slot| world.distance(distance(slot)).expect("broken ones are still there");
        let state = |slot| (row(slot).damage.to_f64(), row(slot).enabled);
        let worn = 0.25 * f64::from(u32::try_from(tick.min(4)).expect("small") + 1);
        assert_eq!([state(0), state(1)], [(0.0, true); 2]);
        assert_eq!([state(2), state(3)], [(worn, tick < 4), (0.25, false)], "tick {tick}");
        let open = |slot| !world.face(face(slot)).expect("it is still there").enabled;
        assert!(open(0) && !open(1), "tick {tick}: the faces along the edge, no others");
    }
}

/// What a disabled end holds is not strained.
#[test]
fn what_is_disabled_does_not_tear() {
    for object in [ObjectId::Particle(first(1)), ObjectId::Distance(distance(0))] {
        let mut blueprint = pair(3.0, 0.0);
        let link = Distance::new(first(0), first(1), Real::ONE).tear_strain(factor(0.5));
        blueprint.distances = vec![Distance { toughness: factor(1e3), ..link }];
        let mut world = blueprint.build();
        act(&mut world, &[Action::SetEnabled { object, enabled: false }]);
        run(&mut world, 3);
        let damage = world.distance(distance(0)).map(|row| row.damage);
        assert_eq!(damage, Some(Factor::ZERO), "{object}");
    }
}

/// Six elastic edges of 1 m around a volume, or around none.
fn tetrahedron(with_volume: bool) -> Blueprint {
    let places = [[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.0, 0.866], [0.5, 0.816, 0.289]];
    let specs = places.map(|place| ParticleSpec::at(vec3(place) + Vec3::Y));
    let mut blueprint = Blueprint::new(WorldConfig { iterations: 2, ..NOTHING }, &specs);
    for (a, b) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
        let edge = Distance::new(first(a), first(b), Real::ONE).compliance(unit(1e-3));
        blueprint.distances.push(edge);
    }
    if with_volume {
        let corners = specs.map(|spec| spec.position);
        let order = [0, 2, 1, 3]; // so that the volume is positive
        let volume = Volume::of(order.map(|k| corners[k]));
        blueprint.volumes = vec![Volume::new(order.map(|k| first(k as u32)), volume)];
    }
    blueprint
}

/// Cubic metres, of the order in which it is positive.
fn volume(world: &World) -> f64 {
    let [a, b, c, d] = [0, 2, 1, 3].map(|slot| place(world, slot));
    dot(sub(b, a), cross(sub(c, a), sub(d, a))) / 6.0
}

/// Dropped, a soft tetrahedron keeps its volume within 2 %, and 0.1 % once it lies there.
#[test]
fn a_volume_is_kept() {
    let mut blueprint = tetrahedron(true);
    blueprint.config.gravity = Vec3::new(Real::ZERO, real!("-9.81"), Real::ZERO);
    blueprint.config.damping = Real::ONE;
    blueprint.half_spaces = vec![HalfSpace::default()];
    let mut world = blueprint.build();
    let rest = volume(&world);
    assert!((rest - 0.1178).abs() < 1e-3, "{rest} m^3");
    for tick in 0..600 {
        world.step(&[]);
        let error = (volume(&world) / rest - 1.0).abs();
        let most = if tick < 300 { 0.02 } else { 1e-3 };
        assert!(error < most, "tick {tick}: {error}");
    }
}

/// A blow that drives a corner through the others turns it inside out only without a volume.
#[test]
fn a_volume_does_not_turn_inside_out() {
    for with_volume in [false, true] {
        let mut world = tetrahedron(with_volume).build();
        let down = Vec3::new(Real::ZERO, real!("-60"), Real::ZERO);
        act(&mut world, &[Action::Impulse { particle: first(3), impulse: down }]);
        let mut least = volume(&world);
        for _ in 0..120 {
            world.step(&[]);
            least = least.min(volume(&world));
        }
        assert_eq!(least > 0.0, with_volume, "{least} m^3");
    }
}

/// Half a square metre in the plane x + z = 0, of three particles of 2 kg, in a wind.
fn sail(wind: [f64; 3]) -> Blueprint {
    let corner = 0.5_f64.sqrt();
    let places = [[0.0; 3], [corner, 0.0, -corner], [0.0, 1.0, 0.0]];
    let specs = places.map(|place| ParticleSpec::at(vec3(place)).mass(real!("2")));
    let config = WorldConfig { wind: vec3(wind), ..NOTHING };
    let mut blueprint = Blueprint::new(config, &specs);
    blueprint.faces = vec![Face::new([0, 1, 2].map(first)).drag(factor(1.5))];
    blueprint
}

/// `F = drag A (u . n) n`, a third on each corner, from either side.
#[test]
fn wind_pushes_along_the_normal() {
    for wind in [[4.0, 0.0, 0.0], [1.0, -7.0, 3.0], [-5.0, 2.0, -1.0], [3.0, 9.0, -3.0]] {
        let mut world = sail(wind).build();
        world.step(&[]);
        let normal = [0.5_f64.sqrt(), 0.0, 0.5_f64.sqrt()];
        let force = 1.5 * 0.5 * dot(wind, normal);
        for slot in 0..3 {
            // What four substeps add up to.
            let expected = normal.map(|n| n * force / 6.0 / 60.0);
            let moved = world.particles().displacement(first(slot)).expect("it lives").to_f64();
            let error = length(sub(moved, expected.map(|v| v / 240.0)));
            assert!(error < 4.0 * ULP, "{wind:?}: {moved:?} for {expected:?} m/s");
        }
    }
}

/// In the end a face moves with the wind through it, and keeps its way along itself, however short
/// the substeps.
#[test]
fn a_face_comes_to_move_with_the_wind() {
    for substeps in [1, 4, 64] {
        let mut blueprint = sail([1.0, -7.0, 3.0]);
        blueprint.config.substeps = substeps;
        for spec in &mut blueprint.particles {
            spec.velocity = vec3([0.5, 2.0, -0.5]);
        }
        let mut world = blueprint.build();
        run(&mut world, 60 * 100);
        for slot in 0..3 {
            let speed = world.velocity(first(slot)).expect("it lives").to_f64();
            let error = length(sub(speed, [2.5, 2.0, 1.5]));
            let units = error / (ULP * 60.0 * f64::from(substeps));
            assert!(units < 6.0, "{substeps} substeps: {speed:?}");
        }
    }
}

/// What is not a movable corner of an enabled face with drag feels no wind.
#[test]
fn wind_leaves_the_rest_alone() {
    let mut blueprint = sail([4.0, 0.0, 0.0]);
    blueprint.faces[0].enabled = false;
    blueprint.faces.push(Face::new([0, 1, 2].map(first)));
    let mut world = blueprint.build();
    run(&mut world, 10);
    assert_eq!(world.position(first(2)), Some(Vec3::Y));
    blueprint.faces[0].enabled = true;
    blueprint.particles[2] = blueprint.particles[2].pinned();
    let mut world = blueprint.build();
    run(&mut world, 10);
    assert_eq!(world.position(first(2)), Some(Vec3::Y));
    assert_ne!(world.position(first(0)), Some(Vec3::ZERO));
}

/// With a particle go the distances, volumes and faces on it, in this order, and no others.
#[test]
fn orphans_are_removed() {
    let mut blueprint = tetrahedron(true);
    blueprint.faces = [[0, 1, 2], [1, 2, 3]].map(|ends| Face::new(ends.map(first))).to_vec();
    let mut world = blueprint.build();
    let events = act(&mut world, &[Action::Remove { object: ObjectId::Particle(first(0)) }]);
    let gone = [
        ObjectId::Particle(first(0)),
        ObjectId::Distance(distance(0)),
        ObjectId::Distance(distance(1)),
        ObjectId::Distance(distance(2)),
        ObjectId::Volume(VolumeId(Handle::new(0, 1))),
        ObjectId::Face(face(0)),
    ];
    assert_eq!(events, gone.map(|object| EventKind::Removed { object }));
    let left = [world.distances().count(), world.volumes().count(), world.faces().count()];
    assert_eq!(left, [3, 0, 1]);
}

/// A winch: a rope of another length is still a rope, and other slack is cut to the length.
#[test]
fn a_rope_stays_a_rope() {
    let rope = Distance::rope(first(0), first(1), Real::ONE);
    for (slack, length, expected) in [("1", "3", "3"), ("0.5", "3", "0.5"), ("0.5", "0.2", "0.2")] {
        let mut blueprint = pair(1.0, 0.0);
        blueprint.distances = vec![rope.slack(slack.parse().expect("a decimal"))];
        let mut world = blueprint.build();
        let rest_length = length.parse().expect("a decimal");
        act(&mut world, &[Action::SetRestLength { distance: distance(0), rest_length }]);
        let slack = world.distance(distance(0)).map(|row| row.slack.to_string());
        assert_eq!(slack.as_deref(), Some(expected));
    }
}

/// A net of division-free rods held at two corners, and a particle on a slack rope of 60 m.
fn kite(columns: u32, rows: u32, tail: f64) -> Blueprint {
    let at = |k: u32| {
        let (x, z) = (f64::from(k % columns) * 0.1, f64::from(k / columns) * 0.1);
        ParticleSpec::at(vec3([x, 0.0, z]))
    };
    let count = columns * rows;
    let mut specs: Vec<_> = (0..count).map(at).collect();
    for corner in [0, columns as usize - 1] {
        specs[corner] = specs[corner].pinned();
    }
    specs.push(ParticleSpec::at(vec3([tail, 5.0, 0.0])));
    specs[count as usize].particle.gravity_scale = Factor::ZERO;
    let mut blueprint =
        Blueprint::new(WorldConfig { iterations: 3, ..WorldConfig::default() }, &specs);
    let mut tie = |a, b, length| {
        let rod = Distance::new(first(a), first(b), length).form(DistanceForm::DivisionFree);
        blueprint.distances.push(rod);
    };
    for k in 0..count {
        let (right, down) = (k % columns + 1 < columns, k / columns + 1 < rows);
        if right {
            tie(k, k + 1, real!("0.1"));
        }
        if down {
            tie(k, k + columns, real!("0.09"));
        }
        if right && down {
            tie(k, k + columns + 1, real!("0.14"));
        }
    }
    let rope = Distance::rope(first(count - 1), first(count), Real::from_int(60));
    blueprint.distances.push(rope.form(DistanceForm::DivisionFree));
    blueprint
}

/// Cloth that reaches too far for 32 bits moves like cloth that does not; so does one that has
/// grown, and one that came back.
#[test]
fn how_far_cloth_reaches_changes_nothing() {
    for (columns, rows, ticks) in [(12, 9, 60), (70, 66, 6)] {
        let tail = first(columns * rows);
        let [mut near, mut far] = [6.0, 55.0].map(|x| kite(columns, rows, x).build());
        let mut roving = near.clone();
        let mut restored = near.clone();
        for tick in 0..ticks {
            let to = |x| Action::Teleport { particle: tail, position: vec3([x, 5.0, 0.0]) };
            let there = [to(55.0), to(6.0)][usize::from(tick % 4 > 1)];
            restored.restore(&roving.save()).expect("what was saved can be restored");
            act(&mut restored, &[there]);
            act(&mut roving, &[there]);
            assert_eq!(restored.hash(), roving.hash(), "tick {tick}: restored");
            act(&mut near, &[]);
            act(&mut far, &[]);
            for slot in 0..columns * rows {
                let [near, far, roving] =
                    [&near, &far, &roving].map(|world| world.position(first(slot)));
                assert_eq!([far, roving], [near; 2], "particle {slot} at tick {tick}");
            }
        }
        assert!(place(&near, columns * rows - 1)[1] < -1e-3, "it falls");
    }
}
