//! All partitions give the same pairs.

use verlock::geometry::Aabb;
use verlock::math::Pcg;

use super::crowd::{Change, Crowd, apply};
use super::{BruteForce, Partition, all};

const TICKS: u32 = if cfg!(debug_assertions) { 400 } else { 10_000 };

/// Pairs, queries and counts are those of brute force, whatever happens, and what the partitions
/// take for granted holds, before and after they catch up.
#[test]
fn all_partitions_agree() {
    let mut partitions = all();
    let mut crowd = Crowd::new(1);
    let mut total = 0;
    for tick in 0..TICKS {
        let changes = crowd.tick();
        let region = crowd.bounds();
        let mut wanted = None;
        for (name, partition) in &mut partitions {
            apply(&mut **partition, &changes);
            let sound = |partition: &dyn Partition| {
                assert_eq!(partition.validate(), Ok(()), "{name}, tick {tick}");
            };
            let mut found = [vec![], vec![]];
            sound(&**partition);
            partition.query(&region, &mut found[0]);
            let pairs = if tick % 4 == 3 { vec![] } else { partition.pairs().to_vec() };
            sound(&**partition);
            partition.query(&region, &mut found[1]);
            assert_eq!(found[0], found[1], "{name}, tick {tick}: catching up changed a query");
            let [found, _] = found;
            let given = (partition.len(), found, pairs);
            let wanted = wanted.get_or_insert_with(|| given.clone());
            assert!(*wanted == given, "{name}, tick {tick}: {wanted:?}, not {given:?}");
        }
        total += wanted.map_or(0, |(_, _, pairs)| pairs.len());
    }
    assert!(total > 40 * TICKS as usize, "{total} pairs in all say little");
}

/// The list has every pair once, the lower id first, in order.
#[test]
fn pairs_are_sorted() {
    let mut crowd = Crowd::new(2);
    let mut oracle = BruteForce::new();
    for _ in 0..40 {
        apply(&mut oracle, &crowd.tick());
    }
    let pairs = oracle.pairs();
    assert!(pairs.len() > 20 && pairs.is_sorted_by(|a, b| a < b));
    assert!(pairs.iter().all(|[a, b]| a < b));
}

/// What happened before reaches no list: partitions with a past agree with those that are given the
/// same objects at once, in any order.
#[test]
fn order_does_not_matter() {
    let mut crowd = Crowd::new(3);
    let mut old = all();
    for _ in 0..60 {
        let changes = crowd.tick();
        for (_, partition) in &mut old {
            apply(&mut **partition, &changes);
            partition.pairs();
        }
    }
    for order in 0..3 {
        let mut draw = Pcg::new(order, 0);
        for ((name, old), (_, mut new)) in old.iter_mut().zip(all()) {
            let mut ids: Vec<u32> = (0..64).filter(|&id| old.object(id).is_some()).collect();
            ids.sort_by_cached_key(|_| draw.next_u32());
            for id in ids {
                let object = old.object(id).expect("an object");
                apply(&mut *new, &[Change::Insert(id, object)]);
            }
            assert_eq!(old.pairs(), new.pairs(), "{name}");
        }
    }
}

/// A margin reaches no list: a box that comes one step nearer touches, and not before.
#[test]
fn touching_is_exact() {
    let at = |x: i64| {
        let corner = |x| verlock::Vec3::from_raw([x, 0, 0]);
        Aabb::new(corner(x), corner(x + 1000)).into()
    };
    for (name, mut partition) in all() {
        partition.insert(0, at(0)).expect("inserted");
        partition.insert(1, at(1500)).expect("inserted");
        for x in (990..1010).rev().chain(990..1010) {
            partition.update(1, at(x)).expect("updated");
            let touching = if x <= 1000 { 1 } else { 0 };
            assert_eq!(partition.pairs().len(), touching, "{name}: {x}");
        }
    }
}
