//! Predicates and pairs of triangles: the same test in `f64`, and the crate `robust`.

use std::hint::black_box;
use std::time::{Duration, Instant};

use verlock::Vec3;
use verlock::geometry::{
    Triangle, intersection_triangle_triangle, orient3d, overlap_triangle_triangle,
};
use verlock::math::Pcg;

use crate::clock::rounds;
use crate::guigue;

/// So many that no branch predictor learns them.
const PAIRS: usize = 32_768;

/// How the pairs of a set are made.
#[derive(Clone, Copy)]
struct Set {
    name: &'static str,
    /// How long a triangle is, raw.
    size: i64,
    /// How far apart two are, in their lengths.
    apart: i64,
}

const SETS: [Set; 6] = [
    Set { name: "near, 5 cm", size: 1 << 20, apart: 0 },
    Set { name: "near, 1 m", size: 1 << 24, apart: 0 },
    Set { name: "near, 1 km", size: 1 << 34, apart: 0 },
    Set { name: "far, 5 cm", size: 1 << 20, apart: 4 },
    Set { name: "far, 1 m", size: 1 << 24, apart: 4 },
    Set { name: "far, 1 km", size: 1 << 34, apart: 4 },
];

/// Prints all measurements.
pub fn run() {
    for set in SETS {
        triangles(set);
    }
    predicates();
}

/// The corners of the pairs of a set, raw.
fn pairs(set: Set) -> Vec<[[[i64; 3]; 3]; 2]> {
    let mut rng = Pcg::new(1, 0);
    let mut number = |most: i64| (rng.next_u64() % most.unsigned_abs()).cast_signed() - most / 2;
    let pair = |_| {
        let centre = [(); 3].map(|()| number(set.size * set.apart + 1));
        [[0; 3], centre].map(|centre| [(); 3].map(|()| centre.map(|c| c + number(set.size))))
    };
    (0..PAIRS).map(pair).collect()
}

fn float([x, y, z]: [i64; 3]) -> [f64; 3] {
    [x as f64, y as f64, z as f64]
}

/// The shortest times of each test, taken in turns, in nanoseconds an item; and what it counted.
fn passes<const N: usize>(tests: [&dyn Fn() -> usize; N]) -> [(f64, usize); N] {
    let mut best = [(Duration::MAX, 0); N];
    for _ in 0..rounds() {
        // Several passes in a row: caches get warm.
        for (best, test) in best.iter_mut().zip(tests) {
            for _ in 0..8 {
                let clock = Instant::now();
                let counted = black_box(test());
                *best = (*best).min((clock.elapsed(), counted));
            }
        }
    }
    best.map(|(time, counted)| (time.as_secs_f64() * 1e9 / PAIRS as f64, counted))
}

/// How many items pass a test.
fn count<T>(items: &[T], test: impl Fn(&T) -> bool) -> usize {
    black_box(items).iter().filter(|item| test(item)).count()
}

fn triangles(set: Set) {
    let raw = pairs(set);
    let triangle =
        |corners: [[i64; 3]; 3]| Triangle::new(corners.map(Vec3::from_raw)).expect("in range");
    let exact: Vec<_> = raw.iter().map(|pair| pair.map(triangle)).collect();
    let floats: Vec<_> = raw.iter().map(|pair| pair.map(|corners| corners.map(float))).collect();
    let [(twin, met), (ours, ours_met), (points, _)] = passes([
        &|| count(&floats, |[a, b]| guigue::overlap(a, b)),
        &|| count(&exact, |[a, b]| overlap_triangle_triangle(a, b)),
        &|| count(&exact, |[a, b]| intersection_triangle_triangle(a, b).is_some()),
    ]);
    println!(
        "{:<12} f64 {twin:>6.2} ns, exact {ours:>6.2} ns, * {:.2}; with points {points:>6.2} ns; \
         {met} and {ours_met} of {PAIRS} meet",
        set.name,
        ours / twin
    );
}

/// The predicate on points in general position, and on points of one plane.
fn predicates() {
    let mut rng = Pcg::new(2, 0);
    let mut number = || (rng.next_u64() % (1 << 24)).cast_signed() - (1 << 23);
    for (name, flat) in [("generic", false), ("coplanar", true)] {
        let mut points = || {
            let [a, u, v, w] = [(); 4].map(|()| [(); 3].map(|()| number()));
            let plane = |s: i64, t: i64| [0, 1, 2].map(|k| a[k] + s * u[k] + t * v[k]);
            let last = if flat { plane(3, 5) } else { w };
            [a, plane(1, 0), plane(0, 1), last]
        };
        let raw: Vec<_> = (0..PAIRS).map(|_| points()).collect();
        let exact: Vec<_> = raw.iter().map(|points| points.map(Vec3::from_raw)).collect();
        let coord = |point| {
            let [x, y, z] = float(point);
            robust::Coord3D { x, y, z }
        };
        let floats: Vec<_> = raw.iter().map(|points| points.map(coord)).collect();
        let [(ours, above), (theirs, below)] = passes([
            &|| count(&exact, |&[a, b, c, d]| orient3d(a, b, c, d).is_gt()),
            // Its sign is the opposite.
            &|| count(&floats, |&[a, b, c, d]| robust::orient3d(a, b, c, d) < 0.0),
        ]);
        assert_eq!(above, below, "both are exact");
        println!("orient3d {name:<9} {ours:.2} ns, robust {theirs:.2} ns, * {:.3}", ours / theirs);
    }
}
