//! Whether triangles meet, against the oracle.

use num_bigint::BigInt;
use verlock::geometry::{Triangle, overlap_triangle_triangle};
use verlock::math::Pcg;

use super::{Corners, ORDERS, below, triangle};
use crate::corpus::laws::oracle;

/// How far from each other the corners of two triangles of a class may be, so that the test goes
/// through each width: the unit of the grid is 1 raw, or so large that a triangle is as long as it
/// may be.
pub const CLASSES: [Class; 8] = [
    Class { most: 1, unit: 1 },
    Class { most: 2, unit: 1 },
    Class { most: 4, unit: 1 },
    Class { most: 30, unit: 1 },
    // At the limits of the widths.
    Class { most: 4, unit: 1_664_510 / 8 },
    Class { most: 3, unit: ((1 << 31) - 1) / 6 },
    Class { most: 2, unit: Triangle::SPAN_MAX / 2 },
    Class { most: Triangle::SPAN_MAX, unit: 1 },
];

#[derive(Clone, Copy)]
pub struct Class {
    /// Corners lie on a grid from 0 to this.
    most: i64,
    unit: i64,
}

impl Class {
    /// Two triangles; their boxes often meet in no more than a corner, and they are often flat, or
    /// lie in one plane, or share corners.
    pub fn pair(self, rng: &mut Pcg) -> [Corners; 2] {
        let mut corner = || [(); 3].map(|()| below(rng, self.most) * self.unit);
        let mut pair = [[(); 3]; 2].map(|corners| corners.map(|()| corner()));
        let kind = rng.below(16);
        match kind {
            // In one plane, which is seldom that of two axes.
            0 | 1 => pair.iter_mut().flatten().for_each(|[x, y, z]| *z = (*x + *y) / 2),
            2 => pair.iter_mut().flatten().for_each(|[x, _, _]| *x = 0),
            // A segment, or a point.
            3 => pair[0][2] = pair[0][1],
            4 => pair[1] = [pair[1][0]; 3],
            // Shared corners.
            5 => pair[1][0] = pair[0][2],
            6 => pair[1] = [pair[0][0], pair[0][1], pair[1][2]],
            // A corner in the middle of an edge: exact where the sum is even.
            7 => pair[1][0] = [0, 1, 2].map(|k| i64::midpoint(pair[0][0][k], pair[0][1][k])),
            // Side by side, the boxes touching or one step apart.
            8 | 9 => {
                let step = i64::from(kind == 9);
                let least = pair[0].iter().map(|corner| corner[0]).max().unwrap_or(0);
                pair[1].iter_mut().for_each(|[x, ..]| *x += least + step);
            }
            _ => {}
        }
        pair
    }

    /// What the oracle says, in 64 bits where they do.
    fn oracle(self, [a, b]: &[Corners; 2]) -> bool {
        if self.most * self.unit <= 30 {
            oracle::overlap(a, b)
        } else {
            let [a, b] = [a, b].map(|corners| corners.map(|corner| corner.map(BigInt::from)));
            oracle::overlap(&a, &b)
        }
    }
}

fn check(pair: [Corners; 2], expected: bool) {
    let [a, b] = pair.map(triangle);
    assert_eq!(overlap_triangle_triangle(&a, &b), expected, "{pair:?}");
    assert_eq!(overlap_triangle_triangle(&b, &a), expected, "swapped: {pair:?}");
}

/// Compares as many random pairs of every class.
fn compare(pairs: u32, stream: u64) {
    for (index, class) in (0..).zip(CLASSES) {
        let mut rng = Pcg::new(index, stream);
        let mut met = 0;
        for _ in 0..pairs {
            let pair = class.pair(&mut rng);
            let expected = class.oracle(&pair);
            check(pair, expected);
            met += u32::from(expected);
        }
        // A test of pairs that are all alike would prove little.
        assert!(met > pairs / 20 && met < pairs - pairs / 20, "class {index}: {met} of {pairs}");
    }
}

#[test]
fn triangles_meet_where_the_oracle_says() {
    compare(2_000, 0);
}

/// 0 disagreements in 10^8 pairs: `cargo test --release -- --ignored oracle`.
#[test]
#[ignore = "takes a quarter of an hour in a release build"]
fn triangles_meet_where_the_oracle_says_in_a_hundred_million_pairs() {
    for stream in 1..=10 {
        for (index, class) in (0..).zip(CLASSES) {
            let big = class.most * class.unit > 30;
            let mut rng = Pcg::new(index, stream);
            for _ in 0..if big { 25_000 } else { 2_475_000 } {
                let pair = class.pair(&mut rng);
                check(pair, class.oracle(&pair));
            }
        }
        println!("{} pairs", stream * 4 * (2_475_000 + 25_000));
    }
}

/// Every pair of triangles with corners of a unit cube.
#[test]
fn triangles_meet_where_the_oracle_says_on_the_whole_unit_grid() {
    let corner = |code: u32| [0, 1, 2].map(|axis| i64::from(code >> axis & 1));
    for code in 0..8_u32.pow(6) {
        let digit = |place: u32| corner(code >> (3 * place) & 7);
        let pair = [[0, 1, 2].map(digit), [3, 4, 5].map(digit)];
        check(pair, oracle::overlap(&pair[0], &pair[1]));
    }
}

/// At the limits of the widths, and beyond them by one or by so much that they would wrap. The
/// largest determinants are those of the corners of a cube.
#[test]
fn size_does_not_matter() {
    let sizes = [1_664_510, 1_664_511, (1 << 31) - 1, 1 << 31, 1 << 32, Triangle::SPAN_MAX];
    let corner = |code: u32| [0, 1, 2].map(|axis| i64::from(code >> axis & 1));
    for code in (0..8_u32.pow(6)).step_by(3) {
        let digit = |place: u32| corner(code >> (3 * place) & 7);
        let pair = [[0, 1, 2].map(digit), [3, 4, 5].map(digit)];
        let [a, b] = pair.map(triangle);
        let expected = overlap_triangle_triangle(&a, &b);
        for size in sizes {
            let [a, b] = pair.map(|corners| triangle(corners.map(|p| p.map(|c| c * size))));
            assert_eq!(overlap_triangle_triangle(&a, &b), expected, "{pair:?} * {size}");
        }
    }
}

#[test]
fn the_order_of_corners_does_not_matter() {
    let mut rng = Pcg::new(5, 0);
    for class in CLASSES {
        for _ in 0..300 {
            let pair = class.pair(&mut rng);
            let expected = class.oracle(&pair);
            for [order_a, order_b] in ORDERS.map(|a| ORDERS.map(|b| [a, b])).concat() {
                check([order_a.map(|k| pair[0][k]), order_b.map(|k| pair[1][k])], expected);
            }
        }
    }
}

#[test]
fn moving_both_does_not_matter() {
    let mut rng = Pcg::new(6, 0);
    for class in CLASSES {
        for _ in 0..300 {
            let pair = class.pair(&mut rng);
            let way = [(); 3].map(|()| below(&mut rng, 1 << 60) - (1 << 59));
            let moved = pair.map(|corners| corners.map(|p| [0, 1, 2].map(|k| p[k] + way[k])));
            let [a, b] = pair.map(triangle);
            check(moved, overlap_triangle_triangle(&a, &b));
        }
    }
}

/// Pairs that other programs were wrong about.
#[test]
fn known_traps_are_passed() {
    // The coplanar tree of the paper lacks a branch.
    check([[[0, 0, 0], [0, 0, 8], [8, 0, 0]], [[2, 0, 2], [1, 0, 4], [9, 0, 0]]], true);
    // Their boxes touch in a corner, and together they are as long as two may be.
    let far = Triangle::SPAN_MAX;
    let [low, high] = [[0; 3], [far; 3]];
    let a = [low, high, [far, 0, far]];
    let b = [high, [2 * far; 3], [2 * far, far, 2 * far]];
    check([a, b], true);
    check([a, b.map(|[x, y, z]| [x + 1, y, z])], false);
}
