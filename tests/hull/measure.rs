//! Distances of points from hulls and round shapes, in floats and in integers of any size: nothing
//! of the library's own.

use num_bigint::BigInt;
use verlock::geometry::{Capsule, ConvexHull, Cuboid, Sphere};
use verlock::math::Pcg;
use verlock::{Real, Vec3};

use super::oracle::{Big, big, minus};
use crate::corpus::laws::oracle::{cross, dot};

pub type Place = [f64; 3];

pub fn metres(real: Real) -> f64 {
    real.raw() as f64 / 16_777_216.0
}

pub fn place(p: Vec3) -> Place {
    p.raw().map(|c| c as f64 / 16_777_216.0)
}

pub fn sub(a: Place, b: Place) -> Place {
    [0, 1, 2].map(|k| a[k] - b[k])
}

pub fn along(a: Place, b: Place, t: f64) -> Place {
    [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t)
}

pub fn product(a: Place, b: Place) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

pub fn length(a: Place) -> f64 {
    product(a, a).sqrt()
}

/// A random direction.
pub fn direction(rng: &mut Pcg) -> Place {
    loop {
        let p = [(); 3].map(|()| f64::from(rng.next_u32()) / 2f64.powi(31) - 1.0);
        let long = length(p);
        if (0.1..1.0).contains(&long) {
            return p.map(|c| c / long);
        }
    }
}

/// How far the points of a hull reach in a direction.
pub fn support(points: &[Place], way: Place) -> f64 {
    points.iter().map(|&p| product(p, way)).fold(f64::NEG_INFINITY, f64::max)
}

/// The distance of a point from the hull of points: descent to the nearest point of it (Frank and
/// Wolfe, with steps away from corners).
pub fn distance(points: &[Place], p: Place) -> f64 {
    let mut shares = vec![0.0; points.len()];
    shares[0] = 1.0;
    let mut at = points[0];
    // What is left of the square of a distance that floats can still tell.
    let least = 1e-16 * product(sub(p, at), sub(p, at)).max(f64::MIN_POSITIVE);
    for _ in 0..20_000 {
        let way = sub(p, at);
        let reach = |k: &usize| product(points[*k], way);
        let order = |a: &usize, b: &usize| reach(a).total_cmp(&reach(b));
        let best = (0..points.len()).max_by(order).expect("points");
        let worst = (0..points.len()).filter(|&k| shares[k] > 0.0).min_by(order).expect("one");
        let step = sub(points[best], points[worst]);
        let long = product(step, step);
        if long == 0.0 || reach(&best) - product(at, way) < least {
            break;
        }
        let t = (product(way, step) / long).min(shares[worst]);
        shares[best] += t;
        shares[worst] -= t;
        at = [0, 1, 2].map(|k| at[k] + step[k] * t);
    }
    length(sub(p, at))
}

fn square(v: &Big) -> BigInt {
    dot(v, v)
}

pub fn sphere_contains(sphere: &Sphere, p: Vec3) -> bool {
    let way = minus(&big(p.raw()), &big(sphere.center().raw()));
    square(&way) <= BigInt::from(sphere.radius().raw()).pow(2)
}

pub fn capsule_contains(capsule: &Capsule, p: Vec3) -> bool {
    let [a, b] = capsule.ends().map(|end| big(end.raw()));
    let (axis, way) = (minus(&b, &a), minus(&big(p.raw()), &a));
    let (reach, whole) = (dot(&axis, &way), square(&axis));
    let limit = BigInt::from(capsule.radius().raw()).pow(2);
    let zero = BigInt::from(0);
    if reach <= zero {
        square(&way) <= limit
    } else if reach >= whole {
        square(&minus(&big(p.raw()), &b)) <= limit
    } else {
        square(&cross(&axis, &way)) <= limit * whole
    }
}

pub fn cuboid_contains(cuboid: &Cuboid, p: Vec3) -> bool {
    let half = cuboid.half_edges().map(|half| big(half.raw()));
    let way = minus(&big(p.raw()), &big(cuboid.center().raw()));
    (0..3).all(|i| {
        let normal = cross(&half[(i + 1) % 3], &half[(i + 2) % 3]);
        let (reach, whole) = (dot(&normal, &way), dot(&normal, &half[i]));
        reach.magnitude() <= whole.magnitude()
    })
}

/// By the planes of all faces: those of hulls that were not moved are exact.
pub fn hull_contains(hull: &ConvexHull, p: Vec3) -> bool {
    hull.topology().widest_corners().iter().all(|corners| {
        let [a, b, c] = corners.map(|vertex| big(hull.vertices()[vertex as usize].raw()));
        let normal = cross(&minus(&b, &a), &minus(&c, &a));
        dot(&normal, &minus(&big(p.raw()), &a)) <= BigInt::from(0)
    })
}
