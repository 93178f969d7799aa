//! What is exchanged, moved, mirrored or turned touches in the same way.

use verlock::collision::{Contact, Manifold, Shape, collide, manifold_convex_convex};
use verlock::math::{Real, UnitVec3};
use verlock::{Vec3, real};

use super::draw::{Draw, Kind, mapped};

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
}

const MARGIN: Real = real!("0.05");

/// What is left of a manifold without names.
fn places(found: &Manifold) -> (UnitVec3, Vec<[Vec3; 2]>) {
    let place = |contact: &Contact| [contact.on_a, contact.on_b];
    let mut places: Vec<_> = found.contacts().iter().map(place).collect();
    places.sort_unstable();
    (found.normal, places)
}

/// Holds a law for pairs of all kinds that touch.
fn for_pairs(mut law: impl FnMut(&Shape, &Shape, &Manifold)) {
    let mut draw = Draw::new(3);
    for a in Kind::ALL {
        for b in Kind::ALL {
            let mut found = 0;
            for k in 0..60 {
                let size = [0.5, 20.0, 5000.0][k % 3];
                let center = draw.within(0.6 * size);
                let [a, b] = [draw.shape(a, [0.0; 3], size), draw.shape(b, center, size)];
                if let Some(manifold) = manifold_convex_convex(&a, &b, MARGIN) {
                    law(&a, &b, &manifold);
                    found += 1;
                }
            }
            assert!(found > 5 || [a, b] == [Kind::HalfSpace; 2], "{a:?} {b:?}: only {found}");
        }
    }
}

fn expect(a: &Shape, b: &Shape) -> Manifold {
    manifold_convex_convex(a, b, MARGIN).expect("they touch")
}

#[test]
fn moved_pairs_touch_likewise() {
    let mut draw = Draw::new(4);
    for_pairs(|a, b, found| {
        let way = Vec3::from_raw([(); 3].map(|()| draw.0.next_u64().cast_signed() >> 5));
        let there = expect(&mapped(a, |p| p + way), &mapped(b, |p| p + way));
        assert_eq!(there.normal, found.normal);
        let moved = found.contacts().iter().map(|&contact| Contact {
            on_a: contact.on_a + way,
            on_b: contact.on_b + way,
            ..contact
        });
        assert!(moved.eq(there.contacts().iter().copied()), "{found:?} {there:?}");
    });
}

/// Whether two manifolds are equal, but for the choice between axes or points as good as each
/// other.
fn is_alike(one: &Manifold, other: &Manifold) -> bool {
    let apart = (one.separation() - other.separation()).raw().abs();
    assert!(apart < 1 << 11, "{one:?} {other:?}");
    places(one) == places(other)
}

#[test]
fn mirrored_and_turned_pairs_touch_likewise() {
    let (mut all, mut ties) = (0, 0);
    for_pairs(|a, b, found| {
        for map in Map::ALL {
            let there = expect(&mapped(a, |p| map.point(p)), &mapped(b, |p| map.point(p)));
            let (normal, places) = places(found);
            let mut places: Vec<_> = places.iter().map(|on| on.map(|p| map.point(p))).collect();
            places.sort_unstable();
            let apart = (there.separation() - found.separation()).raw().abs();
            assert!(apart < 1 << 11, "{found:?} {there:?}");
            all += 1;
            ties += usize::from((map.normal(normal), places) != self::places(&there));
        }
    });
    assert!(ties * 20 < all, "{ties} of {all} differ");
}

#[test]
fn exchanged_pairs_touch_likewise() {
    let (mut all, mut ties) = (0, 0);
    for_pairs(|a, b, found| {
        all += 1;
        ties += usize::from(!is_alike(&expect(b, a).flipped(), found));
    });
    assert!(ties * 20 < all, "{ties} of {all} differ");
}

/// Whatever a shape is, it collides.
#[test]
fn all_convex_pairs_collide_by_one_function() {
    let mut manifolds = vec![];
    for_pairs(|a, b, found| {
        manifolds.clear();
        collide(a, b, MARGIN, &mut manifolds);
        assert_eq!(manifolds, [*found]);
    });
}
