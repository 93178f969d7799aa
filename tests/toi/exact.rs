//! Never late, and hardly ever early.

use verlock::geometry::sweep::Sweep;
use verlock::math::Pcg;

use super::oracle::contacts;
use super::{CLASSES, Class, Corners, sweep};

/// How often what was found.
#[derive(Clone, Copy, Default, Debug)]
struct Tally {
    queries: u32,
    hits: u32,
    /// Of the hits: the time is the first contact's, rounded down.
    exact: u32,
    /// Misses that were not proved to be: searches that ended early, and others.
    cut: u32,
    near: u32,
}

/// Compares one query with the oracle.
fn check(corners: &Corners, is_face: bool, tally: &mut Tally) {
    let found = sweep(&Sweep::default(), corners, is_face);
    let mut contacts = contacts(corners, is_face);
    tally.queries += 1;
    tally.hits += u32::from(!contacts.is_empty());
    let Some(impact) = found else {
        assert!(contacts.is_empty(), "missed: {corners:?} {is_face} at {contacts:?}");
        return;
    };
    for time in &mut contacts {
        let late = !time.is_at_least(impact.time.raw());
        assert!(!late, "late: {corners:?} {is_face} found {impact:?}, is {time:?}");
    }
    match contacts.iter_mut().map(super::oracle::Time::floor).min() {
        Some(first) => tally.exact += u32::from(first == impact.time.raw()),
        None if impact.is_cut => tally.cut += 1,
        None => tally.near += 1,
    }
}

/// Sizes of features, raw: some small enough for 64 bits, some beyond any.
const SIZES: [i64; 8] = [2, 9, 1 << 10, 1 << 20, 1 << 25, 1 << 30, 1 << 41, 1 << 57];

fn run(seed: u64, class: Class, is_face: bool, queries: u32) -> Tally {
    let mut rng = Pcg::new(seed, class as u64);
    let mut tally = Tally::default();
    for _ in 0..queries {
        let size = SIZES[rng.below(8) as usize];
        check(&class.corners(&mut rng, size), is_face, &mut tally);
    }
    tally
}

fn all(seed: u64, queries: u32) {
    for class in CLASSES {
        for is_face in [true, false] {
            let tally = run(seed, class, is_face, queries);
            println!("{class:?} {}: {tally:?}", if is_face { "VF" } else { "EE" });
            let least = if matches!(class, Class::Struck) { queries / 2 } else { queries / 100 };
            assert!(tally.hits > least, "{class:?} {is_face}: {tally:?}");
        }
    }
}

#[test]
fn no_contact_is_missed_or_late() {
    all(1, 100);
}

#[test]
#[ignore = "a million queries: some minutes with --release"]
fn no_contact_of_a_million_is_missed_or_late() {
    all(2, 56_000);
}

/// Where boxes are not halved but narrowed, one that has only a corner in the face may be all that
/// is left of those that meet there: here on the edge from the second corner to the third.
#[test]
fn a_contact_between_boxes_is_not_missed() {
    let struck = [
        [
            [[1, 1, 2], [3, 3, 1]],
            [[3, 1, 1], [1, 3, 0]],
            [[0, 6, 1], [1, 1, 0]],
            [[4_309_248, -4_128_768, 1], [5, 5, 2]],
        ],
        [
            [[6, 8, 0], [2, 12, 0]],
            [[0, 0, 8], [4, 0, 4]],
            [[8, 8, 0], [-39_124_696, -29_634_352, -14_530_468]],
            [[0, 8, 0], [4, 4, 4]],
        ],
        [
            [[-518_882, -729_678, -564_086], [518_890, 729_686, 564_078]],
            [[2, -2, 6], [-2, 2, 10]],
            [[6, 8, 2], [10, 8, -2]],
            [[-2, -2, -8], [2, 2, -8]],
        ],
    ];
    let mut tally = Tally::default();
    for corners in &struck {
        check(corners, true, &mut tally);
    }
    assert_eq!(tally.hits, 3, "{tally:?}");
}
