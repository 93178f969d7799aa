//! Convex shapes as points and a radius.

use super::skin::{Skin, grown};
use crate::collision::Shape;
use crate::geometry::{Aabb, HalfSpace, Triangle};
use crate::math::determinant::{cross, dot};
use crate::math::wide::{round_shift_wide, to_i64};
use crate::math::{Real, UnitVec3, Vec3};

/// A convex shape: the hull of some points, and all that is within a radius of it.
pub(in crate::collision) struct Core<'a> {
    points: Points<'a>,
    pub(in crate::collision) radius: Real,
}

enum Points<'a> {
    One([Vec3; 1]),
    Two([Vec3; 2]),
    Three([Vec3; 3]),
    Eight([Vec3; 8]),
    Many(&'a [Vec3]),
}

/// How a shape is looked at.
pub(in crate::collision) enum View<'a> {
    HalfSpace(&'a HalfSpace),
    Convex(Core<'a>),
    Skin(Skin<'a>),
}

impl Core<'_> {
    /// At least one.
    pub(in crate::collision) fn points(&self) -> &[Vec3] {
        match &self.points {
            Points::One(points) => points,
            Points::Two(points) => points,
            Points::Three(points) => points,
            Points::Eight(points) => points,
            Points::Many(points) => points,
        }
    }

    pub(in crate::collision) fn point(point: Vec3) -> Self {
        Self { points: Points::One([point]), radius: Real::ZERO }
    }

    /// Whether it is a triangle on whose plane another does not come, at the start, at the end or
    /// between. Quick, and silent in case of doubt.
    pub(in crate::collision) fn is_passed_by(&self, other: &Core, motion: Vec3) -> bool {
        let Points::Three([a, b, c]) = self.points else { return false };
        // Sides are below 2^41, so that a normal is below 2^83 and a height below 2^127.
        let is_near = |way: Vec3| way.raw().into_iter().all(|c| c.unsigned_abs() < 1 << 42);
        let normal = cross((b - a).raw(), (c - a).raw());
        // A round shape reaches as far as the normal is long, which is no more than this: 2^124.
        let length = normal.iter().map(|c| c.unsigned_abs()).sum::<u128>();
        let reach = length * u128::from(other.radius.raw().unsigned_abs());
        let mut is_free = [true; 2]; // behind and in front
        for &point in other.points() {
            for way in [point - a, point + motion - a] {
                if !is_near(way) {
                    return false;
                }
                let height = dot(&normal, way.raw());
                is_free[usize::from(height > 0)] = false;
                if height.unsigned_abs() <= reach {
                    return false;
                }
            }
        }
        is_free != [false; 2]
    }

    /// The box around it.
    pub(in crate::collision) fn bounds(&self) -> Aabb {
        let points = self.points();
        let around = points.iter().fold(Aabb::of_point(points[0]), |all, &p| all.with(p));
        grown(&around, self.radius)
    }
}

impl From<Triangle> for Core<'_> {
    fn from(triangle: Triangle) -> Self {
        Self { points: Points::Three(*triangle.corners()), radius: Real::ZERO }
    }
}

impl Shape {
    pub(in crate::collision) fn view(&self) -> View<'_> {
        let (points, radius) = match self {
            Self::HalfSpace(half_space) => return View::HalfSpace(half_space),
            Self::Sphere(sphere) => (Points::One([sphere.center()]), sphere.radius()),
            Self::Capsule(capsule) => (Points::Two(capsule.ends()), capsule.radius()),
            Self::Cuboid(cuboid) => (Points::Eight(cuboid.corners()), Real::ZERO),
            Self::MeshShape(mesh) => return View::Skin(Skin::Mesh(mesh)),
            Self::HeightField(field) => return View::Skin(Skin::Field(field)),
            Self::ConvexHull(hull) => (Points::Many(hull.vertices()), Real::ZERO),
            Self::Triangle(triangle) => (Points::Three(*triangle.corners()), Real::ZERO),
        };
        View::Convex(Core { points, radius })
    }
}

/// `normal * length`, rounded.
pub(in crate::collision) fn along(normal: UnitVec3, length: Real) -> Vec3 {
    // Below 2^31 * 2^62.
    let part = |n: i64| to_i64(round_shift_wide(i128::from(n) * i128::from(length.raw()), 30));
    Vec3::from_raw(normal.raw().map(part))
}

/// `normal . way`, exact, in units of 2^-54.
pub(in crate::collision) fn height(normal: UnitVec3, way: Vec3) -> i128 {
    // Ways are below 2^63, so that each product is below 2^94.
    normal.raw().into_iter().zip(way.raw()).map(|(n, c)| i128::from(n) * i128::from(c)).sum()
}
