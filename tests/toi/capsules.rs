//! Round shapes: balls against an exact quadratic, capsules against looking often; and landing
//! before they touch, against exact distances.

use num_bigint::BigInt;
use verlock::geometry::sweep::{Motion, Sweep};
use verlock::geometry::{Capsule, Sphere};
use verlock::math::{Pcg, Unit};
use verlock::{Real, Vec3};

use super::number;
use crate::closest::oracle::{nearest, on_segments};

fn point(rng: &mut Pcg, size: i64) -> Vec3 {
    Vec3::from_raw([(); 3].map(|()| number(rng, size)))
}

/// The square of the distance of two moving points less that of a reach, `a t^2 + b t + c`.
fn quadratic(p: Motion<Vec3>, q: Motion<Vec3>, reach: i64) -> [BigInt; 3] {
    let [start, end] = [(p.start, q.start), (p.end, q.end)]
        .map(|(p, q)| [0, 1, 2].map(|k| BigInt::from(q.raw()[k]) - p.raw()[k]));
    let way = [0, 1, 2].map(|k| &end[k] - &start[k]);
    let dot = |u: &[BigInt; 3], v: &[BigInt; 3]| -> BigInt { (0..3).map(|k| &u[k] * &v[k]).sum() };
    let reach = BigInt::from(reach);
    [dot(&way, &way), 2 * dot(&start, &way), dot(&start, &start) - &reach * &reach]
}

/// Whether a quadratic that opens upward is above 0 before a time (in units of 2^-30), and whether
/// also then.
fn is_above([a, b, c]: &[BigInt; 3], time: i32) -> [bool; 2] {
    if time == 0 {
        return [true, *c > BigInt::ZERO];
    }
    let (zero, unit, time) = (BigInt::ZERO, BigInt::from(1 << 30), BigInt::from(time));
    let end = a * &time * &time + b * &time * &unit + c * &unit * &unit;
    let starts = *c > zero;
    // Its lowest point, where it is between.
    let dips = *b < zero && 2 * a * &time > -b * &unit && b * b >= 4 * a * c;
    [starts && !dips && end >= zero, starts && !dips && end > zero]
}

fn balls(seed: u64, queries: u32) {
    let mut rng = Pcg::new(seed, 21);
    let (mut hits, mut exact) = (0, 0);
    for _ in 0..queries {
        let size = [9, 1 << 20, 1 << 24, 1 << 34, 1 << 58][rng.below(5) as usize];
        let radii = [(); 2].map(|()| number(&mut rng, (size / 3).min(1 << 39)).abs());
        let motion = |rng: &mut Pcg| Motion::new(point(rng, size), point(rng, size));
        let centers = [motion(&mut rng), motion(&mut rng)];
        let ball = |k: usize| {
            let at = |center| Sphere::new(center, Real::from_raw(radii[k])).expect("in range");
            Motion::new(at(centers[k].start), at(centers[k].end))
        };
        let found = Sweep::default().sphere_sphere(ball(0), ball(1));
        let square = quadratic(centers[0], centers[1], radii[0] + radii[1]);
        let Some(impact) = found else {
            let [_, above] = is_above(&square, 1 << 30);
            assert!(above, "missed: {centers:?} {radii:?}");
            continue;
        };
        hits += 1;
        let time = impact.time.raw();
        assert!(is_above(&square, time)[0], "late: {centers:?} {radii:?} {impact:?}");
        // A little later, or with a little more reach, they do touch.
        let wider = quadratic(centers[0], centers[1], radii[0] + radii[1] + 4);
        exact += u32::from(!is_above(&wider, (time + 8).min(1 << 30))[1]);
    }
    println!("balls: {hits} hits of {queries}, {exact} exact");
    assert!(hits > queries / 20 && exact * 100 >= hits * 99, "{exact} of {hits}");
}

/// The distance of the axes of two capsules at a time, in floats.
fn distance(a: Motion<[Vec3; 2]>, b: Motion<[Vec3; 2]>, time: f64) -> f64 {
    let at = |motion: Motion<[Vec3; 2]>, end: usize| {
        let (start, end) = (motion.start[end].raw(), motion.end[end].raw());
        [0, 1, 2].map(|k| start[k] as f64 + (end[k] - start[k]) as f64 * time)
    };
    let [p, q, r, s] = [at(a, 0), at(a, 1), at(b, 0), at(b, 1)];
    let sub = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (u, v, w) = (sub(q, p), sub(s, r), sub(p, r));
    // The best place on B for one on A, and the other way round, in turns: convex.
    let clamp = |along: f64, square: f64| (along / square.max(1e-9)).clamp(0.0, 1.0);
    let mut least = f64::MAX;
    for start in [0.0, 0.5, 1.0] {
        let mut on_a: f64 = start;
        for _ in 0..40 {
            let on_b = clamp(dot(w, v) + on_a * dot(u, v), dot(v, v));
            on_a = clamp(on_b * dot(u, v) - dot(w, u), dot(u, u));
            let d = [0, 1, 2].map(|k| w[k] + on_a * u[k] - on_b * v[k]);
            least = least.min(dot(d, d));
        }
    }
    least.sqrt()
}

fn capsules(seed: u64, queries: u32) {
    const SAMPLES: u32 = 24;
    let mut rng = Pcg::new(seed, 22);
    let (mut hits, mut near) = (0, 0);
    for _ in 0..queries {
        let size: i64 = [1 << 12, 1 << 20, 1 << 24, 1 << 30][rng.below(4) as usize];
        let radii = [(); 2].map(|()| number(&mut rng, size / 5).abs());
        let axis = |rng: &mut Pcg| {
            let [start, way] = [point(rng, size), point(rng, size)];
            let (along, turned) = (point(rng, size / 2), point(rng, size / 2));
            Motion::new([start, start + along], [start + way, start + way + turned])
        };
        let axes = [axis(&mut rng), axis(&mut rng)];
        let capsule = |k: usize| {
            let at = |ends| Capsule::new(ends, Real::from_raw(radii[k])).expect("in range");
            Motion::new(at(axes[k].start), at(axes[k].end))
        };
        let found = Sweep::default().capsule_capsule(capsule(0), capsule(1));
        let time = found.map_or(1.0, |impact| f64::from(impact.time.raw()) / f64::from(1 << 30));
        let reach = (radii[0] + radii[1]) as f64;
        for k in 0..if time > 0.0 { SAMPLES } else { 0 } {
            let earlier = time * f64::from(k) / f64::from(SAMPLES);
            let apart = distance(axes[0], axes[1], earlier);
            assert!(
                apart > reach - 2.0,
                "late: {axes:?} {radii:?} {found:?}: {apart} at {earlier}"
            );
        }
        let Some(impact) = found else { continue };
        hits += 1;
        let apart = distance(axes[0], axes[1], time);
        near += u32::from(apart < reach + 4.0 || impact.is_cut && apart < reach * 1.001);
    }
    println!("capsules: {hits} hits of {queries}, {near} near");
    assert!(hits > queries / 30 && near * 100 >= hits * 99, "{near} of {hits}");
}

/// Whether two capsules have no point in common, in rational numbers.
fn are_apart(a: &Capsule, b: &Capsule) -> bool {
    let [on_a, on_b] = nearest(on_segments(a.ends(), b.ends()));
    let [square, scale] = on_a.distance_sq(&on_b);
    let reach = BigInt::from((a.radius() + b.radius()).raw());
    square > &reach * &reach * scale
}

/// Pushes capsules towards one another, over and over again from where the last step has ended.
fn land(seed: u64, steps: u32) {
    let mut rng = Pcg::new(seed, 23);
    let mut stopped = 0;
    let mut pair = None;
    for step in 0..steps {
        let size: i64 = [30, 1 << 12, 1 << 20, 1 << 24, 1 << 34][(step / 16 % 5) as usize];
        if step % 16 == 0 {
            pair = None;
        }
        // Somewhere, side by side: sometimes with no more than a raw unit between, or balls.
        let [a, b] = pair.unwrap_or_else(|| {
            let along = size * i64::from(rng.below(2));
            let [a, b] = [(); 2].map(|()| {
                let radius = Real::from_raw(number(&mut rng, size / 3).abs());
                let end = point(&mut rng, size);
                Capsule::new([end, end + point(&mut rng, along)], radius).expect("in range")
            });
            let beside = (a.bounds().max().x - b.bounds().min().x).raw() + 1;
            let away = Vec3::from_raw([beside + number(&mut rng, size).max(0), 0, 0]);
            [a, Capsule::new(b.ends().map(|end| end + away), b.radius()).expect("in range")]
        });
        let way = (b.ends()[0] - a.ends()[0]).raw().map(|c| c.clamp(-size, size));
        let by = Vec3::from_raw(way) + point(&mut rng, size / 4);
        // The ends on their own, or not.
        let own = size / 8 * i64::from(rng.below(2));
        let mut moved = |capsule: Capsule, by: Vec3| {
            let ends = capsule.ends().map(|end| end + by + point(&mut rng, own));
            let end = Capsule::new(ends, capsule.radius()).expect("in range");
            Motion::new(capsule, end)
        };
        let motions = [moved(a, by), moved(b, Vec3::ZERO)];
        let gap = Real::from_raw([0, 2, size / 100][(step % 3) as usize]);
        let sweep = Sweep { gap, ..Sweep::default() };
        let time = sweep.advance_capsule_capsule(motions[0], motions[1]);
        match sweep.capsule_capsule(motions[0], motions[1]) {
            None => assert_eq!(time, Unit::ONE),
            Some(impact) => assert!(time <= impact.time, "{motions:?}"),
        }
        let [a, b] = motions.map(|motion| motion.at(time));
        assert!(are_apart(&a, &b), "{motions:?} {gap} {time}");
        stopped += u32::from(time < Unit::ONE);
        pair = Some([a, b]);
    }
    println!("{stopped} of {steps} stopped");
    assert!(stopped > steps / 5, "{stopped} of {steps} stopped");
}

#[test]
fn capsules_land_apart() {
    land(1, 3_000);
}

#[test]
#[ignore = "a million steps: a minute or two with --release"]
fn capsules_land_apart_a_million_times() {
    land(2, 1_000_000);
}

#[test]
fn balls_touch_when_a_quadratic_says() {
    balls(1, 2_000);
}

#[test]
fn capsules_touch_no_later_than_seen() {
    capsules(1, 300);
}

#[test]
#[ignore = "a million balls and a hundred thousand capsules: a minute or two with --release"]
fn a_million_balls_and_capsules_are_never_late() {
    balls(2, 1_000_000);
    capsules(2, 100_000);
}

#[test]
fn radii_count_for_the_whole_step() {
    let ball = |x: i32, radius: i32| {
        Sphere::new(Vec3::from_ints(x, 0, 0), Real::from_int(radius)).expect("in range")
    };
    let still = Motion::rest(ball(0, 1));
    let found = |motion| Sweep::default().sphere_sphere(motion, still).map(|impact| impact.time);
    // From 10 to 2 m, touching at 3 m.
    assert_eq!(found(Motion::new(ball(10, 2), ball(2, 1))), Unit::from_ratio(7, 8).ok());
    assert_eq!(found(Motion::new(ball(10, 1), ball(3, 1))), None);
    assert_eq!(found(Motion::rest(ball(2, 1))), Some(Unit::ZERO));
}
