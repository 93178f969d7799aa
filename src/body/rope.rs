//! Ropes.

use alloc::vec::Vec;

use super::Assembly;
use super::tether::tethers;
use crate::constraint::{Distance, DistanceForm};
use crate::math::{Real, Unit, Vec3};
use crate::particle::{Particle, RangeError, WORLD_LIMIT, check_in, check_within};
use crate::real;

/// What a rope is like: particles in a line, each linked to the next.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rope {
    /// Of each particle, kilograms, 0.001 to 1,000,000. Default 0.1.
    pub mass: Real,
    /// Of the links, 0 to 1. Default 1.
    pub stiffness: Unit,
    /// Stiffness of the distances to the next but one particle, which resist bending, 0 to 1; 0 for
    /// none. Default 0.
    pub bending: Unit,
    /// Of all distances. Default [`DistanceForm::DivisionFree`].
    pub form: DistanceForm,
    /// Whether long-range attachments hold it to its pinned particles. Default `true`.
    pub attachments: bool,
}

impl Rope {
    /// The rope along these points, metres, with those pinned for which `pinned` says so.
    ///
    /// # Errors
    /// A point is outside of any world; two points that follow one another coincide, or are farther
    /// apart than [`Distance::REST_LENGTH_MAX`]; a number is out of its range.
    pub fn along(
        &self,
        points: &[Vec3],
        pinned: impl Fn(u32) -> bool,
    ) -> Result<Assembly, RangeError> {
        self.validate()?;
        points.iter().try_for_each(|&point| check_within(point, WORLD_LIMIT, "position"))?;
        let mut rope = Assembly {
            particles: Assembly::particles_at(points, self.mass, pinned),
            distances: self.links(points, 1, self.stiffness)?,
            ..Assembly::default()
        };
        let tethers = if self.attachments { tethers(&rope) } else { Vec::new() };
        if self.bending > Unit::ZERO {
            rope.distances.extend(self.links(points, 2, self.bending)?);
        }
        rope.distances.extend(tethers);
        Ok(rope)
    }

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { mass, stiffness, bending, form: _, attachments: _ } = *self;
        check_in(mass, Particle::MASS_MIN..=Particle::MASS_MAX, "mass")?;
        check_in(stiffness, Unit::ZERO..=Unit::ONE, "stiffness")?;
        check_in(bending, Unit::ZERO..=Unit::ONE, "bending")
    }

    /// Links from each point to the next, or to the `stride`-th.
    fn links(
        &self,
        points: &[Vec3],
        stride: usize,
        stiffness: Unit,
    ) -> Result<Vec<Distance>, RangeError> {
        let pairs = points.iter().zip(points.iter().skip(stride));
        let ends = (0u32..).zip(u32::try_from(stride).unwrap_or(u32::MAX)..);
        let link = |((a, b), (from, to)): ((&Vec3, &Vec3), (u32, u32))| {
            let length = Assembly::length(*a, *b)?;
            let link = Distance::new(Assembly::id(from), Assembly::id(to), length);
            Ok(link.form(self.form).stiffness(stiffness))
        };
        pairs.zip(ends).map(link).collect()
    }
}

impl Default for Rope {
    fn default() -> Self {
        Self {
            mass: real!("0.1"),
            stiffness: Unit::ONE,
            bending: Unit::ZERO,
            form: DistanceForm::DivisionFree,
            attachments: true,
        }
    }
}
