//! Triangles in one plane made one polygon.

use alloc::vec;
use alloc::vec::Vec;

use super::quickhull::{Face, Quickhull};
use crate::math::determinant::cross;
use crate::math::wide::sub;

/// What is left of points that have been wrapped: the corners of the hull, in the order of the
/// points, and its faces, each counter-clockwise from its lowest corner, sorted.
pub(super) struct Facets {
    /// Places among the points.
    pub(super) corners: Vec<u32>,
    /// Places among the corners.
    pub(super) faces: Vec<Vec<u32>>,
}

impl Facets {
    /// The facets of the hull of some points, see [`Quickhull::of`]. They are those of the hull
    /// itself, whatever the order of the points.
    pub(super) fn of(points: &[[i64; 3]]) -> Option<Self> {
        let hull = Quickhull::of(points)?;
        let planes = planes(&hull.faces, points);
        let mut faces = outlines(&hull.faces, &planes);
        for outline in &mut faces {
            *outline = without_straight(outline, points);
        }
        let mut corners: Vec<u32> = faces.iter().flatten().copied().collect();
        corners.sort_unstable();
        corners.dedup();
        let mut places = vec![0; points.len()];
        for (place, &corner) in (0..).zip(&corners) {
            places[corner as usize] = place;
        }
        for face in &mut faces {
            for corner in face.iter_mut() {
                *corner = places[*corner as usize];
            }
            let lowest = (0..face.len()).min_by_key(|&k| face[k]).unwrap_or(0);
            face.rotate_left(lowest);
        }
        faces.sort_unstable();
        Some(Self { corners, faces })
    }
}

/// For each triangle the number of its plane; those of one plane are joined by edges.
fn planes(faces: &[Face], points: &[[i64; 3]]) -> Vec<u32> {
    const UNSEEN: u32 = u32::MAX; // there are fewer than 2^31 faces
    let mut planes = vec![UNSEEN; faces.len()];
    let mut open = Vec::new();
    let mut count = 0;
    for first in 0..faces.len() {
        if planes[first] != UNSEEN || faces[first].is_removed {
            continue;
        }
        planes[first] = count;
        open.push(&faces[first]);
        while let Some(face) = open.pop() {
            for neighbour in face.neighbours.map(|n| n as usize) {
                let other = &faces[neighbour];
                let is_level = |&p: &u32| face.height(points, p) == 0;
                if planes[neighbour] == UNSEEN && other.corners.iter().all(is_level) {
                    planes[neighbour] = count;
                    open.push(other);
                }
            }
        }
        count += 1;
    }
    planes
}

/// The outline of each plane's triangles, counter-clockwise.
fn outlines(faces: &[Face], planes: &[u32]) -> Vec<Vec<u32>> {
    // (plane, from, to) of every side beyond which there is another plane.
    let mut sides = Vec::new();
    for (face, &plane) in faces.iter().zip(planes).filter(|(face, _)| !face.is_removed) {
        for (k, &neighbour) in face.neighbours.iter().enumerate() {
            if planes[neighbour as usize] != plane {
                sides.push((plane, face.corners[k], face.corners[(k + 1) % 3]));
            }
        }
    }
    sides.sort_unstable();
    sides.chunk_by(|a, b| a.0 == b.0).map(outline).collect()
}

/// Sides of a convex polygon, sorted by where they begin, one behind the other.
fn outline(sides: &[(u32, u32, u32)]) -> Vec<u32> {
    let mut outline = Vec::with_capacity(sides.len());
    let mut at = 0;
    for _ in sides {
        let (_, from, to) = sides[at];
        outline.push(from);
        // There is one, since the outline is closed.
        at = sides.binary_search_by_key(&to, |side| side.1).unwrap_or(0);
    }
    outline
}

/// The corners of a polygon at which it turns.
fn without_straight(outline: &[u32], points: &[[i64; 3]]) -> Vec<u32> {
    let at = |k: usize| points[outline[k % outline.len()] as usize];
    let turns = |&k: &usize| {
        let [before, corner, after] = [k + outline.len() - 1, k, k + 1].map(at);
        cross(sub(corner, before), sub(after, before)) != [0; 3]
    };
    (0..outline.len()).filter(turns).map(|k| outline[k]).collect()
}
