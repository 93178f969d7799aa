//! Scene files: numbers to the bit, errors that say where, and what each fixture promises to show.

#![allow(clippy::panic, reason = "how a check fails that has something to say")]

mod errors;

use std::collections::BTreeSet;

use self::errors::refused;
use verlock::constraint::{DISTANCES_MAX, Distance};
use verlock::math::{Factor, Pcg, Real, UnitVec3, Vec3};
use verlock::particle::PARTICLES_MAX;
use verlock::real;
use verlock::scene::{Scene, SceneError};
use verlock::world::{Action, Event, EventKind, Refusal, World};

macro_rules! fixture {
    ($name:literal) => {
        include_str!(concat!("../../fixtures/scenes/", $name, ".scene.ron"))
    };
}

const BORDER: &str = fixture!("border");
const CLOUD: &str = fixture!("cloud");
const COMMANDS: &str = fixture!("commands");
const FAR: &str = fixture!("far");
const NEAR: &str = fixture!("near");
const NET: &str = fixture!("net");
const OVERFLOW: &str = fixture!("overflow");
const PENDULUM: &str = fixture!("pendulum");
const PROJECTILE: &str = fixture!("projectile");
const ROPE: &str = fixture!("rope");
const STORM: &str = fixture!("storm");

/// The same words, whatever the order of particles; small enough to be read with every mistake.
const SMALL: [&str; 6] = [BORDER, COMMANDS, NEAR, OVERFLOW, PENDULUM, STORM];

fn scene(text: &str) -> Scene {
    Scene::parse(text).unwrap_or_else(|error| panic!("{error}"))
}

fn built(fields: &str) -> World {
    scene(&format!("(version: 1, {fields})")).build().unwrap_or_else(|error| panic!("{error}"))
}

/// Runs a scene to its end.
fn run(text: &str, mut watch: impl FnMut(&World, &[Event])) {
    let scene = scene(text);
    let mut world = scene.build().unwrap_or_else(|error| panic!("{error}"));
    for _ in 0..scene.ticks() {
        let commands = scene.commands(&world);
        let events = world.step(&commands).to_vec();
        watch(&world, &events);
    }
}

/// The vector between the ends of a distance, raw.
fn span(world: &World, distance: &Distance) -> [i64; 3] {
    let at = |id| world.position(id).expect("both ends live");
    (at(distance.b) - at(distance.a)).raw()
}

#[test]
fn decimals_become_the_nearest_fixed_point_from_their_text() {
    // Through f64 the first would end in 4.
    let world = built(
        r#"particles: [(
            position: (1000000000.0000002, "-0.00000003", 1_0.5),
            gravity_scale: -0.1, // not this
            mass: /* nor */ 0.7 /* this */,
        )]"#,
    );
    let id = world.particles().ids().next().expect("one particle");
    let expected = [16_777_216_000_000_003, -1, 21 << 23];
    assert_eq!(world.position(id), Some(Vec3::from_raw(expected)));
    let particle = world.particles().particle(id).expect("it lives");
    assert_eq!(particle.gravity_scale, Factor::parse("-0.1").expect("a decimal"));
    assert_eq!(particle.mass, real!("0.7"));
}

#[test]
fn what_does_not_fit_a_world_is_counted_and_never_made() {
    let table = [
        ("clouds: [(count: 4194304), (count: 1)]", "particles"),
        ("clouds: [(count: 4294967295), (count: 4294967295)]", "particles"),
        ("nets: [(columns: 4294967295, rows: 4294967295, diagonals: true)]", "particles"),
        ("ropes: [(particles: 4194304)], particles: [()]", "particles"),
        ("nets: [(columns: 1023, rows: 1023, diagonals: true)]", "distances"),
    ];
    for (fields, expected) in table {
        match refused(&format!("(version: 1, {fields})")) {
            SceneError::TooMany { kind: kind @ "particles", most: PARTICLES_MAX }
            | SceneError::TooMany { kind: kind @ "distances", most: DISTANCES_MAX } => {
                assert_eq!(kind, expected);
            }
            error => panic!("{fields}: {error}"),
        }
    }
    let lists = [("half_spaces", "()", 65), ("ropes", "()", 65_537), ("clouds", "()", 65_537)];
    for (list, element, count) in lists {
        let text = format!("(version: 1, {list}: [{}])", [element].repeat(count).join(","));
        let error = refused(&text).to_string();
        assert!(error.contains("at most"), "{list}: {error}");
    }
    let long = " ".repeat(Scene::TEXT_MAX + 1);
    assert_eq!(refused(&long), SceneError::TooLong);
}

#[test]
fn deep_nesting_is_refused() {
    for open in ["(", "[", "{", "Some(", "(a:", "/*"] {
        for start in ["", "(version: 1, seed: ", "(version: 1, particles: [(mass: "] {
            let text = format!("{start}{}", open.repeat(100_000));
            assert!(matches!(refused(&text), SceneError::Syntax { .. }), "{start}{open}");
        }
    }
}

fn below(random: &mut Pcg, n: usize) -> usize {
    random.below(u32::try_from(n).expect("the length of a small text")) as usize
}

#[test]
fn no_text_makes_it_panic() {
    let mut random = Pcg::new(1, 1);
    let mut readable = 0;
    for round in 0..3000 {
        let mut text = SMALL[round % SMALL.len()].as_bytes().to_vec();
        let other = SMALL[below(&mut random, 6)].as_bytes();
        for _ in 0..=random.below(3) {
            let at = below(&mut random, text.len());
            match random.below(20) {
                0 => text[at] = other[below(&mut random, other.len())],
                1 => drop(text.remove(at)),
                2 => text.truncate(at + 1),
                3..19 => {
                    let digit = text[at..].iter().position(u8::is_ascii_digit).unwrap_or(0);
                    text[at + digit] = b"0123456789-."[below(&mut random, 12)];
                }
                _ => {
                    let from = below(&mut random, other.len() - 40);
                    let to = from + below(&mut random, 40);
                    text.splice(at..at, other[from..to].iter().copied());
                }
            }
        }
        let text = String::from_utf8_lossy(&text);
        let Ok(scene) = Scene::parse(&text) else { continue };
        let Ok(mut world) = scene.build() else { continue };
        readable += 1;
        for _ in 0..scene.ticks().min(12) {
            let commands = scene.commands(&world);
            world.step(&commands);
        }
    }
    assert!(readable > 1000, "only {readable} were scenes: nothing much was tried");
}

#[test]
fn objects_are_made_in_the_order_of_the_documentation() {
    let world = built(
        "half_spaces: [(normal: (0, 0, -7))],
        distances: [(a: 0, b: 9, user: 7)],
        clouds: [(count: 1, min: (4, 4, 4), max: (4, 4, 4))],
        nets: [(corner: (3, 0, 0), columns: 2, rows: 3, pinned: Top)],
        ropes: [(from: (1, 0, 0), to: (1, 0, 9), particles: 2, mass: (2, 4))],
        particles: [(), (position: (0.5, 0, 0))],
        origin: (100, 0, 0)",
    );
    let x: Vec<_> = world.particles().ids().filter_map(|id| world.position(id)).collect();
    let x: Vec<_> = x.iter().map(|position| position.x - Real::from_int(100)).collect();
    let expected = ["0", "0.5", "1", "1", "3", "4", "3", "4", "3", "4", "4"];
    assert_eq!(x, expected.map(|x| Real::parse(x).expect("a decimal")));
    let rows: Vec<_> = world.particles().ids().collect();
    let row = |k: usize| world.particles().particle(rows[k]).expect("it lives");
    assert_eq!([row(2).mass, row(3).mass], [Real::from_int(2), Real::from_int(4)]);
    assert!((0..11).all(|k| row(k).pinned == (k == 4 || k == 5)));

    let ends: Vec<_> = world.distances().map(|(_, d)| (d.a.0.index, d.b.0.index)).collect();
    let net = [(4, 5), (6, 7), (8, 9), (4, 6), (5, 7), (6, 8), (7, 9)];
    assert_eq!(ends[..2], [(0, 9), (2, 3)]);
    assert_eq!(ends[2..], net);
    let placed = |d: &Distance| Vec3::from_raw(span(&world, d)).length();
    assert!(world.distances().all(|(_, d)| d.rest_length == placed(d)));
    let normals: Vec<_> = world.half_spaces().map(|(_, shape)| shape.normal).collect();
    assert_eq!(normals, [-UnitVec3::Z]);
}

#[test]
fn corners_are_numbers() {
    let world = built(
        "particles: [(), (position: (1, 0, 0)), (position: (0, 1, 0)), (position: (0, 0, 0.006))],
        volumes: [(corners: (0, 1, 2, 3))],
        faces: [(corners: (3, 1, 2), drag: 0.5)]",
    );
    let (_, volume) = world.volumes().next().expect("a volume");
    assert_eq!(volume.corners.map(|id| id.0.index), [0, 1, 2, 3]);
    let litre = volume.rest_volume.raw().abs_diff(Real::ONE.raw());
    assert!(litre < 200, "{}", volume.rest_volume);
    let (_, face) = world.faces().next().expect("a face");
    assert_eq!(face.corners.map(|id| id.0.index), [3, 1, 2]);
    assert_eq!(face.drag, Factor::parse("0.5").expect("a decimal"));
}

#[test]
fn commands_are_a_function_of_scene_and_world() {
    let scene = scene(STORM);
    let mut world = scene.build().expect("a fixture");
    let mut seen = BTreeSet::new();
    for _ in 0..60 {
        let commands = scene.commands(&world);
        assert_eq!(commands, scene.commands(&world.clone()));
        for command in &commands {
            if let Action::SpawnParticle { spec, .. } = command.action {
                assert!(seen.insert(spec.position), "chance repeats itself");
            }
        }
        world.step(&commands);
    }
    assert_eq!(seen.len(), 50 * 8, "from tick 10 on, 8 a tick");
}

#[test]
fn far_is_near_moved() {
    let moved = NEAR.replace(
        "(0, 0, 0),\n    particles",
        "(1000000000, 1000000000, 1000000000),\n    particles",
    );
    assert_ne!(moved, NEAR);
    assert_eq!(moved, FAR, "only `origin` may differ");
    let origin = Real::from_int(1_000_000_000).raw();
    let mut near = Vec::new();
    run(NEAR, |world, events| {
        near.push((world.particles().displacements_raw().to_vec(), events.to_vec()));
    });
    let ids = |world: &World| world.particles().ids().collect::<Vec<_>>();
    let mut last = Vec::new();
    run(NEAR, |world, _| {
        last = ids(world).iter().filter_map(|&id| world.position(id)).collect();
    });
    let mut ticks = near.iter();
    let mut end = Vec::new();
    run(FAR, |world, events| {
        let (displacements, near_events) = ticks.next().expect("as many ticks");
        assert_eq!(world.particles().displacements_raw(), displacements);
        assert_eq!(events, near_events);
        end = ids(world).iter().filter_map(|&id| world.position(id)).collect();
    });
    let back: Vec<_> = end.iter().map(|p| Vec3::from_raw(p.raw().map(|c| c - origin))).collect();
    assert_eq!(back, last);
}

#[test]
fn commands_fixture_does_everything_and_is_refused_in_every_way() {
    let scene = scene(COMMANDS);
    let mut world = scene.build().expect("a fixture");
    let (mut actions, mut done, mut refusals) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    let word = |text: String| text.split(' ').next().unwrap_or_default().to_owned();
    for _ in 0..scene.ticks() {
        let commands = scene.commands(&world);
        let events = world.step(&commands);
        for command in &commands {
            let name = word(format!("{:?}", command.action));
            actions.insert(name.clone());
            let refusal = events.iter().find_map(|event| match event.kind {
                EventKind::Refused { player, sequence, why }
                    if (player, sequence) == (command.player, command.sequence) =>
                {
                    Some(why)
                }
                _ => None,
            });
            match refusal {
                Some(why) => refusals.insert(word(format!("{why:?}").replace('(', " "))),
                None => done.insert(name),
            };
        }
    }
    assert_eq!(actions.len(), 17, "one for each variant of `Action`: {actions:?}");
    assert_eq!(done, actions);
    let all = ["NotMovable", "NotPinned", "OutOfRange", "Stale"];
    assert!(refusals.iter().eq(all), "{refusals:?}");
    assert!(world.particles().ids().any(|id| id.0.generation > 1), "a slot is taken again");
}

#[test]
fn overflow_fixture_meets_both_limits() {
    let (mut clamped, mut stopped) = (0, 0);
    run(OVERFLOW, |_, events| {
        for event in events {
            match event.kind {
                EventKind::DisplacementClamped { .. } => clamped += 1,
                EventKind::WorldLimit { .. } => stopped += 1,
                EventKind::Refused { why: Refusal::OutOfRange(_), .. } => {}
                kind => panic!("{kind:?}"),
            }
        }
    });
    assert!(clamped > 100 && stopped > 100, "{clamped} clamped, {stopped} stopped");
}

#[test]
fn border_fixture_crosses_64_metres_both_ways() {
    let narrow = |span: [i64; 3]| span.iter().all(|c| c.abs() <= 1 << 30);
    let mut widths = [(); 14].map(|()| Vec::new());
    run(BORDER, |world, events| {
        assert!(events.is_empty(), "{events:?}");
        for (id, distance) in world.distances() {
            let widths = &mut widths[id.0.slot()];
            let width = narrow(span(world, distance));
            if widths.last() != Some(&width) {
                widths.push(width);
            }
        }
    });
    for (index, widths) in widths.iter().enumerate() {
        assert!(widths.len() > 2, "distance {index} crosses {} times", widths.len() - 1);
    }
}

/// The greatest share by which a link is longer or shorter than it should be, in percent.
fn strain_max(text: &str) -> i64 {
    let mut most = 0;
    run(text, |world, _| {
        for (_, distance) in world.distances() {
            let length = Vec3::from_raw(span(world, distance)).length().raw();
            let rest = distance.rest_length.raw();
            most = most.max((length - rest).abs() * 100 / rest);
        }
    });
    most
}

#[test]
fn links_hold() {
    // Percent, twice of what is seen; a fixture beyond has come apart.
    for (name, text, limit) in [("pendulum", PENDULUM, 1), ("rope", ROPE, 24)] {
        let strain = strain_max(text);
        assert!(strain <= limit, "{name}: {strain} %");
    }
}

#[test]
fn storm_fixture_reuses_slots() {
    let (mut spawned, mut removed, mut refused, mut links) = (0, 0, 0, 0);
    run(STORM, |world, events| {
        links = links.max(world.distances().count());
        for event in events {
            match event.kind {
                EventKind::Spawned { .. } => spawned += 1,
                EventKind::Removed { .. } => removed += 1,
                EventKind::Refused { .. } => refused += 1,
                _ => {}
            }
        }
        let slots = world.particles().positions_raw().len();
        assert!(slots < 600, "{slots} slots for 500 particles");
    });
    assert!(spawned > 5000 && removed > 5000 && refused > 100 && links > 100);
}

#[test]
fn cloud_stays_in_its_box() {
    // Where two sides meet, friction on one may push a little behind the other.
    let limit = Real::from_int(10) + Real::ULP;
    let corner = -real!("0.01").raw();
    run(CLOUD, |world, _| {
        let inside =
            |p: &[i64; 3]| p[0] >= -limit.raw() && p[2].abs() <= limit.raw() && p[1] >= corner;
        assert!(world.particles().positions_raw().iter().all(inside));
    });
}

#[test]
fn net_and_projectile_are_what_they_say() {
    let world = scene(NET).build().expect("a fixture");
    assert_eq!((world.particles().len(), world.distances().count()), (4096, 16_002));
    // Every other link of a row: no two share a particle, so they get one colour.
    let apart = |d: &Distance| d.a.0.index.is_multiple_of(2) && d.b.0.index == d.a.0.index + 1;
    assert!(world.distances().filter(|(_, distance)| apart(distance)).count() > 1024 + 32);

    let mut last = Vec::new();
    run(PROJECTILE, |world, _| {
        last = world.particles().ids().filter_map(|id| world.position(id)).collect();
    });
    let [plain, heavy] = [last[0], last[1]];
    assert_eq!([plain.x, plain.y], [heavy.x, heavy.y], "mass makes no difference");
    assert_eq!(last[6], Vec3::from_ints(0, 1, 6), "disabled");
}

/// The scene of the README plays, and nothing of it is refused.
#[test]
fn readme_scene_plays() {
    let readme = include_str!("../../README.md");
    let (_, text) = readme.split_once("```ron\n").expect("a scene");
    let (text, _) = text.split_once("```").expect("its end");
    let mut refused = Vec::new();
    run(text, |_, events| refused.extend_from_slice(events));
    assert_eq!(refused, []);
}
