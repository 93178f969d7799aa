//! One tick.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::sync::Arc;
use alloc::vec::Vec;

use super::{Command, Event, EventKind, State, World};
use crate::constraint::{Carry, Distance, HalfSpace, Plan, Touch, collide, settle};
use crate::particle::{Drive, Fault, Particle, ParticleId, ParticleSet, PinMotion, Substep};
use crate::store::Table;

/// Buffers of one tick. Nothing in them outlives it, so they are neither saved nor cloned.
#[derive(Debug, Default)]
pub(super) struct Work {
    /// The commands in the order in which they are carried out.
    pub(super) commands: Vec<Command>,
    /// Accelerations by forces, 2^-40 m/s^2.
    pub(super) forces: BTreeMap<ParticleId, [i64; 3]>,
    /// Where pinned particles are moved to.
    pub(super) pins: BTreeMap<ParticleId, [i64; 3]>,
    /// Particles removed in this tick.
    pub(super) removed: BTreeSet<ParticleId>,
    /// Motions of the pins that are still pinned.
    pin_motions: Vec<PinMotion>,
    /// Forces on particles that can still move.
    pushes: Vec<(u32, [i64; 3])>,
    /// The half-spaces that are enabled.
    surfaces: Vec<HalfSpace>,
    /// Positions at the start of the substep.
    start: Vec<[i64; 3]>,
    touches: Vec<Touch>,
}

/// What is derived from the objects. Shared by clones; unable to change a result.
#[derive(Debug, Default)]
pub(super) struct Caches {
    /// The constraints as the relaxation wants them.
    plan: Plan,
    /// Which acceleration drives each particle.
    drive: Vec<Drive>,
}

impl Caches {
    fn new(particles: &Table<Particle>, distances: &Table<Distance>) -> Self {
        let drive = |(index, row)| match particles.slots().tenant(index) {
            Some(_) => Drive::of(row),
            None => Drive::Still,
        };
        let drive = (0u32..).zip(particles.rows().iter()).map(drive).collect();
        Self { plan: Plan::new(distances, particles), drive }
    }
}

impl World {
    /// Advances the world by one tick and returns what happened.
    ///
    /// Commands may come in any order; see [`Command`]. Whatever they contain, the step neither
    /// fails nor panics: what cannot be done is refused with an event.
    pub fn step(&mut self, commands: &[Command]) -> &[Event] {
        self.begin();
        self.apply(commands);
        self.remove_orphans();
        self.refresh_caches();
        self.gather();
        for substep in 0..self.state.config.substeps {
            self.integrate(substep);
            self.relax();
            self.close();
            self.settle_velocities();
            self.sort_events();
        }
        self.end();
        &self.events
    }

    fn begin(&mut self) {
        self.events.clear();
        self.work.forces.clear();
        self.work.pins.clear();
        self.state.random.next_u64();
    }

    /// Rebuilds what is derived from the objects, if they changed.
    fn refresh_caches(&mut self) {
        let State { particles, distances, carries, .. } = &mut self.state;
        // Both marks must be taken: no short circuit.
        if particles.table.take_changed() | distances.take_changed() {
            self.caches = Arc::new(Caches::new(&particles.table, distances));
        }
        // Removed when the list of distances changed, otherwise as many as there are.
        carries.resize(self.caches.plan.carried(), Carry::default());
    }

    /// Collects what acts in all substeps of this tick.
    fn gather(&mut self) {
        let Self { state, work, .. } = self;
        let row = |id: &ParticleId| state.particles.particle(*id);
        let pinned = |id: &ParticleId| row(id).is_some_and(|row| row.pinned && row.enabled);
        let pins = work.pins.iter().filter(|(id, _)| pinned(id));
        work.pin_motions.clear();
        work.pin_motions
            .extend(pins.map(|(id, target)| PinMotion { particle: *id, target: *target }));
        let movable = |id: &ParticleId| row(id).is_some_and(Particle::is_movable);
        let forces = work.forces.iter().filter(|(id, _)| movable(id));
        work.pushes.clear();
        work.pushes.extend(forces.map(|(id, acceleration)| (id.0.index, *acceleration)));

        let active = state.half_spaces.iter().filter(|(_, shape)| shape.enabled);
        work.surfaces.clear();
        work.surfaces.extend(active.map(|(_, shape)| *shape));
    }

    /// Verlet integration; pinned particles follow their targets.
    fn integrate(&mut self, index: u32) {
        let Self { state, work, caches, events } = self;
        let config = &state.config;
        let pace = config.pace();
        let substep = Substep {
            pace,
            phase: state.phase,
            gravity: config.gravity.raw(),
            damping: config.damping_per_substep(),
            displacement_max: config.displacement_max.raw(),
        };
        let report = reporter(events, state.tick);
        state.particles.integrate(&substep, &caches.drive, &mut work.start, report);
        state.particles.push(&substep, &work.pushes);
        let left = config.substeps - index;
        let report = reporter(events, state.tick);
        state.particles.move_pins(&work.pin_motions, left, substep.displacement_max, report);
        state.phase = (state.phase + 1) % pace.phases();
    }

    /// Relaxes distances and half-spaces, `iterations` times.
    fn relax(&mut self) {
        let Self { state, work, caches, .. } = self;
        let position = &mut state.particles.position;
        let moves = |slot: usize| caches.drive[slot] != Drive::Still;
        for _ in 0..state.config.iterations {
            caches.plan.relax(&work.start, position, &mut state.carries);
            collide(&work.surfaces, moves, &work.start, position, &mut work.touches);
        }
    }

    /// What was moved becomes displacement, within the limits.
    fn close(&mut self) {
        let Self { state, work, events, .. } = self;
        let limit = state.config.displacement_max.raw();
        state.particles.close(&work.start, limit, reporter(events, state.tick));
    }

    /// Contacts decide with which velocity their particles leave; positions stay.
    fn settle_velocities(&mut self) {
        let Self { state, work, events, .. } = self;
        let State { tick, config, particles, .. } = state;
        let ParticleSet { table, displacement, .. } = particles;
        let mut report = reporter(events, *tick);
        settle(
            &work.surfaces,
            |slot, surface| config.bounce_min(&table.rows()[slot], surface),
            &mut work.touches,
            displacement,
            config.displacement_max.raw(),
            |index| {
                if let Some(handle) = table.slots().tenant(index) {
                    report(ParticleId(handle), Fault::DisplacementClamped);
                }
            },
        );
    }

    /// Once a substep, so that what happens in every one of them takes no more room.
    fn sort_events(&mut self) {
        self.events.sort_unstable();
        self.events.dedup();
    }

    fn end(&mut self) {
        self.sort_events();
        self.state.tick += 1;
    }

    pub(super) fn report(&mut self, kind: EventKind) {
        self.events.push(Event { tick: self.state.tick, kind });
    }
}

/// Makes events of what the limits of the world stopped.
fn reporter(events: &mut Vec<Event>, tick: u64) -> impl FnMut(ParticleId, Fault) {
    move |particle, fault| {
        let kind = match fault {
            Fault::DisplacementClamped => EventKind::DisplacementClamped { particle },
            Fault::WorldLimit => EventKind::WorldLimit { particle },
        };
        events.push(Event { tick, kind });
    }
}
