//! Commands at random: the same ones in every run.

use alloc::vec::Vec;

use serde::Deserialize;

use super::cloud::{draw_velocity, validate_box, validate_speed};
use super::distance::as_placed;
use super::number::{Masses, decimal, draw_point, shift, vector};
use crate::constraint::{Distance, DistanceForm};
use crate::math::{Pcg, Real, Vec3};
use crate::particle::{ParticleId, ParticleSpec, RangeError, check_in};
use crate::world::{Action, ObjectId, World};

/// A storm as a scene file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Storm {
    /// The first tick.
    from: u64,
    /// The tick after the last.
    until: u64,
    /// Who gives the commands.
    pub(super) player: u32,
    /// How many particles appear in a tick.
    spawns: u32,
    /// How many particles are removed in a tick. One may be drawn twice, and be refused once.
    removes: u32,
    /// How many distances are made in a tick between any two particles, as they are placed.
    links: u32,
    /// How many particles are pushed in a tick.
    impulses: u32,
    /// The box in which particles appear.
    #[serde(deserialize_with = "vector")]
    min: Vec3,
    #[serde(deserialize_with = "vector")]
    max: Vec3,
    /// No component of a velocity (m/s) or of an impulse (N s) is greater, either way.
    #[serde(deserialize_with = "decimal")]
    speed: Real,
    mass: Masses,
}

/// The most commands of one kind in a tick.
const PER_TICK_MAX: u32 = 1 << 16;

impl Storm {
    /// Moves it by the scene's origin.
    pub(super) fn shift(&mut self, origin: Vec3) -> Result<(), RangeError> {
        shift(&mut self.min, origin, "min")?;
        shift(&mut self.max, origin, "max")
    }

    /// Checks every declared range.
    pub(super) fn validate(&self) -> Result<(), RangeError> {
        check_in(self.spawns, 0..=PER_TICK_MAX, "spawns")?;
        check_in(self.removes, 0..=PER_TICK_MAX, "removes")?;
        check_in(self.links, 0..=PER_TICK_MAX, "links")?;
        check_in(self.impulses, 0..=PER_TICK_MAX, "impulses")?;
        validate_box(self.min, self.max)?;
        self.mass.validate()?;
        validate_speed(self.speed)
    }

    /// What it does in the coming tick.
    pub(super) fn actions(&self, world: &World) -> Vec<Action> {
        if !(self.from..self.until).contains(&world.tick()) {
            return Vec::new();
        }
        let mut random = world.random();
        let mut actions: Vec<_> = (0..self.spawns)
            .map(|k| Action::SpawnParticle { token: k.into(), spec: self.spawn(&mut random) })
            .collect();
        let alive: Vec<_> = world.particles().ids().collect();
        let Ok(count @ 1..) = u32::try_from(alive.len()) else {
            return actions;
        };
        let any = |random: &mut Pcg| alive[random.below(count) as usize];
        actions.extend(
            (0..self.removes)
                .map(|_| Action::Remove { object: ObjectId::Particle(any(&mut random)) }),
        );
        actions.extend((0..self.links).map(|k| {
            let (ends, form) = ([any(&mut random), any(&mut random)], random.below(2));
            Action::SpawnDistance { token: k.into(), distance: link(world, ends, form) }
        }));
        actions.extend((0..self.impulses).map(|_| {
            let particle = any(&mut random);
            Action::Impulse { particle, impulse: draw_velocity(&mut random, self.speed) }
        }));
        actions
    }

    fn spawn(&self, random: &mut Pcg) -> ParticleSpec {
        let position = draw_point(random, self.min, self.max);
        let velocity = draw_velocity(random, self.speed);
        ParticleSpec::at(position).velocity(velocity).mass(self.mass.draw(random))
    }
}

/// A distance between two particles as they are.
fn link(world: &World, [a, b]: [ParticleId; 2], form: u32) -> Distance {
    let form = [DistanceForm::Exact, DistanceForm::StartOfStep][form as usize]; // 0 or 1
    as_placed(&Distance { a, b, form, ..Distance::default() }, |id| world.position(id))
}

impl Default for Storm {
    fn default() -> Self {
        Self {
            from: 0,
            until: 0,
            player: 0,
            spawns: 0,
            removes: 0,
            links: 0,
            impulses: 0,
            min: Vec3::ZERO,
            max: Vec3::ONE,
            speed: Real::ZERO,
            mass: Masses::default(),
        }
    }
}
