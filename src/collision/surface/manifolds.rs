//! Manifolds of pairs of which one is a surface.

use alloc::vec::Vec;

use super::pair::NearSurfaces;
use super::proximity::{Proximity, along, manifolds, scaled};
use super::round::{manifolds_capsule_surface, manifolds_sphere_surface};
use super::skin::Skin;
use super::tangle::Tangle;
use super::{DEPTH_MAX, MeshShape, REACH_MAX};
use crate::collision::patch::reduce;
use crate::collision::{Contact, FeatureId, Manifold, Shape};
use crate::geometry::{Aabb, HalfSpace, HeightField, Surface, Triangle};
use crate::math::wide::sub;
use crate::math::{Real, Vec3};

/// Adds the manifolds of two meshes that are nearer than `margin`, in metres; static or moving,
/// hollow or not.
///
/// Where they intersect, parts of a one-sided mesh that are deeper than 2 mm inside another have a
/// manifold each, whose normal and depth lead all of the part out. O(k log k) for k faces near one
/// another, and all vertices inside.
pub fn manifolds_mesh_mesh(a: &MeshShape, b: &MeshShape, margin: Real, out: &mut Vec<Manifold>) {
    let mut pairs = Vec::new();
    a.tree().near_pairs(b.tree(), reach(margin), &mut pairs);
    of_pairs(a, b, &mut pairs, margin, |feature| feature, out);
}

/// Adds the manifolds of a mesh and a height field that are nearer than `margin`, see
/// [`manifolds_mesh_mesh`].
pub fn manifolds_mesh_height_field(
    a: &MeshShape,
    b: &HeightField,
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    surfaces(a, b, margin, |feature| feature, out);
}

/// Adds the manifolds of two shapes that are nearer than `margin`, if the second is a mesh, a
/// height field or a triangle, and the first any shape; else nothing, and returns false.
///
/// Boxes and hulls are surfaces too then. O(k log k) for k faces near one another, and all vertices
/// of what is deep inside.
pub fn collide_surface(a: &Shape, b: &Shape, margin: Real, out: &mut Vec<Manifold>) -> bool {
    match (a, b) {
        (Shape::MeshShape(a), Shape::MeshShape(b)) => manifolds_mesh_mesh(a, b, margin, out),
        (_, Shape::MeshShape(b)) => with_surface(a, b, margin, out),
        (_, Shape::HeightField(b)) => with_surface(a, b, margin, out),
        (_, Shape::Triangle(b)) => with_surface(a, b, margin, out),
        _ => return false,
    }
    true
}

fn with_surface<B: Surface>(a: &Shape, b: &B, margin: Real, out: &mut Vec<Manifold>) {
    let same = |feature| feature;
    match a {
        Shape::HalfSpace(a) => manifolds_half_space_surface(a, b, margin, out),
        Shape::Sphere(a) => manifolds_sphere_surface(a, b, margin, out),
        Shape::Capsule(a) => manifolds_capsule_surface(a, b, margin, out),
        Shape::Cuboid(a) => {
            let skin = Skin::of_cuboid(a);
            surfaces(&skin, b, margin, |feature| skin.name(feature), out);
        }
        Shape::ConvexHull(a) => {
            let skin = Skin::of_hull(a);
            surfaces(&skin, b, margin, |feature| skin.name(feature), out);
        }
        Shape::MeshShape(a) => surfaces(a, b, margin, same, out),
        Shape::HeightField(a) => surfaces(a, b, margin, same, out),
        Shape::Triangle(a) => surfaces::<Triangle, B>(a, b, margin, same, out),
    }
}

/// Adds the manifold of a half-space and a surface that are nearer than `margin`: of all vertices
/// that are. O(n) for n faces.
pub fn manifolds_half_space_surface<S: Surface>(
    half_space: &HalfSpace,
    surface: &S,
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    let (origin, normal) = (half_space.point().raw(), half_space.normal());
    let (mut faces, mut vertices) = (Vec::new(), Vec::new());
    surface.faces_near(&surface.bounds(), &mut faces);
    vertices.extend(faces.into_iter().flat_map(|face| surface.corners(face)));
    vertices.sort_unstable();
    vertices.dedup();
    let near = vertices.into_iter().filter_map(|vertex| {
        let on_b = surface.position(vertex);
        // Both are within 2^60.
        let separation = along(normal, sub(on_b.raw(), origin));
        let on_a = on_b - Vec3::from_raw(scaled(normal, separation));
        let features = [FeatureId::face(0), FeatureId::vertex(vertex)];
        let contact = Contact { features, on_a, on_b, separation };
        (separation <= margin).then_some(Proximity { normal, contact })
    });
    manifolds(&near.collect::<Vec<_>>(), out);
}

/// Of two surfaces, the first better the smaller one. `name` tells what features of the first are
/// called.
fn surfaces<A: Surface, B: Surface>(
    a: &A,
    b: &B,
    margin: Real,
    name: impl Fn(FeatureId) -> FeatureId,
    out: &mut Vec<Manifold>,
) {
    let reach = reach(margin);
    let (mut own, mut others, mut pairs) = (Vec::new(), Vec::new(), Vec::new());
    a.faces_near(&grown(&b.bounds(), reach), &mut own);
    for face in own {
        b.faces_near(&grown(&a.triangle(face).bounds(), reach), &mut others);
        pairs.extend(others.iter().map(|&other| [face, other]));
    }
    of_pairs(a, b, &mut pairs, margin, name, out);
}

fn of_pairs<A: Surface, B: Surface>(
    a: &A,
    b: &B,
    pairs: &mut [[u32; 2]],
    margin: Real,
    name: impl Fn(FeatureId) -> FeatureId,
    out: &mut Vec<Manifold>,
) {
    if pairs.is_empty() {
        return;
    }
    let mut found = NearSurfaces::new(a, b, pairs, margin).proximities();
    let tangle = Tangle::new((a, b), pairs, &found);
    found.retain(|proximity| !tangle.covers(proximity));
    let rename = |contact: &mut Contact| contact.features[0] = name(contact.features[0]);
    for proximity in &mut found {
        rename(&mut proximity.contact);
    }
    let first = out.len();
    manifolds(&found, out);
    for (normal, mut contacts) in tangle.parts {
        contacts.iter_mut().for_each(rename);
        out.extend(reduce(normal, &contacts));
    }
    out[first..].sort_unstable_by_key(|manifold| manifold.contacts()[0].features);
}

/// How far apart faces may be that touch or have passed through one another.
fn reach(margin: Real) -> Real {
    margin.clamp(DEPTH_MAX, REACH_MAX)
}

/// A box grown to every side. Coordinates are below 2^61.
pub(super) fn grown(bounds: &Aabb, reach: Real) -> Aabb {
    let reach = Vec3::new(reach, reach, reach);
    Aabb::new(bounds.min() - reach, bounds.max() + reach)
}
