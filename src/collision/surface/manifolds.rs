//! Manifolds of surfaces.

use alloc::vec::Vec;

use super::pair::NearSurfaces;
use super::proximity::manifolds;
use super::tangle::Tangle;
use super::{DEPTH_MAX, MeshShape, REACH_MAX};
use crate::collision::Manifold;
use crate::geometry::{Aabb, HeightField, Surface};
use crate::math::{Real, Vec3};

/// Adds the manifolds of two meshes that are nearer than `margin`.
pub fn manifolds_mesh_mesh(a: &MeshShape, b: &MeshShape, margin: Real, out: &mut Vec<Manifold>) {
    let mut pairs = Vec::new();
    a.tree().near_pairs(b.tree(), reach(margin), &mut pairs);
    of_pairs(a, b, &mut pairs, margin, out);
}

/// Adds the manifolds of a mesh and a height field that are nearer than `margin`.
pub fn manifolds_mesh_height_field(
    a: &MeshShape,
    b: &HeightField,
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    let reach = reach(margin);
    let (mut own, mut others, mut pairs) = (Vec::new(), Vec::new(), Vec::new());
    a.faces_near(&grown(&b.bounds(), reach), &mut own);
    for face in own {
        b.faces_near(&grown(&a.triangle(face).bounds(), reach), &mut others);
        pairs.extend(others.iter().map(|&other| [face, other]));
    }
    of_pairs(a, b, &mut pairs, margin, out);
}

fn of_pairs<A: Surface, B: Surface>(
    a: &A,
    b: &B,
    pairs: &mut [[u32; 2]],
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    if pairs.is_empty() {
        return;
    }
    let mut found = NearSurfaces::new(a, b, pairs, margin).proximities();
    let tangle = Tangle::new((a, b), pairs, &found);
    found.retain(|proximity| !tangle.covers(proximity));
    manifolds(&found, out);
    out.extend(tangle.manifolds);
}

/// How far apart faces may be that touch or have passed through one another.
pub(super) fn reach(margin: Real) -> Real {
    margin.clamp(DEPTH_MAX, REACH_MAX)
}

/// A box grown to every side. Coordinates are below 2^61.
pub(super) fn grown(bounds: &Aabb, reach: Real) -> Aabb {
    let reach = Vec3::new(reach, reach, reach);
    Aabb::new(bounds.min() - reach, bounds.max() + reach)
}
