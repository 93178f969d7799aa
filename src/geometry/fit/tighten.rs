//! Hulls around hulls drawn in.

use alloc::vec::Vec;

use super::frame::Frame;
use super::outward::{Plane, area, outward};
use crate::geometry::{ConvexHull, orient3d};
use crate::math::{Real, Vec3};

/// Every vertex is tried so often, unless none moves any more.
const PASSES_MAX: usize = 4;

/// The hull `outer` around `inner` with vertices nearer to `inner`, as long as it stays around it.
///
/// One vertex after the other: from each side of the loop of its neighbours a plane rises until it
/// touches the inner hull, and where these planes leave the least room the vertex goes.
pub(super) fn tightened(mut outer: ConvexHull, inner: &ConvexHull) -> ConvexHull {
    for _ in 0..PASSES_MAX {
        let mut has_moved = false;
        for vertex in 0..outer.topology().vertices_len() {
            if let Some(tighter) = with_nearer(&outer, inner, vertex) {
                outer = tighter;
                has_moved = true;
            }
        }
        if !has_moved {
            break;
        }
    }
    outer
}

/// The outer hull with one vertex nearer to the inner one; `None` if that does not work.
fn with_nearer(outer: &ConvexHull, inner: &ConvexHull, vertex: u32) -> Option<ConvexHull> {
    let from = *outer.vertices().get(vertex as usize)?;
    let frame = Frame::of(outer);
    let sides = sides_around(outer, vertex).into_iter();
    let planes = sides.filter_map(|side| touching(inner, side, from, &frame));
    let to = outward(&planes.collect::<Vec<_>>(), &frame, outer.bounds())?;
    if distance(inner, to) >= distance(inner, from) {
        return None;
    }
    let mut vertices = outer.vertices().to_vec();
    vertices[vertex as usize] = to;
    let tighter = ConvexHull::around(vertices).ok()?;
    inner.vertices().iter().all(|&point| tighter.contains(point)).then_some(tighter)
}

fn distance(hull: &ConvexHull, point: Vec3) -> Real {
    hull.separation(point).max(Real::ZERO)
}

/// Of every face at a vertex the corners before and behind it.
fn sides_around(hull: &ConvexHull, vertex: u32) -> Vec<[Vec3; 2]> {
    let side = |corners: &[u32]| {
        let place = corners.iter().position(|&corner| corner == vertex)?;
        let beside = [place + corners.len() - 1, place + 1].map(|k| corners[k % corners.len()]);
        Some(beside.map(|corner| hull.vertices()[corner as usize]))
    };
    hull.faces().filter_map(side).collect()
}

/// The plane through a side that touches a hull behind it; `None` if all of the hull is on the
/// line of the side.
fn touching(
    hull: &ConvexHull,
    [before, behind]: [Vec3; 2],
    tip: Vec3,
    frame: &Frame,
) -> Option<Plane> {
    let through = |point: Vec3| {
        Plane::through(frame, [before, point, behind], area(frame, [before, tip, behind]))
    };
    let mut points = hull.vertices().iter().copied();
    // The first that is off the line; then whatever is in front of the plane so far.
    let mut highest = points.find(|&point| through(point).is_some())?;
    for point in points {
        if orient3d(before, highest, behind, point).is_gt() {
            highest = point;
        }
    }
    through(highest)
}
