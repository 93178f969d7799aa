//! What a surface must stay near to: the planes of its faces, and of its boundary.

use alloc::vec;
use alloc::vec::Vec;

use super::lattice::Lattice;
use super::quadric::{Quadric, WEIGHT_BITS};
use super::sides;
use super::surface::{Surface, normal};
use crate::math::determinant::cross;
use crate::math::root::isqrt_wide;
use crate::math::wide::{sub, to_i64};
use crate::math::{UnitVec3, Vec3};

/// A plane through three corners, or through two and upright on a face.
struct Plane {
    normal: UnitVec3,
    /// The vertices that it goes through, the last one twice if there are two.
    corners: [u32; 3],
    /// What its weight is proportional to: twice an area, in cells.
    size: u128,
}

/// The quadric of every vertex: of the planes of its faces, weighted by their area, and of its
/// edges at the boundary, weighted by the square of their length.
///
/// The square of an edge is as much as 2.3 times the area of the face that leans on it if that is
/// equilateral; what is lost from a boundary is seen from afar.
pub(super) fn quadrics(surface: &Surface, lattice: &Lattice, vertices: usize) -> Vec<Quadric> {
    let planes = planes(surface, lattice);
    // At most 2^25 of 2^58.
    let total = planes.iter().map(|plane| plane.size).sum::<u128>().max(1);
    let mut quadrics = vec![Quadric::default(); vertices];
    for Plane { normal, corners, size } in planes {
        // At most 2^24.
        let weight = to_i64(((size << WEIGHT_BITS) / total).cast_signed()).max(1);
        let point = lattice.cell(surface.position(corners[0]));
        let quadric = Quadric::of_plane(normal, point, weight);
        let mut last = None;
        for corner in corners {
            if last.replace(corner) != Some(corner) {
                quadrics[corner as usize] += &quadric;
            }
        }
    }
    quadrics
}

fn planes(surface: &Surface, lattice: &Lattice) -> Vec<Plane> {
    let mut planes = Vec::new();
    // The edges of all faces, sorted, with their normals: what is there once is a boundary.
    let mut edges = Vec::new();
    for corners in surface.faces() {
        let Some(normal) = normal(corners.map(|corner| surface.position(corner))) else { continue };
        let [a, b, c] = corners.map(|corner| lattice.cell(surface.position(corner)));
        // Minors are below 2^57.
        let area = cross(sub(b, a), sub(c, a)).map(|minor| minor.unsigned_abs().pow(2));
        planes.push(Plane { normal, corners, size: isqrt_wide(area.into_iter().sum()) });
        edges.extend(sides(corners).map(|ends| (ends, normal)));
    }
    edges.sort_unstable();
    for same in edges.chunk_by(|(a, _), (b, _)| a == b) {
        let &[([from, to], normal)] = same else { continue };
        let edge = sub(surface.position(to).raw(), surface.position(from).raw());
        // 2^41 and 2^30.
        let Some(normal) = UnitVec3::normalize_wide(cross(edge, normal.raw())) else { continue };
        let [a, b] = [from, to].map(|end| lattice.cell(surface.position(end)));
        let size = Vec3::from_raw(sub(b, a)).length_sq_wide();
        planes.push(Plane { normal, corners: [from, to, to], size });
    }
    planes
}
