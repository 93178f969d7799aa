//! Two particles keep a distance.

use core::fmt;

use serde::{Deserialize, Serialize};

use crate::math::{Factor, Real, Unit};
use crate::particle::{ParticleId, RangeError, check_in, check_not_negative};
use crate::store::Handle;

/// Names a distance constraint of a world.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub struct DistanceId(pub Handle);

/// Keeps the distance of two particles in a range: a rod, a spring, a rope, an angle's opening.
///
/// Without slack the range is one length. `slack = rest_length` makes a rope, which only pulls.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct Distance {
    /// One end.
    pub a: ParticleId,
    /// The other end, another particle.
    pub b: ParticleId,
    /// Metres, more than 0 and at most 1,024.
    pub rest_length: Real,
    /// Metres by which it may be shorter without being pushed, 0 to `rest_length`. Default 0.
    pub slack: Real,
    /// Share of the error that one relaxation removes, 0 to 1. Default 1.
    pub stiffness: Unit,
    /// Metres by which a force of one newton stretches it, 0 to 1 (Macklin, Mueller and Chentanez,
    /// XPBD, 2016): unlike a low stiffness the same for every time step and number of iterations.
    /// What is compliant is projected exactly, whatever its form. Default 0.
    pub compliance: Unit,
    /// How the error is projected. Default [`DistanceForm::StartOfStep`].
    pub form: DistanceForm,
    /// The strain `length / rest_length - 1` above which it takes damage, 0 to 32,767; 0 for none
    /// at all. Default 0.
    pub tear_strain: Factor,
    /// The damage that it stands: the strains above `tear_strain`, summed over the ticks. Then it
    /// breaks: it is disabled, with an event. 0 breaks at once. Default 0.
    pub toughness: Factor,
    /// The damage that it took. Default 0.
    pub damage: Factor,
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
    /// Along the constraint as it is now, by `(d.d - L^2) / (d.d + L^2)` of it instead of
    /// `1 - L / |d|` (Jakobsen 2003): no square root. Right for small errors; a constraint of twice
    /// its length is corrected by 0.6 of it instead of 0.5. Particles more than 64 m apart as
    /// [`DistanceForm::Exact`].
    RootFree,
    /// As [`DistanceForm::Exact`] within 1.4 % of the correction, up to four times the length, but
    /// without root and division and several at a time: for cloth. Rods and ropes of 0.5 mm to 64 m
    /// only: with any other slack, length or with compliance, and for particles more than 64 m
    /// apart, as [`DistanceForm::Exact`].
    DivisionFree,
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

    /// A rope of this length: it pulls and never pushes.
    #[must_use]
    pub fn rope(a: ParticleId, b: ParticleId, length: Real) -> Self {
        Self { slack: length, ..Self::new(a, b, length) }
    }

    /// The same with another slack, metres.
    #[must_use]
    pub fn slack(self, slack: Real) -> Self {
        Self { slack, ..self }
    }

    /// The same with a compliance, metres per newton.
    #[must_use]
    pub fn compliance(self, compliance: Unit) -> Self {
        Self { compliance, ..self }
    }

    /// The same, tearing above a strain.
    #[must_use]
    pub fn tear_strain(self, tear_strain: Factor) -> Self {
        Self { tear_strain, ..self }
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
        let Self { a, b, rest_length, slack, stiffness, compliance, .. } = self;
        let Self { tear_strain, toughness, damage, form: _, enabled: _, user: _, .. } = self;
        if a == b {
            return Err(RangeError::same_particle("b"));
        }
        check_in(*rest_length, Real::ULP..=Self::REST_LENGTH_MAX, "rest_length")?;
        check_in(*slack, Real::ZERO..=*rest_length, "slack")?;
        check_in(*stiffness, Unit::ZERO..=Unit::ONE, "stiffness")?;
        check_in(*compliance, Unit::ZERO..=Unit::ONE, "compliance")?;
        check_not_negative(*tear_strain, "tear_strain")?;
        check_not_negative(*toughness, "toughness")?;
        check_not_negative(*damage, "damage")
    }
}

impl Default for Distance {
    fn default() -> Self {
        Self {
            a: ParticleId::default(),
            b: ParticleId::default(),
            rest_length: Real::ZERO,
            slack: Real::ZERO,
            stiffness: Unit::ONE,
            compliance: Unit::ZERO,
            form: DistanceForm::default(),
            tear_strain: Factor::ZERO,
            toughness: Factor::ZERO,
            damage: Factor::ZERO,
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
