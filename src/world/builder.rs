//! A world before its first tick.

use alloc::vec::Vec;

use super::{Refusal, State, World, WorldConfig};
use crate::body::{Assembly, Face, FaceId};
use crate::constraint::{Distance, DistanceId, HalfSpace, HalfSpaceId, Volume, VolumeId};
use crate::particle::{ParticleId, ParticleSpec, RangeError};

/// Fills a world. The order of creation decides ids and colours: it is part of what peers must
/// agree on.
#[derive(Clone, Debug)]
pub struct WorldBuilder {
    state: State,
}

impl WorldBuilder {
    /// An empty world.
    ///
    /// # Errors
    /// Names the first field of the configuration that is out of its range.
    pub fn new(config: WorldConfig) -> Result<Self, RangeError> {
        config.validate()?;
        Ok(Self { state: State::new(config) })
    }

    /// Seeds the world's random generator (0 if this is not called).
    pub fn seed(&mut self, seed: u64) {
        self.state.seed(seed);
    }

    /// Adds a particle.
    ///
    /// # Errors
    /// A number out of its range, or too many particles; nothing was added then.
    pub fn particle(&mut self, spec: &ParticleSpec) -> Result<ParticleId, Refusal> {
        self.state.spawn_particle(spec)
    }

    /// Adds a distance constraint.
    ///
    /// # Errors
    /// A stale id, a number out of its range, or too many constraints; nothing was added then.
    pub fn distance(&mut self, distance: &Distance) -> Result<DistanceId, Refusal> {
        self.state.spawn_distance(distance)
    }

    /// Adds a half-space.
    ///
    /// # Errors
    /// A number out of its range, or too many half-spaces; nothing was added then.
    pub fn half_space(&mut self, half_space: &HalfSpace) -> Result<HalfSpaceId, Refusal> {
        self.state.spawn_half_space(half_space)
    }

    /// Adds a volume constraint.
    ///
    /// # Errors
    /// A stale id, a number out of its range, or too many constraints; nothing was added then.
    pub fn volume(&mut self, volume: &Volume) -> Result<VolumeId, Refusal> {
        self.state.spawn_volume(volume)
    }

    /// Adds a face.
    ///
    /// # Errors
    /// A stale id, a number out of its range, or too many faces; nothing was added then.
    pub fn face(&mut self, face: &Face) -> Result<FaceId, Refusal> {
        self.state.spawn_face(face)
    }

    /// Adds all parts of an assembly; returns the ids of its particles, in their order.
    ///
    /// # Errors
    /// The first part that the world refuses, or that names no particle of the assembly; nothing
    /// was added then.
    pub fn assemble(&mut self, assembly: &Assembly) -> Result<Vec<ParticleId>, Refusal> {
        let mut state = self.state.clone();
        let add = |spec: &ParticleSpec| state.spawn_particle(spec);
        let ids: Vec<_> = assembly.particles.iter().map(add).collect::<Result<_, _>>()?;
        let stale = Refusal::Stale { field: "assembly" };
        let (distances, volumes, faces) = assembly.renamed(&ids).ok_or(stale)?;
        distances.iter().try_for_each(|distance| state.spawn_distance(distance).map(drop))?;
        volumes.iter().try_for_each(|volume| state.spawn_volume(volume).map(drop))?;
        faces.iter().try_for_each(|face| state.spawn_face(face).map(drop))?;
        self.state = state;
        Ok(ids)
    }

    /// The world at tick 0.
    #[must_use]
    pub fn build(self) -> World {
        World::from_state(self.state)
    }
}
