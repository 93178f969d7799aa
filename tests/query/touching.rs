//! What overlaps has a manifold, down to single raw units, where roundings are as large as shapes.

use verlock::Vec3;
use verlock::collision::{Shape, manifold_convex_convex, overlap};
use verlock::geometry::{Aabb, Capsule, Cuboid};
use verlock::math::{Pcg, Real};

use super::{CLASSES, Draw, KINDS};

/// What axes may be wrong by, as stated: a unit, and 2^-29 of what both span.
fn rounding(a: &Shape, b: &Shape) -> Real {
    let bounds = [a, b].into_iter().filter_map(Shape::bounds).reduce(Aabb::union);
    Real::from_raw(1 + bounds.map_or(0, |bounds| (bounds.span() >> 29) as i64))
}

#[test]
fn what_overlaps_has_a_manifold() {
    let convex = |kind: &usize| !["mesh", "height field"].contains(&KINDS[*kind]);
    let (mut count, mut rounded) = (0, 0);
    for (class, (unit, most)) in CLASSES.into_iter().enumerate() {
        let mut draw = Draw { rng: Pcg::new(31, class as u64), unit, most };
        for kinds in super::kinds().filter(|kinds| kinds.iter().all(convex) && kinds != &[0, 0]) {
            for _ in 0..200 {
                let [a, b] = draw.pair(kinds);
                if !overlap(&a, &b) {
                    continue;
                }
                count += 1;
                if manifold_convex_convex(&a, &b, Real::ZERO).is_none() {
                    rounded += 1;
                    let found = manifold_convex_convex(&a, &b, rounding(&a, &b));
                    assert!(found.is_some(), "{a:?} {b:?}");
                }
            }
        }
    }
    println!("{rounded} of {count} within roundings");
    assert!(count > 5_000, "only {count}");
}

/// A point of radius 1 in a small box: its nearest point is rounded away from it.
#[test]
fn a_unit_of_overlap_is_told() {
    let at = |raw: [i64; 3]| Vec3::from_raw(raw);
    let half_edges = [at([0, 3, 6]), at([-4, 1, 3]), at([-3, 8, -7])];
    let a: Shape = Cuboid::new(at([-2, 5, -1]), half_edges).expect("legal").into();
    let b: Shape = Capsule::new([at([-3, 8, 8]); 2], Real::ULP).expect("legal").into();
    assert!(overlap(&a, &b));
    for [a, b] in [[&a, &b], [&b, &a]] {
        let found = manifold_convex_convex(a, b, Real::ZERO).expect("told");
        assert_eq!(found.separation(), Real::ZERO);
    }
}
