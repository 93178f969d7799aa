//! Against looking often, in floats: whatever is seen to touch has been found, and no later.

use verlock::Real;
use verlock::geometry::sweep::Sweep;
use verlock::math::Pcg;

use super::{CLASSES, Corners, sweep};

type Vector = [f64; 3];

fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `A + u B + v C` at a time, as the library has it.
fn frame(corners: &Corners, is_face: bool, time: f64) -> [Vector; 3] {
    let at = |[start, end]: [[i64; 3]; 2]| {
        [0, 1, 2].map(|k| start[k] as f64 + (end[k] - start[k]) as f64 * time)
    };
    let [p, q, r, s] = corners.map(at);
    if is_face { [sub(p, q), sub(q, r), sub(q, s)] } else { [sub(p, r), sub(q, p), sub(r, s)] }
}

/// Whether features pass through one another between two times, well within both: the volume
/// changes its sign, and where it would be 0 the weights are not near their limits.
fn passes(corners: &Corners, is_face: bool, times: [f64; 2]) -> bool {
    let volume = |time| {
        let [a, b, c] = frame(corners, is_face, time);
        dot(cross(a, b), c)
    };
    let [before, after] = times.map(volume);
    if before * after >= 0.0 {
        return false;
    }
    // Twice by the chord; what is left is far below the margin.
    let middle = times[0] + (times[1] - times[0]) * before / (before - after);
    let [a, b, c] = frame(corners, is_face, middle);
    let normal = cross(b, c);
    let square = dot(normal, normal);
    let [u, v] = [-dot(cross(a, c), normal) / square, dot(cross(a, b), normal) / square];
    let inside = 0.05..0.95;
    let residue = dot(a, normal).abs() / square.sqrt();
    let size = dot(b, b).max(dot(c, c)).sqrt();
    residue < 0.001 * size
        && inside.contains(&u)
        && inside.contains(&v)
        && (!is_face || inside.contains(&(u + v)))
}

/// How far the nearest of some points of the features are apart at a time.
fn distance(corners: &Corners, is_face: bool, time: f64) -> f64 {
    const STEPS: i32 = 8;
    let [a, b, c] = frame(corners, is_face, time);
    let mut least = f64::MAX;
    for i in 0..=STEPS {
        for j in 0..=if is_face { STEPS - i } else { STEPS } {
            let [u, v] = [i, j].map(|k| f64::from(k) / f64::from(STEPS));
            let d = [0, 1, 2].map(|k| a[k] + u * b[k] + v * c[k]);
            least = least.min(dot(d, d));
        }
    }
    least.sqrt()
}

/// Queries of one class; returns how many were seen to touch.
fn run(seed: u64, class: usize, is_face: bool, gap: i64, queries: u32) -> u32 {
    const SAMPLES: u32 = 16;
    let mut rng = Pcg::new(seed, class as u64);
    let mut seen = 0;
    for _ in 0..queries {
        let size = [1 << 12, 1 << 20, 1 << 24, 1 << 30][rng.below(4) as usize];
        let corners = CLASSES[class].corners(&mut rng, size);
        let gap = gap * size / 1000;
        let times = |k: u32| f64::from(k) / f64::from(SAMPLES);
        let touch = (0..SAMPLES).find(|&k| {
            if gap == 0 {
                passes(&corners, is_face, [times(k), times(k + 1)])
            } else {
                distance(&corners, is_face, times(k + 1)) < gap as f64 * 0.999
            }
        });
        let Some(touch) = touch else { continue };
        seen += 1;
        let options = Sweep { gap: Real::from_raw(gap), ..Sweep::default() };
        let found = sweep(&options, &corners, is_face);
        let time = found.map(|impact| f64::from(impact.time.raw()) / f64::from(1 << 30));
        assert!(
            time.is_some_and(|time| time <= times(touch + 1)),
            "{corners:?} {is_face} {gap}: {time:?}, but touches before {}",
            times(touch + 1)
        );
    }
    seen
}

fn all(seed: u64, queries: u32) {
    for (class, name) in CLASSES.iter().enumerate() {
        for is_face in [true, false] {
            let through: u32 = run(seed, class, is_face, 0, queries);
            let near: u32 = run(seed, class, is_face, 200, queries / 16);
            println!("{:?} {is_face}: {through} of {queries} pass, {near} near", name);
        }
    }
}

#[test]
fn no_contact_that_is_seen_is_missed() {
    all(3, 300);
    assert!(run(4, 0, false, 0, 1_000) > 20 && run(4, 0, true, 100, 200) > 10);
}

#[test]
#[ignore = "ten million queries: some minutes with --release"]
fn no_contact_of_ten_million_that_is_seen_is_missed() {
    all(5, 600_000);
}
