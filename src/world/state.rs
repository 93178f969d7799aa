//! All that is saved and hashed.

use alloc::vec::Vec;

use super::{Refusal, WorldConfig};
use crate::body::{FACES_MAX, Face, FaceId};
use crate::constraint::{
    CARRY_MAX, Carry, DISTANCES_MAX, Distance, DistanceId, HALF_SPACES_MAX, HalfSpace, HalfSpaceId,
    VOLUMES_MAX, Volume, VolumeId,
};
use crate::math::Pcg;
use crate::particle::{PARTICLES_MAX, ParticleId, ParticleSet, ParticleSpec, RangeError, check};
use crate::store::Table;

/// Everything whose loss would change the next tick or the next event; nothing else.
#[derive(Debug)]
pub(crate) struct State {
    pub(crate) tick: u64,
    /// Counts substeps modulo [`Pace::phases`](crate::particle::Pace::phases).
    pub(crate) phase: u64,
    pub(crate) config: WorldConfig,
    pub(crate) random: Pcg,
    pub(crate) particles: ParticleSet,
    pub(crate) distances: Table<Distance>,
    /// One for each distance that is carried, in slot order; none after their list changed.
    pub(crate) carries: Vec<Carry>,
    pub(crate) half_spaces: Table<HalfSpace>,
    pub(crate) volumes: Table<Volume>,
    pub(crate) faces: Table<Face>,
}

/// No snapshot is later, so that ticks can be counted on from it for ever.
const TICK_MAX: u64 = u64::MAX >> 1;

/// The stream of the world's generator among all of its seed.
const RANDOM_STREAM: u64 = 0;

impl State {
    pub(super) fn new(config: WorldConfig) -> Self {
        Self {
            tick: 0,
            phase: 0,
            config,
            random: Pcg::new(0, RANDOM_STREAM),
            particles: ParticleSet::default(),
            distances: Table::default(),
            carries: Vec::new(),
            half_spaces: Table::default(),
            volumes: Table::default(),
            faces: Table::default(),
        }
    }

    pub(super) fn seed(&mut self, seed: u64) {
        self.random = Pcg::new(seed, RANDOM_STREAM);
    }

    pub(super) fn spawn_particle(&mut self, spec: &ParticleSpec) -> Result<ParticleId, Refusal> {
        spec.validate()?;
        let ParticleSpec { position, velocity, particle } = spec;
        if !self.particles.table.slots().has_room(PARTICLES_MAX) {
            return Err(Refusal::Full);
        }
        let displacement = self.displacement_for(velocity.raw(), particle)?;
        Ok(self.particles.insert(position.raw(), displacement, *particle))
    }

    pub(super) fn spawn_distance(&mut self, distance: &Distance) -> Result<DistanceId, Refusal> {
        distance.validate()?;
        self.alive(&[distance.a], "a")?;
        self.alive(&[distance.b], "b")?;
        if !self.distances.slots().has_room(DISTANCES_MAX) {
            return Err(Refusal::Full);
        }
        self.carries.clear();
        Ok(DistanceId(self.distances.insert(*distance)))
    }

    /// Whether all of these particles are alive; `field` names them.
    fn alive(&self, ids: &[ParticleId], field: &'static str) -> Result<(), Refusal> {
        let alive = ids.iter().all(|&id| self.particles.contains(id));
        if alive { Ok(()) } else { Err(Refusal::Stale { field }) }
    }

    pub(super) fn spawn_volume(&mut self, volume: &Volume) -> Result<VolumeId, Refusal> {
        volume.validate()?;
        self.alive(&volume.corners, "corners")?;
        if !self.volumes.slots().has_room(VOLUMES_MAX) {
            return Err(Refusal::Full);
        }
        Ok(VolumeId(self.volumes.insert(*volume)))
    }

    pub(super) fn spawn_face(&mut self, face: &Face) -> Result<FaceId, Refusal> {
        face.validate()?;
        self.alive(&face.corners, "corners")?;
        if !self.faces.slots().has_room(FACES_MAX) {
            return Err(Refusal::Full);
        }
        Ok(FaceId(self.faces.insert(*face)))
    }

    /// Removes a distance; `false` if the id is stale.
    pub(super) fn remove_distance(&mut self, id: DistanceId) -> bool {
        let removed = self.distances.remove(id.0).is_some();
        if removed {
            self.carries.clear();
        }
        removed
    }

    /// The number of distances that are carried. O(distances).
    fn carried(&self) -> usize {
        self.distances.iter().filter(|(_, distance)| distance.is_carried()).count()
    }

    pub(super) fn spawn_half_space(&mut self, shape: &HalfSpace) -> Result<HalfSpaceId, Refusal> {
        shape.validate()?;
        if !self.half_spaces.slots().has_room(HALF_SPACES_MAX) {
            return Err(Refusal::Full);
        }
        Ok(HalfSpaceId(self.half_spaces.insert(*shape)))
    }

    /// The displacement with which a particle takes up a velocity.
    pub(super) fn displacement_for(
        &self,
        velocity: [i64; 3],
        particle: &crate::particle::Particle,
    ) -> Result<[i32; 3], RangeError> {
        if !particle.is_movable() {
            return Ok([0; 3]);
        }
        let limit = self.config.displacement_max.raw();
        let acceleration = self.config.acceleration(particle);
        let start = self.config.pace().start(velocity, acceleration, limit);
        start.ok_or(RangeError::new("velocity"))
    }

    /// Checks what the first record of a snapshot holds.
    pub(crate) fn validate_world(&self) -> Result<(), RangeError> {
        let Self { tick, phase, config, random, .. } = self;
        check(*tick <= TICK_MAX, "tick")?;
        config.validate()?;
        check(*phase < config.pace().phases(), "phase")?;
        // An even increment could make a draw without bias loop for ever.
        check(random.state()[1] % 2 == 1, "random.increment")
    }

    /// Checks the particles against the configuration.
    pub(crate) fn validate_particles(&self) -> Result<(), RangeError> {
        check(self.particles.position.len() <= PARTICLES_MAX, "particle count")?;
        self.particles.validate(self.config.displacement_max.raw())
    }

    /// Checks the distance constraints and that their ends are alive.
    pub(crate) fn validate_distances(&self) -> Result<(), RangeError> {
        check(self.distances.rows().len() <= DISTANCES_MAX, "distance count")?;
        self.distances.iter().try_for_each(|(_, distance)| {
            check(self.particles.contains(distance.a), "a")?;
            check(self.particles.contains(distance.b), "b")?;
            distance.validate()
        })
    }

    /// Checks what rounding left over: all of it, or nothing.
    pub(crate) fn validate_carries(&self) -> Result<(), RangeError> {
        let complete = self.carries.is_empty() || self.carries.len() == self.carried();
        check(complete, "carry count")?;
        let small = |c: &i16| c.unsigned_abs() <= CARRY_MAX.unsigned_abs();
        check(self.carries.iter().flatten().flatten().all(small), "carry")
    }

    /// Checks the volume constraints and that their corners are alive.
    pub(crate) fn validate_volumes(&self) -> Result<(), RangeError> {
        check(self.volumes.rows().len() <= VOLUMES_MAX, "volume count")?;
        self.volumes.iter().try_for_each(|(_, volume)| {
            check(volume.corners.iter().all(|&id| self.particles.contains(id)), "corners")?;
            volume.validate()
        })
    }

    /// Checks the faces and that their corners are alive.
    pub(crate) fn validate_faces(&self) -> Result<(), RangeError> {
        check(self.faces.rows().len() <= FACES_MAX, "face count")?;
        self.faces.iter().try_for_each(|(_, face)| {
            check(face.corners.iter().all(|&id| self.particles.contains(id)), "corners")?;
            face.validate()
        })
    }

    /// Checks the half-spaces.
    pub(crate) fn validate_half_spaces(&self) -> Result<(), RangeError> {
        check(self.half_spaces.rows().len() <= HALF_SPACES_MAX, "half-space count")?;
        self.half_spaces.iter().try_for_each(|(_, half_space)| half_space.validate())
    }
}

impl Clone for State {
    fn clone(&self) -> Self {
        let mut clone = Self::new(self.config);
        clone.clone_from(self);
        clone
    }

    fn clone_from(&mut self, source: &Self) {
        // All of it, so that no field can be forgotten.
        #[rustfmt::skip]
        let Self {
            tick, phase, config, random, particles, distances, carries, half_spaces, volumes, faces,
        } = source;
        self.tick = *tick;
        self.phase = *phase;
        self.config = *config;
        self.random = *random;
        self.particles.clone_from(particles);
        self.distances.clone_from(distances);
        self.carries.clone_from(carries);
        self.half_spaces.clone_from(half_spaces);
        self.volumes.clone_from(volumes);
        self.faces.clone_from(faces);
    }
}
