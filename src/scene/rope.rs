//! Particles in a line, each linked to the next.

use alloc::vec::Vec;

use serde::Deserialize;

use super::number::{Masses, decimal, shift, step, vector};
use super::shape::Shape;
use crate::constraint::{Distance, DistanceForm};
use crate::math::{Unit, Vec3};
use crate::particle::{ParticleSpec, RangeError, WORLD_LIMIT, check_in, check_within};

/// A rope as a scene file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Rope {
    #[serde(deserialize_with = "vector")]
    from: Vec3,
    #[serde(deserialize_with = "vector")]
    to: Vec3,
    /// At least 2.
    particles: u32,
    /// Of each particle; a pair goes evenly from the first to the last.
    mass: Masses,
    /// Which of its particles are pinned, counted from 0.
    pinned: Vec<u32>,
    #[serde(deserialize_with = "decimal")]
    stiffness: Unit,
    form: DistanceForm,
}

impl Shape for Rope {
    const SECTION: &'static str = "ropes";

    fn name_of(field: &'static str) -> &'static str {
        if field == "rest_length" { "to: a link" } else { field }
    }

    fn shift(&mut self, origin: Vec3) -> Result<(), RangeError> {
        shift(&mut self.from, origin, "from")?;
        shift(&mut self.to, origin, "to")
    }

    fn validate(&self) -> Result<(), RangeError> {
        check_within(self.from, WORLD_LIMIT, "from")?;
        check_within(self.to, WORLD_LIMIT, "to")?;
        if self.from == self.to {
            return Err(RangeError::coincident("to"));
        }
        check_in(self.particles, 2..=u32::MAX, "particles")?;
        self.mass.validate()?;
        let last = if cfg!(planted) { u32::MAX } else { self.particles - 1 };
        self.pinned.iter().try_for_each(|&place| check_in(place, 0..=last, "pinned"))
    }

    fn count(&self) -> [u64; 2] {
        let particles = u64::from(self.particles);
        [particles, particles.saturating_sub(1)]
    }

    fn particles(&self, _: u32) -> impl Iterator<Item = ParticleSpec> {
        // Both ends are within +-2^60, so is all between them.
        let (edge, steps) = (self.to - self.from, self.particles - 1);
        let mut specs: Vec<_> = (0..=steps)
            .map(|k| {
                let position = self.from + step(edge, k, steps);
                ParticleSpec::at(position).mass(self.mass.step(k, steps))
            })
            .collect();
        for &k in &self.pinned {
            specs[k as usize].particle.pinned = true; // u32 to usize is lossless
        }
        specs.into_iter()
    }

    fn links(&self) -> impl Iterator<Item = [u32; 2]> {
        (1..self.particles).map(|k| [k - 1, k])
    }

    fn link(&self) -> Distance {
        Distance::default().stiffness(self.stiffness).form(self.form)
    }
}

impl Default for Rope {
    fn default() -> Self {
        Self {
            from: Vec3::ZERO,
            to: Vec3::X,
            particles: 2,
            mass: Masses::default(),
            pinned: Vec::new(),
            stiffness: Unit::ONE,
            form: DistanceForm::default(),
        }
    }
}
