//! Worlds and commands out of bytes: mostly sensible, now and then anything.

use arbitrary::{Arbitrary, Unstructured};
use verlock::body::{Face, FaceId};
use verlock::constraint::{
    Distance, DistanceForm, DistanceId, HalfSpace, HalfSpaceId, Volume, VolumeId,
};
use verlock::math::{Factor, Real, Unit, UnitVec3, Vec3};
use verlock::particle::{Particle, ParticleId, ParticleSpec};
use verlock::store::Handle;
use verlock::world::{Action, Command, ObjectId, World, WorldBuilder, WorldConfig};

/// Bytes that choices are read from; when they are used up, every choice is the first.
pub struct Draw<'a>(Unstructured<'a>);

/// No more objects of a kind are in a world at its start.
const OBJECTS_MAX: usize = 10;
/// No more commands are given in a tick.
const COMMANDS_MAX: usize = 7;

/// A metre, a metre a second or a kilogram.
const ONE: i64 = Real::ONE.raw();

/// Numbers where something changes: limits, and what lies just beyond them.
const EDGES: [i64; 14] = [
    0,
    1,
    -1,
    ONE,
    1 << 30,
    (1 << 30) + 1,
    -(1 << 30),
    1024 * ONE,
    1 << 60,
    -(1 << 60),
    (1 << 60) + 1,
    -(1 << 60) + 5 * ONE,
    i64::MAX,
    i64::MIN,
];

impl<'a> Draw<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(Unstructured::new(bytes))
    }

    /// Whether all bytes are used up.
    pub fn is_done(&self) -> bool {
        self.0.is_empty()
    }

    /// A number below `n`, which is not 0.
    pub(super) fn below(&mut self, n: usize) -> usize {
        self.0.choose_index(n).unwrap_or(0)
    }

    /// Any value, or the default when all bytes are used up.
    pub(super) fn any<T: Arbitrary<'a> + Default>(&mut self) -> T {
        self.0.arbitrary().unwrap_or_default()
    }

    /// A raw number, usually within `+-usual`.
    fn raw(&mut self, usual: i64) -> i64 {
        match self.below(16) {
            0 => EDGES[self.below(EDGES.len())],
            1 => self.any(),
            _ => i64::from(self.any::<i16>()) * (usual >> 15),
        }
    }

    fn real(&mut self, usual: i64) -> Real {
        Real::from_raw(self.raw(usual))
    }

    pub(super) fn vector(&mut self, usual: i64) -> Vec3 {
        Vec3::from_raw([self.raw(usual), self.raw(usual), self.raw(usual)])
    }

    fn unit(&mut self) -> Unit {
        let usual = [Unit::ONE.raw(), Unit::ONE.raw() / 2, 0, self.any()];
        Unit::from_raw(usual[self.below(4)])
    }

    fn factor(&mut self) -> Factor {
        let usual = [Factor::ONE.raw(), -3 << 15, 16 << 16, self.any()];
        Factor::from_raw(usual[self.below(4)])
    }

    fn mass(&mut self) -> Real {
        let usual = [ONE, ONE / 4, Particle::MASS_MIN.raw(), Particle::MASS_MAX.raw(), self.any()];
        Real::from_raw(usual[self.below(5)])
    }

    pub(super) fn config(&mut self) -> WorldConfig {
        WorldConfig {
            tick_rate: [60, 50, 1, 1000, self.any()][self.below(5)],
            substeps: [4, 1, 3, 8, 64, 65][self.below(6)],
            iterations: [1, 2, 5, 0][self.below(4)],
            gravity: self.vector(20 * ONE),
            damping: [Real::ZERO, self.real(ONE)][self.below(2)],
            displacement_max: [WorldConfig::DISPLACEMENT_MAX, self.real(ONE)][self.below(2)],
            wind: [Vec3::ZERO, self.vector(20 * ONE)][self.below(2)],
        }
    }

    pub(super) fn spec(&mut self) -> ParticleSpec {
        let user = self.any::<u8>();
        let mut spec = ParticleSpec::at(self.vector(8 * ONE)).velocity(self.vector(16 * ONE));
        spec.particle = Particle {
            mass: self.mass(),
            gravity_scale: self.factor(),
            pinned: user & 0b11 == 0b01,
            enabled: user & 0b1100 != 0b0100,
            user: user.into(),
            ..Particle::default()
        };
        spec
    }

    fn half_space(&mut self) -> HalfSpace {
        let normal = UnitVec3::normalize(self.vector(ONE)).unwrap_or(UnitVec3::Y);
        HalfSpace {
            point: self.vector(4 * ONE),
            normal,
            friction: self.factor(),
            restitution: self.unit(),
            ..HalfSpace::default()
        }
    }

    pub(super) fn link(&mut self, a: ParticleId, b: ParticleId) -> Distance {
        let forms = [
            DistanceForm::StartOfStep,
            DistanceForm::Exact,
            DistanceForm::RootFree,
            DistanceForm::DivisionFree,
        ];
        let form = forms[self.below(4)];
        let rest_length = self.real(4 * ONE);
        Distance {
            slack: [Real::ZERO, rest_length, self.real(ONE)][self.below(3)],
            compliance: [Unit::ZERO, Unit::from_raw(1 << 14), self.unit()][self.below(3)],
            tear_strain: [Factor::ZERO, Factor::from_raw(1 << 13), self.factor()][self.below(3)],
            toughness: [Factor::ZERO, self.factor()][self.below(2)],
            ..Distance::new(a, b, rest_length).form(form).stiffness(self.unit())
        }
    }

    pub(super) fn volume(&mut self, corners: [ParticleId; 4]) -> Volume {
        Volume::new(corners, self.real(100 * ONE)).stiffness(self.unit())
    }

    fn face(&mut self, corners: [ParticleId; 3]) -> Face {
        Face::new(corners).drag(self.factor())
    }

    /// A small world; what its builder refuses is left out.
    pub fn world(&mut self) -> World {
        let builder = WorldBuilder::new(self.config());
        let plain = || WorldBuilder::new(WorldConfig::default());
        let mut builder = builder.or_else(|_| plain()).expect("the default is in range");
        let specs: Vec<_> = (0..self.below(OBJECTS_MAX)).map(|_| self.spec()).collect();
        let ids: Vec<_> = specs.iter().filter_map(|spec| builder.particle(spec).ok()).collect();
        for _ in 0..self.below(OBJECTS_MAX) {
            let ends = [self.one_of(&ids), self.one_of(&ids)];
            let _ = builder.distance(&self.link(ends[0], ends[1]));
        }
        for _ in 0..self.below(4) {
            let _ = builder.half_space(&self.half_space());
        }
        for _ in 0..self.below(4) {
            let corners = [(); 4].map(|()| self.one_of(&ids));
            let _ = builder.volume(&self.volume(corners));
            let corners = [(); 3].map(|()| self.one_of(&ids));
            let _ = builder.face(&self.face(corners));
        }
        builder.build()
    }

    /// The commands of a tick. Players number some of them alike.
    pub fn commands(&mut self, world: &World) -> Vec<Command> {
        let count = self.below(COMMANDS_MAX);
        (0..count)
            .map(|_| {
                let number = self.any::<u8>();
                let (player, sequence) = (u32::from(number >> 6 & 1), u32::from(number & 7));
                Command { player, sequence, action: self.action(world) }
            })
            .collect()
    }

    fn action(&mut self, world: &World) -> Action {
        let kind = self.below(23);
        let token = kind as u64; // below 23
        let particle = self.particle(world);
        match kind {
            0 | 1 => Action::SpawnParticle { token, spec: self.spec() },
            2 | 3 => {
                let b = self.particle(world);
                Action::SpawnDistance { token, distance: self.link(particle, b) }
            }
            4 => Action::SpawnHalfSpace { token, half_space: self.half_space() },
            5 => Action::Remove { object: ObjectId::Particle(particle) },
            6 => Action::Remove { object: self.object(world) },
            7 => Action::Force { particle, force: self.vector(50 * ONE) },
            8 => Action::Impulse { particle, impulse: self.vector(10 * ONE) },
            9 => Action::SetVelocity { particle, velocity: self.vector(20 * ONE) },
            10 => Action::SetAcceleration { particle, acceleration: self.vector(20 * ONE) },
            11 => Action::SetMass { particle, mass: self.mass() },
            12 => Action::SetGravityScale { particle, scale: self.factor() },
            13 => Action::SetPinned { particle, pinned: self.any() },
            14 => Action::MovePin { particle, target: self.vector(8 * ONE) },
            15 => Action::Teleport { particle, position: self.vector(8 * ONE) },
            16 => {
                let distance = self.distance(world);
                Action::SetRestLength { distance, rest_length: self.real(4 * ONE) }
            }
            17 => Action::SetEnabled { object: self.object(world), enabled: self.any() },
            18 => Action::SetUser { object: self.object(world), user: self.any() },
            19 => {
                let corners = [(); 4].map(|()| self.particle(world));
                Action::SpawnVolume { token, volume: self.volume(corners) }
            }
            20 => {
                let corners = [(); 3].map(|()| self.particle(world));
                Action::SpawnFace { token, face: self.face(corners) }
            }
            21 => Action::SetWind { wind: self.vector(20 * ONE) },
            _ => Action::Configure { config: self.config() },
        }
    }

    fn object(&mut self, world: &World) -> ObjectId {
        match self.below(5) {
            3 => {
                let alive: Vec<_> = world.volumes().map(|(VolumeId(id), _)| id).collect();
                ObjectId::Volume(VolumeId(self.handle(&alive)))
            }
            4 => {
                let alive: Vec<_> = world.faces().map(|(FaceId(id), _)| id).collect();
                ObjectId::Face(FaceId(self.handle(&alive)))
            }
            0 => ObjectId::Particle(self.particle(world)),
            1 => ObjectId::Distance(self.distance(world)),
            _ => {
                let alive: Vec<_> = world.half_spaces().map(|(HalfSpaceId(id), _)| id).collect();
                ObjectId::HalfSpace(HalfSpaceId(self.handle(&alive)))
            }
        }
    }

    fn particle(&mut self, world: &World) -> ParticleId {
        let alive: Vec<_> = world.particles().ids().map(|ParticleId(id)| id).collect();
        ParticleId(self.handle(&alive))
    }

    fn distance(&mut self, world: &World) -> DistanceId {
        let alive: Vec<_> = world.distances().map(|(DistanceId(id), _)| id).collect();
        DistanceId(self.handle(&alive))
    }

    /// Mostly a living object, sometimes one that was or will be, or nothing.
    fn handle(&mut self, alive: &[Handle]) -> Handle {
        if self.below(8) == 0 {
            let generation = [self.any::<u8>().into(), self.any::<u32>()][self.below(2)];
            Handle::new(self.any::<u8>().into(), generation)
        } else {
            self.one_of(alive)
        }
    }

    fn one_of<T: Copy + Default>(&mut self, all: &[T]) -> T {
        if all.is_empty() { T::default() } else { all[self.below(all.len())] }
    }
}
