//! Half-spaces in a scene file.

use serde::{Deserialize, Deserializer};

use super::number::{decimal, direction, vector};
use crate::constraint::{HalfSpace, HalfSpaceId};
use crate::math::{Factor, Unit, UnitVec3, Vec3};
use crate::store::Handle;

/// A half-space as an element of a list.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(transparent)]
pub(super) struct HalfSpaceEntry(#[serde(with = "HalfSpaceFields")] pub(super) HalfSpace);

/// How a scene file spells a [`HalfSpace`].
#[derive(Deserialize)]
#[serde(remote = "HalfSpace", rename = "HalfSpace")]
#[serde(default = "HalfSpace::default", deny_unknown_fields)]
pub(super) struct HalfSpaceFields {
    #[serde(deserialize_with = "vector")]
    point: Vec3,
    #[serde(deserialize_with = "direction")]
    normal: UnitVec3,
    #[serde(deserialize_with = "decimal")]
    friction: Factor,
    #[serde(deserialize_with = "decimal")]
    restitution: Unit,
    enabled: bool,
    user: u64,
}

/// The id of a half-space from its number.
pub(super) fn half_space_id<'de, D>(deserializer: D) -> Result<HalfSpaceId, D::Error>
where
    D: Deserializer<'de>,
{
    u32::deserialize(deserializer).map(|number| HalfSpaceId(Handle::new(number, 1)))
}
