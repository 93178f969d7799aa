//! Points that are outside of some faces of a hull.

use super::frame::{FINE_BITS, Frame, meet};
use crate::geometry::triangle::is_in_range;
use crate::geometry::{Aabb, ConvexHull, Triangle, orient3d};
use crate::math::determinant::{cross, dot};
use crate::math::root::isqrt_wide;
use crate::math::wide::{dot_narrow, round_shift, sub, to_i64};
use crate::math::{Unit, UnitVec3, Vec3};

/// Points are not looked for in front of more planes: edges with so many are kept.
const PLANES_MAX: usize = 16;

/// A point is pushed out no more than this often, each time twice as far.
const PUSHES_MAX: u32 = 8;

/// A plane that a point must not be behind.
pub(super) struct Plane {
    /// Three points of it, counter-clockwise, seen from the front.
    points: [Vec3; 3],
    normal: [i64; 3],
    /// `normal . x` of its points in units: below 2^53.
    offset: i64,
    /// How much it counts: below 2^46.
    area: i64,
}

/// The point in front of, or in, each of some planes that is least far in front of them, each
/// counting by its area, or nearly so; `None` if there is none, or where a hull with these bounds
/// cannot reach.
///
/// Of the faces around it, it is that to which the hull grows by the least volume. What rounding
/// does to it is undone by a push, and what counts is tested exactly. O(k^4) for k planes.
pub(super) fn outward(planes: &[Plane], frame: &Frame, bounds: Aabb) -> Option<Vec3> {
    if planes.len() > PLANES_MAX {
        return None;
    }
    let place = frame.place(best_meeting(planes)?);
    let all = |k: usize| planes.iter().map(|plane| plane.normal[k]).sum();
    let way = UnitVec3::normalize(Vec3::from_raw([0, 1, 2].map(all)))?;
    let pushed = |push: u32| {
        // Steps are 0, 1, 2, 4 and so on: at most 2^30 * 2^20 * 2^8.
        let step = frame.unit() * (1 << push >> 1);
        place + Vec3::from_raw(way.raw().map(|c| round_shift(c * step, Unit::FRACTION_BITS)))
    };
    let is_near = |&point: &Vec3| {
        is_in_range(point) && bounds.with(point).span() <= Triangle::SPAN_MAX.unsigned_abs()
    };
    let mut pushes = (0..PUSHES_MAX).map(pushed).filter(is_near);
    pushes.find(|&point| {
        let mut points = planes.iter().map(|plane| plane.points);
        points.all(|[a, b, c]| orient3d(a, b, c, point).is_ge())
    })
}

impl Plane {
    /// The plane of a face.
    pub(super) fn of_face(hull: &ConvexHull, frame: &Frame, face: u32) -> Option<Self> {
        let vertices = hull.vertices();
        let (&first, rest) = hull.face_corners(face).split_first()?;
        let sides = rest.windows(2).map(|side| [first, side[0], side[1]]);
        let area = sides.map(|corners| area(frame, corners.map(|k| vertices[k as usize]))).sum();
        let widest = hull.topology().widest_corners()[face as usize];
        Self::through(frame, widest.map(|vertex| vertices[vertex as usize]), area)
    }

    /// The plane through three points; `None` if they are on one line.
    pub(super) fn through(frame: &Frame, points: [Vec3; 3], area: i64) -> Option<Self> {
        let [a, b, c] = points.map(Vec3::raw);
        let normal = UnitVec3::normalize_wide(cross(sub(b, a), sub(c, a)))?.raw();
        let reach = |p: Vec3| dot_narrow(normal, frame.units(p));
        let offset = points.into_iter().map(reach).max()?;
        Some(Self { points, normal, offset, area })
    }

    /// Whether the plane is behind a point in fine units: the point is in front of it or in it, or
    /// so near that rounding cannot tell.
    fn is_behind(&self, x: [i128; 3]) -> bool {
        // Rounding moves a point by less than a fine unit.
        let slack = 1 << Unit::FRACTION_BITS;
        // Normals have length 2^30, points are below 2^32.
        let reach: i128 = (0..3).map(|k| i128::from(self.normal[k]) * x[k]).sum();
        reach + slack >= i128::from(self.offset) << FINE_BITS
    }
}

/// Of the points in front of all planes, or in them, the one that is least far in front of them,
/// each counting by its area. In fine units.
///
/// It is where three planes meet whose normals the sum of all normals, by area, lies between: then
/// whatever adds less volume is behind one of the three.
fn best_meeting(planes: &[Plane]) -> Option<[i64; 3]> {
    // At most 2^4 * 2^46 * 2^30.
    let weight = [0, 1, 2].map(|k| {
        let sum = planes.iter().map(|plane| i128::from(plane.area) * i128::from(plane.normal[k]));
        sum.sum::<i128>()
    });
    let weight = UnitVec3::normalize_wide(weight)?.raw();
    for (i, a) in planes.iter().enumerate() {
        for (j, b) in planes[..i].iter().enumerate() {
            for c in &planes[..j] {
                let normals = [a, b, c].map(|plane| plane.normal);
                if !is_between(normals, weight) {
                    continue;
                }
                // Values are below 2^60; products of normals at most 2^60: together 2^122.
                let values = [a, b, c].map(|plane| i128::from(plane.offset) << FINE_BITS);
                let Some(x) = meet(normals, values) else { continue };
                // What is too far away costs too much in any case.
                let is_near = x.iter().all(|c| c.abs() < 1 << 32);
                if is_near && planes.iter().all(|plane| plane.is_behind(x)) {
                    return Some(x.map(to_i64));
                }
            }
        }
    }
    None
}

/// Whether a direction is a sum of positive shares of three others, or of some of them.
fn is_between([a, b, c]: [[i64; 3]; 3], way: [i64; 3]) -> bool {
    // Lengths are 1: cross products at most 2^60, and with a direction at most 2^90.
    let volume = |a, b, c| dot(&cross(a, b), c).signum();
    let signs = [volume(b, c, way), volume(c, a, way), volume(a, b, way)];
    match volume(a, b, c) {
        0 => false,
        sign => signs.iter().all(|&other| other == sign || other == 0),
    }
}

/// Twice the area of a triangle, in square units: below 2^43.
pub(super) fn area(frame: &Frame, corners: [Vec3; 3]) -> i64 {
    let [a, b, c] = corners.map(|corner| frame.units(corner));
    let square = cross(sub(b, a), sub(c, a)).map(|c| c * c).into_iter().sum::<i128>();
    to_i64(isqrt_wide(square.unsigned_abs()).cast_signed())
}
