//! Balls around hulls.

use super::Fit;
use super::ball::smallest_ball;
use super::frame::Frame;
use crate::geometry::{ConvexHull, ShapeError, Sphere};
use crate::math::root::isqrt_wide_up;
use crate::math::wide::to_i64;
use crate::math::{Real, Vec3};

/// The smallest ball around a hull, but for less than a millionth of its size, or two raw units.
/// O(vertices).
///
/// # Errors
/// [`ShapeError`] if it is larger than a [`Sphere`] can be.
pub fn fit_sphere(hull: &ConvexHull) -> Result<Fit<Sphere>, ShapeError> {
    let frame = Frame::of(hull);
    let center = frame.place(smallest_ball(&frame.points).center);
    let distances = hull.vertices().iter().map(|&vertex| distance_up(vertex, center));
    let radius = distances.max().unwrap_or(Real::ZERO);
    let shape = Sphere::new(center, radius)?;
    // The farthest point of the ball is right beyond the nearest one of the hull's surface.
    Ok(Fit { shape, deviation: radius + hull.separation(center) })
}

/// The distance of two points of the world, rounded up.
pub(super) fn distance_up(a: Vec3, b: Vec3) -> Real {
    let square = (a - b).length_sq_wide();
    // Below 2^63: points are within 2^60 along each axis.
    Real::from_raw(to_i64(isqrt_wide_up(square).cast_signed()))
}
