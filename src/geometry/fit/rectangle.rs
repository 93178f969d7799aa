//! The smallest rectangle around points of a plane.

use alloc::vec::Vec;

/// A direction, and the area of the smallest rectangle around some points that has a side along it.
#[derive(Clone, Copy)]
pub(super) struct Rectangle {
    pub(super) side: [i64; 2],
    pub(super) area: i128,
}

/// The smallest rectangle around points that differ by at most 2^30; `None` if they all lie on one
/// line. One of its sides is along a side of their hull (Freeman, Shapira 1975). O(n log n), and
/// O(k^2) for a hull of k corners.
pub(super) fn smallest_rectangle(points: Vec<[i64; 2]>) -> Option<Rectangle> {
    let hull = hull(points);
    if hull.len() < 3 {
        return None;
    }
    let sides = (0..hull.len()).map(|k| {
        let (a, b) = (hull[k], hull[(k + 1) % hull.len()]);
        let side @ [x, y] = [b[0] - a[0], b[1] - a[1]];
        // Both at most 2^60, and times the length of the side too long.
        let [long, wide] = [extent(&hull, side), extent(&hull, [-y, x])].map(i128::from);
        Rectangle { side, area: long * wide / i128::from(x * x + y * y) }
    });
    sides.min_by_key(|rectangle| rectangle.area)
}

/// How far points reach along a direction, times its length.
fn extent(points: &[[i64; 2]], way: [i64; 2]) -> i64 {
    let origin = points[0];
    let reach = |p: &[i64; 2]| (p[0] - origin[0]) * way[0] + (p[1] - origin[1]) * way[1];
    let (mut low, mut high) = (0, 0);
    for at in points.iter().map(reach) {
        low = low.min(at);
        high = high.max(at);
    }
    high - low
}

/// The hull of points, counter-clockwise (Andrew's monotone chain, 1979).
fn hull(mut points: Vec<[i64; 2]>) -> Vec<[i64; 2]> {
    points.sort_unstable(); // equal ones are dropped
    points.dedup();
    let mut hull = half(points.iter().copied());
    hull.extend(half(points.iter().rev().copied()));
    hull
}

/// The corners on the right of the way from the first point to the last, without the last one.
fn half(points: impl Iterator<Item = [i64; 2]>) -> Vec<[i64; 2]> {
    let mut corners: Vec<[i64; 2]> = Vec::new();
    for p in points {
        while let [.., a, b] = corners[..] {
            let turn = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            if turn > 0 {
                break;
            }
            corners.pop();
        }
        corners.push(p);
    }
    corners.pop();
    corners
}
