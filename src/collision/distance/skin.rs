//! Surfaces of triangles, whichever they are.

use alloc::vec::Vec;
use core::ops::ControlFlow;

use super::{Closest, Core, of_convex, of_half_space};
use crate::collision::MeshShape;
use crate::geometry::{Aabb, HalfSpace, HeightField, Surface, Triangle};
use crate::math::{Real, Vec3};

/// A surface: its faces, and nothing behind them.
#[derive(Clone, Copy)]
pub(in crate::collision) enum Skin<'a> {
    Mesh(&'a MeshShape),
    Field(&'a HeightField),
}

impl Skin<'_> {
    pub(in crate::collision) fn bounds(&self) -> Aabb {
        match self {
            Self::Mesh(mesh) => mesh.bounds(),
            Self::Field(field) => field.bounds(),
        }
    }

    pub(in crate::collision) fn faces_near(&self, bounds: &Aabb, faces: &mut Vec<u32>) {
        match self {
            Self::Mesh(mesh) => mesh.faces_near(bounds, faces),
            Self::Field(field) => field.faces_near(bounds, faces),
        }
    }

    pub(in crate::collision) fn triangle(&self, face: u32) -> Triangle {
        match self {
            Self::Mesh(mesh) => mesh.triangle(face),
            Self::Field(field) => field.triangle(face),
        }
    }

    pub(in crate::collision) fn faces(&self) -> Vec<u32> {
        let mut faces = Vec::new();
        self.faces_near(&self.bounds(), &mut faces);
        faces
    }
}

/// The nearest so far; a break where something overlaps.
type Search = ControlFlow<(), Option<Closest>>;

/// Compares two, the second of which has a higher number.
fn nearer(best: Option<Closest>, next: Closest) -> Closest {
    best.filter(|best| best.distance <= next.distance).unwrap_or(next)
}

/// The nearest points of a surface, A, and a convex shape, B; `None` where they overlap.
pub(super) fn to_convex(a: Skin, b: &Core) -> Option<Closest> {
    search(a, b, None).continue_value()?
}

/// The nearest points of two surfaces.
pub(super) fn to_skin(a: Skin, b: Skin) -> Option<Closest> {
    let mut best: Option<Closest> = None;
    for face in a.faces() {
        let triangle = a.triangle(face);
        // Nothing nearer lies farther than the box of B.
        let gap = gap(&triangle.bounds(), &b.bounds());
        if best.is_some_and(|best| gap > best.distance) {
            continue;
        }
        let known = best.map(Closest::flipped);
        let found = search(b, &triangle.into(), known).continue_value()??.flipped();
        let is_new = best.is_none_or(|best| found.distance < best.distance);
        if is_new {
            best = Some(Closest { part_a: face, ..found });
        }
    }
    best
}

/// The nearest points of a half-space, A, and a surface.
pub(super) fn to_half_space(a: &HalfSpace, b: Skin) -> Option<Closest> {
    let mut best = None;
    for face in b.faces() {
        let found = of_half_space(a, &b.triangle(face).into())?;
        best = Some(nearer(best, Closest { part_b: face, ..found }));
    }
    best
}

/// The faces within a reach, which grows until it is as far as the nearest of them; or those that
/// are nearer than what is known.
fn search(a: Skin, b: &Core, mut best: Option<Closest>) -> Search {
    let (around_a, around_b) = (a.bounds(), b.bounds());
    let gap = gap(&around_a, &around_b).raw();
    // Faces are many, so the first reach is a small part of all; at most 2^41 here.
    let mut more = (around_a.span().cast_signed() >> 6) + 1;
    let mut faces = Vec::new();
    loop {
        // A distance is rounded, by less than two units.
        let known = best.map(|best| best.distance.raw() + 2);
        let reach = known.unwrap_or(i64::MAX).min(gap.saturating_add(more));
        a.faces_near(&grown(&around_b, Real::from_raw(reach)), &mut faces);
        for &face in &faces {
            let Some(found) = of_convex(&a.triangle(face).into(), b, Vec3::ZERO) else {
                return ControlFlow::Break(());
            };
            best = Some(nearer(best, Closest { part_a: face, ..found }));
        }
        let is_known = best.is_some_and(|best| best.distance.raw() + 2 <= reach);
        if is_known || known == Some(reach) {
            return ControlFlow::Continue(best);
        }
        more = more.saturating_mul(2);
    }
}

/// How far two boxes are from each other along the axis where it is most: what is in them is not
/// nearer.
fn gap(a: &Aabb, b: &Aabb) -> Real {
    let [low_a, high_a, low_b, high_b] = [a.min(), a.max(), b.min(), b.max()].map(Vec3::raw);
    let along = |k: usize| (low_b[k] - high_a[k]).max(low_a[k] - high_b[k]);
    Real::from_raw(along(0).max(along(1)).max(along(2)).max(0))
}

/// A box that is larger by as much on every side, as far as there are numbers.
pub(in crate::collision) fn grown(bounds: &Aabb, by: Real) -> Aabb {
    let by = by.raw();
    let low = bounds.min().raw().map(|c| c.saturating_sub(by));
    let high = bounds.max().raw().map(|c| c.saturating_add(by));
    Aabb::new(Vec3::from_raw(low), Vec3::from_raw(high))
}
