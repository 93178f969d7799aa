//! What a partition knows of an object.

use super::PartitionError;
use crate::geometry::Aabb;
use crate::math::Vec3;

/// A tight box, and the point by which an [`Orthtree`](super::Orthtree) files it.
///
/// Made from a box, the centre is the middle of it; a centre of mass does as well, and no result
/// depends on it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Object {
    /// The smallest box around the object, closed.
    pub bounds: Aabb,
    /// Its centre of mass, or any point near its middle.
    pub centre: Vec3,
}

impl Object {
    /// No coordinate is beyond +-2^36 m (raw: 2^60), as in a world.
    pub const COORDINATE_MAX: i64 = 1 << 60;

    /// Whether all coordinates are in range.
    #[inline]
    pub(super) fn check(&self) -> Result<(), PartitionError> {
        // The corners are ordered, so each needs only its outer side checked.
        let bounds = &self.bounds;
        let [low, high] = [bounds.min().raw(), bounds.max().raw()];
        let low = low[0].min(low[1]).min(low[2]);
        let high = high[0].max(high[1]).max(high[2]);
        if low < -Self::COORDINATE_MAX || high > Self::COORDINATE_MAX {
            return Err(PartitionError::OutOfRange { field: "bounds" });
        }
        let far = |c: i64| c.unsigned_abs() > Self::COORDINATE_MAX.unsigned_abs();
        if self.centre.raw().into_iter().any(far) {
            return Err(PartitionError::OutOfRange { field: "centre" });
        }
        Ok(())
    }
}

impl From<Aabb> for Object {
    #[inline]
    fn from(bounds: Aabb) -> Self {
        let [low, high] = [bounds.min().raw(), bounds.max().raw()];
        let middle = [0, 1, 2].map(|k| low[k].midpoint(high[k]));
        Self { bounds, centre: Vec3::from_raw(middle) }
    }
}
