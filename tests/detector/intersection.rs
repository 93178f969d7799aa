//! Where triangles meet, against one that is clipped by the other in rational numbers.

use num_bigint::BigInt;
use verlock::Vec3;
use verlock::geometry::{
    Feature, Intersection, IntersectionPoint, Triangle, TriangleError,
    intersection_triangle_triangle, overlap_triangle_triangle,
};
use verlock::math::Pcg;

use super::overlap::CLASSES;
use super::{Corners, ORDERS, below, triangle};
use crate::corpus::laws::oracle::cross;

/// A point x/w, y/w, z/w with w > 0.
#[derive(Clone, Debug)]
struct Rational {
    xyz: [BigInt; 3],
    w: BigInt,
}

impl PartialEq for Rational {
    fn eq(&self, other: &Self) -> bool {
        (0..3).all(|k| &self.xyz[k] * &other.w == &other.xyz[k] * &self.w)
    }
}

impl From<[i64; 3]> for Rational {
    fn from(point: [i64; 3]) -> Self {
        Self { xyz: point.map(BigInt::from), w: BigInt::from(1) }
    }
}

/// The points where `normal . (x - point) >= 0`.
struct HalfSpace {
    normal: [BigInt; 3],
    point: [BigInt; 3],
}

impl HalfSpace {
    /// How far a point is inside, times something positive that all points share but for `w`.
    fn depth(&self, p: &Rational) -> BigInt {
        (0..3).map(|k| &self.normal[k] * (&p.xyz[k] - &self.point[k] * &p.w)).sum()
    }

    /// Both sides of a plane: the plane.
    fn plane(normal: &[BigInt; 3], point: &[BigInt; 3]) -> [Self; 2] {
        let side = |normal| Self { normal, point: point.clone() };
        [side(normal.clone()), side(normal.each_ref().map(|c| -c))]
    }
}

fn sub(a: &[BigInt; 3], b: &[BigInt; 3]) -> [BigInt; 3] {
    [0, 1, 2].map(|k| &a[k] - &b[k])
}

fn is_zero(v: &[BigInt; 3]) -> bool {
    v.iter().all(|c| *c == BigInt::ZERO)
}

/// The half-spaces whose common part is a triangle, a segment or a point.
fn half_spaces(corners: &Corners) -> Vec<HalfSpace> {
    let corners = corners.map(|corner| corner.map(BigInt::from));
    let edges = [[0, 1], [1, 2], [2, 0]];
    let along = edges.map(|[i, j]| sub(&corners[j], &corners[i]));
    let normal = cross(&along[0], &along[1]);
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis| axis.map(BigInt::from));
    let mut all = Vec::new();
    if !is_zero(&normal) {
        all.extend(HalfSpace::plane(&normal, &corners[0]));
        for (direction, [from, _]) in along.iter().zip(edges) {
            all.push(HalfSpace { normal: cross(&normal, direction), point: corners[from].clone() });
        }
    } else if let Some(direction) = along.iter().find(|direction| !is_zero(direction)) {
        for normal in axes.each_ref().map(|axis| cross(direction, axis)) {
            all.extend(HalfSpace::plane(&normal, &corners[0]));
        }
        // The ends are the first and the last corner in this direction.
        let dot = |p: &[BigInt; 3]| (0..3).map(|k| &p[k] * &direction[k]).sum::<BigInt>();
        let [first, last] =
            [corners.iter().min_by_key(|p| dot(p)), corners.iter().max_by_key(|p| dot(p))]
                .map(|end| end.expect("three corners").clone());
        all.push(HalfSpace { normal: direction.clone(), point: first });
        all.push(HalfSpace { normal: direction.each_ref().map(|c| -c), point: last });
    } else {
        axes.iter().for_each(|axis| all.extend(HalfSpace::plane(axis, &corners[0])));
    }
    all
}

/// What is left of a convex polygon in a half-space (Sutherland and Hodgman, 1974).
fn clip(polygon: &[Rational], half_space: &HalfSpace) -> Vec<Rational> {
    let mut kept: Vec<Rational> = Vec::new();
    for (index, from) in polygon.iter().enumerate() {
        let to = &polygon[(index + 1) % polygon.len()];
        let (here, there) = (half_space.depth(from), half_space.depth(to));
        if here >= BigInt::ZERO {
            kept.push(from.clone());
        }
        if (here > BigInt::ZERO && there < BigInt::ZERO)
            || (here < BigInt::ZERO && there > BigInt::ZERO)
        {
            // from + (to - from) t, with t = (here / w) / (here / w - there / w').
            let (a, b) = (&here * &to.w, &there * &from.w);
            let (a, b) = if a > b { (a, b) } else { (-a, -b) };
            let whole = &a - &b;
            let xyz = [0, 1, 2].map(|k| &a * &to.xyz[k] * &from.w - &b * &from.xyz[k] * &to.w);
            kept.push(Rational { xyz, w: whole * &from.w * &to.w });
        }
    }
    kept.dedup();
    while kept.len() > 1 && kept.first() == kept.last() {
        kept.pop();
    }
    kept
}

/// The corners of what two triangles have in common, around it.
fn common(a: &Corners, b: &Corners) -> Vec<Rational> {
    let start = a.map(Rational::from).to_vec();
    let polygon =
        half_spaces(b).iter().fold(start, |polygon, half_space| clip(&polygon, half_space));
    let direction = |from: &Rational, to: &Rational| {
        [0, 1, 2].map(|k| &to.xyz[k] * &from.w - &from.xyz[k] * &to.w)
    };
    // Points between their neighbours are no corners. A flat ring goes there and back.
    let is_corner = |&at: &usize| {
        let len = polygon.len();
        let [last, next] = [(at + len - 1) % len, (at + 1) % len].map(|k| &polygon[k]);
        let [u, v] = [direction(last, &polygon[at]), direction(&polygon[at], next)];
        let onward = (0..3).map(|k| &u[k] * &v[k]).sum::<BigInt>() > BigInt::ZERO;
        !(is_zero(&cross(&u, &v)) && onward)
    };
    let mut corners: Vec<Rational> = Vec::new();
    for at in (0..polygon.len()).filter(is_corner) {
        if !corners.contains(&polygon[at]) {
            corners.push(polygon[at].clone());
        }
    }
    corners
}

/// To nearest from the smallest corner, ties away from zero.
fn rounded(point: &Rational, base: [i64; 3]) -> Vec3 {
    Vec3::from_raw([0, 1, 2].map(|k| {
        let way = &point.xyz[k] - BigInt::from(base[k]) * &point.w;
        let magnitude = BigInt::from(way.magnitude().clone());
        let steps = (2 * magnitude + &point.w) / (2 * &point.w);
        let steps = i64::try_from(steps).expect("between two corners");
        base[k] + if way < BigInt::ZERO { -steps } else { steps }
    }))
}

/// The part of a triangle with an area that holds a point of it.
fn feature(point: &Rational, corners: &Corners) -> Feature {
    let corners = corners.map(|corner| corner.map(BigInt::from));
    let on_line = |edge: usize| {
        let (from, to) = (&corners[edge], &corners[(edge + 1) % 3]);
        let way = [0, 1, 2].map(|k| &point.xyz[k] - &from[k] * &point.w);
        is_zero(&cross(&sub(to, from), &way))
    };
    match [0, 1, 2].map(on_line) {
        [true, _, true] => Feature::Vertex(0),
        [true, true, _] => Feature::Vertex(1),
        [_, true, true] => Feature::Vertex(2),
        [true, ..] => Feature::Edge(0),
        [_, true, _] => Feature::Edge(1),
        [.., true] => Feature::Edge(2),
        [false, false, false] => Feature::Face,
    }
}

fn places(intersection: Option<&Intersection>) -> Vec<Vec3> {
    let points = intersection.map_or(&[][..], Intersection::points);
    points.iter().map(|point| point.position).collect()
}

/// Compares what is found with what is left by clipping; returns how many corners that has.
fn check([a, b]: [Corners; 2]) -> usize {
    let found = intersection_triangle_triangle(&triangle(a), &triangle(b));
    let expected = common(&a, &b);
    let base = *a.iter().chain(&b).min().expect("six corners");
    let mut round: Vec<_> = expected.iter().map(|point| rounded(point, base)).collect();
    let found_places = places(found.as_ref());
    let context = || format!("{a:?} {b:?}: {found:?}");
    let flat = [a, b].map(|corners| triangle(corners).is_degenerate());
    if flat == [false; 2] {
        for point in found.iter().flat_map(Intersection::points) {
            let IntersectionPoint { position, on_a, on_b } = *point;
            let same_place = (0..round.len()).filter(|&at| round[at] == position);
            let mut features =
                same_place.map(|at| [feature(&expected[at], &a), feature(&expected[at], &b)]);
            assert!(features.any(|features| features == [on_a, on_b]), "{}", context());
        }
    }
    if round.len() > 2 {
        // Around from the smallest, towards the smaller one of its neighbours.
        let len = round.len();
        let rings = (0..len).flat_map(|first| {
            let round = &round;
            [1, len - 1].map(|step| (0..len).map(|at| round[(first + at * step) % len]).collect())
        });
        let ring: Vec<Vec3> = rings.min().expect("a ring");
        assert_eq!(found_places, ring, "{}", context());
    } else {
        round.sort();
        if flat != [false; 2] {
            round.dedup();
        }
        assert_eq!(found_places, round, "{}", context());
    }
    expected.len()
}

#[test]
fn triangles_have_in_common_what_clipping_leaves() {
    let mut kinds = [0; 7];
    for (index, class) in (0..).zip(CLASSES) {
        let mut rng = Pcg::new(index, 100);
        for _ in 0..400 {
            let pair = class.pair(&mut rng);
            let corners = check(pair);
            kinds[corners] += 1;
            let [a, b] = pair.map(triangle);
            assert_eq!(corners > 0, overlap_triangle_triangle(&a, &b), "{pair:?}");
        }
    }
    // Nothing, a point, a segment, polygons.
    assert!(
        kinds[..5].iter().all(|&count| count > 20) && kinds[5] > 0 && kinds[6] > 0,
        "{kinds:?}"
    );
}

/// The middle corner of a segment lies inside of what is common, and its end is rounded past it.
#[test]
fn no_end_is_a_corner_inside() {
    let a = [[0, 2, 0], [0, 1, 2], [0, 0, 1]];
    check([a, [[0, 1, 1], [0, 2, 0], [0, 0, 2]]]);
}

/// `cargo test --release -- --ignored clipping`.
#[test]
#[ignore = "takes 17 s in a release build, minutes in a debug build"]
fn triangles_have_in_common_what_clipping_leaves_in_a_million_pairs() {
    let mut kinds = [0; 7];
    for (index, class) in (0..).zip(CLASSES) {
        let mut rng = Pcg::new(index, 101);
        (0..125_000).for_each(|_| kinds[check(class.pair(&mut rng))] += 1);
    }
    println!("corners of what was common: {kinds:?}");
}

#[test]
fn the_order_of_corners_changes_names_only() {
    let mut rng = Pcg::new(1, 102);
    // Two corners of what is common round to the smallest place, and two to the largest.
    let close = [[[4, 4, 0], [0, 1, 0], [7, 2, 0]], [[1, 1, 0], [7, 6, 0], [5, 6, 0]]];
    for class in CLASSES {
        for pair in (0..100).map(|_| class.pair(&mut rng)).chain([close]) {
            let [a, b] = pair.map(triangle);
            let expected = places(intersection_triangle_triangle(&a, &b).as_ref());
            for [order_a, order_b] in ORDERS.map(|a| ORDERS.map(|b| [a, b])).concat() {
                let [a, b] = [order_a.map(|k| pair[0][k]), order_b.map(|k| pair[1][k])];
                for pair in [[a, b], [b, a]] {
                    let [a, b] = pair.map(triangle);
                    let found = places(intersection_triangle_triangle(&a, &b).as_ref());
                    assert_eq!(found, expected, "{pair:?}");
                }
            }
        }
    }
}

#[test]
fn what_is_common_moves_along() {
    let mut rng = Pcg::new(2, 102);
    for class in CLASSES {
        for _ in 0..300 {
            let pair = class.pair(&mut rng);
            let way = [(); 3].map(|()| below(&mut rng, 1 << 60) - (1 << 59));
            let moved = pair.map(|corners| corners.map(|p| [0, 1, 2].map(|k| p[k] + way[k])));
            let [here, there] = [pair, moved].map(|pair| {
                let [a, b] = pair.map(triangle);
                intersection_triangle_triangle(&a, &b)
            });
            let way = Vec3::from_raw(way);
            let names = |found: Option<&Intersection>, way| {
                let points = found.map_or(&[][..], Intersection::points).iter();
                points.map(|p| (p.position + way, p.on_a, p.on_b)).collect::<Vec<_>>()
            };
            assert_eq!(names(here.as_ref(), way), names(there.as_ref(), Vec3::ZERO), "{pair:?}");
        }
    }
}

#[test]
fn what_is_too_large_is_refused() {
    let far = Triangle::COORDINATE_MAX;
    let of = |corners: Corners| Triangle::new(corners.map(Vec3::from_raw)).map(drop);
    assert_eq!(of([[far, -far, far]; 3]), Ok(()));
    for (corner, place) in [(1, far + 1), (2, -far - 1), (0, i64::MIN)] {
        let mut corners = [[far; 3]; 3];
        corners[corner][2] = place;
        let corner = u32::try_from(corner).expect("one of three");
        assert_eq!(of(corners), Err(TriangleError::OutOfRange { corner }));
    }
    let span = Triangle::SPAN_MAX;
    assert_eq!(of([[far; 3], [far, far - span, far], [far; 3]]), Ok(()));
    assert_eq!(of([[far; 3], [far, far - span - 1, far], [far; 3]]), Err(TriangleError::TooLong));
}
