//! Points that are outside of some faces of a hull.

use alloc::vec::Vec;

use super::frame::{FINE_BITS, Frame, meet};
use crate::geometry::triangle::is_in_range;
use crate::geometry::{ConvexHull, Triangle, orient3d};
use crate::math::determinant::{cross, dot};
use crate::math::wide::{round_shift, sub, to_i64};
use crate::math::{Unit, UnitVec3, Vec3};

/// Points are not looked for in front of more faces: edges of so many are kept.
const FACES_MAX: usize = 16;

/// A point is pushed out no more than this often, each time twice as far.
const PUSHES_MAX: u32 = 8;

/// The plane of a face, in units.
struct Plane {
    normal: [i64; 3],
    /// `normal . x` of its points: below 2^52.
    offset: i64,
    /// Of the face, doubled: below 2^46.
    area: i64,
}

/// The point in front of, or in the plane of, each of some faces that adds the least volume, or
/// nearly so; `None` if there is none.
///
/// The volume is linear in the point, so that a corner of the region in front is the best: where
/// three planes meet. What rounding does to it is undone by a push, and what counts is tested
/// exactly. O(k^4) for k faces.
pub(super) fn outward(hull: &ConvexHull, frame: &Frame, faces: &[u32]) -> Option<Vec3> {
    if faces.len() > FACES_MAX {
        return None;
    }
    let planes: Vec<Plane> = faces.iter().map(|&face| Plane::of(hull, frame, face)).collect();
    let place = frame.place(best_meeting(&planes)?);
    let all = |k: usize| planes.iter().map(|plane| plane.normal[k]).sum();
    let way = UnitVec3::normalize(Vec3::from_raw([0, 1, 2].map(all)))?;
    let pushed = |push: u32| {
        // Steps are 0, 1, 2, 4 and so on: at most 2^30 * 2^20 * 2^8.
        let step = frame.unit() * (1 << push >> 1);
        place + Vec3::from_raw(way.raw().map(|c| round_shift(c * step, Unit::FRACTION_BITS)))
    };
    let mut pushes = (0..PUSHES_MAX).map(pushed).filter(|&point| is_near(hull, point));
    pushes.find(|&point| faces.iter().all(|&face| is_in_front(hull, face, point)))
}

impl Plane {
    fn of(hull: &ConvexHull, frame: &Frame, face: u32) -> Self {
        let normal = hull.normals()[face as usize].raw();
        let corners = hull.face_corners(face).iter().map(|&corner| frame.points[corner as usize]);
        let reach = |p: [i64; 3]| (0..3).map(|k| normal[k] * p[k]).sum::<i64>();
        let offset = corners.clone().map(reach).max().unwrap_or(0);
        let first = hull.face_corners(face)[0];
        let from = |p: [i64; 3]| sub(p, frame.points[first as usize]);
        // Components of sums are below 2^45, times at most 1.
        let sides: Vec<[i64; 3]> = corners.map(from).collect();
        let fan = sides.windows(2).map(|side| cross(side[0], side[1]));
        let area: i128 =
            fan.map(|c| (0..3).map(|k| c[k] * i128::from(normal[k])).sum::<i128>()).sum();
        Self { normal, offset, area: to_i64(area >> Unit::FRACTION_BITS) }
    }

    /// Whether a point in fine units is in front of it, or so near that rounding can tell.
    fn is_behind(&self, x: [i128; 3]) -> bool {
        // Rounding moves a point by less than a fine unit.
        let slack = 1 << Unit::FRACTION_BITS;
        // Normals have length 1, points are below 2^33.
        let reach: i128 = (0..3).map(|k| i128::from(self.normal[k]) * x[k]).sum();
        reach + slack >= i128::from(self.offset) << FINE_BITS
    }
}

/// Of the points that no plane is in front of, the one that is least far in front of the planes,
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

/// Whether a hull may reach to a point.
fn is_near(hull: &ConvexHull, point: Vec3) -> bool {
    is_in_range(point) && hull.bounds().with(point).span() <= Triangle::SPAN_MAX.unsigned_abs()
}

/// Whether a point is in front of a face, or in its plane. Exact.
fn is_in_front(hull: &ConvexHull, face: u32, point: Vec3) -> bool {
    let corners = hull.topology().widest_corners()[face as usize];
    let [a, b, c] = corners.map(|vertex| hull.vertices()[vertex as usize]);
    orient3d(a, b, c, point).is_ge()
}
