//! Signs, against big integers and against tables.

use std::cmp::Ordering;
use std::path::PathBuf;
use std::{fs, iter};

use num_bigint::BigInt;
use verlock::geometry::{Triangle, orient2d, orient3d, overlap_triangle_triangle};
use verlock::math::Pcg;
use verlock::{Real, Vec3};

use super::{below, triangle};
use crate::corpus::laws::oracle::cross;

/// `((b - a) x (c - a)) . (d - a)`.
fn exact3([a, b, c, d]: [[i64; 3]; 4]) -> Ordering {
    let from = |p: [i64; 3]| [0, 1, 2].map(|k| BigInt::from(p[k]) - BigInt::from(a[k]));
    let (normal, way) = (cross(&from(b), &from(c)), from(d));
    let sum: BigInt = (0..3).map(|k| &normal[k] * &way[k]).sum();
    sum.cmp(&BigInt::ZERO)
}

fn exact2([a, b, c]: [[i64; 2]; 3]) -> Ordering {
    let from = |p: [i64; 2], k: usize| BigInt::from(p[k]) - BigInt::from(a[k]);
    (from(b, 0) * from(c, 1)).cmp(&(from(b, 1) * from(c, 0)))
}

fn sign3(points: [[i64; 3]; 4]) -> Ordering {
    let [a, b, c, d] = points.map(Vec3::from_raw);
    orient3d(a, b, c, d)
}

fn sign2(points: [[i64; 2]; 3]) -> Ordering {
    let [a, b, c] = points.map(|point| point.map(Real::from_raw));
    orient2d(a, b, c)
}

/// Where the widths change, one to either side, and where 64 bits end.
fn extents() -> impl Iterator<Item = i64> {
    let powers = [1, 4, 20, 29, 30, 31, 40, 41, 42, 61, 62];
    let around = powers.into_iter().flat_map(|bits| [-1, 0, 1].map(|step| (1 << bits) + step));
    around.chain(iter::once(i64::MAX))
}

/// A coordinate up to an extent from 0, often at its very end.
fn coordinate(rng: &mut Pcg, extent: i64) -> i64 {
    match rng.below(6) {
        0 => extent,
        1 => -extent,
        2 if extent == i64::MAX => i64::MIN,
        2 => -extent - 1,
        3 => 0,
        _ => below(rng, extent) - below(rng, extent),
    }
}

#[test]
fn signs_are_those_of_big_integers() {
    let mut rng = Pcg::new(1, 200);
    let mut signs = [0; 3];
    for extent in extents() {
        for round in 0..2_000 {
            let mut points = [[(); 3]; 4].map(|p| p.map(|()| coordinate(&mut rng, extent)));
            if round % 2 == 0 {
                // On the plane of the others or a step beside it.
                let [a, b, ..] = points;
                let step = i64::from(rng.below(3)) - 1;
                points[3] = [0, 1, 2].map(|k| i64::midpoint(a[k], b[k]));
                points[3][0] = points[3][0].saturating_add(step);
            }
            let expected = exact3(points);
            assert_eq!(sign3(points), expected, "{points:?}");
            signs[(expected as i8 + 1) as usize] += 1;
            let flat = [points[0], points[1], points[3]].map(|[x, y, _]| [x, y]);
            assert_eq!(sign2(flat), exact2(flat), "{flat:?}");
        }
    }
    assert!(signs.iter().all(|&count| count > 1_000), "{signs:?}");
}

#[test]
fn swapping_two_points_swaps_the_sides() {
    let mut rng = Pcg::new(2, 200);
    for extent in extents() {
        for _ in 0..100 {
            let points = [[(); 3]; 4].map(|p| p.map(|()| coordinate(&mut rng, extent)));
            let mut swapped = points;
            let first = rng.below(4) as usize;
            swapped.swap(first, (first + 1 + rng.below(3) as usize) % 4);
            assert_eq!(sign3(swapped), sign3(points).reverse(), "{points:?}");
        }
    }
}

/// The lines of a table: numbers, and behind them the answer.
fn table(name: &str) -> Vec<(String, Vec<i64>, String)> {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "fixtures/predicates", name].iter().collect();
    let text = fs::read_to_string(&path).expect("a table");
    let rows = (1..).zip(text.lines()).filter(|(_, line)| !line.starts_with('#'));
    let row = |(number, line): (u32, &str)| {
        let mut words: Vec<_> = line.split_whitespace().collect();
        let answer = words.pop().expect("an answer").into();
        let numbers = words.into_iter().map(|word| word.parse().expect("an integer")).collect();
        (format!("{name}:{number}"), numbers, answer)
    };
    let rows: Vec<_> = rows.filter(|(_, line)| !line.is_empty()).map(row).collect();
    assert!(rows.len() > 10, "{name} is a table");
    rows
}

fn points<const D: usize, const N: usize>(numbers: &[i64]) -> [[i64; D]; N] {
    assert_eq!(numbers.len(), D * N);
    std::array::from_fn(|point| std::array::from_fn(|axis| numbers[point * D + axis]))
}

fn name(sign: Ordering) -> &'static str {
    match sign {
        Ordering::Less => "-",
        Ordering::Equal => "0",
        Ordering::Greater => "+",
    }
}

#[test]
fn tables_are_kept() {
    for (place, numbers, answer) in table("orient2d.txt") {
        assert_eq!(name(sign2(points(&numbers))), answer, "{place}");
    }
    for (place, numbers, answer) in table("orient3d.txt") {
        assert_eq!(name(sign3(points(&numbers))), answer, "{place}");
    }
    for (place, numbers, answer) in table("triangle_triangle.txt") {
        let [a, b, c, d, e, f] = points(&numbers);
        let pair: [Triangle; 2] = [[a, b, c], [d, e, f]].map(triangle);
        let met = overlap_triangle_triangle(&pair[0], &pair[1]);
        assert_eq!(if met { "meet" } else { "apart" }, answer, "{place}");
    }
}
