//! The distance of shapes in floats, by brute force.

use verlock::Vec3;
use verlock::collision::Shape;
use verlock::geometry::{HeightField, Surface};

use crate::support::float::{add_scaled, cross, dot, length, sub};

type Point = [f64; 3];

/// Convex pieces as points and a radius; or a plane as a point and a normal.
pub enum Twin {
    Plane(Point, Point),
    Pieces(Vec<(Vec<Point>, f64)>),
}

impl Twin {
    /// A shape as it is seen from a point near it, in raw units.
    pub fn of(shape: &Shape, origin: Vec3) -> Self {
        let at = |p: Vec3| (p - origin).raw().map(|c| c as f64);
        let all = |points: &[Vec3]| points.iter().map(|&p| at(p)).collect::<Vec<_>>();
        let faces = |surface: &dyn Fn(u32) -> [Vec3; 3], len: u32| {
            (0..len).map(|face| (all(&surface(face)), 0.0)).collect()
        };
        Self::Pieces(match shape {
            Shape::HalfSpace(s) => {
                let normal = s.normal().raw().map(|c| c as f64 / f64::from(1 << 30));
                return Self::Plane(at(s.point()), normal);
            }
            Shape::Sphere(s) => vec![(vec![at(s.center())], s.radius().raw() as f64)],
            Shape::Capsule(s) => vec![(all(&s.ends()), s.radius().raw() as f64)],
            Shape::Cuboid(s) => vec![(all(&s.corners()), 0.0)],
            Shape::ConvexHull(s) => vec![(all(s.vertices()), 0.0)],
            Shape::Triangle(s) => vec![(all(s.corners()), 0.0)],
            Shape::MeshShape(s) => {
                faces(&|face| *s.triangle(face).corners(), s.mesh().faces().len() as u32)
            }
            Shape::HeightField(s) => {
                faces(&|face| *s.triangle(face).corners(), HeightField::faces_len(s))
            }
            _ => unreachable!("a kind that is not listed"),
        })
    }

    /// The distance, below 0 where they overlap: then it is not worth more than its sign.
    pub fn distance(&self, other: &Self) -> f64 {
        match (self, other) {
            (Self::Plane(p, n), Self::Plane(q, m)) => {
                if *m == n.map(|c| -c) {
                    dot(*n, sub(*q, *p))
                } else {
                    f64::NEG_INFINITY
                }
            }
            (Self::Plane(p, n), Self::Pieces(pieces))
            | (Self::Pieces(pieces), Self::Plane(p, n)) => {
                let heights = pieces.iter().flat_map(|(points, radius)| {
                    points.iter().map(move |&q| dot(*n, sub(q, *p)) - radius)
                });
                heights.fold(f64::INFINITY, f64::min)
            }
            (Self::Pieces(a), Self::Pieces(b)) => {
                let pairs = a.iter().flat_map(|a| b.iter().map(move |b| convex(a, b)));
                pairs.fold(f64::INFINITY, f64::min)
            }
        }
    }
}

fn convex(a: &(Vec<Point>, f64), b: &(Vec<Point>, f64)) -> f64 {
    let cores = if gap(&a.0, &b.0) > 0.0 { apart(&a.0, &b.0) } else { return f64::NEG_INFINITY };
    cores - a.1 - b.1
}

/// The greatest gap along any axis that may part two hulls, not to scale: 0 or less if none does.
/// Exact for small whole numbers.
pub fn gap(a: &[Point], b: &[Point]) -> f64 {
    let ways = |points: &[Point]| -> Vec<Point> {
        let pairs = points
            .iter()
            .enumerate()
            .flat_map(|(i, &p)| points[i + 1..].iter().map(move |&q| sub(q, p)));
        pairs.collect()
    };
    let mut edges = ways(a);
    edges.extend(ways(b));
    let across = sub(b[0], a[0]);
    let mut axes: Vec<Point> = vec![across];
    axes.extend(&edges);
    for (i, &e) in edges.iter().enumerate() {
        axes.extend(edges[i + 1..].iter().map(|&f| cross(e, f)));
        // Where all is in one plane, or on one line.
        axes.push(cross(e, across));
        axes.push(cross(cross(e, across), e));
        axes.extend(
            edges[i + 1..]
                .iter()
                .filter(|_| edges.len() <= 6)
                .flat_map(|&f| [cross(cross(e, f), e), cross(cross(e, f), f)]),
        );
    }
    axes.iter().map(|axis| gap_along(*axis, a, b)).fold(f64::NEG_INFINITY, f64::max)
}

/// As a share of the axis, so that rounding is small.
fn gap_along(axis: Point, a: &[Point], b: &[Point]) -> f64 {
    let size = length(axis);
    if size == 0.0 {
        return f64::NEG_INFINITY;
    }
    let along = |p: &Point| dot(axis, sub(*p, a[0]));
    let [mut low_a, mut high_a, mut low_b, mut high_b] =
        [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    for p in a {
        (low_a, high_a) = (low_a.min(along(p)), high_a.max(along(p)));
    }
    for p in b {
        (low_b, high_b) = (low_b.min(along(p)), high_b.max(along(p)));
    }
    (low_b - high_a).max(low_a - high_b) / size
}

/// The distance of two hulls that are apart: of any corner and any triangle of corners, or of any
/// two segments between corners.
fn apart(a: &[Point], b: &[Point]) -> f64 {
    let mut best = f64::INFINITY;
    for (a, b) in [(a, b), (b, a)] {
        for &p in a {
            for i in 0..b.len() {
                for j in i..b.len() {
                    for k in j..b.len() {
                        best = best.min(length(sub(on_triangle(p, [b[i], b[j], b[k]]), p)));
                    }
                }
            }
        }
    }
    for i in 0..a.len() {
        for j in i + 1..a.len() {
            for k in 0..b.len() {
                for l in k + 1..b.len() {
                    best = best.min(segments([a[i], a[j]], [b[k], b[l]]));
                }
            }
        }
    }
    best
}

fn on_segment(p: Point, [a, b]: [Point; 2]) -> Point {
    let along = sub(b, a);
    let whole = dot(along, along);
    let t = if whole == 0.0 { 0.0 } else { (dot(along, sub(p, a)) / whole).clamp(0.0, 1.0) };
    add_scaled(a, along, t)
}

/// The foot on the plane, if that is inside, or the nearest of those on the edges.
fn on_triangle(p: Point, [a, b, c]: [Point; 3]) -> Point {
    let normal = cross(sub(b, a), sub(c, a));
    let whole = dot(normal, normal);
    let inside = |[from, to]: [Point; 2]| dot(normal, cross(sub(to, from), sub(p, from))) > 0.0;
    if whole > 0.0 && [[a, b], [b, c], [c, a]].into_iter().all(inside) {
        return add_scaled(p, normal, -dot(normal, sub(p, a)) / whole);
    }
    let feet = [[a, b], [b, c], [c, a]].map(|edge| on_segment(p, edge));
    let far = |q: &Point| length(sub(*q, p));
    feet.into_iter().min_by(|q, r| far(q).total_cmp(&far(r))).expect("three")
}

/// The distance of the insides of two segments; their ends are looked at elsewhere.
fn segments([a, b]: [Point; 2], [c, d]: [Point; 2]) -> f64 {
    let (u, v, w) = (sub(b, a), sub(d, c), sub(c, a));
    let normal = cross(u, v);
    let whole = dot(normal, normal);
    let (s, t) = (dot(cross(w, v), normal), dot(cross(w, u), normal));
    let inside = |n: f64| 0.0 < n && n < whole;
    if inside(s) && inside(t) { dot(normal, w).abs() / whole.sqrt() } else { f64::INFINITY }
}
