//! What of a shape is in front of the eye and near the picture.

use super::camera::{Lens, between};

/// A pyramid of views without its tip, twice as wide and high as the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frustum {
    focal: i64,
    /// Screen units from the middle.
    reach: [i64; 2],
    near: i64,
}

/// The planes around a frustum.
const PLANES: usize = 5;

impl Frustum {
    pub(super) fn new(lens: Lens, near: i64) -> Self {
        Self { focal: lens.focal(), reach: lens.half().map(|half| 2 * half), near }
    }

    /// How far inside of a plane a view is, in a unit of the plane's own. Below 2^61.7: 40 bits of
    /// the view times 21.6 of the focal length, and times 18 of the reach.
    fn inside(&self, plane: usize, view: [i64; 3]) -> i64 {
        let [x, y, ahead] = view;
        match plane {
            0 => ahead - self.near,
            1 => self.reach[0] * ahead - self.focal * x,
            2 => self.reach[0] * ahead + self.focal * x,
            3 => self.reach[1] * ahead - self.focal * y,
            _ => self.reach[1] * ahead + self.focal * y,
        }
    }

    pub(super) fn contains(&self, view: [i64; 3]) -> bool {
        (0..PLANES).all(|plane| self.inside(plane, view) >= 0)
    }

    /// The part of a line that is inside.
    pub(super) fn clip_line(&self, ends: [[i64; 3]; 2]) -> Option<[[i64; 3]; 2]> {
        let [mut a, mut b] = ends;
        for plane in 0..PLANES {
            let [at_a, at_b] = [a, b].map(|view| self.inside(plane, view));
            match (at_a < 0, at_b < 0) {
                (true, true) => return None,
                (true, false) => a = between(b, a, at_b, at_b - at_a),
                (false, true) => b = between(a, b, at_a, at_a - at_b),
                (false, false) => {}
            }
        }
        Some([a, b])
    }

    /// The part of a triangle that is inside: a convex polygon, perhaps without corners
    /// (Sutherland and Hodgman 1974).
    pub(super) fn clip_triangle(&self, corners: [[i64; 3]; 3]) -> Vec<[i64; 3]> {
        let mut polygon = corners.to_vec();
        if corners.iter().all(|&corner| self.contains(corner)) {
            return polygon;
        }
        for plane in 0..PLANES {
            let Some(&last) = polygon.last() else { break };
            let mut kept = Vec::with_capacity(polygon.len() + 1);
            let mut a = last;
            for b in polygon {
                let [at_a, at_b] = [a, b].map(|view| self.inside(plane, view));
                // From the inside out both times: a shared edge is cut at the same point.
                match (at_a < 0, at_b < 0) {
                    (true, false) => kept.extend([between(b, a, at_b, at_b - at_a), b]),
                    (false, true) => kept.push(between(a, b, at_a, at_a - at_b)),
                    (false, false) => kept.push(b),
                    (true, true) => {}
                }
                a = b;
            }
            polygon = kept;
        }
        polygon
    }
}
