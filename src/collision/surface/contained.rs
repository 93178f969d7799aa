//! Surfaces that are inside of others as a whole.

use alloc::vec::Vec;

use super::contains::{is_inside, is_within};
use super::exit::Exit;
use super::proximity::scaled;
use super::shell::{Shell, is_free};
use super::tangle::beyond;
use crate::collision::{Contact, FeatureId};
use crate::geometry::{Aabb, Surface};
use crate::math::wide::add;
use crate::math::{Real, UnitVec3, Vec3};

/// The normal and the contacts of each shell of two surfaces that is inside the other surface as a
/// whole; a shell is what hangs together. `rims` are the faces of both that intersect others.
///
/// O(log n) for each shell of n faces if the other surface is closed and one-sided and the boxes
/// around both meet; O(n log n) for each whose first face is inside or only touches, and for each
/// that is inside as much again for each place tried.
pub(super) fn contained<A: Surface, B: Surface>(
    a: &A,
    b: &B,
    rims: &[Vec<u32>; 2],
) -> Vec<(UnitVec3, Vec<Contact>)> {
    let mut parts = within(b, a, &rims[0]);
    for (normal, contacts) in &mut parts {
        *normal = -*normal;
        for Contact { features, on_a, on_b, .. } in contacts {
            features.swap(0, 1);
            core::mem::swap(on_a, on_b);
        }
    }
    parts.extend(within(a, b, &rims[1]));
    parts
}

/// The same of the second only.
fn within<A: Surface, B: Surface>(
    outer: &A,
    inner: &B,
    rim: &[u32],
) -> Vec<(UnitVec3, Vec<Contact>)> {
    let is_solid = outer.is_closed() && !outer.is_two_sided();
    let shells = inner.shells();
    let all_intersect = shells.len() == 1 && !rim.is_empty();
    if !is_solid || all_intersect || !outer.bounds().overlaps(&inner.bounds()) {
        return Vec::new();
    }
    shells.iter().filter_map(|&face| part(outer, inner, face, rim)).collect()
}

/// The same of the shell that holds a face.
fn part<A: Surface, B: Surface>(
    outer: &A,
    inner: &B,
    face: u32,
    rim: &[u32],
) -> Option<(UnitVec3, Vec<Contact>)> {
    let is_outside = |point: Vec3| !is_within(outer, point);
    let corners = inner.corners(face).map(|vertex| inner.position(vertex));
    if corners.into_iter().any(is_outside) {
        return None;
    }
    // What only touches may be partly outside, or as a whole, with all vertices on the surface.
    let shell = Shell::of(inner, &[face]);
    if shell.faces.iter().any(|face| rim.binary_search(face).is_ok()) {
        return None;
    }
    let mut points = shell.vertices.iter().map(|&(_, point)| point);
    if points.clone().any(is_outside) || !points.any(|point| is_inside(outer, point)) {
        return None;
    }
    let exit = exit(outer, inner, &shell, corners[0])?;
    let deepest = deepest(&exit, &shell);
    let contacts = shell.vertices.iter().filter_map(|&(vertex, point)| {
        let separation = -exit.depth(point);
        let on_a = point - Vec3::from_raw(scaled(exit.outward, separation));
        let features = [exit.feature, FeatureId::vertex(vertex)];
        // Shallow ones would only let it tip.
        let is_deep = -separation.raw() >= deepest.raw() / 2;
        is_deep.then_some(Contact { features, on_a, on_b: point, separation })
    });
    Some((exit.outward, contacts.collect()))
}

/// The shortest way through a place that is near the middle of what is inside, or where it starts
/// if the middle is outside; of those that leave it free.
fn exit<A: Surface, B: Surface>(outer: &A, inner: &B, shell: &Shell, start: Vec3) -> Option<Exit> {
    let body = Aabb::around(shell.vertices.iter().map(|&(_, point)| point))?;
    let [low, high] = [body.min().raw(), body.max().raw()];
    // Coordinates are below 2^61.
    let middle = Vec3::from_raw([0, 1, 2].map(|k| low[k] + (high[k] - low[k]) / 2));
    let middle = if is_within(outer, middle) { middle } else { start };
    let depth = |exit: &Exit| deepest(exit, shell);
    Exit::of_inside(outer, middle, &body, depth, |exit| {
        let out = beyond(exit.outward, depth(exit));
        is_free((inner, &shell.faces), out, outer)
            && !is_within(outer, Vec3::from_raw(add(start.raw(), out)))
    })
}

/// How deep the deepest vertex is behind a plane; a shell has some.
fn deepest(exit: &Exit, shell: &Shell) -> Real {
    let depths = shell.vertices.iter().map(|&(_, point)| exit.depth(point));
    depths.max().unwrap_or(Real::ZERO)
}
