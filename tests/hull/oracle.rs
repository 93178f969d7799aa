//! The hull of points by looking at every plane through three of them.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use verlock::geometry::ConvexHull;

use super::Point;
use crate::corpus::laws::oracle::{Exact, cross, dot};

pub type Big = [BigInt; 3];

pub fn big(p: Point) -> Big {
    p.map(BigInt::from)
}

pub fn minus(a: &Big, b: &Big) -> Big {
    [0, 1, 2].map(|k| a[k].minus(&b[k]))
}

/// The sets of points in the planes that have points before them nowhere and behind them somewhere.
fn facets(points: &[Point]) -> BTreeSet<BTreeSet<Point>> {
    let places: Vec<Point> = points.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
    let zero = BigInt::from(0);
    let mut facets = BTreeSet::new();
    for (i, &a) in places.iter().enumerate() {
        for (j, &b) in places.iter().enumerate().skip(i + 1) {
            for &c in &places[j + 1..] {
                let a = big(a);
                let normal = cross(&minus(&big(b), &a), &minus(&big(c), &a));
                let heights: Vec<BigInt> =
                    places.iter().map(|&p| dot(&normal, &minus(&big(p), &a))).collect();
                let [front, behind] = [heights.iter().max(), heights.iter().min()];
                if (front == Some(&zero)) != (behind == Some(&zero)) {
                    let level = places.iter().zip(&heights).filter(|(_, h)| **h == zero);
                    facets.insert(level.map(|(&p, _)| p).collect());
                }
            }
        }
    }
    facets
}

/// The normal and the offset along it of every face of the hull around some points.
pub fn planes(points: &[Point]) -> Vec<(Big, BigInt)> {
    let places: Vec<Point> = points.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
    let mut planes = vec![];
    for facet in facets(points) {
        let mut facet = facet.into_iter().map(big);
        let (a, b) = (facet.next().expect("three"), facet.next().expect("three"));
        let normals = facet.map(|c| cross(&minus(&b, &a), &minus(&c, &a)));
        let zero = BigInt::from(0);
        let normal = normals.into_iter().find(|n| *n != [0, 0, 0].map(BigInt::from));
        let normal = normal.expect("not all on one line");
        let is_front = places.iter().any(|&p| dot(&normal, &minus(&big(p), &a)) > zero);
        let normal = if is_front { normal.map(|c| -c) } else { normal };
        let offset = dot(&normal, &a);
        planes.push((normal, offset));
    }
    planes
}

/// The corners and the corners of each face of the hull around some points; none if it is flat.
///
/// A point is a corner if no other is in all the faces that it is in.
pub fn hull(points: &[Point]) -> (BTreeSet<Point>, BTreeSet<BTreeSet<Point>>) {
    let facets = facets(points);
    let is_corner = |p: &Point| {
        let mut of_p = facets.iter().filter(|facet| facet.contains(p));
        let Some(first) = of_p.next() else { return false };
        let common = of_p.fold(first.clone(), |common, facet| &common & facet);
        common.len() == 1
    };
    let corners: BTreeSet<Point> = points.iter().copied().filter(is_corner).collect();
    let faces = facets.iter().map(|facet| facet & &corners).collect();
    (corners, faces)
}

/// The same of a hull.
pub fn of(hull: &ConvexHull) -> (BTreeSet<Point>, BTreeSet<BTreeSet<Point>>) {
    let at = |&vertex: &u32| hull.vertices()[vertex as usize].raw();
    let corners = hull.vertices().iter().map(|p| p.raw()).collect();
    (corners, hull.faces().map(|corners| corners.iter().map(at).collect()).collect())
}
