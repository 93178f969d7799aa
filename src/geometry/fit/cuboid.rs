//! Boxes around hulls.

use alloc::vec::Vec;
use core::cmp::Reverse;

use super::Fit;
use super::axis::{Scored, best, descend};
use super::frame::{FINE_BITS, Frame};
use super::rectangle::smallest_rectangle;
use crate::geometry::hull::across;
use crate::geometry::{ConvexHull, Cuboid, HullEdge, ShapeError};
use crate::math::determinant::{cross, dot};
use crate::math::wide::{dot_narrow, dot_wide, round_shift, round_shift_wide, sub, to_i64};
use crate::math::{Real, Unit, UnitVec3, Vec3};

/// No more of the largest faces are tried as sides of a box.
const FACES_MAX: usize = 256;
/// No more of the longest edges are tried, in pairs.
const EDGES_MAX: usize = 24;

/// A box around a hull, as small as a search finds it: with one side along a face or along two
/// edges, then turned downhill in volume. Around that axis it is the smallest, but for less than a
/// millionth of its size, or a few raw units. For n vertices O(n log n) a direction that is tried,
/// and O(k^2) where the hull has k corners as seen from there; of directions there are hundreds.
///
/// # Errors
/// [`ShapeError`] if it leaves the range of the world, or is too long.
pub fn fit_cuboid(hull: &ConvexHull) -> Result<Fit<Cuboid>, ShapeError> {
    let axes = box_axes(hull, &Frame::of(hull));
    let shape = around(hull, axes)?;
    let separations = shape.corners().map(|corner| hull.separation(corner));
    let deviation = separations.into_iter().fold(Real::ZERO, Real::max);
    Ok(Fit { shape, deviation })
}

/// The directions of the edges of the smallest box that is found, right-handed.
pub(super) fn box_axes(hull: &ConvexHull, frame: &Frame) -> [UnitVec3; 3] {
    let score = |axis| along(&frame.points, axis);
    let first = best(candidates(hull).into_iter().filter_map(score));
    // Solid hulls have a shadow everywhere, if they are not thinner than a unit.
    let start = first.map_or(UnitVec3::Y, |scored| scored.what[0]);
    let found = descend(start, score);
    found.map_or([UnitVec3::X, UnitVec3::Y, UnitVec3::Z], |scored| scored.what)
}

/// Directions that a side of a small box may face: those of large faces, and across two long edges.
fn candidates(hull: &ConvexHull) -> Vec<UnitVec3> {
    let size = |face: usize| {
        let corners = hull.topology().widest_corners()[face];
        let [a, b, c] = corners.map(|vertex| hull.vertices()[vertex as usize].raw());
        // Below 2^82, times at most 1: the length of the cross product.
        dot(&cross(sub(b, a), sub(c, a)), hull.normals()[face].raw())
    };
    let mut faces: Vec<_> =
        (0..hull.normals().len()).map(|face| Reverse((size(face), Reverse(face)))).collect();
    faces.sort_unstable();
    let normal =
        |&Reverse((_, Reverse(face))): &Reverse<(i128, Reverse<usize>)>| hull.normals()[face];
    let mut normals: Vec<_> = faces.iter().take(FACES_MAX).map(normal).collect();
    let ends = |edge: &HullEdge| edge.ends.map(|vertex| hull.vertices()[vertex as usize]);
    let mut edges: Vec<[i64; 3]> = hull
        .edges()
        .iter()
        .map(|edge| {
            let [a, b] = ends(edge);
            sub(b.raw(), a.raw())
        })
        .collect();
    edges.sort_by_key(|&edge| Reverse(dot_wide(edge, edge)));
    edges.truncate(EDGES_MAX);
    for (k, &a) in edges.iter().enumerate() {
        normals.extend(edges[..k].iter().filter_map(|&b| UnitVec3::normalize_wide(cross(a, b))));
    }
    normals
}

/// The smallest box with a side that faces along an axis.
fn along(points: &[[i64; 3]], axis: UnitVec3) -> Option<Scored<[UnitVec3; 3]>> {
    let [u, v] = across(axis.raw())?;
    // Below 2^53 before the shift, and differences below 2^30 behind it.
    let to = |way: UnitVec3, p: &[i64; 3]| {
        round_shift(dot_narrow(way.raw(), *p), Unit::FRACTION_BITS - FINE_BITS)
    };
    let rectangle = smallest_rectangle(points.iter().map(|p| [to(u, p), to(v, p)]).collect())?;
    let heights = points.iter().map(|p| to(axis, p));
    let (low, high) =
        heights.fold((i64::MAX, i64::MIN), |(low, high), t| (low.min(t), high.max(t)));
    let cost = rectangle.area * i128::from(high - low);
    // At most 2^62.
    let side = |k: usize| u.raw()[k] * rectangle.side[0] + v.raw()[k] * rectangle.side[1];
    let side = UnitVec3::normalize(Vec3::from_raw([0, 1, 2].map(side)))?;
    let other = UnitVec3::normalize_wide(cross(axis.raw(), side.raw()))?;
    Some(Scored { cost, what: [axis, side, other] })
}

/// The smallest box along axes that contains a hull. Rounding turns its sides a little: it grows
/// until every vertex is inside.
fn around(hull: &ConvexHull, axes: [UnitVec3; 3]) -> Result<Cuboid, ShapeError> {
    let origin = hull.vertices()[0].raw();
    let ranges = axes.map(|axis| {
        let reach = |v: &Vec3| {
            let way = sub(v.raw(), origin);
            // Below 3 * 2^71.
            (0..3).map(|k| i128::from(axis.raw()[k]) * i128::from(way[k])).sum::<i128>()
        };
        hull.vertices().iter().map(reach).fold((0, 0), |(low, high), t| (low.min(t), high.max(t)))
    });
    let sum = |lengths: [i128; 3], k: usize| {
        // Lengths are below 2^73, shares of them added below 2^105.
        let sum = (0..3).map(|i| i128::from(axes[i].raw()[k]) * lengths[i]).sum();
        to_i64(round_shift_wide(sum, 2 * Unit::FRACTION_BITS + 1))
    };
    let middle = ranges.map(|(low, high)| low + high);
    let center = Vec3::from_raw([0, 1, 2].map(|k| origin[k] + sum(middle, k)));
    let mut more = 0;
    loop {
        let half_edges = [0, 1, 2].map(|i| {
            let mut lengths = [0; 3];
            lengths[i] = ranges[i].1 - ranges[i].0 + (more << (Unit::FRACTION_BITS + 1));
            Vec3::from_raw([0, 1, 2].map(|k| sum(lengths, k)))
        });
        match Cuboid::new(center, half_edges) {
            Ok(cuboid) if hull.vertices().iter().all(|&v| contains(&cuboid, v)) => {
                return Ok(cuboid);
            }
            Ok(_) | Err(ShapeError::Flat) => more = 2 * more + 1,
            Err(error) => return Err(error),
        }
    }
}

/// Whether a point, of the world and at most 2^41 away, is in a box. Exact.
fn contains(cuboid: &Cuboid, point: Vec3) -> bool {
    let half = cuboid.half_edges().map(Vec3::raw);
    let way = sub(point.raw(), cuboid.center().raw());
    (0..3).all(|i| {
        // Below 2^41 and 2^83: below 3 * 2^124.
        let normal = cross(half[(i + 1) % 3], half[(i + 2) % 3]);
        dot(&normal, way).abs() <= dot(&normal, half[i]).abs()
    })
}
