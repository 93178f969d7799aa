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

/// The same corners in fixed point and in `f64`.
struct Pair {
    exact: [Triangle; 2],
    float: [[[f64; 3]; 3]; 2],
}

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

fn pairs(set: Set) -> Vec<Pair> {
    let mut rng = Pcg::new(1, 0);
    let mut number = |most: i64| (rng.next_u64() % most.unsigned_abs()).cast_signed() - most / 2;
    let pair = |_| {
        let centre = [(); 3].map(|()| number(set.size * set.apart + 1));
        let corners =
            [[0; 3], centre].map(|centre| [(); 3].map(|()| centre.map(|c| c + number(set.size))));
        let exact = corners.map(|corners| Triangle::new(corners.map(Vec3::from_raw)));
        let float = corners.map(|corners| corners.map(|p| p.map(|c| c as f64)));
        Pair { exact: exact.map(|triangle| triangle.expect("in range")), float }
    };
    (0..PAIRS).map(pair).collect()
}

/// The shortest time of a pass over all pairs, and how many were counted.
fn pass<T>(items: &[T], count: impl Fn(&T) -> bool) -> (f64, usize) {
    let round = |_| {
        let clock = Instant::now();
        let counted = black_box(items).iter().filter(|item| count(item)).count();
        (clock.elapsed(), black_box(counted))
    };
    let (time, counted) = (0..4 * rounds()).map(round).min().unwrap_or((Duration::ZERO, 0));
    (time.as_secs_f64() * 1e9 / items.len() as f64, counted)
}

fn triangles(set: Set) {
    let pairs = pairs(set);
    let exact: Vec<_> = pairs.iter().map(|pair| pair.exact).collect();
    let float: Vec<_> = pairs.iter().map(|pair| pair.float).collect();
    let (twin, met) = pass(&float, |[a, b]| guigue::overlap(a, b));
    let (ours, ours_met) = pass(&exact, |[a, b]| overlap_triangle_triangle(a, b));
    let (points, _) = pass(&exact, |[a, b]| intersection_triangle_triangle(a, b).is_some());
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
        let float: Vec<_> = raw.iter().map(|points| points.map(|p| p.map(|c| c as f64))).collect();
        let (ours, above) = pass(&exact, |&[a, b, c, d]| orient3d(a, b, c, d).is_gt());
        let coord = |[x, y, z]: [f64; 3]| robust::Coord3D { x, y, z };
        let (theirs, below) = pass(&float, |points| {
            let [a, b, c, d] = points.map(coord);
            // Its sign is the opposite.
            robust::orient3d(a, b, c, d) < 0.0
        });
        assert_eq!(above, below, "both are exact");
        println!("orient3d {name:<9} {ours:.2} ns, robust {theirs:.2} ns, * {:.3}", ours / theirs);
    }
}
