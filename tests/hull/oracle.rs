//! The hull of points by looking at every plane, in integers of any size.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use verlock::geometry::ConvexHull;

use super::Point;
use crate::corpus::laws::oracle::Exact;
use crate::corpus::laws::planes::{self, Plane};

pub type Big = [BigInt; 3];

pub fn big(p: Point) -> Big {
    p.map(BigInt::from)
}

pub fn minus(a: &Big, b: &Big) -> Big {
    [0, 1, 2].map(|k| a[k].minus(&b[k]))
}

/// The points in order, each once, and the planes of the faces of their hull.
pub fn planes(points: &[Point]) -> (Vec<Point>, Vec<Plane<BigInt>>) {
    let points: Vec<Point> = BTreeSet::from_iter(points.iter().copied()).into_iter().collect();
    let planes = planes::planes(&points.iter().map(|&p| big(p)).collect::<Vec<_>>());
    (points, planes)
}

/// The corners and the corners of each face of the hull around some points; none if it is flat.
pub fn hull(points: &[Point]) -> (BTreeSet<Point>, BTreeSet<BTreeSet<Point>>) {
    let (points, planes) = planes(points);
    let corners = (0..points.len()).filter(|&k| planes::is_corner(&planes, k));
    let corners: BTreeSet<Point> = corners.map(|k| points[k]).collect();
    let face = |plane: &Plane<BigInt>| -> BTreeSet<Point> {
        plane.points.iter().map(|&k| points[k]).filter(|p| corners.contains(p)).collect()
    };
    let faces = planes.iter().map(face).collect();
    (corners, faces)
}

/// The same of a hull.
pub fn of(hull: &ConvexHull) -> (BTreeSet<Point>, BTreeSet<BTreeSet<Point>>) {
    let at = |&vertex: &u32| hull.vertices()[vertex as usize].raw();
    let corners = hull.vertices().iter().map(|p| p.raw()).collect();
    (corners, hull.faces().map(|corners| corners.iter().map(at).collect()).collect())
}
