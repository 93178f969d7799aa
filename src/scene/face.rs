//! Faces in a scene file.

use serde::{Deserialize, Deserializer};

use super::number::decimal;
use super::volume::corners;
use crate::body::{Face, FaceId};
use crate::math::Factor;
use crate::particle::ParticleId;
use crate::store::Handle;

/// A face as an element of a list.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(transparent)]
pub(super) struct FaceEntry(#[serde(with = "FaceFields")] pub(super) Face);

/// How a scene file spells a [`Face`].
#[derive(Deserialize)]
#[serde(remote = "Face", rename = "Face")]
#[serde(default = "Face::default", deny_unknown_fields)]
pub(super) struct FaceFields {
    #[serde(deserialize_with = "corners")]
    corners: [ParticleId; 3],
    #[serde(deserialize_with = "decimal")]
    drag: Factor,
    enabled: bool,
    user: u64,
}

/// The id of a face from its number.
pub(super) fn face_id<'de, D: Deserializer<'de>>(deserializer: D) -> Result<FaceId, D::Error> {
    u32::deserialize(deserializer).map(|number| FaceId(Handle::new(number, 1)))
}
