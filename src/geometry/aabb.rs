//! Boxes along the axes.

use crate::math::Vec3;

/// An axis-aligned box, closed: its surface belongs to it. A point is a box too.
///
/// Every operation is exact. `min <= max` along each axis, whoever made it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[repr(C)]
pub struct Aabb {
    min: Vec3,
    max: Vec3,
}

impl Aabb {
    /// The box between two opposite corners, whichever they are.
    #[inline]
    #[must_use]
    pub fn new(a: Vec3, b: Vec3) -> Self {
        Self::of_point(a).with(b)
    }

    /// The box of one point.
    #[inline]
    #[must_use]
    pub const fn of_point(point: Vec3) -> Self {
        Self { min: point, max: point }
    }

    /// The smallest box around some points; `None` around none.
    #[inline]
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = Self::of_point(points.next()?);
        Some(points.fold(first, Self::with))
    }

    /// The lowest corner.
    #[inline]
    #[must_use]
    pub const fn min(&self) -> Vec3 {
        self.min
    }

    /// The highest corner.
    #[inline]
    #[must_use]
    pub const fn max(&self) -> Vec3 {
        self.max
    }

    /// The smallest box around this one and a point.
    #[inline]
    #[must_use]
    pub fn with(self, point: Vec3) -> Self {
        self.union(Self::of_point(point))
    }

    /// The smallest box around both.
    #[inline]
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        let (a, b) = (self.min, other.min);
        let min = Vec3::new(a.x.min(b.x), a.y.min(b.y), a.z.min(b.z));
        let (a, b) = (self.max, other.max);
        let max = Vec3::new(a.x.max(b.x), a.y.max(b.y), a.z.max(b.z));
        Self { min, max }
    }

    /// Whether they have a point in common; touching counts. Branch-free.
    #[inline]
    #[must_use]
    #[allow(clippy::needless_bitwise_bool, reason = "a branch a comparison costs more")]
    pub fn overlaps(&self, other: &Self) -> bool {
        (self.min.x <= other.max.x)
            & (self.max.x >= other.min.x)
            & (self.min.y <= other.max.y)
            & (self.max.y >= other.min.y)
            & (self.min.z <= other.max.z)
            & (self.max.z >= other.min.z)
    }

    /// Whether all of the other lies in this one.
    #[inline]
    #[must_use]
    pub fn contains(&self, other: &Self) -> bool {
        self.union(*other) == *self
    }

    /// The length of the longest edge, raw: exact for any two corners.
    #[inline]
    #[must_use]
    pub fn span(&self) -> u64 {
        let [low, high] = [self.min.raw(), self.max.raw()];
        let along = |k: usize| high[k].abs_diff(low[k]);
        along(0).max(along(1)).max(along(2))
    }
}
