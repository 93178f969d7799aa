//! All points near a segment.

use super::segment::check_ends;
use super::sphere::check_radius;
use super::{Aabb, ShapeError, Sphere, Triangle};
use crate::math::{Real, Vec3};

/// A ball swept along a segment, closed. Both ends may be one point: then it is a ball.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Capsule {
    ends: [Vec3; 2],
    radius: Real,
}

impl Capsule {
    /// The capsule around the segment between `ends`, in metres.
    ///
    /// # Errors
    /// [`ShapeError`] if an end is out of range, the segment spans more than
    /// [`Triangle::SPAN_MAX`], or the radius is outside
    /// 0..=[`Sphere::RADIUS_MAX`](super::Sphere::RADIUS_MAX).
    pub fn new(ends: [Vec3; 2], radius: Real) -> Result<Self, ShapeError> {
        check_ends(ends)?;
        if Aabb::new(ends[0], ends[1]).span() > Triangle::SPAN_MAX.unsigned_abs() {
            return Err(ShapeError::TooLong);
        }
        check_radius(radius)?;
        Ok(Self { ends, radius })
    }

    /// The capsule around a segment whose ends are known to be in range and near enough, with the
    /// radius of another.
    #[inline]
    pub(crate) const fn between(ends: [Vec3; 2], radius: Real) -> Self {
        Self { ends, radius }
    }

    /// The ends of the segment, in metres: the centers of the caps.
    #[inline]
    #[must_use]
    pub const fn ends(&self) -> [Vec3; 2] {
        self.ends
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
        let segment = Aabb::new(self.ends[0], self.ends[1]);
        Aabb::new(segment.min() - reach, segment.max() + reach)
    }
}

impl From<Sphere> for Capsule {
    /// The ball as a capsule whose ends are one point.
    fn from(ball: Sphere) -> Self {
        Self { ends: [ball.center(); 2], radius: ball.radius() }
    }
}
