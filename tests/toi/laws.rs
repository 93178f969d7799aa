//! What does not change a time, and what limits cost.

use verlock::geometry::Triangle;
use verlock::geometry::sweep::{Impact, Sweep};
use verlock::math::{Pcg, Unit};
use verlock::{Real, real};

use super::{CLASSES, Corners, number, sweep};

/// The same features, every corner changed.
fn changed(corners: &Corners, change: impl Fn([i64; 3]) -> [i64; 3]) -> Corners {
    corners.map(|ends| ends.map(&change))
}

/// Some queries of every class and size, with a gap or without.
fn queries(seed: u64, each: u32) -> impl Iterator<Item = (Corners, bool, Sweep)> {
    let mut rng = Pcg::new(seed, 41);
    (0..each as usize * CLASSES.len()).map(move |k| {
        let size = [9, 1 << 20, 1 << 24, 1 << 38, 1 << 57][rng.below(5) as usize];
        let gap = [0, 0, 2, size / 50][rng.below(4) as usize];
        let sweep = Sweep { gap: Real::from_raw(gap), ..Sweep::default() };
        (CLASSES[k % CLASSES.len()].corners(&mut rng, size), k % 2 == 0, sweep)
    })
}

#[test]
fn times_do_not_depend_on_the_place_or_on_the_axes() {
    let mut rng = Pcg::new(1, 40);
    let mut hits = 0;
    for (corners, is_face, options) in queries(1, 100) {
        let found = sweep(&options, &corners, is_face);
        hits += u32::from(found.is_some());
        let way = [(); 3].map(|()| number(&mut rng, 1 << 58));
        let same = |change: &dyn Fn([i64; 3]) -> [i64; 3], what| {
            let there = sweep(&options, &changed(&corners, change), is_face);
            assert_eq!(there, found, "{corners:?} {is_face} {what}");
        };
        same(&|p| [0, 1, 2].map(|k| p[k] + way[k]), "moved");
        same(&|[x, y, z]| [y, z, x], "turned");
        same(&|[x, y, z]| [-y, x, z], "turned about z");
        same(&|[x, y, z]| [x, -y, z], "mirrored");
    }
    assert!(hits > 200, "{hits}");
}

/// Whatever is found with few boxes is no later than with many, and nothing is lost.
#[test]
fn few_boxes_only_make_times_earlier() {
    let mut cut = 0;
    for (corners, is_face, options) in queries(2, 60) {
        let found = sweep(&options, &corners, is_face);
        for work_max in [0, 1, 3, 10, 40] {
            let early = sweep(&Sweep { work_max, ..options }, &corners, is_face);
            cut += u32::from(early.is_some_and(|impact| impact.is_cut));
            match (early, found) {
                (None, Some(_)) => panic!("{corners:?} {is_face}: lost with {work_max}"),
                (Some(early), Some(found)) => assert!(early.time <= found.time, "{corners:?}"),
                (Some(early), None) => assert!(early.is_cut, "{corners:?} {is_face}"),
                (None, None) => {}
            }
        }
    }
    assert!(cut > 100, "{cut}");
}

/// A larger gap is never touched later.
#[test]
fn wider_gaps_are_touched_sooner() {
    for (corners, is_face, options) in queries(3, 60) {
        let time = |gap: Real| {
            let found = sweep(&Sweep { gap, ..options }, &corners, is_face);
            found.map_or(1 << 31, |impact| i64::from(impact.time.raw()))
        };
        let twice = Real::from_raw(2 * options.gap.raw() + 1);
        assert!(time(twice) <= time(options.gap) + 64, "{corners:?} {is_face}");
    }
}

/// The gap counts along every direction, and is cut to its range.
#[test]
fn gaps_are_distances() {
    const M: i64 = Real::ONE.raw();
    // A vertex that falls from 4 m to the ground, 10 m from the corners of a face.
    let fall = [
        [[0, 4 * M, 0], [0, 0, 0]],
        [[-10 * M, 0, -10 * M]; 2],
        [[10 * M, 0, -10 * M]; 2],
        [[0, 0, 10 * M]; 2],
    ];
    for (gap, time) in [("0", "1"), ("1", "0.75"), ("3", "0.25"), ("4", "0"), ("-1", "1")] {
        let gap = gap.parse().expect("a decimal");
        let found = sweep(&Sweep { gap, ..Sweep::default() }, &fall, true).expect("touches");
        assert_eq!(found.time, time.parse().expect("a decimal"), "{gap}");
    }
    let wide = Sweep { gap: Real::MAX, ..Sweep::default() };
    assert_eq!(sweep(&wide, &fall, true).map(|found| found.time), Some(Unit::ZERO));
    let above = changed(&fall, |[x, y, z]| [x, y + 2 * M * i64::from(y > 0), z]);
    let near = Sweep { gap: real!("1.9"), ..Sweep::default() };
    let short = above.map(|[start, end]| [start, if start[1] > 0 { [0, 2 * M, 0] } else { end }]);
    assert_eq!(sweep(&near, &short, true), None);
}

#[test]
fn what_is_out_of_range_is_not_known() {
    const FAR: i64 = Triangle::COORDINATE_MAX;
    let unknown = |found: Option<Impact>| {
        found.is_some_and(|impact| impact.is_cut && impact.time == Unit::ZERO)
    };
    for far in [FAR + 1, -FAR - 1, i64::MAX, i64::MIN] {
        for corner in 0..8 {
            let mut corners: Corners =
                [[[0, 0, 0]; 2], [[9; 3]; 2], [[9, 0, 9]; 2], [[0, 9, 9]; 2]];
            corners[corner / 2][corner % 2][corner % 3] = far;
            for is_face in [true, false] {
                assert!(unknown(sweep(&Sweep::default(), &corners, is_face)), "{corners:?}");
            }
        }
    }
    // From one end of the world to the other is known.
    let through =
        [[[FAR; 3], [-FAR; 3]], [[FAR, -FAR, 0]; 2], [[-FAR, FAR, 0]; 2], [[-FAR, -FAR, FAR]; 2]];
    let found = sweep(&Sweep::default(), &through, true).expect("touches");
    assert!(!unknown(Some(found)) && found.time < Unit::ONE, "{found:?}");
}
