//! Any two convex shapes.

use super::half_space::manifold_half_space;
use super::manifold_cuboid_cuboid;
use super::pair::Pair;
use super::separate::{Owner, Verdict, separate};
use super::solid::Solid;
use crate::collision::patch::{
    Contacts, NEAR_SQ, Seam, TIE, between, clip, keep_deepest, patch, reduce,
};
use crate::collision::width::{Narrow, Wide, Width};
use crate::collision::{Contact, FeatureId, Manifold, Shape};
use crate::geometry::{ClosestConvex, closest_convex};
use crate::math::determinant::cross;
use crate::math::wide::{add, dot_wide, sub};
use crate::math::{Real, UnitVec3, Vec3};

/// Where two convex shapes touch, or are at most `margin` apart; `None` where they are farther, and
/// of shapes that are not convex, or of two half-spaces.
///
/// Where they are apart and one is round, or both are triangles, the normal is the direction
/// between their nearest points; otherwise that of the axis along which they overlap least, of the
/// faces and of all pairs of edges, faces first where it is nearly a tie. O(faces * vertices +
/// edges^2) for hulls, less for most pairs.
///
/// The margin counts as in [`collide`](crate::collision::collide). What overlaps has a manifold,
/// unless axes have to tell it and it does by no more than these are wrong: a unit of the last
/// place and 2^-29 of what both shapes span.
#[must_use]
pub fn manifold_convex_convex(a: &Shape, b: &Shape, margin: Real) -> Option<Manifold> {
    match (a, b) {
        (Shape::Cuboid(a), Shape::Cuboid(b)) => manifold_cuboid_cuboid(a, b, margin),
        (Shape::HalfSpace(a), _) => manifold_half_space(a, b, margin),
        (_, Shape::HalfSpace(b)) => Some(manifold_half_space(b, a, margin)?.flipped()),
        _ => {
            let pair = Pair::new(&a.bounds()?, &b.bounds()?, margin)?;
            let (a, b) = (Solid::new(a, pair.origin)?, Solid::new(b, pair.origin)?);
            if pair.is_narrow {
                manifold::<Narrow>(&a, &b, &pair)
            } else {
                manifold::<Wide>(&a, &b, &pair)
            }
        }
    }
}

/// What the separation of rounded points is wrong by at most, raw.
const ROUNDED: i64 = 4;

/// How far apart [`closest_convex`] tells exactly, raw.
const REACH_MAX: i64 = 1 << 40;

fn manifold<W: Width>(a: &Solid, b: &Solid, pair: &Pair) -> Option<Manifold> {
    let radii = [a.radius, b.radius];
    let seam = |normal| Seam { radii, ..pair.seam(normal) };
    let closest = || closest_convex(&a.corners, &b.corners, Vec3::ZERO, Real::ZERO);
    // Axes of faces and edges do not tell all that is apart if one has none, or both are flat.
    let has_faces = !a.normals.is_empty() && !b.normals.is_empty();
    if (!has_faces || a.is_flat() && b.is_flat())
        && let Some(nearest) = closest()
    {
        return along_nearest::<W>(&seam(nearest.normal), [a, b], &nearest);
    }
    // Below 2^38 + 2^40.
    let Verdict::Best(axis) = separate::<W>(a, b, pair.margin + radii[0] + radii[1]) else {
        return None;
    };
    let normal = axis.map_or_else(|| any_axis(a, b), |axis| axis.normal);
    match axis.map(|axis| axis.owner) {
        Some(Owner::FaceOfB(face)) => {
            let outlines = [b.outline(Some(face), -normal), a.outline_at::<W>(normal)];
            let closest = || closest_convex(&b.corners, &a.corners, Vec3::ZERO, Real::ZERO);
            Some(patch::<W>(&seam(normal).flipped(), outlines.each_ref(), closest)?.flipped())
        }
        owner => {
            let outlines = match owner {
                Some(Owner::Edges([of_a, of_b])) => {
                    [a.outline(of_a, normal), b.outline(of_b, -normal)]
                }
                Some(Owner::FaceOfA(face)) => {
                    [a.outline(Some(face), normal), b.outline_at::<W>(-normal)]
                }
                _ => [a.outline_at::<W>(normal), b.outline_at::<W>(-normal)],
            };
            patch::<W>(&seam(normal), outlines.each_ref(), closest)
        }
    }
}

/// The manifold of shapes whose cores are apart, one of them round.
fn along_nearest<W: Width>(
    seam: &Seam,
    [a, b]: [&Solid; 2],
    nearest: &ClosestConvex,
) -> Option<Manifold> {
    let outlines = [a.outline_at::<W>(seam.normal), b.outline_at::<W>(-seam.normal)];
    let names = [a.name(nearest.on_a, &outlines[0]), b.name(nearest.on_b, &outlines[1])];
    let mut deepest = seam.nearest::<W>(names, nearest);
    let beyond = deepest.separation.raw() - seam.margin;
    if beyond > 0 {
        // The nearest points are rounded: who is as near as the margin is told exactly.
        let reach = Real::from_raw((seam.radii[0] + seam.radii[1] + seam.margin).min(REACH_MAX));
        let is_near = || closest_convex(&a.corners, &b.corners, Vec3::ZERO, reach).is_none();
        if beyond > ROUNDED || !is_near() {
            return None;
        }
        deepest.separation = Real::from_raw(seam.margin);
    }
    let mut contacts = match [a.segment(), b.segment()] {
        [Some(a), Some(b)] => side_by_side::<W>(seam, a, b),
        _ if a.corners.len().min(b.corners.len()) == 1 => Contacts::new(),
        _ => clip::<W>(seam, outlines.each_ref()),
    };
    keep_deepest(&mut contacts, deepest);
    reduce(seam.normal, &contacts)
}

/// A direction for cores that meet without being solid: across the segment that is in it, if one
/// is.
fn any_axis(a: &Solid, b: &Solid) -> UnitVec3 {
    let way = |segment: [[i64; 3]; 2]| sub(segment[1], segment[0]);
    let way = a.segment().or(b.segment()).map_or([0; 3], way);
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let shortest = (0..3).min_by_key(|&k| way[k].abs()).unwrap_or(0);
    // At right angles to the segment and to the axis along which it is shortest.
    UnitVec3::normalize_wide(cross(way, axes[shortest])).unwrap_or(UnitVec3::X)
}

/// Where two segments touch that are nearly parallel, with a sine below 1/32: at those ends that
/// are beside the other one. None of others.
///
/// Seen along the normal the segments may cross: an end counts where it is so little to the side
/// that the round surfaces are no farther apart there than along the normal, but for a tie.
fn side_by_side<W: Width>(seam: &Seam, a: [[i64; 3]; 2], b: [[i64; 3]; 2]) -> Contacts {
    let mut contacts = Contacts::new();
    let [u, v] = [a, b].map(|[from, to]| UnitVec3::normalize(Vec3::from_raw(sub(to, from))));
    let is_parallel = u.zip(v).is_some_and(|(u, v)| {
        // The sine, times 2^60.
        let sine = cross(u.raw(), v.raw()).map(|c| (c >> 30) as i64);
        dot_wide(sine, sine) < 1 << 50
    });
    if !is_parallel {
        return contacts;
    }
    // With radii of r together, s to the side parts surfaces by s^2 / 2 r: at most a tie.
    let aside_max = i128::from(2 * TIE) * i128::from(seam.radii[0] + seam.radii[1]);
    let mut keep = |features: [FeatureId; 2], on: [[i64; 3]; 2], is_end_of_b: bool| {
        let way = sub(on[1], on[0]);
        let separation = W::round(W::along(seam.normal, way));
        // Below 2^86.
        let aside_sq = dot_wide(way, way) - i128::from(separation).pow(2);
        if aside_sq > aside_max || separation - seam.radii[0] - seam.radii[1] > seam.margin {
            return;
        }
        let contact = if is_end_of_b {
            seam.above::<W>(features, on[1], separation)
        } else {
            let above = add(on[0], W::scale(seam.normal.raw(), separation));
            seam.contact::<W>(features, [on[0], above], separation)
        };
        let is_far = |other: &Contact| {
            let way = sub(other.on_a.raw(), contact.on_a.raw());
            dot_wide(way, way) >= NEAR_SQ + aside_max
        };
        // Ends that are side by side touch once.
        if contacts.iter().all(is_far) {
            contacts.push(contact);
        }
    };
    let edge = FeatureId::edge(0);
    for (end, at) in (0..).zip(b) {
        if let Some(foot) = foot::<W>(a, at) {
            keep([edge, FeatureId::vertex(end)], [foot, at], true);
        }
    }
    for (end, at) in (0..).zip(a) {
        if let Some(foot) = foot::<W>(b, at) {
            keep([FeatureId::vertex(end), edge], [at, foot], false);
        }
    }
    contacts
}

/// The point of a segment beside another point.
fn foot<W: Width>(ends: [[i64; 3]; 2], point: [i64; 3]) -> Option<[i64; 3]> {
    let way = sub(ends[1], ends[0]);
    // Below 2^86.
    let (along, whole) = (dot_wide(way, sub(point, ends[0])), dot_wide(way, way));
    let is_beside = 0 <= along && along <= whole && whole > 0;
    is_beside.then(|| between::<W>(ends, [-along, whole - along]))
}
