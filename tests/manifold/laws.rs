//! What is exchanged, moved, mirrored or turned touches in the same way.

use verlock::Vec3;
use verlock::collision::{Contact, Manifold, manifold_cuboid_cuboid};
use verlock::geometry::Cuboid;
use verlock::math::UnitVec3;
use verlock::real;

use super::draw::Draw;

/// A map of space that keeps lengths: axes exchanged, some of them turned round.
#[derive(Clone, Copy)]
struct Map {
    axes: [usize; 3],
    signs: [i64; 3],
}

impl Map {
    const ALL: [Self; 4] = [
        Self { axes: [0, 1, 2], signs: [-1, 1, 1] },
        Self { axes: [1, 2, 0], signs: [1, 1, 1] },
        Self { axes: [0, 2, 1], signs: [1, 1, -1] },
        Self { axes: [0, 1, 2], signs: [-1, -1, -1] },
    ];

    fn raw(self, v: [i64; 3]) -> [i64; 3] {
        [0, 1, 2].map(|k| self.signs[k] * v[self.axes[k]])
    }

    fn point(self, point: Vec3) -> Vec3 {
        Vec3::from_raw(self.raw(point.raw()))
    }

    fn normal(self, normal: UnitVec3) -> UnitVec3 {
        UnitVec3::from_raw(self.raw(normal.raw()).map(|c| c as i32))
    }

    fn cuboid(self, cuboid: &Cuboid) -> Cuboid {
        let edges = cuboid.half_edges().map(|edge| self.point(edge));
        Cuboid::new(self.point(cuboid.center()), edges).expect("in range")
    }
}

type Parts = (UnitVec3, Vec<Contact>);

fn parts(found: &Manifold) -> Parts {
    (found.normal, found.contacts().to_vec())
}

/// Places without names.
fn places((normal, contacts): &Parts) -> (UnitVec3, Vec<[Vec3; 2]>) {
    let mut places: Vec<_> = contacts.iter().map(|contact| [contact.on_a, contact.on_b]).collect();
    places.sort_unstable();
    (*normal, places)
}

fn for_pairs(mut law: impl FnMut(&Cuboid, &Cuboid, &Manifold)) {
    let mut draw = Draw::new(3);
    let mut found = 0;
    for k in 0..3_000 {
        let size = [0.5, 20.0, 5000.0][k % 3];
        let a = draw.cuboid([0.0; 3], size);
        let center = draw.within(1.2 * size);
        let b = draw.cuboid(center, size);
        if let Some(manifold) = manifold_cuboid_cuboid(&a, &b, real!("0.1")) {
            law(&a, &b, &manifold);
            found += 1;
        }
    }
    assert!(found > 1_500, "only {found} touch");
}

#[test]
fn moved_pairs_touch_likewise() {
    let mut draw = Draw::new(4);
    for_pairs(|a, b, found| {
        let way = Vec3::from_raw([(); 3].map(|()| draw.0.next_u64().cast_signed() >> 4));
        let [p, q] = [a, b].map(|cuboid| {
            Cuboid::new(cuboid.center() + way, cuboid.half_edges()).expect("in range")
        });
        let there = manifold_cuboid_cuboid(&p, &q, real!("0.1")).expect("they touch");
        assert_eq!(there.normal, found.normal);
        let moved = found.contacts().iter().map(|&contact| Contact {
            on_a: contact.on_a + way,
            on_b: contact.on_b + way,
            ..contact
        });
        assert!(moved.eq(there.contacts().iter().copied()), "{found:?} {there:?}");
    });
}

/// The same bits, unless two axes or points are as good as each other: then one is preferred.
#[test]
fn mirrored_and_turned_pairs_touch_likewise() {
    let mut ties = 0;
    for_pairs(|a, b, found| {
        for map in Map::ALL {
            let [p, q] = [a, b].map(|cuboid| map.cuboid(cuboid));
            let there = manifold_cuboid_cuboid(&p, &q, real!("0.1")).expect("they touch");
            let expected = parts(found).1.into_iter().map(|contact| Contact {
                on_a: map.point(contact.on_a),
                on_b: map.point(contact.on_b),
                ..contact
            });
            let expected = (map.normal(found.normal), expected.collect());
            if expected != parts(&there) {
                ties += 1;
                assert!((there.separation() - found.separation()).raw().abs() < 1 << 11);
            }
        }
    });
    assert!(ties < 60, "{ties} differ");
}

#[test]
fn exchanged_pairs_touch_likewise() {
    let mut ties = 0;
    for_pairs(|a, b, found| {
        let there = manifold_cuboid_cuboid(b, a, real!("0.1")).expect("they touch");
        if places(&parts(&there.flipped())) != places(&parts(found)) {
            ties += 1;
            assert!((there.separation() - found.separation()).raw().abs() < 1 << 11);
        }
    });
    assert!(ties < 30, "{ties} differ");
}
