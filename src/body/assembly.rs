//! Parts that are put into a world together.

use alloc::vec::Vec;

use super::Face;
use crate::constraint::{Distance, Volume};
use crate::math::{Real, Vec3};
use crate::particle::{ParticleId, ParticleSpec, RangeError, check_in};
use crate::store::Handle;

/// Particles, and what holds them together.
///
/// Parts name particles by [`Assembly::id`], their places in `particles`; whoever puts the assembly
/// into a world gives them the ids that they have there.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Assembly {
    /// In the order in which they are added.
    pub particles: Vec<ParticleSpec>,
    /// Added after the particles.
    pub distances: Vec<Distance>,
    /// Added after the distances.
    pub volumes: Vec<Volume>,
    /// Added last.
    pub faces: Vec<Face>,
}

impl Assembly {
    /// The id by which parts of an assembly name its particle of this place.
    #[must_use]
    pub const fn id(place: u32) -> ParticleId {
        ParticleId(Handle::new(place, 1))
    }

    /// Particles of one mass at these places, those pinned for which `pinned` says so.
    pub(super) fn particles_at(
        places: &[Vec3],
        mass: Real,
        pinned: impl Fn(u32) -> bool,
    ) -> Vec<ParticleSpec> {
        let particle = |(place, &position): (u32, _)| {
            let mut spec = ParticleSpec::at(position).mass(mass);
            spec.particle.pinned = pinned(place);
            spec
        };
        (0u32..).zip(places).map(particle).collect()
    }

    /// The length of a distance between two places, which must not coincide.
    pub(super) fn length(a: Vec3, b: Vec3) -> Result<Real, RangeError> {
        let length = a.distance(b);
        if length == Real::ZERO {
            return Err(RangeError::coincident("rest_length"));
        }
        check_in(length, Real::ULP..=Distance::REST_LENGTH_MAX, "rest_length")?;
        Ok(length)
    }

    /// The parts with other ids for their particles; `None` for a part that names none of them.
    pub(crate) fn renamed(
        &self,
        ids: &[ParticleId],
    ) -> Option<(Vec<Distance>, Vec<Volume>, Vec<Face>)> {
        let name = |id: ParticleId| {
            let own = id.0.generation == 1;
            ids.get(id.0.slot()).filter(|_| own).copied()
        };
        let distances = self.distances.iter().map(|distance| {
            let (a, b) = (name(distance.a)?, name(distance.b)?);
            Some(Distance { a, b, ..*distance })
        });
        let volumes = self.volumes.iter().map(|volume| {
            let [a, b, c, d] = volume.corners.map(name);
            Some(Volume { corners: [a?, b?, c?, d?], ..*volume })
        });
        let faces = self.faces.iter().map(|face| {
            let [a, b, c] = face.corners.map(name);
            Some(Face { corners: [a?, b?, c?], ..*face })
        });
        Some((
            distances.collect::<Option<_>>()?,
            volumes.collect::<Option<_>>()?,
            faces.collect::<Option<_>>()?,
        ))
    }
}
