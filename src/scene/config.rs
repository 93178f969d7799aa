//! The configuration in a scene file.

use serde::Deserialize;

use super::number::{decimal, vector};
use crate::math::{Real, Vec3};
use crate::world::WorldConfig;

/// How a scene file spells a [`WorldConfig`].
#[derive(Deserialize)]
#[serde(remote = "WorldConfig", rename = "Config")]
#[serde(default = "WorldConfig::default", deny_unknown_fields)]
pub(super) struct ConfigFields {
    tick_rate: u32,
    substeps: u32,
    iterations: u32,
    #[serde(deserialize_with = "vector")]
    gravity: Vec3,
    #[serde(deserialize_with = "decimal")]
    damping: Real,
    #[serde(deserialize_with = "decimal")]
    displacement_max: Real,
    #[serde(deserialize_with = "vector")]
    wind: Vec3,
}
