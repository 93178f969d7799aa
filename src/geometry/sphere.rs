//! All points near one.

use super::triangle::is_in_range;
use super::{Aabb, ShapeError, Triangle};
use crate::math::{Real, Vec3};

/// A ball, closed. With a radius of 0 it is a point.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Sphere {
    center: Vec3,
    radius: Real,
}

impl Sphere {
    /// The greatest radius of anything round: 32,768 m.
    pub const RADIUS_MAX: Real = Real::from_int(1 << 15);

    /// The ball about `center`, both in metres.
    ///
    /// # Errors
    /// [`ShapeError`] if the center is out of range or the radius outside
    /// 0..=[`RADIUS_MAX`](Self::RADIUS_MAX).
    pub fn new(center: Vec3, radius: Real) -> Result<Self, ShapeError> {
        if !is_in_range(center) {
            return Err(ShapeError::OutOfRange("center"));
        }
        check_radius(radius)?;
        Ok(Self { center, radius })
    }

    /// The middle, in metres.
    #[inline]
    #[must_use]
    pub const fn center(&self) -> Vec3 {
        self.center
    }

    /// In metres, 0 or more.
    #[inline]
    #[must_use]
    pub const fn radius(&self) -> Real {
        self.radius
    }

    /// The smallest box around it. Exact.
    #[inline]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let reach = Vec3::new(self.radius, self.radius, self.radius);
        Aabb::new(self.center - reach, self.center + reach)
    }
}

/// Checks the radius of something round.
pub(super) fn check_radius(radius: Real) -> Result<(), ShapeError> {
    if radius < Real::ZERO {
        return Err(ShapeError::Negative("radius"));
    }
    // Diameters stay below the span of a triangle.
    const { assert!(2 * Sphere::RADIUS_MAX.raw() < Triangle::SPAN_MAX) };
    if radius > Sphere::RADIUS_MAX { Err(ShapeError::TooLarge("radius")) } else { Ok(()) }
}
