//! Surfaces that are inside of others as a whole.

use alloc::vec::Vec;

use super::DEPTH_MAX;
use super::contains::is_within;
use super::feet::Foot;
use super::proximity::{along, scaled};
use super::shell::{Shell, is_free};
use super::tangle::beyond;
use crate::collision::{Contact, FeatureId};
use crate::geometry::{Aabb, Surface};
use crate::math::wide::{add, sub};
use crate::math::{UnitVec3, Vec3};

/// The normal and the contacts of two surfaces of which one is inside the other as a whole: what
/// hangs together with its first face is. They must not intersect.
///
/// O(1) unless the box around one is inside that around the other: O(n) for n faces then, and if
/// one is inside, O(n log n).
pub(super) fn contained<A: Surface, B: Surface>(a: &A, b: &B) -> Option<(UnitVec3, Vec<Contact>)> {
    if let Some(found) = within(a, b) {
        return Some(found);
    }
    let (normal, mut contacts) = within(b, a)?;
    for Contact { features, on_a, on_b, .. } in &mut contacts {
        features.swap(0, 1);
        core::mem::swap(on_a, on_b);
    }
    Some((-normal, contacts))
}

/// Where the outer surface is left, and how far.
struct Exit {
    /// Outward.
    normal: UnitVec3,
    /// A feature of the outer surface, and a point before which all of it is, as far as is known.
    feature: FeatureId,
    point: Vec3,
}

/// The same if it is the second that is inside.
fn within<A: Surface, B: Surface>(outer: &A, inner: &B) -> Option<(UnitVec3, Vec<Contact>)> {
    let is_solid = outer.is_closed() && !outer.is_two_sided();
    if !is_solid || !outer.bounds().contains(&inner.bounds()) {
        return None;
    }
    let mut faces = Vec::new();
    inner.faces_near(&inner.bounds(), &mut faces);
    let first = faces.into_iter().min()?;
    let start = inner.position(inner.corners(first)[0]);
    if !is_within(outer, start) {
        return None;
    }
    let shell = Shell::of(inner, &[first]);
    let exit = exit(outer, inner, &shell, start)?;
    let height = |point: Vec3| along(exit.normal, sub(point.raw(), exit.point.raw()));
    let deepest = shell.vertices.iter().map(|&(_, point)| height(point)).min()?;
    let contacts = shell.vertices.iter().filter_map(|&(vertex, point)| {
        let separation = height(point);
        let on_a = point - Vec3::from_raw(scaled(exit.normal, separation));
        let features = [exit.feature, FeatureId::vertex(vertex)];
        // Shallow ones would only let it tip.
        let is_deep = separation.raw() <= deepest.raw() / 2;
        is_deep.then_some(Contact { features, on_a, on_b: point, separation })
    });
    Some((exit.normal, contacts.collect()))
}

/// The way through the place that is nearest to the middle of what is inside, or to where it
/// starts if the middle is outside. If that leads into something else, the shortest way out of the
/// box around the outer surface.
fn exit<A: Surface, B: Surface>(outer: &A, inner: &B, shell: &Shell, start: Vec3) -> Option<Exit> {
    let inside = Aabb::around(shell.vertices.iter().map(|&(_, point)| point))?;
    let [low, high] = [inside.min().raw(), inside.max().raw()];
    // Coordinates are below 2^61.
    let middle = Vec3::from_raw([0, 1, 2].map(|k| low[k] + (high[k] - low[k]) / 2));
    let middle = if is_within(outer, middle) { middle } else { start };
    let foot = Foot::of_inside(outer, middle, DEPTH_MAX)?;
    let exit = Exit { normal: -foot.normal, feature: foot.feature, point: foot.position };
    let height = |&(_, point): &(u32, Vec3)| along(exit.normal, sub(point.raw(), exit.point.raw()));
    let out = beyond(exit.normal, -shell.vertices.iter().map(height).min()?);
    if is_free((inner, &shell.faces), out, outer)
        && !is_within(outer, Vec3::from_raw(add(start.raw(), out)))
    {
        return Some(exit);
    }
    let bounds = outer.bounds();
    let axes = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z];
    let ways = (0..3).flat_map(|k| {
        let depths = [bounds.max().raw()[k] - low[k], high[k] - bounds.min().raw()[k]];
        [(depths[0], axes[k], bounds.max()), (depths[1], -axes[k], bounds.min())]
    });
    let (_, normal, point) = ways.min_by_key(|&(depth, ..)| depth)?;
    Some(Exit { normal, point, ..exit })
}
