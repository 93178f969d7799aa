//! Carrying out the commands of a tick.

use alloc::vec::Vec;

use super::{Action, Command, EventKind, ObjectId, Refusal, World, WorldConfig};
use crate::math::Vec3;
use crate::math::wide::{add, round_div_wide, to_i32, to_i64};
use crate::particle::{
    Pace, Particle, ParticleId, RangeError, WORLD_LIMIT, check_within, clamp_longest,
};

type Done = Result<(), Refusal>;

impl World {
    /// Carries out the commands in order of player and sequence.
    pub(super) fn apply(&mut self, commands: &[Command]) {
        let mut sorted = core::mem::take(&mut self.work.commands);
        sorted.clear();
        sorted.extend_from_slice(commands);
        sorted.sort_unstable();
        for Command { player, sequence, action } in &sorted {
            if let Err(why) = self.act(action) {
                let (player, sequence) = (*player, *sequence);
                self.report(EventKind::Refused { player, sequence, why });
            }
        }
        self.work.commands = sorted;
    }

    fn act(&mut self, action: &Action) -> Done {
        match action {
            Action::SpawnParticle { token, spec } => {
                let object = ObjectId::Particle(self.state.spawn_particle(spec)?);
                self.report(EventKind::Spawned { token: *token, object });
            }
            Action::SpawnDistance { token, distance } => {
                let object = ObjectId::Distance(self.state.spawn_distance(distance)?);
                self.report(EventKind::Spawned { token: *token, object });
            }
            Action::SpawnHalfSpace { token, half_space } => {
                let object = ObjectId::HalfSpace(self.state.spawn_half_space(half_space)?);
                self.report(EventKind::Spawned { token: *token, object });
            }
            Action::Remove { object } => self.remove(*object)?,
            Action::Force { particle, force } => self.force(*particle, *force)?,
            Action::Impulse { particle, impulse } => self.impulse(*particle, *impulse)?,
            Action::SetVelocity { particle, velocity } => {
                let row = *self.movable(*particle)?;
                let displacement = self.state.displacement_for(velocity.raw(), &row)?;
                self.state.particles.displacement[particle.0.slot()] = displacement;
            }
            Action::SetAcceleration { particle, acceleration } => {
                self.edit(*particle, |row| row.acceleration = *acceleration)?;
            }
            Action::SetMass { particle, mass } => self.edit(*particle, |row| row.mass = *mass)?,
            Action::SetGravityScale { particle, scale } => {
                self.edit(*particle, |row| row.gravity_scale = *scale)?;
            }
            Action::SetPinned { particle, pinned } => {
                self.edit(*particle, |row| row.pinned = *pinned)?;
            }
            Action::MovePin { particle, target } => self.move_pin(*particle, *target)?,
            Action::Teleport { particle, position } => {
                self.row(*particle)?;
                check_within(*position, WORLD_LIMIT, "position")?;
                self.state.particles.position[particle.0.slot()] = position.raw();
            }
            Action::SetRestLength { distance, rest_length } => {
                let stale = Refusal::Stale { field: "distance" };
                let mut row = *self.state.distances.get(distance.0).ok_or(stale)?;
                let is_rope = row.slack == row.rest_length;
                row.rest_length = *rest_length;
                row.slack = if is_rope { *rest_length } else { row.slack.min(*rest_length) };
                row.validate()?;
                self.state.distances.set(distance.0, row);
            }
            Action::SetEnabled { object, enabled } => self.set_enabled(*object, *enabled)?,
            Action::SetUser { object, user } => self.set_user(*object, *user)?,
            Action::Configure { config } => self.configure(config)?,
            Action::SpawnVolume { token, volume } => {
                let object = ObjectId::Volume(self.state.spawn_volume(volume)?);
                self.report(EventKind::Spawned { token: *token, object });
            }
            Action::SpawnFace { token, face } => {
                let object = ObjectId::Face(self.state.spawn_face(face)?);
                self.report(EventKind::Spawned { token: *token, object });
            }
            Action::SetWind { wind } => {
                let config = WorldConfig { wind: *wind, ..self.state.config };
                config.validate()?;
                self.state.config = config;
            }
        }
        Ok(())
    }

    fn row(&self, id: ParticleId) -> Result<&Particle, Refusal> {
        self.state.particles.particle(id).ok_or(Refusal::Stale { field: "particle" })
    }

    fn movable(&self, id: ParticleId) -> Result<&Particle, Refusal> {
        let row = self.row(id)?;
        if row.is_movable() { Ok(row) } else { Err(Refusal::NotMovable) }
    }

    /// Changes a particle's properties if the result is valid.
    fn edit(&mut self, id: ParticleId, change: impl FnOnce(&mut Particle)) -> Done {
        let before = *self.row(id)?;
        let mut row = before;
        change(&mut row);
        row.validate()?;
        let config = self.state.config;
        let accelerations = [&before, &row].map(|row| config.acceleration(row));
        self.state.particles.table.set(id.0, row);
        self.hand_over(id, [config.pace(); 2], accelerations);
        Ok(())
    }

    /// Keeps the velocity of a particle whose pace or acceleration changed.
    fn hand_over(&mut self, id: ParticleId, [old, new]: [Pace; 2], [before, after]: [[i64; 3]; 2]) {
        let displacement = self.state.particles.displacement[id.0.slot()];
        let kept = if (old, before) == (new, after) {
            displacement.map(i64::from)
        } else {
            old.convert(displacement, before, new, after)
        };
        self.set_displacement(id, kept);
    }

    /// Sets a displacement of at most 2^61, cut to the maximum with an event.
    fn set_displacement(&mut self, id: ParticleId, displacement: [i64; 3]) {
        let cut = clamp_longest(displacement, self.state.config.displacement_max.raw());
        let kept = cut.unwrap_or(displacement).map(to_i32); // at most 2^30
        self.state.particles.displacement[id.0.slot()] = kept;
        if cut.is_some() {
            self.report(EventKind::DisplacementClamped { particle: id });
        }
    }

    fn remove(&mut self, object: ObjectId) -> Done {
        let stale = Refusal::Stale { field: "object" };
        let removed = match object {
            ObjectId::Particle(id) => self.state.particles.remove(id),
            ObjectId::Distance(id) => self.state.remove_distance(id),
            ObjectId::HalfSpace(id) => self.state.half_spaces.remove(id.0).is_some(),
            ObjectId::Volume(id) => self.state.volumes.remove(id.0).is_some(),
            ObjectId::Face(id) => self.state.faces.remove(id.0).is_some(),
        };
        if !removed {
            return Err(stale);
        }
        self.report(EventKind::Removed { object });
        if let ObjectId::Particle(gone) = object {
            self.work.removed.insert(gone);
        }
        Ok(())
    }

    /// Removes what needed particles that were removed in this tick. O(objects).
    pub(super) fn remove_orphans(&mut self) {
        if self.work.removed.is_empty() {
            return;
        }
        let removed = core::mem::take(&mut self.work.removed);
        let needs = |ids: &[ParticleId]| ids.iter().any(|id| removed.contains(id));
        let distances = self.distances().filter(|(_, distance)| needs(&[distance.a, distance.b]));
        let volumes = self.volumes().filter(|(_, volume)| needs(&volume.corners));
        let faces = self.faces().filter(|(_, face)| needs(&face.corners));
        let distances = distances.map(|(id, _)| ObjectId::from(id));
        let volumes = volumes.map(|(id, _)| ObjectId::from(id));
        let faces = faces.map(|(id, _)| ObjectId::from(id));
        let orphans: Vec<_> = distances.chain(volumes).chain(faces).collect();
        for object in orphans {
            let done = self.remove(object);
            debug_assert!(done.is_ok(), "{object} was alive");
        }
    }

    fn force(&mut self, id: ParticleId, force: Vec3) -> Done {
        let mass = i128::from(self.movable(id)?.mass.raw());
        // a in 2^-40: F 2^40 / m, both raw: 63 + 40 bits.
        let acceleration = force.raw().map(|f| round_div_wide(i128::from(f) << 40, mass));
        let before = self.work.forces.get(&id).copied().unwrap_or_default();
        let limit = i128::from(Particle::ACCELERATION_MAX.raw()) << 16;
        let mut sum = [0; 3];
        for k in 0..3 {
            let total = i128::from(before[k]) + acceleration[k];
            if total.abs() > limit {
                return Err(RangeError::new("force").into());
            }
            sum[k] = to_i64(total); // within the limit, below 2^58
        }
        self.work.forces.insert(id, sum);
        Ok(())
    }

    fn impulse(&mut self, id: ParticleId, impulse: Vec3) -> Done {
        let mass = self.movable(id)?.mass;
        let kick = self.state.config.pace().kick(impulse.raw(), mass);
        let displacement = self.state.particles.displacement[id.0.slot()];
        self.set_displacement(id, add(displacement.map(i64::from), kick));
        Ok(())
    }

    fn move_pin(&mut self, id: ParticleId, target: Vec3) -> Done {
        let row = self.row(id)?;
        if !(row.pinned && row.enabled) {
            return Err(Refusal::NotPinned);
        }
        check_within(target, WORLD_LIMIT, "target")?;
        self.work.pins.insert(id, target.raw());
        Ok(())
    }

    fn set_enabled(&mut self, object: ObjectId, enabled: bool) -> Done {
        match object {
            ObjectId::Particle(id) => return self.edit(id, |row| row.enabled = enabled),
            ObjectId::Distance(id) => {
                self.state.distances.get_mut(id.0).map(|row| row.enabled = enabled)
            }
            ObjectId::HalfSpace(id) => {
                self.state.half_spaces.get_mut(id.0).map(|row| row.enabled = enabled)
            }
            ObjectId::Volume(id) => {
                self.state.volumes.get_mut(id.0).map(|row| row.enabled = enabled)
            }
            ObjectId::Face(id) => self.state.faces.get_mut(id.0).map(|row| row.enabled = enabled),
        }
        .ok_or(Refusal::Stale { field: "object" })
    }

    fn set_user(&mut self, object: ObjectId, user: u64) -> Done {
        match object {
            ObjectId::Particle(id) => return self.edit(id, |row| row.user = user),
            ObjectId::Distance(id) => self.state.distances.get_mut(id.0).map(|row| row.user = user),
            ObjectId::HalfSpace(id) => {
                self.state.half_spaces.get_mut(id.0).map(|row| row.user = user)
            }
            ObjectId::Volume(id) => self.state.volumes.get_mut(id.0).map(|row| row.user = user),
            ObjectId::Face(id) => self.state.faces.get_mut(id.0).map(|row| row.user = user),
        }
        .ok_or(Refusal::Stale { field: "object" })
    }

    /// Velocities survive; what then exceeds the new maximum is cut. O(particles).
    fn configure(&mut self, config: &WorldConfig) -> Done {
        config.validate()?;
        let old = core::mem::replace(&mut self.state.config, *config);
        let paces = [old.pace(), config.pace()];
        if paces[0] != paces[1] {
            self.state.phase = 0;
        }
        let ids: Vec<_> = self.state.particles.ids().collect();
        for id in ids {
            let row = &self.state.particles.table.rows()[id.0.slot()];
            let accelerations = [&old, config].map(|config| config.acceleration(row));
            self.hand_over(id, paces, accelerations);
        }
        Ok(())
    }
}
