//! The particle arrays.

use alloc::vec::Vec;
use core::fmt;

use serde::{Deserialize, Serialize};

use super::{Particle, RangeError, WORLD_LIMIT, check};
use crate::math::Vec3;
use crate::store::{Handle, Table};

/// Names a particle of a world.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub struct ParticleId(pub Handle);

impl fmt::Display for ParticleId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "particle {}", self.0)
    }
}

/// All particles of a world, one array for each thing the inner loops read.
///
/// The arrays have one element a slot. A free slot holds zeros, so that equal worlds have equal
/// bytes. Invariant: positions and displacements keep their limits.
#[derive(Debug, Default)]
pub struct ParticleSet {
    pub(crate) table: Table<Particle>,
    pub(crate) position: Vec<[i64; 3]>,
    pub(crate) displacement: Vec<[i32; 3]>,
}

impl ParticleSet {
    /// Adds a particle. The caller has validated it and kept the number below the limit.
    pub(crate) fn insert(
        &mut self,
        position: [i64; 3],
        displacement: [i32; 3],
        particle: Particle,
    ) -> ParticleId {
        let handle = self.table.insert(particle);
        let slot = handle.slot();
        if slot == self.position.len() {
            self.position.push(position);
            self.displacement.push(displacement);
        } else {
            self.position[slot] = position;
            self.displacement[slot] = displacement;
        }
        ParticleId(handle)
    }

    /// Removes a particle; `false` if the id is stale.
    pub(crate) fn remove(&mut self, id: ParticleId) -> bool {
        let removed = self.table.remove(id.0).is_some();
        if removed {
            self.position[id.0.slot()] = [0; 3];
            self.displacement[id.0.slot()] = [0; 3];
        }
        removed
    }

    /// The number of particles. O(slots).
    #[must_use]
    pub fn len(&self) -> usize {
        self.table.slots().live()
    }

    /// Whether there is no particle.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.table.slots().iter().next().is_none()
    }

    /// Whether the id names a living particle.
    #[must_use]
    pub fn contains(&self, id: ParticleId) -> bool {
        self.table.slots().contains(id.0)
    }

    /// The ids of all particles in order of their slots.
    pub fn ids(&self) -> impl Iterator<Item = ParticleId> + '_ {
        self.table.slots().iter().map(ParticleId)
    }

    /// The id of the particle in a slot.
    #[must_use]
    pub fn id_at(&self, index: u32) -> Option<ParticleId> {
        self.table.slots().tenant(index).map(ParticleId)
    }

    /// The particle's position in metres.
    #[must_use]
    pub fn position(&self, id: ParticleId) -> Option<Vec3> {
        self.contains(id).then(|| Vec3::from_raw(self.position[id.0.slot()]))
    }

    /// What the particle moved in the last substep, in metres.
    #[must_use]
    pub fn displacement(&self, id: ParticleId) -> Option<Vec3> {
        self.contains(id).then(|| Vec3::from_raw(self.displacement[id.0.slot()].map(i64::from)))
    }

    /// The particle's properties.
    #[must_use]
    pub fn particle(&self, id: ParticleId) -> Option<&Particle> {
        self.table.get(id.0)
    }

    /// All positions in raw units (2^-24 m), one a slot; free slots hold zeros.
    #[must_use]
    pub fn positions_raw(&self) -> &[[i64; 3]] {
        &self.position
    }

    /// All displacements of the last substep in raw units (2^-24 m), one a slot.
    #[must_use]
    pub fn displacements_raw(&self) -> &[[i32; 3]] {
        &self.displacement
    }

    /// Checks every invariant; the error names the field that is broken.
    pub(crate) fn validate(&self, displacement_max: i64) -> Result<(), RangeError> {
        let Self { table, position, displacement } = self;
        let same = [position.len(), displacement.len()] == [table.rows().len(); 2];
        check(same, "particle count")?;
        let limit = WORLD_LIMIT.unsigned_abs();
        check(position.iter().flatten().all(|c| c.unsigned_abs() <= limit), "position")?;
        let limit = displacement_max.unsigned_abs();
        let short = |c: &i32| u64::from(c.unsigned_abs()) <= limit;
        check(displacement.iter().flatten().all(short), "displacement")?;
        (0u32..).zip(table.rows().iter()).try_for_each(|(index, particle)| {
            let slot = index as usize;
            let vacant = cfg!(planted) || position[slot] == [0; 3] && displacement[slot] == [0; 3];
            check(vacant || table.slots().tenant(index).is_some(), "position of a free slot")?;
            particle.validate()
        })
    }
}

impl Clone for ParticleSet {
    fn clone(&self) -> Self {
        let Self { table, position, displacement } = self;
        Self {
            table: table.clone(),
            position: position.clone(),
            displacement: displacement.clone(),
        }
    }

    fn clone_from(&mut self, source: &Self) {
        let Self { table, position, displacement } = source;
        self.table.clone_from(table);
        self.position.clone_from(position);
        self.displacement.clone_from(displacement);
    }
}
