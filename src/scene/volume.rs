//! Volumes in a scene file.

use serde::{Deserialize, Deserializer};

use super::number::decimal;
use super::particle::particle_id;
use crate::constraint::{Volume, VolumeId};
use crate::math::{Real, Unit, Vec3};
use crate::particle::ParticleId;
use crate::store::Handle;

/// A volume as an element of a list.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(transparent)]
pub(super) struct VolumeEntry(#[serde(with = "VolumeFields")] pub(super) Volume);

/// How a scene file spells a [`Volume`].
#[derive(Deserialize)]
#[serde(remote = "Volume", rename = "Volume")]
#[serde(default = "Volume::default", deny_unknown_fields)]
pub(super) struct VolumeFields {
    #[serde(deserialize_with = "corners")]
    corners: [ParticleId; 4],
    /// 0: the volume as placed.
    #[serde(deserialize_with = "decimal")]
    rest_volume: Real,
    #[serde(deserialize_with = "decimal")]
    stiffness: Unit,
    enabled: bool,
    user: u64,
}

/// The ids of corners from their numbers: `(0, 1, 2, 3)`.
pub(super) fn corners<'de, D, const N: usize>(deserializer: D) -> Result<[ParticleId; N], D::Error>
where
    D: Deserializer<'de>,
    [Number; N]: Deserialize<'de>,
{
    <[Number; N]>::deserialize(deserializer).map(|numbers| numbers.map(|Number(id)| id))
}

/// The number of a particle.
#[derive(Clone, Copy, Deserialize)]
#[serde(transparent)]
pub(super) struct Number(#[serde(deserialize_with = "particle_id")] ParticleId);

/// The id of a volume from its number.
pub(super) fn volume_id<'de, D: Deserializer<'de>>(deserializer: D) -> Result<VolumeId, D::Error> {
    u32::deserialize(deserializer).map(|number| VolumeId(Handle::new(number, 1)))
}

/// The volume with a rest volume: if it is open, as the corners are placed.
pub(super) fn as_placed(volume: &Volume, position: impl Fn(ParticleId) -> Option<Vec3>) -> Volume {
    let mut placed = *volume;
    if volume.rest_volume == Real::ZERO {
        // Corners that are nowhere are what will be refused.
        let corners = volume.corners.map(|id| position(id).unwrap_or(Vec3::ZERO));
        placed.rest_volume = Volume::of(corners);
    }
    placed
}
