//! How far a point is from a hull.

use super::ConvexHull;
use crate::geometry::{Triangle, closest_point_triangle};
use crate::math::wide::{round_shift_wide, sub, to_i64};
use crate::math::{Real, Unit, Vec3};

impl ConvexHull {
    /// The distance of a point of the world from the surface, in metres, negative inside; wrong by
    /// at most a raw unit outside, by 2^-28 of the size and a raw unit inside. O(corners).
    #[must_use]
    pub(in crate::geometry) fn separation(&self, point: Vec3) -> Real {
        let mut highest = i64::MIN;
        let mut nearest: Option<Real> = None;
        for (face, corners) in (0..).zip(self.faces()) {
            let height = self.height(face, point);
            highest = highest.max(height);
            if height <= 0 {
                continue;
            }
            // Outside, the nearest point is of a face that the point is in front of.
            let Some((&first, rest)) = corners.split_first() else { continue };
            for side in rest.windows(2) {
                let corners =
                    [first, side[0], side[1]].map(|vertex| self.vertices[vertex as usize]);
                let foot = closest_point_triangle(point, &Triangle::between(corners));
                let distance = point.distance(foot.position);
                nearest = Some(nearest.map_or(distance, |nearest| nearest.min(distance)));
            }
        }
        nearest.unwrap_or(Real::from_raw(highest))
    }

    /// How far a point is in front of the plane of a face, raw.
    pub(in crate::geometry) fn height(&self, face: usize, point: Vec3) -> i64 {
        let normal = self.normals[face].raw();
        let way = sub(point.raw(), self.vertices[self.anchors[face] as usize].raw());
        // Below 3 * 2^91.
        let height = (0..3).map(|k| i128::from(normal[k]) * i128::from(way[k])).sum();
        to_i64(round_shift_wide(height, Unit::FRACTION_BITS))
    }
}
