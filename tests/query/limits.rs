//! The largest shapes, as far apart as they may be, and numbers that are no place.

use std::sync::Arc;

use verlock::Vec3;
use verlock::collision::{
    Colliders, Filter, MeshShape, Shape, cast, cast_segment, closest_points, overlap,
};
use verlock::geometry::{
    Aabb, Capsule, ConvexHull, Cuboid, HalfSpace, HeightField, Segment, Sphere, Triangle,
    TriangleMesh,
};
use verlock::math::{Real, UnitVec3};

const SPAN: i64 = Triangle::SPAN_MAX;
const FAR: i64 = Triangle::COORDINATE_MAX;

/// One shape of every kind, as large as it may be, in a corner of the world: that of three bits.
fn largest(corner: u32) -> [Shape; 8] {
    // From the corner inwards.
    let at = |x: i64, y: i64, z: i64| {
        let raw = [x, y, z];
        let place = |k: usize| if corner >> k & 1 == 1 { FAR - raw[k] } else { raw[k] - FAR };
        Vec3::from_raw([place(0), place(1), place(2)])
    };
    let tips = [at(0, 0, 0), at(SPAN, SPAN, 0), at(SPAN, 0, SPAN), at(0, SPAN, SPAN)];
    let half = SPAN / 2;
    let middle = at(half, half, half);
    let mesh = TriangleMesh::new(tips, [[0, 1, 2], [0, 2, 3]]).expect("legal");
    let lowest = Aabb::around(tips).expect("four").min();
    let heights = [0, half, SPAN - 1, 0].map(Real::from_raw);
    [
        HalfSpace::new(tips[0], UnitVec3::normalize(middle - tips[0]).expect("a way"))
            .expect("legal")
            .into(),
        Sphere::new(tips[0], Sphere::RADIUS_MAX).expect("legal").into(),
        Capsule::new([tips[0], tips[1]], Sphere::RADIUS_MAX).expect("legal").into(),
        Cuboid::upright(middle, Vec3::from_raw([half; 3])).expect("legal").into(),
        ConvexHull::around(tips).expect("legal").into(),
        MeshShape::new(Arc::new(mesh)).into(),
        HeightField::new(lowest, [Real::from_raw(SPAN); 2], 2, heights).expect("legal").into(),
        Triangle::new([tips[0], tips[1], tips[2]]).expect("legal").into(),
    ]
}

/// Nothing is too large or too far, and what is apart stays so.
#[test]
fn the_largest_shapes_have_distances() {
    let home = largest(0);
    let motions = [[i64::MAX; 3], [i64::MIN, 0, i64::MAX], [FAR, -FAR, FAR], [SPAN, 1, 0]];
    for corner in [0, 1, 5, 7] {
        for b in &largest(corner) {
            for a in &home {
                let found = closest_points(a, b);
                assert_eq!(found.is_none(), overlap(b, a));
                for motion in motions.map(Vec3::from_raw) {
                    for motion in [motion, Vec3::from_raw(motion.raw().map(|c| c.saturating_neg()))]
                    {
                        let hit = cast(a, motion, b);
                        assert_eq!(hit.is_some_and(|hit| hit.touch.is_none()), found.is_none());
                    }
                }
            }
            let segment = Segment::new([Vec3::ZERO, Vec3::from_raw([SPAN; 3])]).expect("legal");
            assert_eq!(cast_segment(&segment, b), None);
            assert!(!b.contains(Vec3::from_raw([i64::MAX, 0, i64::MIN])));
        }
    }
}

/// Queries may be as large as numbers go.
#[test]
fn sets_hold_the_largest_shapes() {
    let mut set = Colliders::new();
    for corner in [0, 7] {
        for shape in largest(corner) {
            // Round ones reach beyond the range.
            let is_round = matches!(shape, Shape::Sphere(_) | Shape::Capsule(_));
            assert_eq!(set.insert(shape.into()).is_err(), is_round);
        }
    }
    for probe in &largest(0) {
        for reach in [Real::MIN, Real::ZERO, Real::MAX] {
            let near = set.closest(probe, reach, &Filter::ALL);
            let expected = if reach < Real::ZERO { 0 } else { 1 };
            assert!(near.len() >= expected, "{} within {reach:?}", near.len());
        }
        for motion in [[i64::MAX; 3], [i64::MIN; 3]] {
            assert!(!set.cast(probe, Vec3::from_raw(motion), &Filter::ALL).is_empty());
        }
    }
}
