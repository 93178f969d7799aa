//! Files that were typed by hand from `FORMAT.md`: writer and reader cannot share a mistake.

use verlock::body::Face;
use verlock::constraint::{Distance, DistanceForm, HalfSpace, Volume};
use verlock::math::{Factor, Unit};
use verlock::particle::ParticleSpec;
use verlock::replay::{Recorder, Replay, verify};
use verlock::world::{Action, Command, ObjectId, World, WorldBuilder, WorldConfig};
use verlock::{Real, Vec3, real};

use crate::support::fixture::read;
use crate::support::worlds::{particle, small};

/// The bytes of a text: two hexadecimal digits each; what follows a `#` is a comment.
fn typed(name: &str) -> Vec<u8> {
    let text = String::from_utf8(read(name)).expect("a text");
    let code = text.lines().filter_map(|line| line.split('#').next());
    let bytes = code.flat_map(str::split_whitespace);
    bytes.map(|byte| u8::from_str_radix(byte, 16).expect("hexadecimal digits")).collect()
}

fn builder() -> WorldBuilder {
    let config = WorldConfig {
        tick_rate: 8,
        substeps: 1,
        iterations: 2,
        gravity: Vec3::ZERO,
        damping: Real::ZERO,
        displacement_max: Real::ONE,
        wind: Vec3::ZERO,
    };
    WorldBuilder::new(config).expect("a good configuration")
}

/// The world that `snapshot.hex` says it is.
fn world() -> World {
    let mut builder = builder();
    let mut pin = ParticleSpec::at(Vec3::new(Real::ONE, real!("-2"), real!("0.5"))).pinned();
    pin.particle.user = 0x0102_0304_0506_0708;
    let at = Vec3::new(real!("3"), Real::ZERO, Real::ZERO);
    let velocity = Vec3::new(real!("0.5"), Real::ZERO, Real::ZERO);
    let moving = ParticleSpec::at(at).velocity(velocity).mass(real!("2.5"));
    let still = ParticleSpec::at(Vec3::Z).pinned();
    for spec in [pin, moving, ParticleSpec::at(Vec3::Z), still, still] {
        builder.particle(&spec).expect("a good particle");
    }
    let link = Distance {
        slack: real!("0.5"),
        stiffness: Unit::from_raw(1 << 28),
        compliance: Unit::from_raw(1 << 20),
        form: DistanceForm::DivisionFree,
        tear_strain: Factor::from_raw(3 << 14),
        toughness: Factor::from_raw(1 << 18),
        damage: Factor::from_raw(1 << 15),
        enabled: false,
        user: u64::MAX,
        ..Distance::new(particle(0), particle(1), real!("2"))
    };
    builder.distance(&link).expect("a good distance");
    let mut faces = [Face::new([0, 1, 2].map(particle)); 2];
    faces[1] =
        Face { drag: Factor::from_raw(5 << 15), user: 7, ..Face::new([0, 3, 4].map(particle)) };
    for face in &faces {
        builder.face(face).expect("a good face");
    }
    let corners = [0, 1, 3, 4].map(particle);
    let volume = Volume { enabled: false, ..Volume::new(corners, real!("-1.5")) };
    builder.volume(&volume).expect("a good volume");
    let floor = HalfSpace {
        point: Vec3::new(Real::ZERO, real!("-4"), Real::ZERO),
        restitution: Unit::from_raw(3 << 28),
        ..HalfSpace::default()
    };
    builder.half_space(&floor).expect("a good half-space");
    let mut world = builder.build();
    let object = ObjectId::Particle(particle(2));
    world.step(&[Command { player: 0, sequence: 0, action: Action::Remove { object } }]);
    world
}

/// The typed snapshot is the one that is written, and it is read.
#[test]
fn the_typed_snapshot_is_the_written_one() {
    let typed = typed("format/snapshot.hex");
    let mut world = world();
    assert_eq!(world.save(), typed);
    let mut loaded = World::load(&typed).expect("a sound snapshot");
    assert_eq!(loaded.hash(), world.hash());
    for _ in 0..10 {
        loaded.step(&[]);
        world.step(&[]);
        assert_eq!(loaded.hash(), world.hash());
    }
    let mut restored = small();
    restored.restore(&typed).expect("a sound snapshot");
    assert_eq!(restored.save(), typed);
}

/// The typed replay is the one that is recorded, and it verifies.
#[test]
fn the_typed_replay_is_the_recorded_one() {
    let typed = typed("format/replay.hex");
    let mut builder = builder();
    let velocity = Vec3::new(Real::ZERO, real!("0.5"), Real::ZERO);
    builder.particle(&ParticleSpec::at(Vec3::ZERO).velocity(velocity)).expect("a good particle");
    let mut recorder = Recorder::new(builder.build(), 2);
    let mark = Action::SetUser { object: ObjectId::Particle(particle(0)), user: 42 };
    let place = Action::Teleport { particle: particle(0), position: Vec3::X };
    recorder.step(&[
        Command { player: 2, sequence: 3, action: place },
        Command { player: 1, sequence: 7, action: mark },
    ]);
    recorder.step(&[]);
    assert_eq!(recorder.replay(), typed);
    let replay = Replay::parse(&typed).expect("a sound replay");
    let mut heights = vec![];
    let result = verify::<World>(&replay, |world| {
        heights.push(world.position(particle(0)).expect("alive").y);
    });
    assert_eq!(result, Ok(()));
    assert_eq!(heights, [real!("0.0625"), real!("0.125")]);
}
