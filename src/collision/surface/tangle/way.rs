//! The way out of an overlap.

use alloc::vec::Vec;
use core::cmp::Reverse;

use super::component::Component;
use super::view::View;
use super::wholes::Wholes;
use crate::collision::surface::DEPTH_MAX;
use crate::collision::surface::contains::is_in_solid;
use crate::collision::surface::feet::normal_of;
use crate::collision::surface::manifolds::grown;
use crate::collision::surface::proximity::scaled;
use crate::collision::surface::shell::is_free;
use crate::geometry::Surface;
use crate::math::wide::{add, dot_wide, round_shift_wide, sub, to_i64};
use crate::math::{Real, UnitVec3, Vec3};

/// The direction in which to move B, and how far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    pub(super) normal: UnitVec3,
    pub(super) depth: Real,
    /// How far along the normal A reaches, and from where on B does, as [`reach`] measures. `None`
    /// if that is told by what is outside of the component.
    pub(super) levels: Option<[i128; 2]>,
}

/// Of so many faces of either surface that the contour goes through, the normals are tried.
const NORMALS_MAX: usize = 8;

/// How much farther things are moved to see whether they come apart: 0.1 mm.
const SLACK: i64 = (1 << 24) / 10_000;

/// How far a point is along a direction, from another one: raw, times 2^30.
pub(super) fn reach(normal: UnitVec3, point: Vec3, origin: Vec3) -> i128 {
    dot_wide(normal.raw(), sub(point.raw(), origin.raw()))
}

/// A reach as a length.
pub(super) fn length(reach: i128) -> Real {
    Real::from_raw(to_i64(round_shift_wide(reach, 30)))
}

/// Moving A by a way and B by its opposite part, or the other way round.
pub(in crate::collision::surface) fn beyond(normal: UnitVec3, depth: Real) -> [i64; 3] {
    scaled(normal, depth + Real::from_raw(SLACK))
}

/// The same for a direction and its opposite.
fn rank(normal: UnitVec3) -> UnitVec3 {
    normal.max(-normal)
}

/// Of all ways that are known to free either surface from the component, the shortest: along the
/// area of the contour, or along the normal of a face that the contour goes through. Of equal ones
/// the nearest to the area.
///
/// Where no more than [`DEPTH_MAX`] along the area is needed, no other is looked for: as a rule
/// something rests there, on a floor or in a corner.
///
/// If none frees any, it is the shortest that parts all that hangs together with the component:
/// along the area, such a normal, or an axis. That may be farther than needed: if it is more than
/// twice as far as the component reaches along the area, it is along the area, which frees a part
/// at least, unless it would sink it, or the component [hides](Component::hides) what is inside.
pub(super) fn way_out<A: Surface, B: Surface>(
    (a, b): (&View<A>, &View<B>),
    component: &Component,
    wholes: (&mut Wholes<A>, &mut Wholes<B>),
) -> Way {
    let area = component.normal();
    let hides = area.is_some_and(|area| component.hides((a, b), area));
    let along_area = area.filter(|_| !hides).map(|area| component.way(area));
    if let Some(way) = along_area.filter(|way| way.depth <= DEPTH_MAX) {
        return way;
    }
    let bounds = component.bounds();
    let (mut of_a, mut of_b) = (Vec::new(), Vec::new());
    let sinks = |way: &Way| {
        let back = Way { normal: -way.normal, ..*way };
        leads_into(a.surface, b.surface, (component, 1), way)
            || leads_into(b.surface, a.surface, (component, 0), &back)
    };
    // What is farther away than a surface is moved does not belong to this part.
    let mut frees = |way: &Way| {
        let around = grown(&bounds, way.depth);
        let out = beyond(way.normal, way.depth);
        b.faces_near(&around, &mut of_b);
        a.faces_near(&around, &mut of_a);
        (is_free((b, &of_b), out, a) || is_free((a, &of_a), out.map(|c| -c), b)) && !sinks(way)
    };
    let sooner = along_area.map(|way| Way { depth: DEPTH_MAX, levels: None, ..way });
    if let Some(way) = sooner.filter(&mut frees) {
        return way;
    }
    let along = |normal: &UnitVec3| area.map_or(0, |area| dot_wide(area.raw(), normal.raw()));
    let mut normals = Vec::new();
    for (k, faces) in component.rims.iter().enumerate() {
        let mut own: Vec<_> = match k {
            0 => faces.iter().filter_map(|&face| normal_of(a, face)).collect(),
            _ => faces.iter().filter_map(|&face| normal_of(b, face)).map(|n| -n).collect(),
        };
        own.sort_unstable_by_key(|normal| (Reverse(along(normal)), rank(*normal), *normal));
        own.dedup();
        own.truncate(NORMALS_MAX);
        normals.extend(own);
    }
    let aligned = normals.iter().copied().filter(|normal| area.is_none() || along(normal) > 0);
    let aligned = aligned.map(|normal| component.way(normal));
    let mut ways: Vec<_> = along_area.into_iter().chain(aligned).collect();
    ways.sort_by_key(|way| (way.depth, Reverse(along(&way.normal)), rank(way.normal)));
    if let Some(way) = ways.into_iter().find(&mut frees) {
        return shortened(way, frees);
    }
    normals.extend(area);
    let apart = apart(wholes, component, &normals);
    // Below 2^62.
    let is_near = |way: &Way| way.depth.raw() < apart.depth.raw() / 2;
    along_area.filter(|way| is_near(way) && !sinks(way)).unwrap_or(apart)
}

/// Whether a way leads A (0) or B (1) into the other one, where it may meet nothing, if that is
/// closed and one-sided: whether it takes a point of the component inside, or the foremost corner
/// of the faces that the contour goes through, which are often all of it. Between two walls the way
/// out of one may lead as deep into the other.
///
/// A corner that was inside is led out by another part, if there is an edge that tells. What is
/// turned inside out, as a room may be, is solid nowhere.
fn leads_into<S: Surface, T: Surface>(
    solid: &S,
    moved: &T,
    (component, k): (&Component, usize),
    way: &Way,
) -> bool {
    if !solid.is_closed() || solid.is_two_sided() {
        return false;
    }
    let out = beyond(way.normal, way.depth);
    // Points are within 2^60 and move by less than 2^62.
    let is_sunk = |point: Vec3| is_in_solid(solid, Vec3::from_raw(add(point.raw(), out)));
    let sample = component.sample(k);
    let foremost = || {
        let corners = component.rims[k].iter().flat_map(|&face| moved.corners(face));
        let corners = corners.map(|vertex| moved.position(vertex));
        corners.max_by_key(|&corner| (reach(way.normal, corner, sample), corner))
    };
    let is_left = |corner: &Vec3| component.is_cut_in_faces(k) || !is_in_solid(solid, *corner);
    is_sunk(sample) || foremost().filter(is_left).is_some_and(is_sunk)
}

/// A way that frees, cut short where surfaces are hollow, as in a corner, and come apart sooner
/// than as far as they reach: it is too long by a sixteenth, or no longer than [`DEPTH_MAX`].
fn shortened(way: Way, mut frees: impl FnMut(&Way) -> bool) -> Way {
    let shorter = |depth: i64| Way { depth: Real::from_raw(depth), levels: None, ..way };
    let mut least = shorter(way.depth.raw() - way.depth.raw() / 16);
    if !frees(&least) {
        return way;
    }
    let mut short = 0;
    while least.depth > DEPTH_MAX && least.depth.raw() - short > least.depth.raw() / 16 {
        let middle = shorter(short + (least.depth.raw() - short) / 2);
        if frees(&middle) {
            least = middle;
        } else {
            short = middle.depth.raw();
        }
    }
    least
}

/// The shortest way that parts what hangs together with a component, and lessens it at once. O(1)
/// for each direction that cannot be the shortest, as far as the ends of shells tell.
fn apart<A: Surface, B: Surface>(
    (a, b): (&mut Wholes<A>, &mut Wholes<B>),
    component: &Component,
    normals: &[UnitVec3],
) -> Way {
    let shells = [a.of(&component.rims[0]), b.of(&component.rims[1])];
    let origin = component.origin();
    let area = component.normal();
    let is_out = |n: &UnitVec3| area.is_none_or(|area| dot_wide(area.raw(), n.raw()) > 0);
    let rank = |way: &Way| (way.depth, rank(way.normal));
    let way = |normal: UnitVec3, reach: i128| Way { normal, depth: length(reach), levels: None };
    let both = |normal: &UnitVec3| [*normal, -*normal];
    let at_least = |normal: UnitVec3| {
        let of_a = a.reach_at_least(&shells[0], normal, origin);
        way(normal, of_a + b.reach_at_least(&shells[1], -normal, origin))
    };
    let axes = [UnitVec3::X, UnitVec3::Y, UnitVec3::Z];
    let along_axes = axes.iter().flat_map(both).filter(is_out).map(at_least);
    let mut best = along_axes.min_by_key(rank);
    for normal in normals.iter().flat_map(both).filter(is_out) {
        if best.is_some_and(|best| best.depth < at_least(normal).depth) {
            continue;
        }
        let of_a = a.reach(&shells[0], normal, origin);
        let way = way(normal, of_a + b.reach(&shells[1], -normal, origin));
        best = best.filter(|best| rank(best) <= rank(&way)).or(Some(way));
    }
    best.unwrap_or_else(|| component.way(UnitVec3::Y))
}
