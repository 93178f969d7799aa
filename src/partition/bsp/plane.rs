//! Planes, and on which side of them boxes are.

use crate::geometry::Triangle;
use crate::math::Vec3;

/// A box along some axes: lowest and highest corner, raw.
pub(super) type Span<const D: usize> = [[i64; D]; 2];

/// All points whose product with the normal is the offset: a plane, or a line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Plane<const D: usize> {
    /// Of any length; components within +-2^30.
    normal: [i32; D],
    /// Raw.
    offset: i128,
}

/// Where a box is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Side {
    /// All of it has a smaller product.
    Behind,
    /// All of it has a larger one.
    Front,
    /// Some of it is on the plane.
    Across,
}

impl<const D: usize> Plane<D> {
    /// The points at this place along an axis.
    pub(super) fn across(axis: usize, place: i64) -> Self {
        let mut normal = [0; D];
        normal[axis] = 1;
        Self { normal, offset: i128::from(place) }
    }

    /// The plane of a triangle, nearly: its normal is rounded. `None` if the triangle is
    /// degenerate or lies across these axes. Every plane is as right as any other.
    pub(super) fn of(triangle: &Triangle, axes: [usize; D]) -> Option<Self> {
        let [a, b, c] = triangle.corners().map(Vec3::raw);
        // Edges are below 2^41, so these are below 2^83.
        let edge = |to: [i64; 3], k: usize| i128::from(to[k]) - i128::from(a[k]);
        let minor = |k: usize, l: usize| edge(b, k) * edge(c, l) - edge(b, l) * edge(c, k);
        let normal = axes.map(|axis| minor((axis + 1) % 3, (axis + 2) % 3));
        let longest = normal.into_iter().map(i128::unsigned_abs).max().filter(|&c| c != 0)?;
        let shift = (u128::BITS - longest.leading_zeros()).saturating_sub(30);
        // Within +-2^30 after the shift, which floors.
        let normal = normal.map(|c| i32::try_from(c >> shift).unwrap_or(0));
        let products = normal.iter().zip(axes);
        let offset = products.map(|(&n, axis)| i128::from(n) * i128::from(a[axis])).sum();
        Some(Self { normal, offset })
    }

    /// The side that a box is on, exactly.
    pub(super) fn side(&self, [low, high]: &Span<D>) -> Side {
        let mut least = -self.offset;
        let mut most = -self.offset;
        for k in 0..D {
            // Below 2^94 each, whatever the box is.
            let [a, b] = [low[k], high[k]].map(|c| i128::from(c) * i128::from(self.normal[k]));
            least += a.min(b);
            most += a.max(b);
        }
        if most < 0 {
            Side::Behind
        } else if least > 0 {
            Side::Front
        } else {
            Side::Across
        }
    }
}
