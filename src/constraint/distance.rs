//! Two particles keep a distance.

use core::fmt;

use serde::{Deserialize, Serialize};

use crate::math::{Real, Unit};
use crate::particle::{ParticleId, RangeError, check};
use crate::store::Handle;

/// Names a distance constraint of a world.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub struct DistanceId(pub Handle);

/// Keeps two particles at a rest length: a rod, or with a low stiffness a spring.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct Distance {
    /// One end.
    pub a: ParticleId,
    /// The other end, another particle.
    pub b: ParticleId,
    /// Metres, more than 0 and at most 1,024.
    pub rest_length: Real,
    /// Share of the error that one relaxation removes, 0 to 1. Default 1.
    pub stiffness: Unit,
    /// How the error is projected. Default [`DistanceForm::StartOfStep`].
    pub form: DistanceForm,
    /// A disabled constraint does nothing. Default `true`.
    pub enabled: bool,
    /// Whatever the game wants to keep here. Default 0.
    pub user: u64,
}

/// How a distance constraint is projected.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub enum DistanceForm {
    /// Along the constraint as it is now, by exactly the error (Jakobsen 2003). Damps rotation,
    /// which is welcome in cloth and plants.
    Exact,
    /// Along the constraint as it was at the start of the substep (SHAKE: Ryckaert, Ciccotti and
    /// Berendsen 1977): no square root, and angular momentum and energy are kept. Where the error
    /// or the turn is too large for that, as [`DistanceForm::Exact`].
    #[default]
    StartOfStep,
}

impl Distance {
    /// The greatest rest length.
    pub const REST_LENGTH_MAX: Real = Real::from_int(1024);

    /// A rigid rod of this length.
    #[must_use]
    pub fn new(a: ParticleId, b: ParticleId, rest_length: Real) -> Self {
        Self { a, b, rest_length, ..Self::default() }
    }

    /// The same with another form.
    #[must_use]
    pub fn form(self, form: DistanceForm) -> Self {
        Self { form, ..self }
    }

    /// The same with another stiffness.
    #[must_use]
    pub fn stiffness(self, stiffness: Unit) -> Self {
        Self { stiffness, ..self }
    }

    /// Whether what its corrections are rounded by is carried on, and saved.
    pub(crate) fn is_carried(&self) -> bool {
        self.form == DistanceForm::StartOfStep
    }

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { a, b, rest_length, stiffness, form: _, enabled: _, user: _ } = self;
        check(a != b, "b")?;
        let lengths = Real::ULP..=Self::REST_LENGTH_MAX;
        check(lengths.contains(rest_length), "rest_length")?;
        check((Unit::ZERO..=Unit::ONE).contains(stiffness), "stiffness")
    }
}

impl Default for Distance {
    fn default() -> Self {
        Self {
            a: ParticleId::default(),
            b: ParticleId::default(),
            rest_length: Real::ZERO,
            stiffness: Unit::ONE,
            form: DistanceForm::default(),
            enabled: true,
            user: 0,
        }
    }
}

impl fmt::Display for DistanceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "distance {}", self.0)
    }
}
