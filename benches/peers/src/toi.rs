//! Times of impact: vertices and faces, edges and edges; and capsules beside parry's.

use std::hint::black_box;
use std::time::{Duration, Instant};

use parry3d::math::{Pose, Vector};
use parry3d::query::{ShapeCastOptions, cast_shapes};
use parry3d::shape;
use verlock::geometry::Capsule;
use verlock::geometry::sweep::{Motion, Sweep};
use verlock::math::Pcg;
use verlock::{Real, Vec3};

use crate::clock::rounds;

/// So many that no branch predictor learns them.
const QUERIES: usize = 16_384;
/// Half a metre, raw.
const SIZE: i64 = 1 << 23;

/// Four points in motion.
type Corners = [Motion<Vec3>; 4];

/// How features move.
#[derive(Clone, Copy)]
enum Class {
    /// Each corner from anywhere to anywhere.
    Any,
    /// Each feature by up to its size, and corners on their own by an eighth of it.
    Thrown,
    /// Everything by up to a fiftieth of its size.
    Slow,
}

/// Prints all measurements.
pub fn run() {
    for (name, class) in [("any", Class::Any), ("thrown", Class::Thrown), ("slow", Class::Slow)] {
        let mut rng = Pcg::new(1, 0);
        let queries: Vec<_> = (0..QUERIES).map(|_| corners(&mut rng, class)).collect();
        let sweep = Sweep::default();
        percentiles(&format!("vertex-face, {name}"), &queries, |&[p, q, r, s]| {
            sweep.vertex_face(p, [q, r, s]).is_some()
        });
        percentiles(&format!("edge-edge, {name}"), &queries, |&[p, q, r, s]| {
            sweep.edge_edge([p, q], [r, s]).is_some()
        });
    }
    capsules();
}

fn point(rng: &mut Pcg, size: i64) -> Vec3 {
    let range = 2 * size.unsigned_abs() + 1;
    Vec3::from_raw([(); 3].map(|()| (rng.next_u64() % range).cast_signed() - size))
}

fn corners(rng: &mut Pcg, class: Class) -> Corners {
    let ways = [point(rng, SIZE), point(rng, SIZE)];
    [0, 1, 1, 1].map(|feature| {
        let start = point(rng, SIZE);
        let end = match class {
            Class::Any => point(rng, SIZE),
            Class::Thrown => start + ways[feature] + point(rng, SIZE / 8),
            Class::Slow => start + point(rng, SIZE / 50),
        };
        Motion::new(start, end)
    })
}

/// Each query by itself; the shortest of its times counts.
fn percentiles<T>(name: &str, queries: &[T], test: impl Fn(&T) -> bool) {
    let mut times = vec![Duration::MAX; queries.len()];
    let mut hits = 0;
    for _ in 0..rounds() {
        hits = 0;
        for (query, time) in queries.iter().zip(&mut times) {
            let clock = Instant::now();
            hits += usize::from(black_box(test(black_box(query))));
            *time = (*time).min(clock.elapsed());
        }
    }
    times.sort_unstable();
    let at = |percent: usize| times[(times.len() - 1) * percent / 100].as_nanos();
    let total: Duration = times.iter().sum();
    println!(
        "{name:<20} median {:>5} ns, 90 % {:>5}, 99 % {:>6}, mean {:>5}; {hits} of {} touch",
        at(50),
        at(90),
        at(99),
        total.as_nanos() / times.len() as u128,
        times.len()
    );
}

/// Capsules that move without turning.
fn capsules() {
    let mut rng = Pcg::new(2, 0);
    let radius = Real::from_raw(SIZE / 8);
    let capsule = |ends| Capsule::new(ends, radius).expect("in range");
    let mut query = || {
        [(); 2].map(|()| {
            let (start, along) = (point(&mut rng, SIZE), point(&mut rng, SIZE / 2));
            let way = point(&mut rng, SIZE);
            let at = |place| capsule([place, place + along]);
            (Motion::new(at(start), at(start + way)), way)
        })
    };
    let queries: Vec<_> = (0..QUERIES).map(|_| query()).collect();
    let sweep = Sweep::default();
    percentiles("capsules", &queries, |[(a, _), (b, _)]| sweep.capsule_capsule(*a, *b).is_some());
    let float = |v: Vec3| {
        let [x, y, z] = v.raw().map(|c| c as f32 / (1 << 24) as f32);
        Vector::new(x, y, z)
    };
    let theirs: Vec<_> = queries
        .iter()
        .map(|pair| {
            pair.each_ref().map(|(motion, way)| {
                let [a, b] = motion.start.ends().map(float);
                (shape::Capsule::new(a, b, (SIZE / 8) as f32 / (1 << 24) as f32), float(*way))
            })
        })
        .collect();
    let options = ShapeCastOptions { max_time_of_impact: 1.0, ..ShapeCastOptions::default() };
    let still = Pose::identity();
    percentiles("capsules, parry3d", &theirs, |[(a, u), (b, v)]| {
        cast_shapes(&still, *u, a, &still, *v, b, options).expect("capsules").is_some()
    });
}
