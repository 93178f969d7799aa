//! The hull of points by looking at every plane through three of them.

use super::oracle::{Exact, cross, dot};

type Vector<T> = [T; 3];

/// A plane with points behind it, but none in front: that of a face.
pub struct Plane<T> {
    /// Points to the front.
    pub normal: Vector<T>,
    /// How far along the normal it is.
    pub offset: T,
    /// The places of the points in it, in order.
    pub points: Vec<usize>,
}

/// The planes of all faces of the hull of some points, no two of which coincide; none if they all
/// lie in one.
pub fn planes<T: Exact>(points: &[Vector<T>]) -> Vec<Plane<T>> {
    let mut planes: Vec<Plane<T>> = vec![];
    for (i, a) in points.iter().enumerate() {
        for (j, b) in points.iter().enumerate().skip(i + 1) {
            for c in &points[j + 1..] {
                let Some(plane) = Plane::of([a, b, c], points) else { continue };
                if planes.iter().all(|other| other.points != plane.points) {
                    planes.push(plane);
                }
            }
        }
    }
    planes
}

/// Whether a point is a corner of the hull: no other is in all the faces that it is in.
pub fn is_corner<T>(planes: &[Plane<T>], point: usize) -> bool {
    let mut of_it = planes.iter().filter(|plane| plane.points.contains(&point));
    let Some(first) = of_it.next() else { return false };
    let mut common = first.points.clone();
    for plane in of_it {
        common.retain(|other| plane.points.contains(other));
    }
    common.len() == 1
}

impl<T: Exact> Plane<T> {
    fn of([a, b, c]: [&Vector<T>; 3], points: &[Vector<T>]) -> Option<Self> {
        let from_a = |p: &Vector<T>| [0, 1, 2].map(|k| p[k].minus(&a[k]));
        let normal = cross(&from_a(b), &from_a(c));
        let heights: Vec<T> = points.iter().map(|p| dot(&normal, &from_a(p))).collect();
        let zero = T::default();
        let has_front = heights.iter().any(|height| *height > zero);
        let has_back = heights.iter().any(|height| *height < zero);
        if has_front == has_back {
            return None;
        }
        let normal = if has_front { normal.map(|c| zero.minus(&c)) } else { normal };
        let level = (0..points.len()).filter(|&k| heights[k] == zero);
        Some(Self { offset: dot(&normal, a), points: level.collect(), normal })
    }

    /// Whether a point is behind it or in it.
    pub fn is_before(&self, point: &Vector<T>) -> bool {
        dot(&self.normal, point) <= self.offset
    }
}
