//! Floor 0: numbers and vectors. Fixed point, exact, the same bits everywhere.
//!
//! # Conventions
//!
//! Right-handed axes, y up. Metres, seconds, kilograms. A *raw* value is the integer behind a
//! number: 2^-24 of the unit (60 nm) for [`Real`], 2^-`BITS` for [`Fraction`].
//!
//! # The rounding rule
//!
//! Products are summed exactly in a wide integer and rounded once, **to nearest, ties away from
//! zero** ([`wide`]); divisions round the same way; roots floor, or go to the nearest. Rounding
//! is therefore odd-symmetric, and mirrored worlds stay mirrored. Only differences of positions
//! are ever rounded, never a position, so a world behaves the same wherever it stands.
//!
//! # Overflow
//!
//! None is silent. `checked_*` returns `None`, operators panic in every build profile, and the
//! raw formulas of [`wide`] state the bound that their callers prove. Only this floor names the
//! crate `fixed`, whose own operators panic in debug builds and wrap in release builds.
//!
//! # Floats
//!
//! Converted at the edges, by their bits, in one file (`float.rs`); no arithmetic on them.

#![allow(
    clippy::cast_possible_truncation,
    reason = "fixed point narrows on purpose; the bound stands beside each cast"
)]

mod decimal;
pub(crate) mod determinant;
mod float;
mod fraction;
pub(crate) mod int256;
mod real;
mod rng;
pub mod root;
mod text;
pub mod trig;
mod unit_vec3;
mod vec3;
pub mod wide;

pub use decimal::DecimalError;
pub use fraction::{Factor, Fraction, FractionError, Unit, Weight};
pub use real::{Real, RealError};
pub use rng::Pcg;
pub use unit_vec3::UnitVec3;
pub use vec3::Vec3;
