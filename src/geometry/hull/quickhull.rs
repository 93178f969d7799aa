//! The hull of points as triangles: Quickhull (Barber, Dobkin, Huhdanpaa, *The Quickhull Algorithm
//! for Convex Hulls*, 1996) in exact integers.
//!
//! ```text
//! begin with a tetrahedron; every point goes to a face that sees it
//! while a face sees points: take the farthest, the eye
//!     remove the faces that see the eye; join the eye to each edge of the hole
//!     points of the removed faces go to new faces that see them, or are inside
//! ```
//! To see is to be strictly in front. No sign is wrong, hence no tolerance: an eye in the plane of
//! a face leaves the face and adds triangles beside it in its plane. None has no area: where the
//! eye is on the line of an edge, it is in the planes of both of its faces, and neither sees it.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;

use crate::math::determinant::{cross, dot};
use crate::math::wide::sub;

/// A triangle of the hull.
pub(super) struct Face {
    /// Counter-clockwise, seen from outside; places among the points.
    pub(super) corners: [u32; 3],
    /// The face across the side from corner k to the next.
    pub(super) neighbours: [u32; 3],
    normal: [i128; 3],
    /// Points in front of this face.
    outside: Vec<u32>,
    /// Seen by an eye, and so no part of the hull any more.
    pub(super) is_removed: bool,
}

impl Face {
    /// How far in front of it a point is: the distance times the length of the normal.
    #[inline]
    pub(super) fn height(&self, points: &[[i64; 3]], point: u32) -> i128 {
        let origin = points[self.corners[0] as usize];
        dot(&self.normal, sub(points[point as usize], origin))
    }
}

/// The triangles of a hull of points, in the making or done.
pub(super) struct Quickhull<'a> {
    points: &'a [[i64; 3]],
    pub(super) faces: Vec<Face>,
    /// For the ends of a hole's edges, while it is closed: the face of the edge that begins there.
    spokes: Vec<u32>,
    /// Faces that are removed.
    free: Vec<u32>,
}

/// An edge of the hole that an eye leaves, counter-clockwise, and the face beyond it.
struct Rim {
    from: u32,
    to: u32,
    beyond: u32,
    side: usize,
}

/// Four of the points, far apart, as the corners of a tetrahedron with its last corner behind the
/// plane of the others; `None` where all points lie in one plane. Of equal points the first. O(n).
pub(super) fn simplex(points: &[[i64; 3]]) -> Option<[u32; 4]> {
    let a = first_best(points, |p| Reverse(*p))?;
    let b = first_best(points, |p| *p)?;
    let [at_a, at_b] = [a, b].map(|p| points[p as usize]);
    // Coordinates span less than 2^41 here: areas are below 2^84, volumes below 2^125.
    let normal_to = |p: [i64; 3]| cross(sub(at_b, at_a), sub(p, at_a));
    let area = |p: &[i64; 3]| normal_to(*p).map(i128::abs).iter().sum::<i128>();
    let c = first_best(points, area)?;
    let normal = normal_to(points[c as usize]);
    let height = |p: &[i64; 3]| dot(&normal, sub(*p, at_a));
    let d = first_best(points, |p| height(p).abs())?;
    match height(&points[d as usize]) {
        0 => None, // also where all lie on one line, or in one place
        ..0 => Some([a, b, c, d]),
        1.. => Some([a, c, b, d]),
    }
}

/// The first of the points with the greatest score.
fn first_best<K: Ord>(points: &[[i64; 3]], score: impl Fn(&[i64; 3]) -> K) -> Option<u32> {
    (0..).zip(points).max_by_key(|&(place, p)| (score(p), Reverse(place))).map(|(place, _)| place)
}

impl<'a> Quickhull<'a> {
    /// The hull of fewer than 2^30 points that span less than 2^41 along each axis; `None` where
    /// all lie in one plane. Expected O(n log n).
    pub(super) fn of(points: &'a [[i64; 3]]) -> Option<Self> {
        let simplex = simplex(points)?;
        let mut hull =
            Self { points, faces: Vec::new(), spokes: vec![0; points.len()], free: Vec::new() };
        hull.begin(simplex);
        let mut open: Vec<u32> = (0..4).collect();
        while let Some(face) = open.pop() {
            if let Some(eye) = hull.farthest(face) {
                open.extend(hull.add(face, eye));
            }
        }
        Some(hull)
    }

    /// The first four faces.
    fn begin(&mut self, [a, b, c, d]: [u32; 4]) {
        self.put([a, b, c], [3, 1, 2]);
        self.put([c, b, d], [0, 3, 2]);
        self.put([a, c, d], [0, 1, 3]);
        self.put([b, a, d], [0, 2, 1]);
        let all = (0..).zip(self.points).map(|(place, _)| place).collect();
        self.hand_out(all, &[0, 1, 2, 3]);
    }

    /// Adds a face, in the place of a removed one if there is one; returns its place.
    #[expect(clippy::cast_possible_truncation, reason = "at most 2 faces a point, below 2^31")]
    fn put(&mut self, corners: [u32; 3], neighbours: [u32; 3]) -> u32 {
        let [a, b, c] = corners.map(|corner| self.points[corner as usize]);
        let normal = cross(sub(b, a), sub(c, a));
        let face = Face { corners, neighbours, normal, outside: Vec::new(), is_removed: false };
        if let Some(place) = self.free.pop() {
            self.faces[place as usize] = face;
            place
        } else {
            self.faces.push(face);
            self.faces.len() as u32 - 1
        }
    }

    /// The point farthest in front of a face; of several, the first.
    fn farthest(&self, face: u32) -> Option<u32> {
        let face = &self.faces[face as usize];
        let outside = face.outside.iter().copied();
        outside.max_by_key(|&point| (face.height(self.points, point), Reverse(point)))
    }

    /// Adds an eye that a face sees; returns the new faces.
    fn add(&mut self, face: u32, eye: u32) -> Vec<u32> {
        let seen = self.remove_seen(face, eye);
        let rims = self.rims(&seen);
        let mut points = Vec::new();
        for &face in &seen {
            points.append(&mut self.faces[face as usize].outside);
        }
        self.free.extend(seen);
        let new = self.close(&rims, eye);
        self.hand_out(points, &new);
        new
    }

    /// Removes the faces that see an eye, all that are joined to one of them.
    fn remove_seen(&mut self, face: u32, eye: u32) -> Vec<u32> {
        self.faces[face as usize].is_removed = true;
        let mut seen = vec![face];
        let mut next = 0;
        while let Some(&face) = seen.get(next) {
            next += 1;
            for neighbour in self.faces[face as usize].neighbours {
                let face = &mut self.faces[neighbour as usize];
                let unseen = i128::from(cfg!(planted));
                if !face.is_removed && face.height(self.points, eye) > unseen {
                    face.is_removed = true;
                    seen.push(neighbour);
                }
            }
        }
        seen
    }

    /// The edges around removed faces.
    fn rims(&self, seen: &[u32]) -> Vec<Rim> {
        let mut rims = Vec::new();
        for &inner in seen {
            let Face { corners, neighbours, .. } = &self.faces[inner as usize];
            for (k, &beyond) in neighbours.iter().enumerate() {
                let face = &self.faces[beyond as usize];
                let [from, to] = [corners[k], corners[(k + 1) % 3]];
                // Beyond the edge it runs the other way.
                let side = face.corners.iter().position(|&corner| corner == to);
                if let Some(side) = side.filter(|_| !face.is_removed) {
                    rims.push(Rim { from, to, beyond, side });
                }
            }
        }
        rims
    }

    /// Joins the eye to each edge of the hole.
    fn close(&mut self, rims: &[Rim], eye: u32) -> Vec<u32> {
        let new: Vec<u32> = rims
            .iter()
            .map(|&Rim { from, to, beyond, side }| {
                let place = self.put([from, to, eye], [beyond; 3]);
                self.faces[beyond as usize].neighbours[side] = place;
                self.spokes[from as usize] = place;
                place
            })
            .collect();
        for (&place, rim) in new.iter().zip(rims) {
            // The edges form one loop: the next face begins where this one's edge ends.
            let next = self.spokes[rim.to as usize];
            self.faces[place as usize].neighbours[1] = next;
            self.faces[next as usize].neighbours[2] = place;
        }
        new
    }

    /// Gives each point to the first of the faces that sees it, if one does.
    fn hand_out(&mut self, points: Vec<u32>, faces: &[u32]) {
        for point in points {
            let sees = |&&face: &&u32| self.faces[face as usize].height(self.points, point) > 0;
            if let Some(&face) = faces.iter().find(sees) {
                self.faces[face as usize].outside.push(point);
            }
        }
    }
}
