//! Random worlds: of everyday size, or made of the ends of every range.

use verlock::WorldConfig;
use verlock::body::{Face, FaceId};
use verlock::constraint::{
    Distance, DistanceForm, DistanceId, HalfSpace, HalfSpaceId, Volume, VolumeId,
};
use verlock::math::{Factor, Pcg, Real, Unit, UnitVec3, Vec3};
use verlock::particle::{Particle, ParticleId, ParticleSpec, WORLD_LIMIT};
use verlock::real;
use verlock::store::Handle;
use verlock::world::{Action, Command, ObjectId};

use super::blueprint::{Blueprint, first};

/// How much a random world holds; volumes and faces in proportion to links. Shrinks well.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    pub particles: u32,
    pub links: u32,
    pub walls: u32,
    pub ticks: u32,
}

impl Size {
    fn volumes(&self) -> u32 {
        if self.particles < 4 { 0 } else { self.links / 4 }
    }

    fn faces(&self) -> u32 {
        if self.particles < 3 { 0 } else { self.links / 3 }
    }
}

/// A few metres, everyday masses and speeds, every kind of object and command.
pub fn everyday(seed: u64, size: Size) -> Blueprint {
    let mut draw = Draw(Pcg::new(seed, 1));
    let config = draw.config();
    let mut blueprint = Blueprint { config, ..Blueprint::default() };
    blueprint.particles = (0..size.particles).map(|_| draw.particle()).collect();
    blueprint.distances = (0..size.links).map(|_| draw.link(size.particles)).collect();
    blueprint.half_spaces = (0..size.walls).map(|_| draw.wall()).collect();
    blueprint.volumes = (0..size.volumes()).map(|_| draw.volume(size.particles)).collect();
    blueprint.faces = (0..size.faces()).map(|_| draw.face(size.particles)).collect();
    for sequence in 0..size.ticks {
        let tick = u64::from(draw.below(size.ticks));
        let action = draw.action(size);
        let player = draw.below(3);
        blueprint.script.push((tick, Command { player, sequence, action }));
    }
    blueprint
}

/// Speeds, masses, lengths, coefficients and positions from the ends of their ranges, and a hub
/// with `size.links` constraints.
pub fn hostile(seed: u64, size: Size) -> Blueprint {
    let mut draw = Draw(Pcg::new(seed, 2));
    let config = WorldConfig {
        tick_rate: draw.one_of(&[1, 60, 1000]),
        substeps: draw.one_of(&[1, 4]),
        iterations: draw.one_of(&[1, 3]),
        gravity: draw.corner(WorldConfig::GRAVITY_MAX.raw()),
        damping: draw.one_of(&[Real::ZERO, Real::ONE]),
        displacement_max: draw.one_of(&[Real::ULP, Real::ONE, WorldConfig::DISPLACEMENT_MAX]),
        wind: draw.corner(WorldConfig::WIND_MAX.raw()),
    };
    let mut blueprint = Blueprint { config, ..Blueprint::default() };
    let rate = i64::from(config.tick_rate * config.substeps);
    // Half the maximum: what gravity takes off at the start must fit as well.
    let fastest = config.displacement_max.raw() / 2 * rate;
    blueprint.particles = (0..size.particles).map(|_| draw.extreme_particle(fastest)).collect();
    for link in 0..size.links {
        let spoke = 1 + link % (size.particles - 1);
        let lengths = [Real::ULP, Real::ONE, real!("64"), Distance::REST_LENGTH_MAX];
        let stiffness = draw.one_of(&[Unit::ONE, Unit::ONE, Unit::from_raw(1)]);
        let rest_length = draw.one_of(&lengths);
        blueprint.distances.push(Distance {
            slack: draw.one_of(&[Real::ZERO, Real::ZERO, Real::ULP, rest_length]),
            compliance: draw.one_of(&[Unit::ZERO, Unit::ZERO, Unit::from_raw(1), Unit::ONE]),
            tear_strain: draw.one_of(&[Factor::ZERO, Factor::from_raw(i32::MAX)]),
            ..Distance::new(first(0), first(spoke), rest_length)
                .form(draw.form())
                .stiffness(stiffness)
        });
    }
    for _ in 0..size.volumes() {
        let litres = draw.one_of(&[-Volume::REST_VOLUME_MAX, Real::ULP, Volume::REST_VOLUME_MAX]);
        let stiffness = draw.one_of(&[Unit::ONE, Unit::from_raw(1)]);
        let corners = draw.corners(size.particles);
        blueprint.volumes.push(Volume::new(corners, litres).stiffness(stiffness));
    }
    for _ in 0..size.faces() {
        let drag = draw.one_of(&[Face::DRAG_MAX, Factor::from_raw(1)]);
        blueprint.faces.push(Face::new(draw.corners(size.particles)).drag(drag));
    }
    for _ in 0..size.walls {
        blueprint.half_spaces.push(HalfSpace {
            point: draw.place(),
            restitution: Unit::ONE,
            friction: draw.one_of(&[Factor::ZERO, HalfSpace::FRICTION_MAX]),
            ..draw.wall()
        });
    }
    for sequence in 0..size.ticks * 4 {
        let tick = u64::from(draw.below(size.ticks));
        let action = draw.extreme_action(size.particles);
        blueprint.script.push((tick, Command { player: 0, sequence, action }));
    }
    blueprint
}

/// Every form of a distance.
pub const FORMS: [DistanceForm; 4] = [
    DistanceForm::Exact,
    DistanceForm::StartOfStep,
    DistanceForm::RootFree,
    DistanceForm::DivisionFree,
];

struct Draw(Pcg);

impl Draw {
    fn below(&mut self, n: u32) -> u32 {
        self.0.below(n)
    }

    fn chance(&mut self, percent: u32) -> bool {
        self.below(100) < percent
    }

    fn one_of<T: Copy>(&mut self, choice: &[T]) -> T {
        choice[self.below(u32::try_from(choice.len()).expect("a short list")) as usize]
    }

    fn real(&mut self, lo: Real, hi: Real) -> Real {
        self.0.real(lo, hi)
    }

    fn vector(&mut self, reach: Real) -> Vec3 {
        let mut one = || self.0.real(-reach, reach);
        Vec3::new(one(), one(), one())
    }

    /// A vector of components -limit, 0 or limit.
    fn corner(&mut self, limit: i64) -> Vec3 {
        Vec3::from_raw([(); 3].map(|()| self.one_of(&[-limit, 0, limit])))
    }

    fn form(&mut self) -> DistanceForm {
        self.one_of(&FORMS)
    }

    fn factor(&mut self, lo: i32, hi: i32) -> Factor {
        let span = (hi - lo).unsigned_abs();
        Factor::from_raw(lo + self.below(span).cast_signed())
    }

    fn unit(&mut self) -> Unit {
        Unit::from_raw(self.below(1 + (1 << 30)).cast_signed())
    }

    fn config(&mut self) -> WorldConfig {
        WorldConfig {
            tick_rate: self.one_of(&[30, 60, 144]),
            substeps: 1 + self.below(4),
            iterations: 1 + self.below(3),
            gravity: self.vector(real!("10")),
            damping: self.one_of(&[Real::ZERO, real!("0.1"), real!("5")]),
            displacement_max: self.one_of(&[WorldConfig::DISPLACEMENT_MAX, real!("0.1")]),
            wind: self.vector(real!("8")),
        }
    }

    fn particle(&mut self) -> ParticleSpec {
        let mut particle = Particle {
            mass: self.one_of(&[Real::ONE, real!("0.25"), real!("40")]),
            pinned: self.chance(15),
            enabled: !self.chance(5),
            ..Particle::default()
        };
        if self.chance(40) {
            particle.gravity_scale = self.factor(-(2 << 16), 2 << 16);
            particle.acceleration = self.vector(real!("20"));
        }
        let velocity = self.vector(real!("2"));
        ParticleSpec { position: self.vector(real!("2")), velocity, particle }
    }

    fn link(&mut self, particles: u32) -> Distance {
        let a = self.below(particles);
        let b = (a + 1 + self.below(particles - 1)) % particles;
        let rest_length = self.real(real!("0.5"), real!("3"));
        let soft = Unit::from_raw(self.below(1 << 22).cast_signed()); // to 4 mm/N
        let part = self.real(Real::ULP, rest_length);
        let strain = self.factor(1, 1 << 15);
        Distance {
            slack: self.one_of(&[Real::ZERO, Real::ZERO, rest_length, part]),
            compliance: self.one_of(&[Unit::ZERO, Unit::ZERO, soft]),
            tear_strain: self.one_of(&[Factor::ZERO, Factor::ZERO, strain]),
            toughness: self.one_of(&[Factor::ZERO, Factor::ONE]),
            ..Distance::new(first(a), first(b), rest_length)
                .form(self.form())
                .stiffness(if self.chance(50) { Unit::ONE } else { self.unit() })
        }
    }

    /// Different particles.
    fn corners<const N: usize>(&mut self, particles: u32) -> [ParticleId; N] {
        let mut drawn: [u32; N] = [0; N];
        for k in 0..N {
            let mut slot = self.below(particles);
            while drawn[..k].contains(&slot) {
                slot = (slot + 1) % particles;
            }
            drawn[k] = slot;
        }
        drawn.map(first)
    }

    fn volume(&mut self, particles: u32) -> Volume {
        let litres = self.real(real!("-3000"), real!("3000"));
        Volume::new(self.corners(particles), litres).stiffness(self.unit())
    }

    fn face(&mut self, particles: u32) -> Face {
        let face = Face::new(self.corners(particles)).drag(self.factor(0, 4 << 16));
        Face { enabled: !self.chance(5), ..face }
    }

    /// Any kind of object; some ids are stale.
    fn object(&mut self, size: Size) -> ObjectId {
        let kinds = [size.particles, size.links, size.walls, size.volumes(), size.faces()];
        let kind = self.below(5);
        let id = Handle::new(self.below(kinds[kind as usize] + 1), 1);
        match kind {
            0 => ObjectId::Particle(ParticleId(id)),
            1 => ObjectId::Distance(DistanceId(id)),
            2 => ObjectId::HalfSpace(HalfSpaceId(id)),
            3 => ObjectId::Volume(VolumeId(id)),
            _ => ObjectId::Face(FaceId(id)),
        }
    }

    fn wall(&mut self) -> HalfSpace {
        let normal = UnitVec3::normalize(self.vector(Real::ONE)).unwrap_or(UnitVec3::Y);
        let [x, y, z] = normal.raw();
        HalfSpace {
            // Two metres behind the origin.
            point: Vec3::from_raw([x, y, z].map(|n| -n >> 5)),
            normal,
            friction: self.factor(0, 1 << 16),
            restitution: self.unit(),
            ..HalfSpace::default()
        }
    }

    fn action(&mut self, size: Size) -> Action {
        // One more than there are: some ids are stale.
        let particle = first(self.below(size.particles + 1));
        match self.below(18) {
            0 => Action::Force { particle, force: self.vector(real!("100")) },
            1 => Action::Impulse { particle, impulse: self.vector(real!("3")) },
            2 => Action::SetVelocity { particle, velocity: self.vector(real!("3")) },
            3 => Action::SetAcceleration { particle, acceleration: self.vector(real!("9")) },
            4 => Action::SetMass { particle, mass: self.real(Real::ULP, real!("9")) },
            5 => Action::SetGravityScale { particle, scale: self.factor(-99_999, 99_999) },
            6 => Action::SetPinned { particle, pinned: self.chance(50) },
            7 => Action::MovePin { particle, target: self.vector(real!("2")) },
            8 => Action::Teleport { particle, position: self.vector(real!("2")) },
            9 => Action::SetEnabled { object: self.object(size), enabled: self.chance(50) },
            10 => Action::SpawnParticle { token: 0, spec: self.particle() },
            11 => Action::SpawnDistance { token: 1, distance: self.link(size.particles) },
            12 => Action::Remove { object: self.object(size) },
            13 if size.volumes() > 0 => {
                Action::SpawnVolume { token: 2, volume: self.volume(size.particles) }
            }
            14 if size.faces() > 0 => {
                Action::SpawnFace { token: 3, face: self.face(size.particles) }
            }
            15 => Action::SetWind { wind: self.vector(real!("12")) },
            16 => {
                let distance = DistanceId(Handle::new(self.below(size.links + 1), 1));
                Action::SetRestLength { distance, rest_length: self.real(Real::ULP, real!("3")) }
            }
            _ => Action::Configure { config: self.config() },
        }
    }

    /// Somewhere near the origin, near a limit of the world, or anywhere.
    fn place(&mut self) -> Vec3 {
        let near = self.vector(real!("100"));
        match self.below(4) {
            0 => near,
            1 => self.corner(WORLD_LIMIT),
            2 => Vec3::from_raw([(); 3].map(|()| {
                let far = self.one_of(&[-WORLD_LIMIT, WORLD_LIMIT]);
                far - far.signum() * i64::from(self.below(1 << 30))
            })),
            _ => self.vector(Real::from_raw(WORLD_LIMIT)),
        }
    }

    fn extreme_particle(&mut self, fastest: i64) -> ParticleSpec {
        let particle = Particle {
            mass: self.one_of(&[Particle::MASS_MIN, Real::ONE, Particle::MASS_MAX]),
            pinned: self.chance(10),
            ..Particle::default()
        };
        let still = Particle { gravity_scale: Factor::ZERO, ..particle };
        let velocity = self.corner(fastest);
        ParticleSpec { position: self.place(), velocity, particle: still }
    }

    fn extreme_action(&mut self, particles: u32) -> Action {
        let particle = first(self.below(particles));
        let huge = Vec3::from_raw([(); 3].map(|()| self.one_of(&[i64::MIN, -1, 0, i64::MAX])));
        match self.below(8) {
            0 => Action::Force { particle, force: huge },
            1 => Action::Impulse { particle, impulse: huge },
            2 => Action::SetVelocity { particle, velocity: huge },
            3 => Action::Teleport { particle, position: self.place() },
            4 => Action::MovePin { particle, target: self.place() },
            5 => Action::SetGravityScale { particle, scale: Particle::GRAVITY_SCALE_MAX },
            6 => {
                let most = Particle::ACCELERATION_MAX.raw();
                Action::SetAcceleration { particle, acceleration: self.corner(most) }
            }
            _ => {
                let stale = ParticleId(Handle::new(self.below(particles), 2));
                Action::Impulse { particle: stale, impulse: huge }
            }
        }
    }
}
