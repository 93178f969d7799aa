//! Many particles at random.

use core::iter;

use serde::Deserialize;

use super::number::{Masses, decimal, draw_point, shift, vector};
use super::shape::Shape;
use crate::constraint::Distance;
use crate::math::{Pcg, Real, Vec3};
use crate::particle::{ParticleSpec, RangeError, WORLD_LIMIT, check_in, check_within};

/// A cloud as a scene file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Cloud {
    count: u32,
    /// The box that holds it.
    #[serde(deserialize_with = "vector")]
    min: Vec3,
    #[serde(deserialize_with = "vector")]
    max: Vec3,
    /// No component of a velocity is faster, either way.
    #[serde(deserialize_with = "decimal")]
    speed: Real,
    mass: Masses,
    seed: u64,
}

impl Shape for Cloud {
    const SECTION: &'static str = "clouds";

    fn name_of(field: &'static str) -> &'static str {
        if field == "velocity" { "speed" } else { field }
    }

    fn shift(&mut self, origin: Vec3) -> Result<(), RangeError> {
        shift(&mut self.min, origin, "min")?;
        shift(&mut self.max, origin, "max")
    }

    fn validate(&self) -> Result<(), RangeError> {
        validate_box(self.min, self.max)?;
        self.mass.validate()?;
        validate_speed(self.speed)
    }

    fn count(&self) -> [u64; 2] {
        [u64::from(self.count), 0]
    }

    /// Clouds of one seed differ: each has a stream of its own. Stream 0 is the world's.
    fn particles(&self, number: u32) -> impl Iterator<Item = ParticleSpec> {
        let mut random = Pcg::new(self.seed, u64::from(number) + 1);
        (0..self.count).map(move |_| {
            let position = draw_point(&mut random, self.min, self.max);
            let velocity = draw_velocity(&mut random, self.speed);
            ParticleSpec::at(position).velocity(velocity).mass(self.mass.draw(&mut random))
        })
    }

    fn links(&self) -> impl Iterator<Item = [u32; 2]> {
        iter::empty()
    }

    fn link(&self) -> Distance {
        Distance::default()
    }
}

/// Both corners are inside the world and in order.
pub(super) fn validate_box(min: Vec3, max: Vec3) -> Result<(), RangeError> {
    check_within(min, WORLD_LIMIT, "min")?;
    let limit = Real::from_raw(WORLD_LIMIT);
    let sides = [(min.x, max.x), (min.y, max.y), (min.z, max.z)];
    sides.into_iter().try_for_each(|(min, max)| check_in(max, min..=limit, "max"))
}

/// A speed is not negative.
pub(super) fn validate_speed(speed: Real) -> Result<(), RangeError> {
    check_in(speed, Real::ZERO..=Real::MAX, "speed")
}

/// A velocity with components of at most `speed`, which is not negative.
pub(super) fn draw_velocity(random: &mut Pcg, speed: Real) -> Vec3 {
    let most = Vec3::new(speed, speed, speed);
    draw_point(random, -most, most)
}

impl Default for Cloud {
    fn default() -> Self {
        Self {
            count: 0,
            min: Vec3::ZERO,
            max: Vec3::ONE,
            speed: Real::ZERO,
            mass: Masses::default(),
            seed: 0,
        }
    }
}
