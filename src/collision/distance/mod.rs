//! How far apart two shapes are.

mod core;
mod skin;

pub(super) use self::core::{Core, View, along, height};
pub(super) use self::skin::{Skin, grown};

use super::Shape;
use crate::geometry::{HalfSpace, closest_convex, is_in_range};
use crate::math::wide::{round_shift_wide, to_i64};
use crate::math::{Real, UnitVec3, Vec3};

/// The nearest points of two shapes that are apart.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Closest {
    /// The point of A, metres. Of several, one of them.
    pub on_a: Vec3,
    /// The point of B, metres.
    pub on_b: Vec3,
    /// From A to B.
    pub normal: UnitVec3,
    /// In metres: above 0.
    pub distance: Real,
    /// Which part of A is nearest: the face of a mesh or height field, 0 for other shapes.
    pub part_a: u32,
    /// Which part of B.
    pub part_b: u32,
}

/// The nearest points of two shapes; `None` where they [overlap]. Meshes and height fields are
/// hollow: what is behind a face is as far from it as what is in front.
///
/// What is nearest is found exactly. Then points of flat-sided shapes are rounded once, the normal
/// is as exact as a unit vector is, and surfaces of round ones are as far along the normal as their
/// radius says.
#[must_use]
pub fn closest_points(a: &Shape, b: &Shape) -> Option<Closest> {
    closest(&a.view(), &b.view())
}

/// The distance of two shapes, in metres; 0 where they [overlap], and only there: not within a
/// mesh, which is hollow. It is wrong by less than two units of the last place.
#[must_use]
pub fn distance(a: &Shape, b: &Shape) -> Real {
    closest_points(a, b).map_or(Real::ZERO, |closest| closest.distance)
}

/// Whether two shapes have a point in common; touching counts. Exact, for a half-space as exact as
/// the length of its normal.
///
/// Of a mesh or height field only the faces are its points: what is inside without touching one
/// does not overlap. [`MeshShape::contains`](super::MeshShape::contains) tells what is inside, and
/// [`collide`](super::collide) leads it out.
#[must_use]
pub fn overlap(a: &Shape, b: &Shape) -> bool {
    closest_points(a, b).is_none()
}

impl Shape {
    /// Whether a point, in metres, is inside or on the surface; of a mesh or height field, which
    /// are hollow to queries, whether it is on a face. Exact. What is out of the range of shapes is
    /// in none.
    ///
    /// The inside of a closed mesh is told by [`MeshShape::contains`](super::MeshShape::contains).
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        is_in_range(point) && closest(&self.view(), &View::Convex(Core::point(point))).is_none()
    }
}

fn closest(a: &View, b: &View) -> Option<Closest> {
    match (a, b) {
        (View::Convex(a), View::Convex(b)) => of_convex(a, b, Vec3::ZERO),
        (View::HalfSpace(a), View::Convex(b)) => of_half_space(a, b),
        (View::Convex(a), View::HalfSpace(b)) => of_half_space(b, a).map(Closest::flipped),
        (View::HalfSpace(a), View::HalfSpace(b)) => of_half_spaces(a, b),
        (View::Skin(a), View::Convex(b)) => skin::to_convex(*a, b),
        (View::Convex(a), View::Skin(b)) => skin::to_convex(*b, a).map(Closest::flipped),
        (View::HalfSpace(a), View::Skin(b)) => skin::to_half_space(a, *b),
        (View::Skin(a), View::HalfSpace(b)) => skin::to_half_space(b, *a).map(Closest::flipped),
        (View::Skin(a), View::Skin(b)) => skin::to_skin(*a, *b),
    }
}

/// The nearest points of two convex shapes, the first of which is moved.
pub(super) fn of_convex(a: &Core, b: &Core, offset: Vec3) -> Option<Closest> {
    let radius = a.radius + b.radius;
    let found = closest_convex(a.points(), b.points(), offset, radius)?;
    let normal = found.normal;
    let on_a = found.on_a + along(normal, a.radius);
    let on_b = found.on_b - along(normal, b.radius);
    let distance = found.on_a.distance(found.on_b) - radius;
    Some(Closest::new([on_a, on_b], normal, distance))
}

fn of_half_space(a: &HalfSpace, b: &Core) -> Option<Closest> {
    let normal = a.normal();
    let heights = b.points().iter().map(|&point| (height(normal, point - a.point()), point));
    let (lowest, point) = heights.min_by_key(|&(height, _)| height)?;
    if lowest <= i128::from(b.radius.raw()) << 30 {
        return None;
    }
    let on_b = point - along(normal, b.radius);
    let above = Real::from_raw(to_i64(round_shift_wide(lowest, 30)));
    Some(Closest::new([point - along(normal, above), on_b], normal, above - b.radius))
}

/// Half-spaces overlap unless they face each other.
pub(super) fn of_half_spaces(a: &HalfSpace, b: &HalfSpace) -> Option<Closest> {
    let normal = a.normal();
    let gap = height(normal, b.point() - a.point());
    if normal != -b.normal() || gap <= 0 {
        return None;
    }
    let gap = Real::from_raw(to_i64(round_shift_wide(gap, 30)));
    Some(Closest::new([a.point(), a.point() + along(normal, gap)], normal, gap))
}

impl Closest {
    /// What is apart has a distance, even if that is rounded to none.
    fn new([on_a, on_b]: [Vec3; 2], normal: UnitVec3, distance: Real) -> Self {
        Self { on_a, on_b, normal, distance: distance.max(Real::ULP), part_a: 0, part_b: 0 }
    }

    /// The same with A and B exchanged.
    #[must_use]
    pub fn flipped(self) -> Self {
        Self {
            on_a: self.on_b,
            on_b: self.on_a,
            normal: -self.normal,
            distance: self.distance,
            part_a: self.part_b,
            part_b: self.part_a,
        }
    }
}
