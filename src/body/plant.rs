//! Plants from meshes.

use super::{Assembly, Cloth};
use crate::constraint::{Distance, DistanceForm};
use crate::geometry::TriangleMesh;
use crate::math::{Factor, Real, Unit, Vec3};
use crate::particle::{ParticleSpec, RangeError, check_in};
use crate::real;
use crate::store::slot_index;

/// What a plant is like: cloth that stands, since every vertex springs back to its place.
///
/// Three stakes, pinned particles around the roots, hold each vertex by compliant distances: three
/// lengths fix a place. High up they pull at a flat angle and by a long lever, so that a plant
/// bends from its roots to its tips.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Plant {
    /// Its edges and faces, like those of a cloth; long-range attachments are not used.
    pub cloth: Cloth,
    /// Metres a newton by which the distances to the stakes give, 0 to 1, more than 0 for a plant
    /// that moves. Default 0.5.
    pub compliance: Unit,
    /// How far the stakes stand from the middle of the roots, metres, more than 0 and at
    /// most 1,024. Default 1.
    pub spread: Real,
}

impl Plant {
    /// The plant of a mesh, with the vertices rooted for which `rooted` says so. O(n log n).
    ///
    /// Its particles are the vertices, then the three stakes.
    ///
    /// # Errors
    /// A distance is longer than [`Distance::REST_LENGTH_MAX`], no vertex is rooted, or a number is
    /// out of its range.
    pub fn of(
        &self,
        mesh: &TriangleMesh,
        rooted: impl Fn(u32) -> bool,
    ) -> Result<Assembly, RangeError> {
        self.validate()?;
        let cloth = Cloth { attachments: false, ..self.cloth };
        let mut plant = cloth.of(mesh, &rooted)?;
        let first = plant.particles.iter().find(|spec| spec.particle.pinned);
        let middle = first.ok_or(RangeError::empty("rooted"))?.position;
        let stakes = self.stakes(middle);
        let count = plant.particles.len();
        for (vertex, spec) in (0u32..).zip(&plant.particles[..count]) {
            if spec.particle.pinned {
                continue;
            }
            for (stake, &at) in (0u32..).zip(&stakes) {
                let length = Assembly::length(spec.position, at)?;
                let stake = Assembly::id(slot_index(count) + stake);
                let hold = Distance::new(stake, Assembly::id(vertex), length);
                let hold = hold.form(DistanceForm::Exact).compliance(self.compliance);
                plant.distances.push(hold);
            }
        }
        plant.particles.extend(stakes.map(|at| ParticleSpec::at(at).pinned()));
        Ok(plant)
    }

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        self.cloth.validate()?;
        check_in(self.compliance, Unit::ZERO..=Unit::ONE, "compliance")?;
        check_in(self.spread, Real::ULP..=Distance::REST_LENGTH_MAX, "spread")
    }

    /// Corners of a triangle around the middle of the roots, level with it.
    fn stakes(&self, middle: Vec3) -> [Vec3; 3] {
        let (one, half) = (self.spread, Real::from_raw(self.spread.raw() / 2));
        // 0.866 of the spread: 7/8 are near enough.
        let side = Real::from_raw(self.spread.raw() / 8 * 7);
        let place = |x, z| middle + Vec3::new(x, Real::ZERO, z);
        [place(one, Real::ZERO), place(-half, side), place(-half, -side)]
    }
}

impl Default for Plant {
    fn default() -> Self {
        let cloth = Cloth { attachments: false, drag: Factor::ONE, ..Cloth::default() };
        let compliance = Unit::from_raw(Unit::ONE.raw() / 2);
        Self { cloth, compliance, spread: real!("1") }
    }
}
