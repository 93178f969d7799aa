//! Small worlds in which every section of a snapshot has records, free slots among them.

use verlock::body::{Face, FaceId};
use verlock::constraint::{
    Distance, DistanceForm, DistanceId, HalfSpace, HalfSpaceId, Volume, VolumeId,
};
use verlock::math::{Factor, Unit, UnitVec3};
use verlock::particle::{ParticleId, ParticleSpec};
use verlock::store::Handle;
use verlock::world::{Action, Command, ObjectId, World, WorldBuilder, WorldConfig};
use verlock::{Real, Vec3, real};

/// The first tenant of a particle slot.
pub fn particle(slot: u32) -> ParticleId {
    ParticleId(Handle::new(slot, 1))
}

/// The first tenant of a distance slot.
pub fn distance(slot: u32) -> DistanceId {
    DistanceId(Handle::new(slot, 1))
}

/// The first tenant of a half-space slot.
pub fn half_space(slot: u32) -> HalfSpaceId {
    HalfSpaceId(Handle::new(slot, 1))
}

/// The first tenant of a volume slot.
pub fn volume(slot: u32) -> VolumeId {
    VolumeId(Handle::new(slot, 1))
}

/// The first tenant of a face slot.
pub fn face(slot: u32) -> FaceId {
    FaceId(Handle::new(slot, 1))
}

/// The command of one player who numbers them from 0.
pub fn command(sequence: u32, action: Action) -> Command {
    Command { player: 1, sequence, action }
}

/// A moving world at tick 2: six particle slots, three distances, two half-spaces, two volumes and
/// two faces. One of each, but for the distances of which one lost an end, was removed.
///
/// Nothing holds particle 4. Distance 2 takes damage in every tick.
pub fn small() -> World {
    let config = WorldConfig {
        tick_rate: 50,
        substeps: 2,
        iterations: 3,
        gravity: Vec3::new(real!("0.25"), real!("-9.81"), Real::ZERO),
        damping: real!("0.5"),
        displacement_max: real!("2"),
        wind: Vec3::new(real!("3"), Real::ZERO, real!("-0.5")),
    };
    let mut builder = WorldBuilder::new(config).expect("a good configuration");
    builder.seed(7);
    let at = |x: i32, y: i32| ParticleSpec::at(Vec3::new(x.into(), y.into(), real!("0.5")));
    let mut own = at(2, 2).velocity(Vec3::X).mass(real!("2.5"));
    own.particle.gravity_scale = Factor::from_raw(3 << 15);
    own.particle.acceleration = Vec3::new(real!("0.1"), real!("-0.2"), real!("0.3"));
    own.particle.user = 99;
    let specs = [at(0, 2).pinned(), at(1, 2), own, at(3, 3), at(4, 0).velocity(-Vec3::Y), at(2, 4)];
    for spec in &specs {
        builder.particle(spec).expect("a good particle");
    }
    let link = |a, b| Distance::new(particle(a), particle(b), Real::ONE);
    let half = Unit::from_raw(1 << 29);
    let (half_metre, slight) = (real!("0.5"), Factor::from_raw(1));
    let worn = Distance { slack: real!("0.125"), rest_length: half_metre, ..link(1, 2) };
    let worn = Distance { toughness: Factor::from_raw(1 << 28), ..worn.tear_strain(slight) };
    let worn = worn.form(DistanceForm::Exact).stiffness(half);
    let links = [link(0, 1), link(3, 4), worn];
    for link in &links {
        builder.distance(link).expect("a good distance");
    }
    let slope = UnitVec3::normalize(Vec3::new(Real::ONE, real!("8"), Real::ZERO));
    let ground = HalfSpace { restitution: half, user: 5, ..HalfSpace::default() };
    let slope = HalfSpace { normal: slope.expect("not zero"), ..ground };
    for plane in [HalfSpace { point: -Vec3::Y, ..ground }, slope] {
        builder.half_space(&plane).expect("a good half-space");
    }
    let corners = [0, 1, 2, 5].map(particle);
    for rest_volume in ["100", "120"] {
        let volume = Volume::new(corners, rest_volume.parse().expect("litres")).stiffness(half);
        builder.volume(&volume).expect("a good volume");
    }
    for corners in [[0, 1, 2], [1, 2, 5]] {
        let face = Face::new(corners.map(particle)).drag(Factor::ONE);
        builder.face(&face).expect("a good face");
    }
    let mut world = builder.build();
    let gone = [
        ObjectId::Particle(particle(3)),
        ObjectId::HalfSpace(half_space(0)),
        ObjectId::Volume(volume(0)),
        ObjectId::Face(face(0)),
    ];
    let gone = gone.map(|object| command(0, Action::Remove { object }));
    world.step(&gone);
    world.step(&[]);
    world
}

/// A world that has nothing in common with [`small`], after a tick.
pub fn other() -> World {
    let mut builder = WorldBuilder::new(WorldConfig::default()).expect("a good configuration");
    for x in 0..40 {
        let spec = ParticleSpec::at(Vec3::new(x.into(), Real::ZERO, Real::ZERO));
        builder.particle(&spec).expect("a good particle");
    }
    for slot in 0..39 {
        let link = Distance::new(particle(slot), particle(slot + 1), Real::ONE);
        builder.distance(&link).expect("a good distance");
    }
    let mut world = builder.build();
    let object = ObjectId::Particle(particle(20));
    world.step(&[command(0, Action::Remove { object })]);
    world
}

/// Every action there is, possible in [`small`] when each is carried out alone.
pub fn actions() -> Vec<Action> {
    let (pin, free) = (particle(0), particle(1));
    let link = Distance::new(particle(2), particle(4), real!("2"));
    let objects = [
        ObjectId::Particle(free),
        ObjectId::Distance(distance(2)),
        ObjectId::HalfSpace(half_space(1)),
        ObjectId::Volume(volume(1)),
        ObjectId::Face(face(1)),
    ];
    let corners = [0, 1, 2, 4].map(particle);
    let mut actions = vec![
        Action::SpawnParticle { token: 1, spec: ParticleSpec::at(Vec3::Z) },
        Action::SpawnDistance { token: 2, distance: link },
        Action::SpawnHalfSpace { token: 3, half_space: HalfSpace::default() },
        Action::Force { particle: free, force: Vec3::X },
        Action::Impulse { particle: free, impulse: Vec3::Z },
        Action::SetVelocity { particle: free, velocity: Vec3::ZERO },
        Action::SetAcceleration { particle: free, acceleration: Vec3::Y },
        Action::SetMass { particle: free, mass: real!("3") },
        Action::SetGravityScale { particle: free, scale: Factor::ZERO },
        Action::SetPinned { particle: free, pinned: true },
        Action::MovePin { particle: pin, target: Vec3::X },
        Action::Teleport { particle: free, position: Vec3::Z },
        Action::SetRestLength { distance: distance(0), rest_length: real!("0.75") },
        Action::Configure { config: WorldConfig::default() },
        Action::SpawnVolume { token: 4, volume: Volume::new(corners, real!("50")) },
        Action::SpawnFace { token: 5, face: Face::new([0, 1, 4].map(particle)) },
        Action::SetWind { wind: Vec3::Y },
    ];
    for object in objects {
        actions.push(Action::Remove { object });
        actions.push(Action::SetEnabled { object, enabled: false });
        actions.push(Action::SetUser { object, user: u64::MAX });
    }
    actions
}
