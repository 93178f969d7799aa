//! What can collide.

use crate::geometry::{Aabb, Capsule, Cuboid, HalfSpace, Sphere, Triangle};

/// A shape where it is. Whatever carries it, moves its points.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Shape {
    /// Everything behind a plane.
    HalfSpace(HalfSpace),
    /// A ball.
    Sphere(Sphere),
    /// A ball swept along a segment.
    Capsule(Capsule),
    /// A box, in any position.
    Cuboid(Cuboid),
    /// A triangle, of both sides.
    Triangle(Triangle),
}

impl Shape {
    /// The smallest box around it; `None` around a half-space, which has no end. Exact. O(1).
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        match self {
            Self::HalfSpace(_) => None,
            Self::Sphere(sphere) => Some(sphere.bounds()),
            Self::Capsule(capsule) => Some(capsule.bounds()),
            Self::Cuboid(cuboid) => Some(cuboid.bounds()),
            Self::Triangle(triangle) => Some(triangle.bounds()),
        }
    }
}

/// A shape is made from any of those it may be.
macro_rules! from_shape {
    ($($shape:ident),*) => {
        $(impl From<$shape> for Shape {
            #[inline]
            fn from(shape: $shape) -> Self {
                Self::$shape(shape)
            }
        })*
    };
}

from_shape!(HalfSpace, Sphere, Capsule, Cuboid, Triangle);
