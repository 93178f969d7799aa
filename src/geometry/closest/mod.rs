//! The nearest points of points, segments and triangles: exact, but for one rounding at the end.
//!
//! Which part of each is nearest is told by signs of dot products and of their products (Ericson,
//! *Real-Time Collision Detection*, 2005, 5.1), all exact: in 64 and 128 bits where everything is
//! within 64 m, in 128 and 256 elsewhere, and nobody can tell which. The point itself is a quotient
//! of integers, and rounded once.
//!
//! Parts are closed, and the smaller one wins where they meet: a foot at a corner is the corner's.
//! Then the lower number wins, which only triangles without an area leave to decide.

mod blend;
mod convex;
mod normal;
mod point_segment;
mod point_triangle;
mod segment_segment;
mod width;

pub(crate) use convex::{ClosestConvex, closest_convex};
pub use normal::{normal_point_segment, normal_point_triangle, normal_segment_segment};
pub use point_segment::closest_point_segment;
pub use point_triangle::closest_point_triangle;
pub use segment_segment::closest_segment_segment;

use super::Feature;
use crate::math::{Unit, Vec3};

/// The point of a segment (`N = 2`) or triangle (`N = 3`) that is nearest to something.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ClosestPoint<const N: usize> {
    /// Where it is, metres. Its difference from the lexicographically smallest end of the feature
    /// is exact until it is rounded, by components, to nearest; so it moves along when everything
    /// is moved, and does not depend on the order of corners.
    pub position: Vec3,
    /// The part that it lies on, and on no smaller one. A segment is its own edge 0.
    pub feature: Feature,
    /// Barycentric, one a corner: from 0 to 1, with a sum of exactly 1. Each is rounded to
    /// nearest; what is then amiss the largest one bears, of equal ones the first.
    pub weights: [Unit; N],
}

impl<const N: usize> ClosestPoint<N> {
    /// A corner.
    #[inline]
    fn at_corner(corners: &[Vec3; N], corner: u8) -> Self {
        let mut weights = [Unit::ZERO; N];
        weights[usize::from(corner)] = Unit::ONE;
        let position = corners[usize::from(corner)];
        Self { position, feature: Feature::Vertex(corner), weights }
    }
}
