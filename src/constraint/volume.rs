//! Four particles keep a volume.

use core::fmt;

use serde::{Deserialize, Serialize};

use super::tetrahedron::{cross, edges};
use crate::math::wide::{dot_wide, round_div_wide, to_i64};
use crate::math::{Real, Unit, Vec3};
use crate::particle::{ParticleId, RangeError, WORLD_LIMIT, check_in, within};
use crate::store::Handle;

/// Names a volume constraint of a world.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub struct VolumeId(pub Handle);

/// Keeps the volume of a tetrahedron of four particles: soft bodies do not collapse, and do not
/// turn inside out.
///
/// Tetrahedra with particles more than 64 m apart along an axis are left alone.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct Volume {
    /// The corners, four different particles.
    pub corners: [ParticleId; 4],
    /// Litres, within +-2^25 (33,554 m^3), with the sign of `(p1 - p0) . ((p2 - p0) x (p3 - p0))`.
    pub rest_volume: Real,
    /// Share of the error that one relaxation removes, 0 to 1. Default 1.
    pub stiffness: Unit,
    /// A disabled constraint does nothing. Default `true`.
    pub enabled: bool,
    /// Whatever the game wants to keep here. Default 0.
    pub user: u64,
}

impl Volume {
    /// Greatest rest volume, either sign.
    pub const REST_VOLUME_MAX: Real = Real::from_int(1 << 25);

    /// Keeps this volume, in litres.
    #[must_use]
    pub fn new(corners: [ParticleId; 4], rest_volume: Real) -> Self {
        Self { corners, rest_volume, ..Self::default() }
    }

    /// The volume of a tetrahedron with these corners, metres, in litres, rounded once; cut to
    /// [`Self::REST_VOLUME_MAX`].
    ///
    /// Corners are inside of a world and at most 64 m apart along each axis, or the result is 0.
    #[must_use]
    pub fn of(corners: [Vec3; 4]) -> Real {
        // Elsewhere differences would not fit.
        let inside = corners.iter().all(|&corner| within(corner, WORLD_LIMIT));
        let volume = if inside { sextuple(corners.map(Vec3::raw)) } else { None }.unwrap_or(0);
        // 6 V / 2^72 m^3 are V 1000 / 6 litres: times 500 / (3 2^48) in raw ones.
        let litres = round_div_wide(volume * 500, 3 << 48);
        let limit = i128::from(Self::REST_VOLUME_MAX.raw());
        Real::from_raw(to_i64(litres.clamp(-limit, limit)))
    }

    /// The same with another stiffness.
    #[must_use]
    pub fn stiffness(self, stiffness: Unit) -> Self {
        Self { stiffness, ..self }
    }

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { corners, rest_volume, stiffness, enabled: _, user: _ } = self;
        let different = (0..4).all(|k| !corners[..k].contains(&corners[k]));
        if !different {
            return Err(RangeError::same_particle("corners"));
        }
        let limit = Self::REST_VOLUME_MAX;
        check_in(*rest_volume, -limit..=limit, "rest_volume")?;
        check_in(*stiffness, Unit::ZERO..=Unit::ONE, "stiffness")
    }

    /// Six times the rest volume in cubic raw units, below 2^100.
    pub(super) fn rest_sextuple(&self) -> i128 {
        round_div_wide(i128::from(self.rest_volume.raw()) * (3 << 48), 500)
    }
}

/// Six times the volume, cubic raw units: at most 3 2^91. `None` beyond 64 m.
pub(super) fn sextuple(corners: [[i64; 3]; 4]) -> Option<i128> {
    let [e1, e2, e3] = edges(corners)?;
    Some(dot_wide(e1, cross(e2, e3)))
}

impl Default for Volume {
    fn default() -> Self {
        Self {
            corners: [ParticleId::default(); 4],
            rest_volume: Real::ZERO,
            stiffness: Unit::ONE,
            enabled: true,
            user: 0,
        }
    }
}

impl fmt::Display for VolumeId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "volume {}", self.0)
    }
}
