//! Whether triangles meet, by another theorem: they do where 0 is in the hull of the differences of
//! their corners. By Caratheodory's theorem that is where 0 is one of these points, or lies in the
//! segment, triangle or tetrahedron of 2, 3 or 4 of them. Nothing is a special case.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

/// Integers wide enough for three of the coordinates multiplied.
pub trait Exact: Clone + Default + Ord {
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
}

impl<T: Clone + Default + Ord> Exact for T
where
    for<'a> &'a T: Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    fn plus(&self, other: &T) -> T {
        self + other
    }

    fn minus(&self, other: &T) -> T {
        self - other
    }

    fn times(&self, other: &T) -> T {
        self * other
    }
}

type Vector<T> = [T; 3];

/// The dot product.
pub fn dot<T: Exact>(u: &Vector<T>, v: &Vector<T>) -> T {
    let [x, y, z] = [0, 1, 2].map(|k| u[k].times(&v[k]));
    x.plus(&y).plus(&z)
}

/// The cross product.
pub fn cross<T: Exact>(u: &Vector<T>, v: &Vector<T>) -> Vector<T> {
    let minor = |j: usize, k: usize| u[j].times(&v[k]).minus(&u[k].times(&v[j]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn is_zero<T: Exact>(v: &Vector<T>) -> bool {
    v.iter().all(|c| *c == T::default())
}

fn sign<T: Exact>(v: &T) -> i32 {
    match v.cmp(&T::default()) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}

/// Whether 0 lies between two points: they are opposite.
fn segment<T: Exact>(p: &Vector<T>, q: &Vector<T>) -> bool {
    is_zero(&cross(p, q)) && sign(&dot(p, q)) <= 0
}

/// Whether 0 lies in a triangle: in its plane, and to the same side of every edge.
fn triangle<T: Exact>(p: &Vector<T>, q: &Vector<T>, r: &Vector<T>) -> bool {
    let turns = [cross(p, q), cross(q, r), cross(r, p)];
    let normal = [0, 1, 2].map(|k| turns[0][k].plus(&turns[1][k]).plus(&turns[2][k]));
    !is_zero(&normal)
        && sign(&dot(p, &turns[1])) == 0
        && turns.iter().all(|turn| sign(&dot(turn, &normal)) >= 0)
}

/// Whether 0 lies in a tetrahedron: its weights there have one sign.
fn tetrahedron<T: Exact>(corners: [&Vector<T>; 4]) -> bool {
    let volume =
        |i: usize, j: usize, k: usize| sign(&dot(&cross(corners[i], corners[j]), corners[k]));
    let weights = [volume(1, 2, 3), -volume(0, 2, 3), volume(0, 1, 3), -volume(0, 1, 2)];
    // All of them 0: it is flat, and smaller hulls decide.
    weights != [0; 4]
        && (weights.iter().all(|&weight| weight >= 0) || weights.iter().all(|&weight| weight <= 0))
}

/// Whether two triangles meet. Triangles without an area are segments or points.
pub fn overlap<T: Exact>(a: &[Vector<T>; 3], b: &[Vector<T>; 3]) -> bool {
    let differences = |p: &Vector<T>| b.each_ref().map(|q| [0, 1, 2].map(|k| p[k].minus(&q[k])));
    let points = a.each_ref().map(differences).concat();
    let all = 0..points.len();
    let above = |first: usize| first + 1..9;
    all.clone().any(|i| is_zero(&points[i]))
        || all.clone().any(|i| above(i).any(|j| segment(&points[i], &points[j])))
        || all.clone().any(|i| {
            above(i).any(|j| above(j).any(|k| triangle(&points[i], &points[j], &points[k])))
        })
        || all.clone().any(|i| {
            above(i).any(|j| {
                above(j).any(|k| {
                    above(k).any(|l| tetrahedron([i, j, k, l].map(|corner| &points[corner])))
                })
            })
        })
}
