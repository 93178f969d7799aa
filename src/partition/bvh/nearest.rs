//! What is nearest to a point.

use alloc::vec::Vec;

use super::Bvh;
use super::build::LANES;
use super::cell_box::CellBox;
use super::cells::Cells;
use super::volume::Volume;
use crate::geometry::{ClosestPoint, closest_point_triangle};
use crate::math::Vec3;

/// The point of a mesh that is nearest to another.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Nearest {
    /// The face that it lies on: of several equally near ones, the lowest.
    pub face: u32,
    /// Where on the face it is.
    pub point: ClosestPoint<3>,
    /// The square of the distance to that place, in units of 2^-48 m^2.
    pub distance_sq: u128,
    /// The place of the face in the order of the leaves.
    pub(super) place: u32,
}

/// A node to look into, with the least square of a distance of anything in it.
type Open = (u128, u32);

impl<V: Volume> Bvh<V> {
    /// The point of the mesh, where its vertices are, that is nearest to `point`, wherever that is.
    ///
    /// Faces are compared by their nearest points as they are rounded, so one that is nearer by
    /// less than 60 nm may be passed over. O(log n) for n faces unless many are equally near.
    #[must_use]
    pub fn nearest(&self, point: Vec3) -> Nearest {
        let first = self.nearest_on(0, point);
        self.nearest_or(first, point)
    }

    /// The same, given a point on one of its faces: the nearer it is, the less is looked at.
    pub(super) fn nearest_or(&self, first: Nearest, point: Vec3) -> Nearest {
        let mut best = first;
        let mut open: Vec<Open> = Vec::from([(0, 0)]);
        while let Some((distance_sq, node)) = open.pop() {
            if distance_sq > best.distance_sq {
                continue;
            }
            let link = self.shape.links[node as usize];
            let mut below = [(0, 0); LANES];
            let mut len = 0;
            for (lane, place) in
                self.volumes[node as usize].iter().zip(link.first..link.first + u32::from(link.len))
            {
                let distance_sq = self.cells.distance_sq(&lane.bounds(), point);
                if distance_sq <= best.distance_sq {
                    below[len] = (distance_sq, place);
                    len += 1;
                }
            }
            let below = &mut below[..len];
            below.sort_unstable();
            if link.is_leaf {
                for &(_, place) in below.iter() {
                    let found = self.nearest_on(place, point);
                    if (found.distance_sq, found.face) < (best.distance_sq, best.face) {
                        best = found;
                    }
                }
            } else {
                open.extend(below.iter().rev()); // the nearest is next
            }
        }
        best
    }

    /// The nearest point of one face.
    pub(super) fn nearest_on(&self, place: u32, point: Vec3) -> Nearest {
        let nearest = closest_point_triangle(point, &self.triangles[place as usize]);
        let distance_sq = distance_sq(point, nearest.position);
        Nearest { face: self.shape.faces[place as usize], point: nearest, distance_sq, place }
    }
}

impl Cells {
    /// The square of the distance between a point and a box, raw. Exact.
    fn distance_sq(&self, cells: &CellBox, point: Vec3) -> u128 {
        let [low, high] = self.corners(cells);
        let point = point.raw();
        let nearest = [0, 1, 2].map(|k| point[k].clamp(low[k], high[k]));
        distance_sq(Vec3::from_raw(point), Vec3::from_raw(nearest))
    }
}

/// The square of the distance between a point and one that is less than a cell of 2^34 beyond 2^60:
/// below 3 * (9/8 * 2^63 + 2^34)^2, which is below 2^128.
fn distance_sq(point: Vec3, place: Vec3) -> u128 {
    let along = |(p, q): (i64, i64)| u128::from(p.abs_diff(q)).pow(2);
    point.raw().into_iter().zip(place.raw()).map(along).sum()
}
