//! Hulls around points, against all planes; what their parts promise of themselves.

use std::collections::BTreeSet;

use verlock::geometry::{ConvexHull, ShapeError, Triangle, orient3d};
use verlock::math::Pcg;
use verlock::{Real, Vec3};

use super::oracle::{self, big, minus};
use super::{Cloud, Point, clouds, hull, shuffle, vectors};
use crate::corpus::laws::oracle::{cross, dot};

/// Corners and faces are those that looking at every plane finds, and flat ones are refused.
#[test]
fn hulls_are_those_of_all_planes() {
    let mut rng = Pcg::new(1, 0);
    let mut flat = 0;
    for cloud in clouds() {
        let points = cloud.draw(&mut rng);
        let expected = oracle::hull(&points);
        match ConvexHull::around(vectors(&points)) {
            Ok(hull) => {
                assert_eq!(oracle::of(&hull), expected, "{cloud:?}");
                validate(&hull, &points);
            }
            Err(error) => {
                assert_eq!((error, expected.1.len()), (ShapeError::Flat, 0), "{cloud:?}");
                flat += 1;
            }
        }
    }
    assert!(flat < 20, "{flat} flat ones");
}

/// The same for more and smaller ones: every arrangement of a few points that a small grid holds is
/// likely to come.
#[test]
fn small_hulls_are_those_of_all_planes() {
    let mut rng = Pcg::new(2, 0);
    let mut solid = 0;
    for round in 0..1500 {
        let (points, places) = (4 + round % 6, 2 + round % 3);
        let points = Cloud { points, places, step: 1, origin: [0; 3] }.draw(&mut rng);
        let expected = oracle::hull(&points);
        let Ok(hull) = ConvexHull::around(vectors(&points)) else {
            assert_eq!(expected.1.len(), 0, "{points:?}");
            continue;
        };
        assert_eq!(oracle::of(&hull), expected, "{points:?}");
        validate(&hull, &points);
        solid += 1;
    }
    assert!(solid > 1000, "only {solid} solid ones");
}

/// What the documentation says of vertices, faces, edges, normals and anchors.
fn validate(hull: &ConvexHull, points: &[Point]) {
    let vertices: Vec<Point> = hull.vertices().iter().map(|p| p.raw()).collect();
    // In the order in which the points came first.
    let mut left = points.iter();
    assert!(vertices.iter().all(|v| left.any(|p| p == v)), "{vertices:?} of {points:?}");
    let faces: Vec<&[u32]> = hull.faces().collect();
    assert!(faces.is_sorted());
    assert_eq!([hull.normals().len(), hull.anchors().len()], [faces.len(); 2]);
    let mut sides = BTreeSet::new();
    for (face, &corners) in (0..).zip(&faces) {
        assert_eq!(hull.face_corners(face), corners);
        assert_eq!(corners.iter().min(), corners.first());
        validate_face(hull, face, corners);
        for (&from, &to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            assert!(sides.insert((from, to, face)));
        }
    }
    assert!(hull.edges().is_sorted_by_key(|edge| edge.ends));
    for edge in hull.edges() {
        let ([low, high], [one, other]) = (edge.ends, edge.faces);
        assert!(low < high);
        assert!(sides.remove(&(low, high, one)) && sides.remove(&(high, low, other)));
    }
    assert_eq!(sides.len(), 0, "sides without an edge");
    for vertex in 0..hull.topology().vertices_len() {
        let ends = hull.edges().iter().map(|edge| edge.ends).filter(|ends| ends.contains(&vertex));
        let other = ends.map(|[low, high]| if low == vertex { high } else { low });
        let other = BTreeSet::from_iter(other);
        assert!(hull.topology().neighbours(vertex).iter().eq(&other), "{other:?}");
    }
    assert_eq!(vertices.len() + faces.len(), hull.edges().len() + 2, "Euler");
}

fn validate_face(hull: &ConvexHull, face: u32, corners: &[u32]) {
    let at = |vertex: u32| hull.vertices()[vertex as usize];
    for k in 0..corners.len() {
        let [a, b, c] = [k, k + 1, k + 2].map(|k| at(corners[k % corners.len()]));
        let behind = hull.vertices().iter().filter(|&&p| orient3d(a, b, c, p).is_lt()).count();
        assert_eq!(behind, hull.vertices().len() - corners.len(), "a strictly convex corner");
    }
    // All triples, in order: the widest is the first of the widest ones.
    let area_sq = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|k| big(at(k).raw()));
        let normal = cross(&minus(&b, &a), &minus(&c, &a));
        dot(&normal, &normal)
    };
    let widest = hull.topology().widest_corners()[face as usize];
    let mut best = None;
    for (i, &a) in corners.iter().enumerate() {
        for (j, &b) in corners.iter().enumerate().skip(i + 1) {
            for &c in &corners[j + 1..] {
                let area = area_sq([a, b, c]);
                if best.as_ref().is_none_or(|(greatest, _)| area > *greatest) {
                    best = Some((area, [a, b, c]));
                }
            }
        }
    }
    assert_eq!(best.map(|(_, corners)| corners), Some(widest));
    let normal = hull.normals()[face as usize].raw();
    let height = |vertex: u32| dot(&big(normal), &big(at(vertex).raw()));
    let anchor = hull.anchors()[face as usize];
    let first = corners.iter().copied().rev().max_by_key(|&corner| height(corner));
    assert_eq!(first, Some(anchor), "the first of the outermost");
}

/// Another order of the points gives the same hull with other numbers; repeated and inner points
/// change nothing.
#[test]
fn hulls_do_not_depend_on_the_order_of_points() {
    let mut rng = Pcg::new(3, 0);
    for cloud in clouds() {
        let mut points = cloud.draw(&mut rng);
        let Ok(before) = ConvexHull::around(vectors(&points)) else { continue };
        let own: Vec<Point> = before.vertices().iter().map(|p| p.raw()).collect();
        assert_eq!(hull(&own), before, "{cloud:?}");
        shuffle(&mut rng, &mut points);
        assert_eq!(oracle::of(&hull(&points)), oracle::of(&before), "{cloud:?}");
        let again: Vec<Point> = own.iter().chain(&points).copied().collect();
        assert_eq!(hull(&again), before, "{cloud:?}");
    }
}

/// Shifted points give the same hull, shifted.
#[test]
fn hulls_move_with_their_points() {
    let mut rng = Pcg::new(4, 0);
    for cloud in clouds().into_iter().filter(|cloud| cloud.origin == [0; 3]) {
        let points = cloud.draw(&mut rng);
        let Ok(here) = ConvexHull::around(vectors(&points)) else { continue };
        let way = [5, -(1 << 59) - 1, (1 << 58) + 12_345];
        let there =
            hull(&points.iter().map(|p| [0, 1, 2].map(|k| p[k] + way[k])).collect::<Vec<_>>());
        assert_eq!(here.topology(), there.topology());
        assert_eq!([here.normals()], [there.normals()]);
        assert_eq!(here.anchors(), there.anchors());
        assert_eq!(here.bounds().min() + Vec3::from_raw(way), there.bounds().min());
    }
}

/// What is too much, too long, too far or flat is named.
#[test]
fn bad_points_are_refused() {
    let far = Real::from_raw(Triangle::COORDINATE_MAX);
    let long = Real::from_raw(Triangle::SPAN_MAX);
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z];
    let refused = |points: &[Vec3]| ConvexHull::around(points.iter().copied()).err();
    assert_eq!(refused(&[]), Some(ShapeError::Flat));
    assert_eq!(refused(&[x; 9]), Some(ShapeError::Flat));
    assert_eq!(refused(&[Vec3::ZERO, x, x + x, -x]), Some(ShapeError::Flat));
    assert_eq!(refused(&[Vec3::ZERO, x, y, x + y, x - y]), Some(ShapeError::Flat));
    assert_eq!(refused(&[Vec3::ZERO, x, y, z]), None);
    assert_eq!(refused(&[Vec3::ZERO, x, y, z * long]), None);
    let longer = long + Real::ULP;
    assert_eq!(refused(&[Vec3::ZERO, x, y, z * longer]), Some(ShapeError::TooLong));
    let out = Vec3::new(far + Real::ULP, Real::ZERO, Real::ZERO);
    assert_eq!(refused(&[out, out - x, out - y, out - z]), Some(ShapeError::OutOfRange("points")));
    let many = std::iter::repeat_n(x, ConvexHull::POINTS_MAX + 1);
    assert_eq!(ConvexHull::around(many).err(), Some(ShapeError::WrongCount("points")));
}
