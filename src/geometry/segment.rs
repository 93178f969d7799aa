//! Two points.

use super::triangle::is_in_range;
use super::{Aabb, Capsule, ShapeError, Triangle};
use crate::math::Vec3;

/// A segment: two ends and all that lies between them, closed. Both may be one point.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[repr(transparent)]
pub struct Segment {
    ends: [Vec3; 2],
}

impl Segment {
    /// The segment between two points, in metres.
    ///
    /// # Errors
    /// [`ShapeError`] if an end is out of range or it spans more than [`Triangle::SPAN_MAX`].
    pub fn new(ends: [Vec3; 2]) -> Result<Self, ShapeError> {
        check_ends(ends)?;
        if Aabb::new(ends[0], ends[1]).span() > Triangle::SPAN_MAX.unsigned_abs() {
            return Err(ShapeError::TooLong);
        }
        Ok(Self { ends })
    }

    /// The segment between two points that are known to be in range and near enough.
    #[inline]
    pub(crate) const fn between(ends: [Vec3; 2]) -> Self {
        Self { ends }
    }

    /// The ends, in metres.
    #[inline]
    #[must_use]
    pub const fn ends(&self) -> [Vec3; 2] {
        self.ends
    }

    /// The smallest box around it.
    #[inline]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb::new(self.ends[0], self.ends[1])
    }
}

impl Triangle {
    /// An edge: 0 goes from corner 0 to 1, 1 from 1 to 2, 2 from 2 to 0. The number is taken
    /// modulo 3.
    #[inline]
    #[must_use]
    pub const fn edge(&self, edge: u8) -> Segment {
        let from = edge as usize % 3;
        Segment::between([self.corners()[from], self.corners()[(from + 1) % 3]])
    }
}

impl Capsule {
    /// The segment in its middle.
    #[inline]
    #[must_use]
    pub const fn segment(&self) -> Segment {
        Segment::between(self.ends())
    }
}

/// Checks that both ends are in range, and names the one that is not.
pub(super) fn check_ends(ends: [Vec3; 2]) -> Result<(), ShapeError> {
    let far = ["end 0", "end 1"].into_iter().zip(ends).find(|&(_, end)| !is_in_range(end));
    far.map_or(Ok(()), |(name, _)| Err(ShapeError::OutOfRange(name)))
}
