//! Distances in a scene file.

use serde::{Deserialize, Deserializer};

use super::number::decimal;
use super::particle::particle_id;
use crate::constraint::{Distance, DistanceForm, DistanceId};
use crate::math::{Factor, Real, Unit, Vec3};
use crate::particle::ParticleId;
use crate::store::Handle;

/// A distance as an element of a list.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(transparent)]
pub(super) struct DistanceEntry(#[serde(with = "DistanceFields")] pub(super) Distance);

/// How a scene file spells a [`Distance`].
#[derive(Deserialize)]
#[serde(remote = "Distance", rename = "Distance")]
#[serde(default = "Distance::default", deny_unknown_fields)]
pub(super) struct DistanceFields {
    #[serde(deserialize_with = "particle_id")]
    a: ParticleId,
    #[serde(deserialize_with = "particle_id")]
    b: ParticleId,
    /// 0: the distance as placed.
    #[serde(deserialize_with = "decimal")]
    rest_length: Real,
    #[serde(deserialize_with = "decimal")]
    slack: Real,
    #[serde(deserialize_with = "decimal")]
    stiffness: Unit,
    #[serde(deserialize_with = "decimal")]
    compliance: Unit,
    form: DistanceForm,
    #[serde(deserialize_with = "decimal")]
    tear_strain: Factor,
    #[serde(deserialize_with = "decimal")]
    toughness: Factor,
    #[serde(deserialize_with = "decimal")]
    damage: Factor,
    enabled: bool,
    user: u64,
}

/// The id of a distance from its number.
pub(super) fn distance_id<'de, D>(deserializer: D) -> Result<DistanceId, D::Error>
where
    D: Deserializer<'de>,
{
    u32::deserialize(deserializer).map(|number| DistanceId(Handle::new(number, 1)))
}

/// The distance with a rest length: if it is open, as the ends are placed. Ends that are nowhere
/// get any length, for it is they that will be refused.
pub(super) fn as_placed(
    distance: &Distance,
    position: impl Fn(ParticleId) -> Option<Vec3>,
) -> Distance {
    let mut placed = *distance;
    if distance.rest_length == Real::ZERO {
        // Positions are within +-2^60: their distance fits.
        let ends = position(distance.a).zip(position(distance.b));
        placed.rest_length = ends.map_or(Real::ONE, |(a, b)| a.distance(b));
    }
    placed
}
