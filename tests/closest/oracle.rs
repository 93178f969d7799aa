//! Nearest points in rational numbers, by looking at every feature.

use num_bigint::BigInt;
use verlock::Vec3;

type Big3 = [BigInt; 3];

/// The point `xyz / w`, `w > 0`.
#[derive(Clone, Debug)]
pub struct Rational {
    pub xyz: Big3,
    pub w: BigInt,
}

pub fn big(p: Vec3) -> Big3 {
    p.raw().map(BigInt::from)
}

pub fn sub(a: &Big3, b: &Big3) -> Big3 {
    [0, 1, 2].map(|k| &a[k] - &b[k])
}

pub fn dot(a: &Big3, b: &Big3) -> BigInt {
    (0..3).map(|k| &a[k] * &b[k]).sum()
}

pub fn cross(a: &Big3, b: &Big3) -> Big3 {
    [0, 1, 2].map(|k| &a[(k + 1) % 3] * &b[(k + 2) % 3] - &a[(k + 2) % 3] * &b[(k + 1) % 3])
}

impl Rational {
    pub fn of(p: Vec3) -> Self {
        Self { xyz: big(p), w: BigInt::from(1) }
    }

    /// `from + (to - from) n / d`.
    pub fn between(from: &Big3, to: &Big3, n: &BigInt, d: &BigInt) -> Self {
        Self { xyz: [0, 1, 2].map(|k| &from[k] * (d - n) + &to[k] * n), w: d.clone() }
    }

    /// The square of the distance, as numerator and denominator.
    pub fn distance_sq(&self, other: &Self) -> [BigInt; 2] {
        let way = [0, 1, 2].map(|k| &self.xyz[k] * &other.w - &other.xyz[k] * &self.w);
        let w = &self.w * &other.w;
        [dot(&way, &way), &w * &w]
    }

    /// Whether a rounded point is nearest by components, of the two at a tie either.
    pub fn rounds_to(&self, p: Vec3) -> bool {
        let p = big(p);
        (0..3).all(|k| {
            let off: BigInt = (&self.xyz[k] - &p[k] * &self.w) * 2;
            off <= self.w && -off <= self.w
        })
    }
}

fn less(a: &[BigInt; 2], b: &[BigInt; 2]) -> bool {
    &a[0] * &b[1] < &b[0] * &a[1]
}

/// The nearest of some pairs of points, the first of equals.
pub fn nearest(pairs: impl IntoIterator<Item = [Rational; 2]>) -> [Rational; 2] {
    let with = |pair: [Rational; 2]| (pair[0].distance_sq(&pair[1]), pair);
    let all = pairs.into_iter().map(with);
    all.reduce(|best, next| if less(&next.0, &best.0) { next } else { best }).expect("a pair").1
}

/// Candidates of a segment: its ends, and the foot if that is between them.
pub fn on_segment(p: Vec3, ends: [Vec3; 2]) -> Vec<Rational> {
    let [a, b] = ends.map(big);
    let along = sub(&b, &a);
    let (n, d) = (dot(&along, &sub(&big(p), &a)), dot(&along, &along));
    let mut all: Vec<_> = ends.map(Rational::of).into();
    if BigInt::ZERO < n && n < d {
        all.push(Rational::between(&a, &b, &n, &d));
    }
    all
}

/// Candidates of a triangle: those of its edges, and the foot on its plane if that is inside.
pub fn on_triangle(p: Vec3, corners: [Vec3; 3]) -> Vec<Rational> {
    let edges = [[0, 1], [1, 2], [2, 0]];
    let mut all: Vec<_> = edges.map(|edge| on_segment(p, edge.map(|k| corners[k]))).concat();
    let [a, b, c] = corners.map(big);
    let normal = cross(&sub(&b, &a), &sub(&c, &a));
    let d = dot(&normal, &normal);
    let p = big(p);
    let inside = [[&a, &b], [&b, &c], [&c, &a]]
        .iter()
        .all(|[from, to]| dot(&normal, &cross(&sub(to, from), &sub(&p, from))) > BigInt::ZERO);
    if inside {
        let height = dot(&normal, &sub(&p, &a));
        all.push(Rational { xyz: [0, 1, 2].map(|k| &p[k] * &d - &normal[k] * &height), w: d });
    }
    all
}

/// Candidates of two segments: each end with the other segment, and the feet of both lines on each
/// other if both are inside.
pub fn on_segments(a: [Vec3; 2], b: [Vec3; 2]) -> Vec<[Rational; 2]> {
    let mut all = Vec::new();
    for end in a {
        all.extend(on_segment(end, b).into_iter().map(|foot| [Rational::of(end), foot]));
    }
    for end in b {
        all.extend(on_segment(end, a).into_iter().map(|foot| [foot, Rational::of(end)]));
    }
    let [[a, a_end], [b, b_end]] = [a, b].map(|ends| ends.map(big));
    let (u, v, w) = (sub(&a_end, &a), sub(&b_end, &b), sub(&b, &a));
    // The lines are nearest where the planes through them and their common normal cut them.
    let normal = cross(&u, &v);
    let d = dot(&normal, &normal);
    let (s, t) = (dot(&cross(&w, &v), &normal), dot(&cross(&w, &u), &normal));
    let inside = |n: &BigInt| BigInt::ZERO < *n && *n < d;
    if inside(&s) && inside(&t) {
        all.push([Rational::between(&a, &a_end, &s, &d), Rational::between(&b, &b_end, &t, &d)]);
    }
    all
}
