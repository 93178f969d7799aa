//! What a shape can be, to the step, and the boxes around it.

use std::sync::Arc;

use verlock::collision::MeshShape;
use verlock::geometry::{
    Aabb, Capsule, Cuboid, HalfSpace, Segment, ShapeError, Sphere, Triangle, TriangleMesh,
};
use verlock::math::{Pcg, UnitVec3};
use verlock::{Real, Vec3};

const FAR: i64 = Triangle::COORDINATE_MAX;
const SPAN: i64 = Triangle::SPAN_MAX;
const RADIUS_MAX: Real = Sphere::RADIUS_MAX;

/// The same number thrice, raw.
fn diagonal(raw: i64) -> Vec3 {
    Vec3::from_raw([raw; 3])
}

#[test]
fn round_shapes_are_limited() {
    assert!(Sphere::new(diagonal(FAR), RADIUS_MAX).is_ok());
    assert!(Sphere::new(Vec3::ZERO, Real::ZERO).is_ok());
    let sphere = |raw, radius| Sphere::new(diagonal(raw), radius).map(drop);
    assert_eq!(sphere(FAR + 1, Real::ONE), Err(ShapeError::OutOfRange("center")));
    assert_eq!(sphere(i64::MIN, Real::ONE), Err(ShapeError::OutOfRange("center")));
    assert_eq!(sphere(0, -Real::ULP), Err(ShapeError::Negative("radius")));
    assert_eq!(sphere(0, RADIUS_MAX + Real::ULP), Err(ShapeError::TooLarge("radius")));

    let capsule = |raw: [i64; 2], radius| Capsule::new(raw.map(diagonal), radius).map(drop);
    assert_eq!(capsule([FAR - SPAN, FAR], RADIUS_MAX), Ok(()));
    assert_eq!(capsule([0, 0], Real::ZERO), Ok(()));
    assert_eq!(capsule([FAR - SPAN - 1, FAR], Real::ONE), Err(ShapeError::TooLong));
    assert_eq!(capsule([i64::MIN, i64::MAX], Real::ONE), Err(ShapeError::OutOfRange("end 0")));
    assert_eq!(capsule([0, FAR + 1], Real::ONE), Err(ShapeError::OutOfRange("end 1")));
    assert_eq!(capsule([0, 1], Real::MIN), Err(ShapeError::Negative("radius")));
    assert_eq!(capsule([0, 1], Real::MAX), Err(ShapeError::TooLarge("radius")));

    let segment = |raw: [i64; 2]| Segment::new(raw.map(diagonal)).map(drop);
    assert_eq!(segment([FAR - SPAN, FAR]), Ok(()));
    assert_eq!(segment([FAR - SPAN - 1, FAR]), Err(ShapeError::TooLong));
    assert_eq!(segment([-FAR - 1, -FAR]), Err(ShapeError::OutOfRange("end 0")));
    assert_eq!(segment([FAR, FAR + 1]), Err(ShapeError::OutOfRange("end 1")));
}

#[test]
fn thicknesses_are_limited() {
    let mesh = TriangleMesh::new([Vec3::ZERO, Vec3::X, Vec3::Z], [[0, 1, 2]]).expect("a mesh");
    let shape = MeshShape::new(Arc::new(mesh));
    let thick = |thickness| shape.clone().with_thickness(thickness).map(|s| s.thickness());
    assert_eq!(thick(RADIUS_MAX), Ok(RADIUS_MAX));
    let refused = |thickness| thick(thickness).unwrap_err().to_string();
    assert_eq!(refused(-Real::ULP), "thickness is below 0");
    assert_eq!(refused(Real::MAX), "thickness is above 32768 m");
}

/// What is refused is named, whether it is one thing or many.
#[test]
fn refusals_can_be_read() {
    for (error, text) in [
        (ShapeError::OutOfRange("end 1"), "end 1 out of range"),
        (ShapeError::OutOfRange("heights"), "heights out of range"),
        (ShapeError::Negative("radius"), "radius is below 0"),
        (ShapeError::TooLarge("radius"), "radius is above 32768 m"),
        (ShapeError::WrongCount("heights"), "heights are too many or too few"),
        (ShapeError::TooLong, "shape spans 131072 m or more"),
    ] {
        assert_eq!(error.to_string(), text);
    }
}

#[test]
fn boxes_are_limited() {
    let upright =
        |center, half: [i64; 3]| Cuboid::upright(diagonal(center), Vec3::from_raw(half)).map(drop);
    let longest = SPAN / 2;
    assert_eq!(upright(FAR - longest, [longest; 3]), Ok(()));
    assert_eq!(upright(FAR - longest, [-longest; 3]), Ok(()));
    assert_eq!(upright(longest - FAR, [longest, 1, 1]), Ok(()));
    assert_eq!(upright(0, [longest + 1, 1, 1]), Err(ShapeError::TooLong));
    assert_eq!(upright(0, [i64::MIN; 3]), Err(ShapeError::TooLong));
    assert_eq!(upright(FAR - 1, [2, 1, 1]), Err(ShapeError::OutOfRange("center")));
    assert_eq!(upright(i64::MIN, [1; 3]), Err(ShapeError::OutOfRange("center")));
    assert_eq!(upright(0, [1, 1, 0]), Err(ShapeError::Flat));

    let edges = |edges: [[i64; 3]; 3]| Cuboid::new(Vec3::ZERO, edges.map(Vec3::from_raw)).map(drop);
    let third = SPAN / 6;
    assert_eq!(edges([[third, 0, 0], [third, 1, 0], [third, 0, 1]]), Ok(()));
    assert_eq!(edges([[third; 3], [third + 3, 1, 0], [third, 0, 1]]), Err(ShapeError::TooLong));
    // In one plane, but no two along one line.
    assert_eq!(edges([[4, 2, 1], [2, 5, 3], [6, 7, 4]]), Err(ShapeError::Flat));
    assert_eq!(edges([[4, 2, 1], [2, 5, 3], [6, 7, 5]]), Ok(()));
}

#[test]
fn half_spaces_are_limited() {
    assert!(HalfSpace::new(diagonal(-FAR), UnitVec3::Y).is_ok());
    let refused = HalfSpace::new(diagonal(-FAR - 1), UnitVec3::Y);
    assert_eq!(refused, Err(ShapeError::OutOfRange("point")));
    let refused = HalfSpace::new(Vec3::ZERO, UnitVec3::from_raw([1 << 29; 3]));
    assert_eq!(refused, Err(ShapeError::NotUnit("normal")));
    assert_eq!(refused.unwrap_err().to_string(), "normal is not of length 1");
}

/// The box around a shape touches it on all sides.
#[test]
fn bounds_are_tight() {
    let mut rng = Pcg::new(5, 5);
    let mut point = |most: i64| {
        Vec3::from_raw([(); 3].map(|()| (rng.next_u64() >> 1).cast_signed() % (2 * most) - most))
    };
    for size in [10, 1 << 24, 1 << 36] {
        for _ in 0..200 {
            let center = point(1 << 50);
            let edges = [(); 3].map(|()| point(size));
            if let Ok(cuboid) = Cuboid::new(center, edges) {
                let corners = cuboid.corners();
                assert_eq!(Aabb::around(corners), Some(cuboid.bounds()));
                assert_eq!(corners[0] + corners[7] - center, center);
                let lengths = [1, 2, 4].map(|corner: usize| corners[corner] - corners[0]);
                assert_eq!(lengths, edges.map(|edge| edge + edge));
            }
            let radius = point(size).x.max(Real::ZERO);
            let ends = [center, center + point(size)];
            let capsule = Capsule::new(ends, radius).expect("in range").bounds();
            let balls = ends.map(|end| Sphere::new(end, radius).expect("in range").bounds());
            assert_eq!(capsule, balls[0].union(balls[1]));
            assert_eq!(balls[0].span(), 2 * radius.raw().unsigned_abs());
            assert_eq!(balls[0].max() - center, center - balls[0].min());
        }
    }
}
