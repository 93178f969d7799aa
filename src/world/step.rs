//! One tick.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::sync::Arc;
use alloc::vec::Vec;

use super::{Command, Event, EventKind, State, World};
use crate::body::{Air, Face, Gust};
use crate::constraint::{
    Carry, DistanceId, HalfSpace, Locals, Memories, Plan, Tear, Tearable, Tetrahedron, Touch,
    collide, settle,
};
use crate::math::wide::add;
use crate::particle::{Drive, Fault, Particle, ParticleId, ParticleSet, PinMotion, Substep};

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
    /// Cloth in 32 bits.
    locals: Locals,
    /// What compliant links have taken.
    taken: Vec<i64>,
    /// What the air does, and the motions that come of it.
    air: Air,
    gusts: Vec<Gust>,
}

/// What is derived from the objects. Shared by clones; unable to change a result.
#[derive(Clone, Debug, Default)]
pub(super) struct Caches {
    /// The constraints as the relaxation wants them.
    plan: Plan,
    /// The volume constraints as the relaxation wants them.
    volumes: Vec<Tetrahedron>,
    /// The distances that can tear.
    tearable: Vec<Tearable>,
    /// Which acceleration drives each particle.
    drive: Vec<Drive>,
    /// Substeps per second, on which compliant constraints depend.
    per_second: u32,
}

impl Caches {
    fn new(state: &State) -> Self {
        let State { config, particles, distances, volumes, .. } = state;
        let (particles, per_second) = (&particles.table, config.pace().per_second());
        let drive = |(index, row)| match particles.slots().tenant(index) {
            Some(_) => Drive::of(row),
            None => Drive::Still,
        };
        let drive = (0u32..).zip(particles.rows().iter()).map(drive).collect();
        let plan = Plan::new(distances, particles, per_second);
        let volumes = volumes.iter().filter_map(|(_, volume)| Tetrahedron::of(volume, particles));
        let (volumes, tearable) =
            (volumes.collect(), Tearable::all(distances, particles).collect());
        Self { plan, volumes, tearable, drive, per_second }
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
        self.tear();
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
        let State { config, particles, distances, volumes, .. } = &mut self.state;
        // All marks must be taken: no short circuit.
        let changed = particles.table.take_changed()
            | distances.take_changed()
            | volumes.take_changed()
            | (config.pace().per_second() != self.caches.per_second);
        if changed {
            self.caches = Arc::new(Caches::new(&self.state));
        }
        // Removed when the list of distances changed, otherwise as many as there are.
        self.state.carries.resize(self.caches.plan.carried(), Carry::default());
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

        let State { config, particles, faces, .. } = &*state;
        work.air.blow(faces, particles, config.wind, config.pace(), &mut work.gusts);
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
        for gust in &work.gusts {
            let position = &mut state.particles.position[gust.slot as usize];
            *position = add(*position, gust.motion(state.phase));
        }
        let left = config.substeps - index;
        let report = reporter(events, state.tick);
        state.particles.move_pins(&work.pin_motions, left, substep.displacement_max, report);
        state.phase = (state.phase + 1) % pace.phases();
    }

    /// Relaxes distances, volumes and half-spaces, `iterations` times.
    fn relax(&mut self) {
        self.work.taken.clear();
        self.work.taken.resize(self.caches.plan.giving(), 0);
        let mut left = self.state.config.iterations;
        while left > 0 {
            self.gather_cloth();
            let Self { state, work, caches, .. } = self;
            let Work { start, surfaces, locals, taken, touches, .. } = work;
            let (plan, position) = (&caches.plan, &mut state.particles.position);
            // Volumes and surfaces must find everything where it is after every relaxation.
            let free = surfaces.is_empty() && caches.volumes.is_empty();
            let passes = if free { left.min(plan.cloth().passes()) } else { 1 };
            for _ in 0..passes {
                locals.relax(plan.cloth());
                plan.relax(start, position, Memories { carries: &mut state.carries, taken });
            }
            locals.scatter(plan.cloth(), position);
            caches.volumes.iter().for_each(|volume| volume.relax(position));
            let moves = |slot: usize| caches.drive[slot] != Drive::Still;
            collide(surfaces, moves, start, position, touches);
            left -= passes;
        }
    }

    /// Takes cloth to 32 bits, but for what has grown too large.
    fn gather_cloth(&mut self) {
        let Self { state, work, caches, .. } = self;
        let State { particles, distances, .. } = state;
        while let Err(far) = work.locals.gather(caches.plan.cloth(), &particles.position) {
            let mut changed = Caches::clone(caches);
            let (plan, per_second) = (&mut changed.plan, caches.per_second);
            *plan = plan.with_far(far, distances, &particles.table, per_second);
            *caches = Arc::new(changed);
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

    /// Damages distances that are too long, and breaks those that stood enough. O(tearable), and
    /// O((faces + broken) log broken) when some break.
    fn tear(&mut self) {
        let mut broken = Vec::new();
        for tearable in &self.caches.tearable {
            let State { particles, distances, .. } = &mut self.state;
            let Some(distance) = distances.get(tearable.id.0) else { continue };
            let ends = [distance.a, distance.b];
            match tearable.tear(distance, &particles.position) {
                None => {}
                Some(Tear::Worn(damage)) => {
                    if let Some(row) = distances.adjust(tearable.id.0) {
                        row.damage = damage;
                    }
                }
                Some(Tear::Broken(damage)) => {
                    if let Some(row) = distances.get_mut(tearable.id.0) {
                        (row.damage, row.enabled) = (damage, false);
                    }
                    broken.push((tearable.id, ends));
                }
            }
        }
        for &(distance, _) in &broken {
            self.report(EventKind::Broken { distance });
        }
        if !broken.is_empty() {
            self.open_faces(&broken);
        }
    }

    /// Disables the faces along broken distances.
    fn open_faces(&mut self, broken: &[(DistanceId, [ParticleId; 2])]) {
        let edges: BTreeSet<_> = broken.iter().map(|&(_, [a, b])| [a.min(b), a.max(b)]).collect();
        let along = |face: &Face| face.edges().iter().any(|edge| edges.contains(edge));
        let open: Vec<_> = self
            .faces()
            .filter(|(_, face)| face.enabled && along(face))
            .map(|(id, _)| id)
            .collect();
        for id in open {
            if let Some(face) = self.state.faces.get_mut(id.0) {
                face.enabled = false;
            }
        }
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
