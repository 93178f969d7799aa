//! Two shapes that are near one another.

use crate::collision::margin::counted;
use crate::collision::patch::Seam;
use crate::collision::width::Narrow;
use crate::geometry::Aabb;
use crate::math::wide::sub;
use crate::math::{Real, UnitVec3, Vec3};

/// Where a pair is, and how large.
pub(super) struct Pair {
    /// What positions are measured from: a point of the box around both.
    pub(super) origin: [i64; 3],
    /// Whether [`Narrow`] numbers do.
    pub(super) is_narrow: bool,
    /// Raw.
    pub(super) margin: i64,
}

impl Pair {
    /// None if their boxes are farther apart than the margin. Boxes span less than 2^41.
    #[inline]
    pub(super) fn new(a: &Aabb, b: &Aabb, margin: Real) -> Option<Self> {
        let margin = counted(margin).raw();
        let [min_a, max_a, min_b, max_b] = [a.min(), a.max(), b.min(), b.max()].map(Vec3::raw);
        let mut span = 0;
        for k in 0..3 {
            // Coordinates are at most 2^60.
            if (min_b[k] - max_a[k]).max(min_a[k] - max_b[k]) > margin {
                return None;
            }
            span = (max_a[k].max(max_b[k]) - min_a[k].min(min_b[k])).max(span);
        }
        let is_narrow = span + margin <= Narrow::SPAN_MAX;
        Some(Self { origin: min_a, is_narrow, margin })
    }

    /// Along what shapes without radii touch.
    #[inline]
    pub(super) fn seam(&self, normal: UnitVec3) -> Seam {
        Seam { normal, radii: [0; 2], margin: self.margin, origin: self.origin }
    }

    /// A point of either shape, from the origin.
    #[inline]
    pub(super) fn local(&self, point: Vec3) -> [i64; 3] {
        sub(point.raw(), self.origin)
    }
}
