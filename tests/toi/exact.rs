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
            assert!(tally.hits > queries / 100, "{class:?} {is_face}: {tally:?}");
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
    all(2, 62_500);
}
