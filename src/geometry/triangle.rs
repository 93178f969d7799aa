//! Three points.

use core::fmt;

use super::Aabb;
use crate::math::Vec3;

/// A triangle: three corners and all that lies between them, closed.
///
/// Corners may coincide or lie on one line: then it is a segment or a point, which every function
/// takes like any other triangle. Its numbers are such that exact predicates on two triangles whose
/// boxes meet fit 128 bits.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[repr(transparent)]
pub struct Triangle {
    corners: [Vec3; 3],
}

/// Why three points are not a [`Triangle`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum TriangleError {
    /// A coordinate is beyond [`Triangle::COORDINATE_MAX`].
    OutOfRange {
        /// The corner that has it: 0, 1 or 2.
        corner: u32,
    },
    /// It spans more than [`Triangle::SPAN_MAX`] along an axis.
    TooLong,
}

impl Triangle {
    /// No coordinate is beyond +-2^36 m (raw: 2^60), as in a world.
    pub const COORDINATE_MAX: i64 = 1 << 60;
    /// It spans no more than this along an axis, raw: 131,072 m less a step.
    pub const SPAN_MAX: i64 = (1 << 41) - 1;

    /// The triangle of these corners.
    ///
    /// # Errors
    /// [`TriangleError`] if a coordinate or the span is too large.
    pub fn new(corners: [Vec3; 3]) -> Result<Self, TriangleError> {
        for (corner, position) in (0..).zip(corners) {
            if !is_in_range(position) {
                return Err(TriangleError::OutOfRange { corner });
            }
        }
        let triangle = Self::between(corners);
        if triangle.is_short() { Ok(triangle) } else { Err(TriangleError::TooLong) }
    }

    /// The triangle of corners that are known to be in range.
    #[inline]
    pub(crate) const fn between(corners: [Vec3; 3]) -> Self {
        Self { corners }
    }

    /// Whether it spans no more than [`SPAN_MAX`](Self::SPAN_MAX).
    pub(super) fn is_short(&self) -> bool {
        self.bounds().span() <= Self::SPAN_MAX.unsigned_abs()
    }

    /// The corners, in metres.
    #[inline]
    #[must_use]
    pub const fn corners(&self) -> &[Vec3; 3] {
        &self.corners
    }

    /// The smallest box around it.
    #[inline]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let [a, b, c] = self.corners;
        Aabb::new(a, b).with(c)
    }

    /// Whether it has no area: the corners lie on one line. Exact.
    #[must_use]
    pub fn is_degenerate(&self) -> bool {
        let [a, b, c] = self.corners.map(Vec3::raw);
        let minor = |j: usize, k: usize| {
            // Sides are below 2^41 along each axis: products are below 2^82.
            let side = |p: &[i64; 3], k: usize| i128::from(p[k] - a[k]);
            side(&b, j) * side(&c, k) == side(&b, k) * side(&c, j)
        };
        minor(0, 1) && minor(1, 2) && minor(2, 0)
    }
}

/// Whether no coordinate is beyond [`Triangle::COORDINATE_MAX`].
pub(crate) fn is_in_range(position: Vec3) -> bool {
    let range = -Triangle::COORDINATE_MAX..=Triangle::COORDINATE_MAX;
    position.raw().iter().all(|c| range.contains(c))
}

impl fmt::Display for TriangleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange { corner } => write!(f, "corner {corner} is out of range"),
            Self::TooLong => f.write_str("triangle spans 131072 m or more"),
        }
    }
}

impl core::error::Error for TriangleError {}
