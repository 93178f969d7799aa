//! A triangle of three particles.

use core::fmt;

use serde::{Deserialize, Serialize};

use crate::math::Factor;
use crate::particle::{ParticleId, RangeError, check_in};
use crate::store::Handle;

/// Names a face of a world.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub struct FaceId(pub Handle);

/// A triangle of cloth or leaf: what is drawn, and what the wind blows on.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct Face {
    /// The corners, three different particles, anticlockwise as seen from the front.
    pub corners: [ParticleId; 3],
    /// Newtons for every square metre and every metre a second by which the air moves through it,
    /// along its normal and whichever side it comes from: 0 to 1,000. Default 0.
    pub drag: Factor,
    /// A disabled face feels no wind and is not drawn. Default `true`.
    pub enabled: bool,
    /// Whatever the game wants to keep here. Default 0.
    pub user: u64,
}

impl Face {
    /// Greatest drag.
    pub const DRAG_MAX: Factor = Factor::from_raw(1000 << 16);

    /// A face that the air passes through.
    #[must_use]
    pub fn new(corners: [ParticleId; 3]) -> Self {
        Self { corners, ..Self::default() }
    }

    /// The same with another drag.
    #[must_use]
    pub fn drag(self, drag: Factor) -> Self {
        Self { drag, ..self }
    }

    /// The edges, of each the lower particle first.
    pub(crate) fn edges(&self) -> [[ParticleId; 2]; 3] {
        let [a, b, c] = self.corners;
        [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)])
    }

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { corners: [a, b, c], drag, enabled: _, user: _ } = self;
        if a == b || b == c || c == a {
            return Err(RangeError::same_particle("corners"));
        }
        check_in(*drag, Factor::ZERO..=Self::DRAG_MAX, "drag")
    }
}

impl Default for Face {
    fn default() -> Self {
        Self { corners: [ParticleId::default(); 3], drag: Factor::ZERO, enabled: true, user: 0 }
    }
}

impl fmt::Display for FaceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "face {}", self.0)
    }
}
