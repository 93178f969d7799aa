//! Hulls with fewer vertices around hulls.

use alloc::vec;
use alloc::vec::Vec;

use super::Fit;
use super::cuboid::fit_cuboid;
use super::frame::Frame;
use super::outward::{Plane, outward};
use super::tighten::tightened;
use crate::geometry::{ConvexHull, Cuboid, HullEdge, ShapeError};
use crate::math::{Real, Vec3};

/// Hulls of more vertices lose them by a faster measure first.
const LARGE: usize = 256;

/// A hull around a hull, with at most `vertices_max` vertices: 4 or more.
///
/// Edge after edge gives way to a point outside, each time where that is least far out (Sander et
/// al., *Silhouette Clipping*, 2000: "progressive hulls"); then the vertices that are left are
/// drawn in. Where no edge can give way, as with boxes, or if it is better, the
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
    if hull.vertices().len() <= vertices_max {
        return Ok(Fit { shape: hull.clone(), deviation: Real::ZERO });
    }
    let around_box = around_box(hull, vertices_max).map(|shape| measured(shape, hull));
    // Where the hull was rounded when it moved, the planes of its faces are not exact.
    let exact = ConvexHull::around(hull.vertices().iter().copied())?;
    let Some(shape) = collapsed(&exact, vertices_max) else { return around_box };
    let drawn_in = measured(tightened(shape, &exact), hull);
    Ok(match around_box {
        Ok(around_box) if around_box.deviation < drawn_in.deviation => around_box,
        _ => drawn_in,
    })
}

fn measured(shape: ConvexHull, hull: &ConvexHull) -> Fit<ConvexHull> {
    let separations = shape.vertices().iter().map(|&vertex| hull.separation(vertex));
    let deviation = separations.fold(Real::ZERO, Real::max);
    Fit { shape, deviation }
}

/// The hull with edges replaced until no more vertices are left; `None` if that does not go on.
fn collapsed(hull: &ConvexHull, vertices_max: usize) -> Option<ConvexHull> {
    // At first how far out of its own faces a point is; of what is too much a third goes in a
    // round.
    let coarse = with_few(hull, vertices_max.max(LARGE), 3, |shape, faces, to| {
        let heights = faces.iter().map(|&face| shape.height(face as usize, to));
        Real::from_raw(heights.max().unwrap_or(0))
    })?;
    // Then how far out of all that was there. With more in a round the last ones to go would not be
    // the best, with fewer there would be more rounds.
    with_few(&coarse, vertices_max, 12, |_, _, to| coarse.separation(to))
}

/// The hull with edges replaced, those first of which a round, one of `share` of the vertices that
/// are too many, costs least: `cost(hull, faces, point)` says what it does to put a point before
/// some faces. `None` if it does not go on.
fn with_few(
    hull: &ConvexHull,
    vertices_max: usize,
    share: usize,
    cost: impl Fn(&ConvexHull, &[u32], Vec3) -> Real,
) -> Option<ConvexHull> {
    let mut shape = hull.clone();
    while let excess @ 1.. = shape.vertices().len().saturating_sub(vertices_max) {
        let mut collapses = collapses(&shape, &cost);
        collapses.sort_unstable_by_key(|collapse| (collapse.cost, collapse.ends));
        shape = with_fewer(&shape, &collapses, excess.div_ceil(share))?;
    }
    Some(shape)
}

/// A point in the place of an edge.
struct Collapse {
    /// How far out it is.
    cost: Real,
    ends: [u32; 2],
    to: Vec3,
}

/// The hull with the first of these edges replaced by points outside that are not next to one
/// another; `None` if there are none.
///
/// With a point in front of all faces at the ends of an edge, or in their planes, the ends are
/// inside: from the point through an end on, the way enters the hull. This holds of all edges that
/// are replaced at once.
fn with_fewer(shape: &ConvexHull, collapses: &[Collapse], most: usize) -> Option<ConvexHull> {
    let mut is_near = vec![false; shape.vertices().len()];
    let mut is_gone = is_near.clone();
    let mut points = Vec::new();
    for &Collapse { ends, to, .. } in collapses {
        if points.len() == most {
            break;
        }
        if ends.into_iter().any(|end| is_near[end as usize]) {
            continue;
        }
        for end in ends {
            is_gone[end as usize] = true;
            for &near in shape.topology().neighbours(end) {
                is_near[near as usize] = true;
            }
        }
        points.push(to);
    }
    if points.is_empty() {
        return None;
    }
    let kept = shape.vertices().iter().zip(&is_gone).filter(|(_, is_gone)| !**is_gone);
    points.extend(kept.map(|(&vertex, _)| vertex));
    ConvexHull::around(points).ok()
}

/// For every edge that can be replaced: by what, and at what cost.
fn collapses(
    shape: &ConvexHull,
    cost: &impl Fn(&ConvexHull, &[u32], Vec3) -> Real,
) -> Vec<Collapse> {
    let frame = Frame::of(shape);
    let faces = faces_at_vertices(shape);
    let collapse = |edge: &HullEdge| {
        let at_ends = edge.ends.map(|end| faces[end as usize].as_slice());
        let mut around = at_ends.concat();
        around.sort_unstable();
        around.dedup();
        let planes = around.iter().map(|&face| Plane::of_face(shape, &frame, face));
        let to = outward(&planes.collect::<Option<Vec<_>>>()?, &frame, shape.bounds())?;
        Some(Collapse { cost: cost(shape, &around, to), ends: edge.ends, to })
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
