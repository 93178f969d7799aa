//! Hulls with fewer vertices around hulls.

use alloc::vec;
use alloc::vec::Vec;

use super::Fit;
use super::cuboid::fit_cuboid;
use super::frame::Frame;
use super::outward::outward;
use crate::geometry::{ConvexHull, Cuboid, HullEdge, ShapeError};
use crate::math::{Real, Vec3};

/// Hulls of more vertices lose them by a faster measure first: how far out of its own faces a point
/// is, not of those of the hull that is fitted.
const LARGE: usize = 512;

/// One vertex of so many that are too many goes in a round: with more the last ones to go are not
/// the best, with fewer there are more rounds.
const ROUND_SHARE: usize = 12;

/// A hull around a hull, with at most `vertices_max` vertices: 4 or more.
///
/// Edge after edge gives way to a point outside, each time where that is least far out (Sander et
/// al., *Silhouette Clipping*, 2000: "progressive hulls"). Where no edge can, as with boxes, the
/// [box](super::fit_cuboid) is taken, or of less than 8 vertices a tetrahedron around it, which is
/// far too large.
///
/// A hull of few enough vertices is its own fit. O(v^2) for v vertices at worst, usually far less.
///
/// # Errors
/// [`ShapeError`] if there must be fewer than 4 vertices, or it leaves the range of the world.
pub fn fit_hull(hull: &ConvexHull, vertices_max: u32) -> Result<Fit<ConvexHull>, ShapeError> {
    if vertices_max < 4 {
        return Err(ShapeError::WrongCount("vertices"));
    }
    let vertices_max = vertices_max as usize;
    let mut shape = hull.clone();
    if shape.vertices().len() > vertices_max {
        // Where the hull was rounded when it moved, the planes of its faces are not exact.
        shape = ConvexHull::around(hull.vertices().iter().copied())?;
    }
    while shape.vertices().len() > vertices_max {
        shape = match with_fewer(&shape, hull, vertices_max) {
            Some(fewer) => fewer,
            None => around_box(hull, vertices_max)?,
        };
    }
    let separations = shape.vertices().iter().map(|&vertex| hull.separation(vertex));
    let deviation = separations.fold(Real::ZERO, Real::max);
    Ok(Fit { shape, deviation })
}

/// A point in the place of an edge.
struct Collapse {
    /// How far out it is.
    cost: Real,
    ends: [u32; 2],
    to: Vec3,
}

/// The hull with some edges replaced by points outside, at least one; `None` if none can be.
///
/// With a point in front of all faces at the ends of an edge, or in their planes, the ends are
/// inside: from the point through an end on, the way enters the hull. This holds of all edges that
/// are replaced at once.
fn with_fewer(shape: &ConvexHull, hull: &ConvexHull, vertices_max: usize) -> Option<ConvexHull> {
    let mut collapses = collapses(shape, hull);
    collapses.sort_unstable_by_key(|collapse| (collapse.cost, collapse.ends));
    // Many at once, so that there are few rounds; fewer, the closer the end.
    let excess = shape.vertices().len() - vertices_max;
    let mut left = excess.div_ceil(ROUND_SHARE);
    let mut is_near = vec![false; shape.vertices().len()];
    let mut is_gone = is_near.clone();
    let mut points = Vec::new();
    for Collapse { ends, to, .. } in collapses {
        if left == 0 {
            break;
        }
        let ends = ends.map(|end| end as usize);
        if ends.into_iter().any(|end| is_near[end]) {
            continue;
        }
        for edge in shape.edges().iter().map(|edge| edge.ends.map(|end| end as usize)) {
            if edge.into_iter().any(|end| ends.contains(&end)) {
                is_near[edge[0]] = true;
                is_near[edge[1]] = true;
            }
        }
        is_gone[ends[0]] = true;
        is_gone[ends[1]] = true;
        points.push(to);
        left -= 1;
    }
    if points.is_empty() {
        return None;
    }
    let kept = shape.vertices().iter().zip(&is_gone).filter(|(_, is_gone)| !**is_gone);
    points.extend(kept.map(|(&vertex, _)| vertex));
    ConvexHull::around(points).ok()
}

/// For every edge that can be replaced: by what.
fn collapses(shape: &ConvexHull, hull: &ConvexHull) -> Vec<Collapse> {
    let frame = Frame::of(shape);
    let faces = faces_at_vertices(shape);
    let is_large = shape.vertices().len() > LARGE;
    let collapse = |edge: &HullEdge| {
        let mut around: Vec<u32> =
            edge.ends.iter().flat_map(|&end| &faces[end as usize]).copied().collect();
        around.sort_unstable();
        around.dedup();
        let to = outward(shape, &frame, &around)?;
        let cost = if is_large {
            around.iter().map(|&face| shape.height(face as usize, to)).max().map(Real::from_raw)?
        } else {
            hull.separation(to)
        };
        Some(Collapse { cost, ends: edge.ends, to })
    };
    shape.edges().iter().filter_map(collapse).collect()
}

/// The faces at every vertex.
fn faces_at_vertices(shape: &ConvexHull) -> Vec<Vec<u32>> {
    let mut faces = vec![Vec::new(); shape.vertices().len()];
    for (face, corners) in (0..).zip(shape.faces()) {
        for &corner in corners {
            faces[corner as usize].push(face);
        }
    }
    faces
}

/// A box around a hull, or a tetrahedron around that.
fn around_box(hull: &ConvexHull, vertices_max: usize) -> Result<ConvexHull, ShapeError> {
    let cuboid = fit_cuboid(hull)?.shape;
    let corners = cuboid.corners();
    if vertices_max < corners.len() {
        ConvexHull::around(tetrahedron(&cuboid))
    } else {
        ConvexHull::around(corners)
    }
}

/// A tetrahedron with every second corner of a box in the middle of a face.
fn tetrahedron(cuboid: &Cuboid) -> [Vec3; 4] {
    // With edges from -1 to 1 the planes are where +-x +-y +-z is 3, of an even number of minus.
    [[1, 1, -1], [1, -1, 1], [-1, 1, 1], [-1, -1, -1]].map(|signs| {
        let ways = cuboid.half_edges().into_iter().zip(signs);
        ways.fold(cuboid.center(), |at, (half, sign)| at + half * Real::from_int(3 * sign))
    })
}
