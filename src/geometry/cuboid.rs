//! Boxes in any position.

use super::triangle::is_in_range;
use super::{Aabb, ShapeError, Triangle};
use crate::math::determinant::{cross, dot};
use crate::math::{Real, UnitVec3, Vec3};

/// A box: a center and half of each of its three edges, closed.
///
/// The edges need not be at right angles, nor right-handed: what particles carry is sheared a
/// little, and remains a box with parallel sides. They must not lie in one plane.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Cuboid {
    center: Vec3,
    half_edges: [Vec3; 3],
    normals: [UnitVec3; 3],
    is_mirrored: bool,
}

impl Cuboid {
    /// The box about `center` that reaches as far as `half_edges` to either side, in metres.
    ///
    /// # Errors
    /// [`ShapeError`] if a corner is out of range, the box spans more than
    /// [`Triangle::SPAN_MAX`], or it has no volume.
    pub fn new(center: Vec3, half_edges: [Vec3; 3]) -> Result<Self, ShapeError> {
        let edges = half_edges.map(Vec3::raw);
        let reach = [0, 1, 2].map(|k| edges.iter().map(|e| u128::from(e[k].unsigned_abs())).sum());
        if reach.into_iter().max() > Some(u128::from(Triangle::SPAN_MAX.unsigned_abs()) / 2) {
            return Err(ShapeError::TooLong);
        }
        // Half-edges are at most 2^40 - 1 from here on: nothing overflows.
        let mut cuboid = Self { center, half_edges, normals: [UnitVec3::Y; 3], is_mirrored: false };
        let in_range = is_in_range(center) && {
            let bounds = cuboid.bounds();
            is_in_range(bounds.min()) && is_in_range(bounds.max())
        };
        if !in_range {
            return Err(ShapeError::OutOfRange("center"));
        }
        let [x, y, z] = edges;
        let crosses = [cross(y, z), cross(z, x), cross(x, y)];
        let volume = dot(&crosses[2], z);
        if volume == 0 {
            return Err(ShapeError::Flat);
        }
        cuboid.is_mirrored = volume < 0;
        for (normal, cross) in cuboid.normals.iter_mut().zip(crosses) {
            // None of them is 0, or the volume would be.
            let right = UnitVec3::normalize_wide(cross).unwrap_or(UnitVec3::Y);
            *normal = if cuboid.is_mirrored { -right } else { right };
        }
        Ok(cuboid)
    }

    /// The box along the axes that reaches as far as the components of `half` to either side.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn upright(center: Vec3, half: Vec3) -> Result<Self, ShapeError> {
        let edge = |x, y, z| Vec3::new(x, y, z);
        let zero = Real::ZERO;
        let edges = [edge(half.x, zero, zero), edge(zero, half.y, zero), edge(zero, zero, half.z)];
        Self::new(center, edges)
    }

    /// The middle, in metres.
    #[inline]
    #[must_use]
    pub const fn center(&self) -> Vec3 {
        self.center
    }

    /// From the middle to the middles of three sides, in metres.
    #[inline]
    #[must_use]
    pub const fn half_edges(&self) -> [Vec3; 3] {
        self.half_edges
    }

    /// At right angles to the sides against the half-edges, each along its half-edge.
    #[inline]
    #[must_use]
    pub const fn normals(&self) -> [UnitVec3; 3] {
        self.normals
    }

    /// Whether the half-edges are left-handed.
    #[inline]
    #[must_use]
    pub const fn is_mirrored(&self) -> bool {
        self.is_mirrored
    }

    /// Its eight corners: bit k of a corner's place says on which end of edge k it is, 0 for the
    /// one against the half-edge.
    #[must_use]
    pub fn corners(&self) -> [Vec3; 8] {
        let along = |corner: usize, at: Vec3, k: usize| {
            let half = self.half_edges[k];
            if corner >> k & 1 == 1 { at + half } else { at - half }
        };
        core::array::from_fn(|corner| (0..3).fold(self.center, |at, k| along(corner, at, k)))
    }

    /// The smallest box along the axes around it. Exact.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let reach = [0, 1, 2].map(|k| self.half_edges.map(|e| e.raw()[k].abs()).into_iter().sum());
        let reach = Vec3::from_raw(reach);
        Aabb::new(self.center - reach, self.center + reach)
    }
}
