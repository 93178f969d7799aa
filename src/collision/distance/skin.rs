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

    /// A face that is likely to be near a box.
    fn face_towards(&self, bounds: &Aabb) -> u32 {
        let (own, other) = (self.bounds(), *bounds);
        let [low, high] = [own.min(), own.max()].map(Vec3::raw);
        let (from, to) = (other.min().raw(), other.max().raw());
        let middle = [0, 1, 2].map(|k| from[k].midpoint(to[k]).clamp(low[k], high[k]));
        match self {
            Self::Mesh(mesh) => mesh.tree().nearest(Vec3::from_raw(middle)).face,
            Self::Field(field) => {
                let [x, _, z] = middle;
                let [bottom, top] = [low[1], high[1]].map(|y| Vec3::from_raw([x, y, z]));
                let mut faces = Vec::new();
                field.faces_near(&Aabb::new(bottom, top), &mut faces);
                faces.first().copied().unwrap_or(0)
            }
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

/// The nearer one, of two at a distance the one of the lower face.
fn nearer(best: Option<Closest>, next: Closest) -> Closest {
    let rank = |closest: &Closest| (closest.distance, closest.part_a, closest.part_b);
    best.filter(|best| rank(best) <= rank(&next)).unwrap_or(next)
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
        let is_far = |best: Closest| is_farther(&triangle.bounds(), &b.bounds(), best.distance);
        if best.is_some_and(is_far) {
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

/// What is nearer than what is known; if nothing is, a face that is likely to be near limits the
/// others.
fn search(a: Skin, b: &Core, mut best: Option<Closest>) -> Search {
    let around = b.bounds();
    if best.is_none() {
        best = compare(a, a.face_towards(&around), b, &around, best)?;
    }
    let mut faces = Vec::new();
    // Distances are rounded, by less than two units.
    let reach = best.map_or(Real::ZERO, |best| best.distance + Real::from_raw(2));
    a.faces_near(&grown(&around, reach), &mut faces);
    for face in faces {
        best = compare(a, face, b, &around, best)?;
    }
    ControlFlow::Continue(best)
}

/// The nearest so far or the one of this face, if its box is not too far away.
fn compare(a: Skin, face: u32, b: &Core, around: &Aabb, best: Option<Closest>) -> Search {
    let triangle = a.triangle(face);
    let is_far = |best: Closest| is_farther(&triangle.bounds(), around, best.distance);
    if best.is_some_and(is_far) {
        return ControlFlow::Continue(best);
    }
    match of_convex(&triangle.into(), b, Vec3::ZERO) {
        None => ControlFlow::Break(()),
        Some(found) => ControlFlow::Continue(Some(nearer(best, Closest { part_a: face, ..found }))),
    }
}

/// Whether two boxes, and so what is in them, are farther from each other than that, and more than
/// a rounded distance may be wrong.
fn is_farther(a: &Aabb, b: &Aabb, distance: Real) -> bool {
    let [low_a, high_a, low_b, high_b] = [a.min(), a.max(), b.min(), b.max()].map(Vec3::raw);
    // At most 2^62, so that squares sum.
    let square = |k: usize| {
        let gap = (low_b[k] - high_a[k]).max(low_a[k] - high_b[k]).max(0);
        u128::from(gap.unsigned_abs()).pow(2)
    };
    square(0) + square(1) + square(2) > u128::from(distance.raw().unsigned_abs() + 2).pow(2)
}

/// A box that is larger by as much on every side, as far as there are numbers.
pub(in crate::collision) fn grown(bounds: &Aabb, by: Real) -> Aabb {
    let by = by.raw();
    let low = bounds.min().raw().map(|c| c.saturating_sub(by));
    let high = bounds.max().raw().map(|c| c.saturating_add(by));
    Aabb::new(Vec3::from_raw(low), Vec3::from_raw(high))
}
