//! Manifolds of surfaces as they were accepted: the same on every machine.

use verlock::collision::{Contact, Manifold, Shape, collide};
use verlock::geometry::{Capsule, ConvexHull, Cuboid, HalfSpace, HeightField, Sphere, Triangle};
use verlock::math::{Pcg, UnitVec3};
use verlock::{Hash, Real, Vec3, real};

use super::solids::{Solid, direction, fixed, number};

/// Every number of a manifold.
fn bytes(manifold: &Manifold) -> Vec<u8> {
    let mut numbers = manifold.normal.raw().to_vec();
    for Contact { features, on_a, on_b, separation } in manifold.contacts() {
        numbers.extend(features.map(|feature| i64::from(feature.bits())));
        numbers.extend(on_a.raw().into_iter().chain(on_b.raw()));
        numbers.push(separation.raw());
    }
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// One of every kind, somewhere about 0 and not larger than 1 m.
fn shapes(rng: &mut Pcg) -> Vec<Shape> {
    let mut near = || fixed([(); 3].map(|()| 0.8 * number(rng)));
    let (half, upright) = (real!("0.4"), Vec3::new(real!("0.3"), real!("0.2"), real!("0.5")));
    let ends = [near(), near()];
    let heights: Vec<_> = (0..36).map(|_| near().x * half).collect();
    let corners = [near(), near(), near()];
    let cloud: Vec<_> = (0..12).map(|_| near()).collect();
    let ring = Solid::ring(8);
    let way = near();
    let mut mesh = ring.shape();
    let places: Vec<_> = ring.vertices.iter().map(|&p| fixed(p) + way).collect();
    mesh.move_to(&places).expect("in range");
    let origin = Vec3::new(real!("-1"), Real::ZERO, real!("-1"));
    let plane = HalfSpace::new(way, UnitVec3::normalize(fixed(direction(rng))).expect("long"));
    vec![
        Shape::from(plane.expect("legal")),
        Sphere::new(ends[0], half).expect("legal").into(),
        Capsule::new(ends, half).expect("legal").into(),
        Cuboid::upright(ends[1], upright).expect("legal").into(),
        ConvexHull::around(cloud).expect("legal").into(),
        mesh.into(),
        HeightField::new(origin, [half; 2], 6, heights).expect("legal").into(),
        Triangle::new(corners).expect("legal").into(),
    ]
}

#[test]
fn manifolds_are_as_accepted() {
    let mut rng = Pcg::new(11, 0);
    let (mut all, mut counts) = (Vec::new(), [[0; 3]; 8]);
    for _ in 0..20 {
        let (first, second) = (shapes(&mut rng), shapes(&mut rng));
        for (kind, a) in first.iter().enumerate() {
            for (surface, b) in second[5..].iter().enumerate() {
                let mut manifolds = Vec::new();
                collide(a, b, real!("0.1"), &mut manifolds);
                counts[kind][surface] += manifolds.len();
                manifolds.iter().for_each(|manifold| all.extend(bytes(manifold)));
            }
        }
    }
    assert!(counts.iter().flatten().all(|&count| count > 2), "{counts:?}");
    assert_eq!(Hash::of(&all).to_string(), "7c104a22cb088134ae54336c11032654");
}
