//! What can collide.

use super::MeshShape;
use crate::geometry::{
    Aabb, Capsule, ConvexHull, Cuboid, HalfSpace, HeightField, Sphere, Surface, Triangle,
};

/// A shape where it is. Whatever carries it, moves its points.
#[derive(Clone, Debug)]
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
    /// A convex polyhedron.
    ConvexHull(ConvexHull),
    /// Triangles that share vertices.
    MeshShape(MeshShape),
    /// Heights over a grid.
    HeightField(HeightField),
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
            Self::ConvexHull(hull) => Some(hull.bounds()),
            Self::MeshShape(mesh) => Some(mesh.bounds()),
            Self::HeightField(field) => Some(field.bounds()),
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

from_shape!(HalfSpace, Sphere, Capsule, Cuboid, ConvexHull, MeshShape, HeightField, Triangle);
