//! How far apart things are that touch nearly.

use crate::math::Real;

/// The greatest margin that counts: 16,384 m.
pub const MARGIN_MAX: Real = Real::from_int(1 << 14);

/// A margin as it counts: below 0 it is 0, above [`MARGIN_MAX`] it is that.
pub(super) fn counted(margin: Real) -> Real {
    margin.clamp(Real::ZERO, MARGIN_MAX)
}
