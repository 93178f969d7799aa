//! Distances of every two kinds of shapes.

use verlock::Vec3;
use verlock::collision::{Shape, closest_points, distance, overlap};
use verlock::math::{Pcg, Real};

use super::twin::Twin;
use super::{CLASSES, Draw, KINDS, kinds, moved};

/// The origin of a twin.
pub fn near(shape: &Shape) -> Vec3 {
    match shape {
        Shape::HalfSpace(s) => s.point(),
        _ => shape.bounds().expect("a box").min(),
    }
}

/// What the twin, its own rounding and the one here may differ by, raw: unit normals err by 2^-29.
pub fn slack(twin: f64, most: f64) -> f64 {
    4.0 + twin.abs() * 1e-8 + most * 1e-8
}

/// Checks a pair; whether it overlaps.
fn check(a: &Shape, b: &Shape, size: f64) -> bool {
    let origin = near(a);
    let twin = Twin::of(a, origin).distance(&Twin::of(b, origin));
    let slack = slack(twin, size);
    let found = closest_points(a, b);
    let told = distance(a, b).raw() as f64;
    let case = || format!("{a:?} and {b:?}: {found:?}, twin {twin}");
    assert_eq!(found.is_none(), overlap(a, b));
    assert_eq!(found.is_none(), told == 0.0);
    assert!((told - twin.max(0.0)).abs() <= slack, "{}", case());
    // On small grids, and without radii, the twin is exact.
    let is_exact = size <= 64.0
        && ![a, b]
            .iter()
            .any(|s| matches!(s, Shape::Sphere(_) | Shape::Capsule(_) | Shape::HalfSpace(_)));
    assert!(!is_exact || found.is_none() == (twin <= 0.0), "{}", case());
    let swapped = closest_points(b, a);
    assert_eq!(swapped.map(|c| c.distance), found.map(|c| c.distance), "{}", case());
    let Some(found) = found else { return true };
    assert!((found.on_a.distance(found.on_b).raw() as f64 - told).abs() <= slack, "{}", case());
    // Each point is on its own shape, and not in the other.
    for (shape, point, other) in [(a, found.on_a, b), (b, found.on_b, a)] {
        let point = Shape::from(verlock::geometry::Sphere::new(point, Real::ZERO).expect("near"));
        assert!(distance(shape, &point).raw() as f64 <= slack, "{}", case());
        let off = (distance(other, &point).raw() as f64 - told).abs();
        assert!(off <= slack, "{}", case());
    }
    false
}

fn compare(pairs: u32, stream: u64) {
    for (index, (unit, most)) in (0..).zip(CLASSES) {
        let mut overlaps = [0; 2];
        for kinds in kinds() {
            let rng = Pcg::new(index, stream + (kinds[0] * KINDS.len() + kinds[1]) as u64);
            let mut draw = Draw { rng, unit, most };
            for _ in 0..pairs {
                let [a, b] = draw.pair(kinds);
                overlaps[usize::from(check(&a, &b, (unit * most) as f64))] += 1;
            }
        }
        assert!(overlaps.iter().all(|&n| n > pairs), "class {index}: {overlaps:?}");
    }
}

#[test]
fn distances_are_those_of_the_twin() {
    compare(4, 100);
}

/// `cargo test --release -- --ignored distances`.
#[test]
#[ignore = "takes minutes in a release build"]
fn distances_are_those_of_the_twin_in_many_pairs() {
    compare(2_000, 300);
}

#[test]
fn moving_both_changes_nothing() {
    let mut draw = Draw { rng: Pcg::new(7, 7), unit: 1 << 12, most: 1 << 12 };
    for kinds in kinds() {
        for _ in 0..4 {
            let [a, b] = draw.pair(kinds);
            let way = draw.way(1 << 40);
            let expected = closest_points(&a, &b);
            let found = closest_points(&moved(&a, way), &moved(&b, way));
            let back = found.map(|c| verlock::collision::Closest {
                on_a: c.on_a - way,
                on_b: c.on_b - way,
                ..c
            });
            assert_eq!(back, expected);
        }
    }
}

/// What is inside and what is not.
#[test]
fn points_are_contained_where_the_twin_says() {
    for (unit, most) in CLASSES {
        let mut draw = Draw { rng: Pcg::new(8, most as u64), unit, most };
        for kind in 0..KINDS.len() {
            for _ in 0..20 {
                let [shape, point] = draw.pair([kind, 1]);
                let Shape::Sphere(ball) = point else { unreachable!("a sphere") };
                let point =
                    verlock::geometry::Sphere::new(ball.center(), Real::ZERO).expect("same");
                let origin = near(&shape);
                let twin = Twin::of(&shape, origin).distance(&Twin::of(&point.into(), origin));
                let slack = slack(twin, (unit * most) as f64);
                let is_in = shape.contains(ball.center());
                assert!(if is_in { twin <= slack } else { twin >= -slack }, "{shape:?}, {twin}");
            }
        }
    }
}
