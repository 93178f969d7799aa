//! Hulls that are moved, and what is inside them.

use num_bigint::BigInt;
use verlock::Vec3;
use verlock::geometry::{ConvexHull, ShapeError, Triangle};
use verlock::math::{Pcg, UnitVec3};

use super::oracle::{self, big, minus};
use super::{Cloud, Point, clouds, hull};
use crate::corpus::laws::oracle::{cross, dot};

type Matrix = [Point; 3];

fn times(m: &Matrix, p: Point) -> Point {
    m.map(|row| (0..3).map(|k| row[k] * p[k]).sum())
}

fn determinant(m: &Matrix) -> BigInt {
    let [a, b, c] = m.map(big);
    dot(&cross(&a, &b), &c)
}

/// A matrix of small numbers.
fn matrix(rng: &mut Pcg) -> Matrix {
    [(); 3].map(|()| [(); 3].map(|()| i64::from(rng.below(9)) - 4))
}

fn vertices(hull: &ConvexHull) -> Vec<Point> {
    hull.vertices().iter().map(|p| p.raw()).collect()
}

fn moved(hull: &ConvexHull, places: &[Point]) -> Result<ConvexHull, ShapeError> {
    let places: Vec<Vec3> = places.iter().map(|&p| Vec3::from_raw(p)).collect();
    let mut copy = hull.clone();
    let result = copy.moved_to(&places);
    if result.is_err() {
        assert_eq!(&copy, hull, "it stays where it was");
    }
    let made = ConvexHull::with_topology(hull.topology().clone(), places);
    assert_eq!(made, result.map(|()| copy), "made there, or moved there");
    made
}

/// Every point of a small box is inside exactly if it is behind all planes.
#[test]
fn hulls_contain_what_is_behind_all_planes() {
    let mut rng = Pcg::new(5, 0);
    let mut counts = [0; 2];
    for cloud in clouds() {
        let points = cloud.draw(&mut rng);
        let Ok(hull) = ConvexHull::around(points.iter().map(|&p| Vec3::from_raw(p))) else {
            continue;
        };
        let (_, planes) = oracle::planes(&points);
        let mut check = |p: Point| {
            let inside = hull.contains(Vec3::from_raw(p));
            let expected = planes.iter().all(|plane| plane.is_before(&big(p)));
            assert_eq!(inside, expected, "{p:?} of {points:?}");
            counts[usize::from(inside)] += 1;
        };
        for _ in 0..40 {
            // A place of the cloud, a step further, or a raw unit beside it.
            let more = Cloud { places: cloud.places + 1, ..cloud };
            let [p] = more.draw(&mut rng)[..1] else { unreachable!() };
            check(p);
            check(p.map(|c| c + i64::from(rng.below(3)) - 1));
        }
        let [a, b] = [points[0], points[1]];
        check([0, 1, 2].map(|k| a[k] + (b[k] - a[k]) / 2));
        points.iter().for_each(|&p| check(p));
        check([i64::MAX; 3]);
        check([i64::MIN; 3]);
    }
    assert!(counts.iter().all(|&count| count > 300), "{counts:?}");
}

/// What an integer matrix does exactly, a hull that is moved by it does: faces stay, insides stay.
#[test]
fn hulls_follow_affine_maps() {
    let mut rng = Pcg::new(6, 0);
    let mut outcomes = [0; 3];
    for round in 0..400 {
        let cloud = Cloud { points: 5 + round % 20, places: 9, step: 1, origin: [-4; 3] };
        let points = cloud.draw(&mut rng);
        let Ok(rest) = ConvexHull::around(points.iter().map(|&p| Vec3::from_raw(p))) else {
            continue;
        };
        let (m, way) = (matrix(&mut rng), [3, -7, 1 << 59]);
        let shift = |p: Point| [0, 1, 2].map(|k| p[k] + way[k]);
        let image: Vec<Point> = vertices(&rest).iter().map(|&p| shift(times(&m, p))).collect();
        let sign = determinant(&m).cmp(&BigInt::from(0));
        let expected = [Err(ShapeError::Mirrored), Err(ShapeError::Flat), Ok(())];
        let expected = expected[(sign as i8 + 1).unsigned_abs() as usize];
        let result = moved(&rest, &image);
        outcomes[(sign as i8 + 1).unsigned_abs() as usize] += 1;
        assert_eq!(result.as_ref().map(|_| ()).map_err(|&error| error), expected);
        let Ok(result) = result else { continue };
        // The hull of the image has the same faces.
        let fresh = hull(&image);
        assert_eq!(oracle::of(&result), oracle::of(&fresh));
        assert_eq!(result.bounds(), fresh.bounds());
        for _ in 0..40 {
            let p = [(); 3].map(|()| i64::from(rng.below(11)) - 5);
            let there = Vec3::from_raw(shift(times(&m, p)));
            assert_eq!(rest.contains(Vec3::from_raw(p)), result.contains(there));
        }
    }
    assert!(outcomes.iter().all(|&count| count > 5), "{outcomes:?}");
}

/// Turned and rounded, a hull still contains its vertices, its normals are those of its widest
/// corners, and no corner of a face is in front of it.
#[test]
fn hulls_survive_rounding() {
    let mut rng = Pcg::new(7, 0);
    for size in [1 << 12, 1 << 24, 1 << 30, 1 << 40] {
        let cloud = Cloud { points: 40, places: 5, step: size / 5, origin: [-(size / 2); 3] };
        let rest = hull(&cloud.draw(&mut rng));
        for _ in 0..20 {
            // Columns of a turn: nearly so is enough.
            let mut axis = || {
                UnitVec3::normalize(Vec3::from_raw(
                    [(); 3].map(|()| rng.next_u64().cast_signed() >> 20),
                ))
            };
            let (Some(x), Some(y)) = (axis(), axis()) else { continue };
            let Some(z) =
                UnitVec3::normalize_wide(cross(&x.raw().map(i128::from), &y.raw().map(i128::from)))
            else {
                continue;
            };
            let Some(y) =
                UnitVec3::normalize_wide(cross(&z.raw().map(i128::from), &x.raw().map(i128::from)))
            else {
                continue;
            };
            let turn = |p: Point| {
                [0, 1, 2].map(|k| {
                    let columns = [x, y, z].map(|axis| i128::from(axis.raw()[k]));
                    let sum: i128 = (0..3).map(|j| columns[j] * i128::from(p[j])).sum();
                    i64::try_from((sum + (1 << 29)) >> 30).expect("in range")
                })
            };
            let image: Vec<Point> = vertices(&rest).iter().map(|&p| turn(p)).collect();
            let there = moved(&rest, &image).expect("a turn");
            assert!(there.vertices().iter().all(|&v| there.contains(v)));
            validate_planes(&there);
        }
    }
}

fn validate_planes(hull: &ConvexHull) {
    let at = |vertex: u32| big(hull.vertices()[vertex as usize].raw());
    for (face, corners) in hull.faces().enumerate() {
        let [a, b, c] = hull.topology().widest_corners()[face].map(at);
        let normal = cross(&minus(&b, &a), &minus(&c, &a));
        let narrow = normal.map(|c| i128::try_from(c).expect("in range"));
        assert_eq!(UnitVec3::normalize_wide(narrow), Some(hull.normals()[face]));
        let n = big(hull.normals()[face].raw());
        let anchor = dot(&n, &at(hull.anchors()[face]));
        assert!(corners.iter().all(|&corner| dot(&n, &at(corner)) <= anchor));
    }
}

/// Of a face of many corners in an arc and one far away, that one tells the normal, whatever its
/// number: of those in the arc alone, rounding would tilt it.
#[test]
fn far_corners_tell_normals() {
    let mut ways: Vec<Point> = Vec::new();
    for (x, y) in (1..15).flat_map(|x| (1..15).map(move |y| (x, y))) {
        let is_new = ways.iter().all(|way| way[0] * y != way[1] * x);
        ways.extend(is_new.then_some([x, y, 0]));
    }
    ways.sort_by(|a, b| (a[1] * b[0]).cmp(&(b[1] * a[0])));
    let mut arc: Vec<Point> = vec![[0; 3]];
    for way in ways {
        let end = *arc.last().expect("a start");
        arc.push([0, 1, 2].map(|k| end[k] + way[k]));
    }
    let far = Vec3::from_raw([-(1 << 24), 1 << 24, 0]);
    for place in 0..arc.len() {
        let mut points: Vec<_> = arc.iter().map(|&p| Vec3::from_raw(p)).collect();
        points.insert(place, far);
        points.push(Vec3::from_raw([-(1 << 23), 1 << 23, -(1 << 24)]));
        let hull = ConvexHull::around(points).expect("a hull");
        let number = hull.faces().position(|face| face.len() > 100).expect("a large face");
        let widest = hull.topology().widest_corners()[number];
        let is_far = |&corner: &u32| hull.vertices()[corner as usize] == far;
        assert!(widest.iter().any(is_far), "{place}: {widest:?}");
    }
}

/// Wrong numbers of vertices, and places that are too far or too far apart, are refused.
#[test]
fn bad_places_are_refused() {
    let rest = hull(&[[0; 3], [9, 0, 0], [0, 9, 0], [0, 0, 9]]);
    let refused = |places: &[Point]| moved(&rest, places).err();
    assert_eq!(refused(&[]), Some(ShapeError::WrongCount("vertices")));
    assert_eq!(refused(&[[0; 3]; 5]), Some(ShapeError::WrongCount("vertices")));
    assert_eq!(refused(&[[0; 3]; 4]), Some(ShapeError::Flat));
    let far = [(1 << 60) + 1, 0, 0];
    assert_eq!(refused(&[far; 4]), Some(ShapeError::OutOfRange("vertices")));
    let long = |span| refused(&[[0; 3], [span, 0, 0], [0, 9, 0], [0, 0, 9]]);
    assert_eq!(long(Triangle::SPAN_MAX), None);
    assert_eq!(long(Triangle::SPAN_MAX + 1), Some(ShapeError::TooLong));
    // The last two exchanged.
    assert_eq!(refused(&[[0; 3], [9, 0, 0], [0, 0, 9], [0, 9, 0]]), Some(ShapeError::Mirrored));
}
