//! Boxes, by poses that are known and by random ones.

use verlock::collision::{FeatureId, manifold_cuboid_cuboid};
use verlock::geometry::Cuboid;
use verlock::math::{Real, UnitVec3};
use verlock::{Vec3, real};

use super::draw::{Draw, METRE, twin_of_cuboid};
use super::{check, twin};

/// How large boxes are, metres to either side, and how far apart in their sizes.
const SCALES: [f64; 4] = [0.5, 0.01, 15.0, 9000.0];

/// One random pair.
fn pair(draw: &mut Draw, size: f64) -> [Cuboid; 2] {
    let a = draw.cuboid([0.0; 3], size);
    let center = draw.within(size * 2.0);
    let b = draw.cuboid(center, size);
    match draw.below(4) {
        // Close to touching: along the best axis, to a hundredth of the size.
        0 | 1 => {
            let (p, q) = (twin_of_cuboid(&a, Vec3::ZERO), twin_of_cuboid(&b, Vec3::ZERO));
            let Some(found) = manifold_cuboid_cuboid(&a, &b, real!("16384")) else { return [a, b] };
            let gap = twin::gap(&p, &q);
            let n = super::float(found.normal);
            let way = n.map(|c| c * (0.01 * size * draw.number() - gap));
            let way = Vec3::from_raw(way.map(|c| (c * METRE) as i64));
            [a, Cuboid::new(b.center() + way, b.half_edges()).expect("in range")]
        }
        _ => [a, b],
    }
}

fn agree(seed: u64, pairs: usize) {
    let mut draw = Draw::new(seed);
    let (mut touching, mut strays) = (0, 0);
    for k in 0..pairs {
        let size = SCALES[k % SCALES.len()];
        let [a, b] = pair(&mut draw, size);
        let margin = Real::from_raw((size * 0.05 * METRE * draw.number().abs()) as i64);
        let found = manifold_cuboid_cuboid(&a, &b, margin);
        let twins = [&a, &b].map(|cuboid| twin_of_cuboid(cuboid, a.center()));
        strays += check(found.as_ref(), twins.each_ref(), a.center(), margin);
        touching += usize::from(found.is_some());
    }
    assert!(strays <= 1 + pairs / 10_000, "{strays} contacts beside shapes");
    assert!(touching > pairs / 4 && touching < pairs, "{touching} of {pairs}");
}

#[test]
fn manifolds_are_those_of_the_twin() {
    agree(1, 4_000);
}

#[test]
#[ignore = "a million poses: a minute"]
fn a_million_manifolds_are_those_of_the_twin() {
    agree(2, 1_000_000);
}

fn upright(center: Vec3, half: Vec3) -> Cuboid {
    Cuboid::upright(center, half).expect("a box")
}

/// A crate on a floor touches with its four lower corners, by name.
#[test]
fn a_box_rests_on_four_corners() {
    let floor = upright(Vec3::ZERO, Vec3::from_ints(5, 1, 5));
    let sunk = real!("0.001");
    let above = upright(Vec3::Y * (real!("1.5") - sunk), Vec3::ONE * real!("0.5"));
    let found = manifold_cuboid_cuboid(&floor, &above, Real::ZERO).expect("they touch");
    assert_eq!(found.normal, UnitVec3::Y);
    let corners = [0, 1, 4, 5].map(|corner| [FeatureId::face(3), FeatureId::vertex(corner)]);
    assert!(found.contacts().iter().map(|contact| contact.features).eq(corners));
    for contact in found.contacts() {
        assert_eq!(contact.separation, -sunk);
        assert_eq!(contact.on_a - contact.on_b, Vec3::Y * sunk);
        assert!(above.corners().contains(&contact.on_b));
    }
}

/// Equal boxes, one on the other: every corner once, though all of them coincide.
#[test]
fn equal_boxes_share_four_points() {
    let below = upright(Vec3::ZERO, Vec3::ONE);
    for way in [Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Z, Vec3::from_ints(2, 0, 0)] {
        let above = upright(Vec3::Y * real!("2") + way, Vec3::ONE);
        let found = manifold_cuboid_cuboid(&below, &above, real!("0.01")).expect("they touch");
        let mut places: Vec<_> = found.contacts().iter().map(|contact| contact.on_b).collect();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), if way.x == real!("2") { 2 } else { 4 }, "{way:?} {found:?}");
    }
}

/// The roof of one below the keel of another: edge against edge, by name.
#[test]
fn crossed_edges_touch_in_one_point() {
    let one = Real::ONE;
    let roof =
        [Vec3::X * real!("4"), Vec3::new(Real::ZERO, one, one), Vec3::new(Real::ZERO, one, -one)];
    let keel =
        [Vec3::Z * real!("4"), Vec3::new(one, one, Real::ZERO), Vec3::new(one, -one, Real::ZERO)];
    let below = Cuboid::new(Vec3::ZERO, roof).expect("a box");
    let above = Cuboid::new(Vec3::Y * real!("3.99"), keel).expect("a box");
    let found = manifold_cuboid_cuboid(&below, &above, Real::ZERO).expect("they touch");
    assert_eq!(found.normal, UnitVec3::Y);
    let [contact] = found.contacts() else { panic!("{found:?}") };
    assert_eq!(contact.features, [FeatureId::edge(3), FeatureId::edge(2)]);
    assert_eq!([contact.on_a.x, contact.on_a.z], [Real::ZERO; 2]);
    assert_eq!(contact.separation, real!("3.99") - real!("4"));
}

/// A plank half over the edge of a table, its far end lower: it is held by the edge, not by the
/// end.
#[test]
fn a_plank_tips_over_an_edge() {
    let table = upright(Vec3::ZERO, Vec3::from_ints(1, 1, 1));
    let along = Vec3::new(real!("2"), real!("-0.1"), Real::ZERO);
    let across = Vec3::new(real!("0.005"), real!("0.1"), Real::ZERO);
    let plank = Cuboid::new(
        Vec3::new(real!("1.2"), real!("1.0945"), Real::ZERO),
        [along, across, Vec3::Z * real!("0.3")],
    );
    let found = manifold_cuboid_cuboid(&table, &plank.expect("a box"), real!("0.01"));
    let found = found.expect("they touch");
    assert!(found.contacts().len() >= 2, "{found:?}");
    assert!(found.contacts().iter().all(|contact| contact.on_a.x <= real!("1.001")), "{found:?}");
}

/// The ends of the ranges: boxes of 131 km, far away, with the greatest margin.
#[test]
fn the_largest_boxes_touch() {
    let half = Real::from_raw((1 << 40) - 1);
    let half = Vec3::new(half, half, half);
    let far = Real::from_raw(-(1 << 60) + (1 << 43));
    let corner = Vec3::new(far, far, far);
    let a = upright(corner, half);
    for (way, touches) in [(0, true), ((1 << 41) - 3, true), ((1 << 41) + (1 << 38), false)] {
        let b = upright(corner + Vec3::X * Real::from_raw(way), half);
        let b = Cuboid::new(b.center(), b.half_edges()).expect("in range");
        let found = manifold_cuboid_cuboid(&a, &b, Real::MAX);
        assert_eq!(found.is_some(), touches, "{way}");
    }
}
