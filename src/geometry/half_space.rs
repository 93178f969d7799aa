//! Everything behind a plane.

use super::ShapeError;
use super::triangle::is_in_range;
use crate::math::{UnitVec3, Vec3};

/// All points on one side of a plane and the plane itself: a floor without an end.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct HalfSpace {
    point: Vec3,
    normal: UnitVec3,
}

impl HalfSpace {
    /// What lies behind the plane through `point`, in metres; `normal` points out of it.
    ///
    /// # Errors
    /// [`ShapeError`] if the point is out of range or the normal not of length 1.
    pub fn new(point: Vec3, normal: UnitVec3) -> Result<Self, ShapeError> {
        if !is_in_range(point) {
            return Err(ShapeError::OutOfRange("point"));
        }
        if !normal.is_unit() {
            return Err(ShapeError::NotUnit("normal"));
        }
        Ok(Self { point, normal })
    }

    /// A point of the plane, in metres.
    #[inline]
    #[must_use]
    pub const fn point(&self) -> Vec3 {
        self.point
    }

    /// Points to where it is empty.
    #[inline]
    #[must_use]
    pub const fn normal(&self) -> UnitVec3 {
        self.normal
    }
}
