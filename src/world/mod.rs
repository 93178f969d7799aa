//! Floor 7: the world: all objects, their commands, and the step.

mod apply;
mod builder;
mod command;
mod config;
mod draw;
mod event;
mod state;
mod step;

use alloc::sync::Arc;
use alloc::vec::Vec;

pub use builder::WorldBuilder;
pub use command::{Action, Command, ObjectId};
pub use config::WorldConfig;
pub use draw::{Detail, DrawOptions, DrawSink, Shade};
pub use event::{Event, EventKind, Refusal};
pub(crate) use state::State;
use step::{Caches, Work};

use crate::body::{Face, FaceId};
use crate::constraint::{Distance, DistanceId, HalfSpace, HalfSpaceId, Volume, VolumeId};
use crate::math::{Pcg, Vec3};
use crate::particle::{ParticleId, ParticleSet};

/// A world of particles and constraints that is advanced tick by tick.
///
/// It is made by a [`WorldBuilder`], by a scene or from a snapshot. From then on it changes only
/// through [`step`](Self::step), `restore` and `clone_from`, so that a recording of its commands is
/// complete. `clone_from` reuses buffers: it is how a rollback game saves and restores.
#[derive(Debug)]
pub struct World {
    /// All that is saved and hashed.
    pub(crate) state: State,
    /// What happened in the last step.
    events: Vec<Event>,
    /// What the step derives from the objects.
    caches: Arc<Caches>,
    /// Buffers of the step: scratch.
    work: Work,
}

impl World {
    /// A world of this state, which has been validated.
    pub(crate) fn from_state(state: State) -> Self {
        Self { state, events: Vec::new(), caches: Arc::default(), work: Work::default() }
    }

    /// The number of ticks stepped so far, which is also the index of the next one.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.state.tick
    }

    /// The configuration in force.
    #[must_use]
    pub fn config(&self) -> &WorldConfig {
        &self.state.config
    }

    /// All particles.
    #[must_use]
    pub fn particles(&self) -> &ParticleSet {
        &self.state.particles
    }

    /// The particle's position in metres.
    #[must_use]
    pub fn position(&self, id: ParticleId) -> Option<Vec3> {
        self.state.particles.position(id)
    }

    /// The particle's velocity in m/s at the end of the last tick.
    ///
    /// It is the displacement of the last substep and half a substep of acceleration: what
    /// [`Action::SetVelocity`] set comes back. A particle that rests on a surface therefore reports
    /// `a h / 2`, two centimetres a second by default; one that cannot move reports its motion.
    #[must_use]
    pub fn velocity(&self, id: ParticleId) -> Option<Vec3> {
        let State { config, particles, .. } = &self.state;
        let particle = particles.particle(id)?;
        let displacement = particles.displacement[id.0.slot()];
        Some(config.pace().velocity(displacement, config.acceleration(particle)))
    }

    /// A distance constraint.
    #[must_use]
    pub fn distance(&self, id: DistanceId) -> Option<&Distance> {
        self.state.distances.get(id.0)
    }

    /// All distance constraints in order of their slots.
    pub fn distances(&self) -> impl Iterator<Item = (DistanceId, &Distance)> {
        self.state.distances.iter().map(|(handle, distance)| (DistanceId(handle), distance))
    }

    /// A half-space.
    #[must_use]
    pub fn half_space(&self, id: HalfSpaceId) -> Option<&HalfSpace> {
        self.state.half_spaces.get(id.0)
    }

    /// All half-spaces in order of their slots.
    pub fn half_spaces(&self) -> impl Iterator<Item = (HalfSpaceId, &HalfSpace)> {
        self.state.half_spaces.iter().map(|(handle, half_space)| (HalfSpaceId(handle), half_space))
    }

    /// A volume constraint.
    #[must_use]
    pub fn volume(&self, id: VolumeId) -> Option<&Volume> {
        self.state.volumes.get(id.0)
    }

    /// All volume constraints in order of their slots.
    pub fn volumes(&self) -> impl Iterator<Item = (VolumeId, &Volume)> {
        self.state.volumes.iter().map(|(handle, volume)| (VolumeId(handle), volume))
    }

    /// A face.
    #[must_use]
    pub fn face(&self, id: FaceId) -> Option<&Face> {
        self.state.faces.get(id.0)
    }

    /// All faces in order of their slots.
    pub fn faces(&self) -> impl Iterator<Item = (FaceId, &Face)> {
        self.state.faces.iter().map(|(handle, face)| (FaceId(handle), face))
    }

    /// What happened in the last step, ordered by kind and ids: nothing after `restore`, the
    /// source's after `clone_from`.
    ///
    /// Events carry their tick. A rollback game that steps a tick again gets its events again: show
    /// those of confirmed ticks once, those of predicted ticks as predictions.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// A random generator for the coming tick: a function of the state, the same on every peer,
    /// and independent of those of other ticks. Drawing from it does not change the world.
    #[must_use]
    pub fn random(&self) -> Pcg {
        let mut seed = self.state.random;
        Pcg::new(seed.next_u64(), self.state.tick)
    }

    /// Becomes the world of another state, which has been validated.
    pub(crate) fn replace_state(&mut self, state: State) {
        self.state = state;
        self.events.clear();
    }
}

impl Clone for World {
    fn clone(&self) -> Self {
        let Self { state, events, caches, work: _ } = self;
        let (state, events, caches) = (state.clone(), events.clone(), caches.clone());
        Self { state, events, caches, work: Work::default() }
    }

    /// Copies state, events and caches into the buffers that are there.
    fn clone_from(&mut self, source: &Self) {
        let Self { state, events, caches, work: _ } = source;
        self.state.clone_from(state);
        self.events.clone_from(events);
        self.caches.clone_from(caches);
    }
}
