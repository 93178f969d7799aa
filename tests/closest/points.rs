//! Nearest points: right, rounded once, and the same however they are asked for.

use num_bigint::BigInt;
use verlock::geometry::{
    ClosestPoint, Feature, Segment, Triangle, closest_point_segment, closest_point_triangle,
    closest_segment_segment, normal_point_segment, normal_point_triangle, normal_segment_segment,
};
use verlock::math::{Pcg, UnitVec3};
use verlock::{Hash, Vec3};

use super::oracle::{Rational, big, cross, nearest, on_segment, on_segments, on_triangle, sub};
use super::{CLASSES, below};

fn segment(ends: [Vec3; 2]) -> Segment {
    Segment::new(ends).expect("in range")
}

fn triangle(corners: [Vec3; 3]) -> Triangle {
    Triangle::new(corners).expect("in range")
}

/// Weights that are no weights, or of corners that the feature does not have, or not of that point.
fn check_weights<const N: usize>(found: &ClosestPoint<N>, corners: [Vec3; N]) {
    let weights = found.weights.map(|weight| i128::from(weight.raw()));
    assert!(weights.iter().all(|weight| (0..=1 << 30).contains(weight)));
    assert_eq!(weights.iter().sum::<i128>(), 1 << 30);
    let used = |corner: usize| match found.feature {
        Feature::Vertex(vertex) => corner == usize::from(vertex),
        Feature::Edge(edge) => {
            let edge = usize::from(edge);
            corner == edge || corner == (edge + 1) % N
        }
        Feature::Face => true,
    };
    assert!((0..N).all(|corner| used(corner) || weights[corner] == 0), "{found:?}");
    for k in 0..3 {
        let base = corners[0].raw()[k];
        let from = |p: Vec3| i128::from(p.raw()[k] - base);
        let sum: i128 = (0..N).map(|i| from(corners[i]) * weights[i]).sum();
        let span = (0..N).map(|i| from(corners[i]).abs()).max().unwrap_or(0);
        // Half a unit of each weight, and two for the largest.
        let slack = span * 4 + (1 << 30);
        assert!((sum - (from(found.position) << 30)).abs() <= slack, "{found:?} of {corners:?}");
    }
}

/// A direction is that of the exact vector to 1.7 units of 2^-30, or none for none.
fn check_normal(normal: Option<UnitVec3>, [from, to]: &[Rational; 2]) {
    let way = [0, 1, 2].map(|k| &to.xyz[k] * &from.w - &from.xyz[k] * &to.w);
    let square: BigInt = way.iter().map(|c| c * c).sum();
    let Some(normal) = normal else {
        assert_eq!(square, BigInt::ZERO);
        return;
    };
    assert!(square > BigInt::ZERO, "a direction of no distance");
    let length = (square << 80_u32).sqrt();
    let most = (BigInt::from(17) << 40_u32).magnitude() / 10_u32;
    for (way, unit) in way.iter().zip(normal.raw()) {
        // In units of 2^-70.
        let exact: BigInt = (way << 110_u32) / &length;
        let off = exact - (BigInt::from(unit) << 40_u32);
        assert!(off.magnitude() <= &most, "{normal:?}, {way}");
    }
}

fn check_segment(point: Vec3, ends: [Vec3; 2]) -> ClosestPoint<2> {
    let found = closest_point_segment(point, &segment(ends));
    let at = Rational::of(point);
    let pair = nearest(on_segment(point, ends).into_iter().map(|foot| [at.clone(), foot]));
    assert!(pair[1].rounds_to(found.position), "{point:?} and {ends:?}: {found:?}");
    check_weights(&found, ends);
    check_normal(normal_point_segment(point, &segment(ends), found.feature), &pair);
    let turned = closest_point_segment(point, &segment([ends[1], ends[0]]));
    assert_eq!(turned.position, found.position);
    found
}

fn check_triangle(point: Vec3, corners: [Vec3; 3]) -> ClosestPoint<3> {
    let found = closest_point_triangle(point, &triangle(corners));
    let at = Rational::of(point);
    let pair = nearest(on_triangle(point, corners).into_iter().map(|foot| [at.clone(), foot]));
    assert!(pair[1].rounds_to(found.position), "{point:?} and {corners:?}: {found:?}");
    check_weights(&found, corners);
    check_normal(normal_point_triangle(point, &triangle(corners), found.feature), &pair);
    for order in [[1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]] {
        let turned = closest_point_triangle(point, &triangle(order.map(|k| corners[k])));
        assert_eq!(turned.position, found.position, "{point:?} and {corners:?} in {order:?}");
    }
    found
}

fn check_segments(a: [Vec3; 2], b: [Vec3; 2]) -> [ClosestPoint<2>; 2] {
    let found = closest_segment_segment(&segment(a), &segment(b));
    let pair = nearest(on_segments(a, b));
    if is_parallel(a, b) {
        // Of several nearest pairs the oracle has another: the distance is the same, but for half
        // a unit a component of either.
        let exact = pair[0].distance_sq(&pair[1]);
        let [p, q] = found.map(|found| Rational::of(found.position));
        let root = |[n, d]: [BigInt; 2]| ((n << 20_u32) / d).sqrt();
        let off = root(exact) - root(p.distance_sq(&q));
        assert!(off.magnitude() <= BigInt::from(2 << 10).magnitude(), "{a:?} and {b:?}: {found:?}");
    } else {
        let right = found.iter().zip(&pair).all(|(found, exact)| exact.rounds_to(found.position));
        assert!(right, "{a:?} and {b:?}: {found:?}");
    }
    check_weights(&found[0], a);
    check_weights(&found[1], b);
    let features = found.map(|found| found.feature);
    let normal = normal_segment_segment(&segment(a), &segment(b), features);
    check_normal(normal, &pair);
    let swapped = closest_segment_segment(&segment(b), &segment(a));
    assert_eq!(swapped.map(|foot| foot.position), [found[1].position, found[0].position]);
    let turned = closest_segment_segment(&segment([a[1], a[0]]), &segment(b));
    assert_eq!(turned.map(|foot| foot.position), found.map(|foot| foot.position));
    found
}

fn is_parallel(a: [Vec3; 2], b: [Vec3; 2]) -> bool {
    let [u, v] = [a, b].map(|[from, to]| sub(&big(to), &big(from)));
    cross(&u, &v).iter().all(|c| *c == BigInt::ZERO)
}

/// As many cases of every class, and how often which feature was nearest.
fn compare(cases: u32, stream: u64) {
    let mut seen = [[0; 3]; 3];
    let mut count = |which: usize, feature: Feature| {
        seen[which][match feature {
            Feature::Vertex(_) => 0,
            Feature::Edge(_) => 1,
            Feature::Face => 2,
        }] += 1;
    };
    for (index, class) in (0..).zip(CLASSES) {
        let mut rng = Pcg::new(index, stream);
        for _ in 0..cases {
            let [a, b, p] = class.points(&mut rng);
            count(0, check_segment(p, [a, b]).feature);
            let [a, b, c, p] = class.points(&mut rng);
            count(1, check_triangle(p, [a, b, c]).feature);
            let [a, b, c, d] = class.points(&mut rng);
            count(2, check_segments([a, b], [c, d])[0].feature);
        }
    }
    // A test of features that are all alike would prove little.
    assert!(
        seen.iter()
            .enumerate()
            .all(|(i, seen)| { seen[..if i == 1 { 3 } else { 2 }].iter().all(|&n| n > cases / 2) })
    );
}

#[test]
fn nearest_points_are_those_of_the_oracle() {
    compare(400, 31);
}

/// `cargo test --release -- --ignored nearest_points`.
#[test]
#[ignore = "takes minutes in a release build"]
fn nearest_points_are_those_of_the_oracle_in_millions_of_cases() {
    compare(200_000, 32);
}

/// Points need not be near, and need not be where a world may be.
#[test]
fn far_points_have_nearest_points() {
    let mut rng = Pcg::new(33, 0);
    for class in CLASSES {
        for _ in 0..100 {
            let [a, b, c] = class.points(&mut rng);
            let bits = [40, 50, 61, 63][rng.below(4) as usize];
            let point =
                Vec3::from_raw([(); 3].map(|()| rng.next_u64().cast_signed() >> (63 - bits)));
            check_segment(point, [a, b]);
            check_triangle(point, [a, b, c]);
        }
    }
    for corner in [i64::MIN, i64::MAX] {
        let [a, b, c] = [Vec3::ZERO, Vec3::X, Vec3::Y];
        check_triangle(Vec3::from_raw([corner; 3]), [a, b, c]);
        check_segment(Vec3::from_raw([corner; 3]), [a, b]);
    }
}

/// Segments as far apart as a world is wide.
#[test]
fn far_segments_have_nearest_points() {
    let mut rng = Pcg::new(34, 0);
    for class in CLASSES {
        for _ in 0..100 {
            let [a, b, c, d] = class.points(&mut rng);
            let shift = Vec3::from_raw([(); 3].map(|()| below(&mut rng, 1 << 60) - (1 << 59)));
            check_segments([a, b], [c + shift, d + shift]);
        }
    }
}

#[test]
fn moving_everything_moves_nearest_points() {
    let mut rng = Pcg::new(35, 0);
    for class in CLASSES {
        for _ in 0..300 {
            let way = Vec3::from_raw([(); 3].map(|()| below(&mut rng, 1 << 60) - (1 << 59)));
            let [a, b, c, d] = class.points(&mut rng);
            let moved = [a, b, c, d].map(|p| p + way);
            let here = closest_point_triangle(d, &triangle([a, b, c]));
            let there = closest_point_triangle(moved[3], &triangle([moved[0], moved[1], moved[2]]));
            assert_eq!(ClosestPoint { position: here.position + way, ..here }, there);
            let here = closest_segment_segment(&segment([a, b]), &segment([c, d]));
            let there = closest_segment_segment(
                &segment([moved[0], moved[1]]),
                &segment([moved[2], moved[3]]),
            );
            let here = here.map(|foot| ClosestPoint { position: foot.position + way, ..foot });
            assert_eq!(here, there);
        }
    }
}

/// Parallel segments meet in the middle of what they have side by side.
#[test]
fn parallel_segments_are_nearest_in_the_middle() {
    let at = |x| Vec3::from_ints(x, 0, 0);
    let above = |x| Vec3::from_ints(x, 5, 0);
    for (a, b, middle) in [([0, 8], [2, 4], 3), ([0, 8], [6, -2], 3), ([0, 8], [8, 9], 8)] {
        let [on_a, on_b] = check_segments(a.map(at), b.map(above));
        assert_eq!([on_a.position, on_b.position], [at(middle), above(middle)]);
    }
    let [on_a, on_b] = check_segments([at(0), at(8)], [above(10), above(20)]);
    assert_eq!([on_a.position, on_b.position], [at(8), above(10)]);
}

/// The same bytes on every machine.
#[test]
fn nearest_points_are_as_accepted() {
    let mut bytes = Vec::new();
    let mut keep = |position: Vec3, feature: Feature, weights: &[verlock::math::Unit]| {
        position.raw().iter().for_each(|c| bytes.extend(c.to_le_bytes()));
        weights.iter().for_each(|weight| bytes.extend(weight.raw().to_le_bytes()));
        bytes.push(match feature {
            Feature::Vertex(corner) => corner,
            Feature::Edge(edge) => 3 + edge,
            Feature::Face => 6,
        });
    };
    for (index, class) in (0..).zip(CLASSES) {
        let mut rng = Pcg::new(index, 36);
        for _ in 0..300 {
            let [a, b, c, d] = class.points(&mut rng);
            let foot = closest_point_triangle(d, &triangle([a, b, c]));
            keep(foot.position, foot.feature, &foot.weights);
            for foot in closest_segment_segment(&segment([a, b]), &segment([c, d])) {
                keep(foot.position, foot.feature, &foot.weights);
            }
        }
    }
    assert_eq!(Hash::of(&bytes).to_string(), "11da72fae6da0d73c60a682390d1e402");
}
