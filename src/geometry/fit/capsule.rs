//! Capsules around hulls.

use alloc::vec::Vec;

use super::Fit;
use super::axis::{Scored, best, descend};
use super::ball::smallest_ball;
use super::cuboid::box_axes;
use super::frame::{FINE_BITS, Frame};
use super::sphere::distance_up;
use crate::geometry::hull::across;
use crate::geometry::{Capsule, ConvexHull, Feature, Segment, ShapeError, closest_point_segment};
use crate::math::root::isqrt;
use crate::math::wide::{dot_narrow, round_shift};
use crate::math::{Real, Unit, UnitVec3, Vec3};

/// The search sets out from no more directions.
const STARTS_MAX: usize = 5;

/// A capsule around a hull, as small as a search for the direction finds it: from the best of some
/// directions downhill in volume. Its axis goes where the radius can be least; as far as it pays to
/// be thicker and shorter, it is.
///
/// # Errors
/// [`ShapeError`] if it is larger than a [`Capsule`] can be, or leaves the range of the world.
pub fn fit_capsule(hull: &ConvexHull) -> Result<Fit<Capsule>, ShapeError> {
    let frame = Frame::of(hull);
    let score = |axis| along(&frame.points, axis);
    let found = best(starts(hull, &frame).into_iter().filter_map(|axis| descend(axis, score)));
    let ends = found.ok_or(ShapeError::Flat)?.what.map(|end| frame.place(end));
    let segment = Segment::new(ends)?;
    let distances = hull.vertices().iter().map(|&vertex| {
        let foot = closest_point_segment(vertex, &segment);
        // Between the ends the foot is rounded, by less than a unit.
        let rounded =
            if matches!(foot.feature, Feature::Vertex(_)) { Real::ZERO } else { Real::ULP };
        distance_up(vertex, foot.position) + rounded
    });
    let radius = distances.max().unwrap_or(Real::ZERO);
    let shape = Capsule::new(ends, radius)?;
    // A capsule is the hull of two balls, and the distance from a convex set is convex.
    let separations = ends.map(|end| hull.separation(end));
    Ok(Fit { shape, deviation: radius + separations[0].max(separations[1]) })
}

/// The best of the edges of a box, and of the ways from the middle of a cube to its faces, edges
/// and corners.
fn starts(hull: &ConvexHull, frame: &Frame) -> Vec<UnitVec3> {
    const WAYS: [[i64; 3]; 13] = [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
        [1, 1, 0],
        [1, -1, 0],
        [1, 0, 1],
        [1, 0, -1],
        [0, 1, 1],
        [0, 1, -1],
        [1, 1, 1],
        [1, 1, -1],
        [1, -1, 1],
        [-1, 1, 1],
    ];
    let ways = WAYS.into_iter().filter_map(|way| UnitVec3::normalize(Vec3::from_raw(way)));
    let mut starts: Vec<_> = box_axes(hull, frame).into_iter().chain(ways).collect();
    let cost = |&axis: &UnitVec3| along(&frame.points, axis).map(|scored| scored.cost);
    starts.sort_by_cached_key(cost);
    starts.truncate(STARTS_MAX);
    starts
}

/// The ends of the smallest capsule along an axis, in fine units.
fn along(points: &[[i64; 3]], axis: UnitVec3) -> Option<Scored<[[i64; 3]; 2]>> {
    let [u, v] = across(axis.raw())?;
    let project = |bits: u32| {
        let to = move |way: UnitVec3, p: [i64; 3]| {
            // Components are below 2^21: the sum is below 2^53.
            round_shift(dot_narrow(way.raw(), p), Unit::FRACTION_BITS - bits)
        };
        move |p: &[i64; 3]| [to(u, *p), to(v, *p), to(axis, *p)]
    };
    let flat: Vec<_> = points.iter().map(project(0)).map(|[x, y, _]| [x, y, 0]).collect();
    let circle = smallest_ball(&flat);
    let [x, y, _] = circle.center;
    // The height of every point, and the square of its distance from the axis: below 2^61.
    let high: Vec<_> = points
        .iter()
        .map(project(FINE_BITS))
        .map(|[px, py, t]| (t, (px - x).pow(2) + (py - y).pow(2)))
        .collect();
    // A thicker capsule may be so much shorter that it is smaller.
    let mut radius = circle.radius;
    let mut best = between(&high, radius);
    loop {
        radius += radius / 32 + 1;
        let thicker = between(&high, radius);
        if thicker.cost >= best.cost {
            break;
        }
        best = thicker;
    }
    let [first, last] = best.what;
    let place = |t: i64| {
        // Lengths are at most 1 and below 2^31: below 2^62.
        [0, 1, 2].map(|k| {
            let [u, v, axis] = [u, v, axis].map(|way| way.raw()[k]);
            round_shift(u * x + v * y + axis * t, Unit::FRACTION_BITS)
        })
    };
    Some(Scored { cost: best.cost, what: [first, last].map(place) })
}

/// Where along its axis the smallest capsule of a radius begins and ends.
fn between(high: &[(i64, i64)], radius: i64) -> Scored<[i64; 2]> {
    let (mut first, mut last) = (i64::MAX, i64::MIN);
    for &(t, far_sq) in high {
        // How far from the point's height an end may be and reach it. Radii are below 2^31.
        let left = (radius * radius - far_sq).max(0).unsigned_abs();
        let reach = isqrt(left).cast_signed();
        first = first.min(t + reach);
        last = last.max(t - reach);
    }
    if first > last {
        // One point would do: it is a ball.
        first = last + (first - last) / 2;
        last = first;
    }
    // Three quarters of the volume, over pi.
    let [radius, length] = [radius, last - first].map(i128::from);
    Scored { cost: radius * radius * (4 * radius + 3 * length), what: [first, last] }
}
