//! Manifolds of pairs of which one is a surface.

use alloc::vec::Vec;

use super::contained::contained;
use super::exit::is_against;
use super::pair::NearSurfaces;
use super::proximity::{Proximity, along, manifolds, scaled};
use super::round::{manifolds_capsule_surface, manifolds_sphere_surface};
use super::skin::Skin;
use super::tangle::Tangle;
use super::{DEPTH_MAX, MeshShape};
use crate::collision::margin::counted;
use crate::collision::patch::reduce;
use crate::collision::{Contact, FeatureId, Manifold, Shape};
use crate::geometry::{Aabb, HalfSpace, HeightField, Surface};
use crate::math::wide::sub;
use crate::math::{Real, Vec3};

/// Adds the manifolds of two meshes that are nearer than `margin`, in metres; static or moving,
/// hollow or not.
///
/// Where they intersect, parts that are deeper than 2 mm inside one another have a manifold each,
/// whose normal and depth lead all of the part out: as a rule the shortest way along the normal of
/// a face where they intersect, or the one that lessens the common volume fastest. What has no
/// inside is pushed out to the side from which it is the shorter way. Where one has gone right
/// through the other, it is the shortest way that parts them as wholes, if that is farther than
/// needed too. O(k log k) for k faces near one another and all vertices inside, and for all n
/// faces O(n log n) for each part that nothing near is a way out of.
///
/// Each shell of one, which is what hangs together, that does not intersect the other but is inside
/// of it, which is closed and one-sided, is pushed out as a whole: through the nearest place that
/// leaves it free, or out of the box around the other. That is O(log n) for each shell, O(n log n)
/// for each whose first face is inside or flush, and for each that is inside as much for each place
/// that is tried, 16 at most, and O(n) for each that is looked at, 256 at most.
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

/// Adds the manifolds of any shape and a mesh that are nearer than `margin`. Boxes and hulls are
/// surfaces too then.
pub(in crate::collision) fn manifolds_shape_mesh(
    a: &Shape,
    b: &MeshShape,
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    match a {
        Shape::MeshShape(a) => manifolds_mesh_mesh(a, b, margin, out),
        _ => with_surface(a, b, margin, out),
    }
}

/// Adds the manifolds of any shape and a height field that are nearer than `margin`.
pub(in crate::collision) fn manifolds_shape_height_field(
    a: &Shape,
    b: &HeightField,
    margin: Real,
    out: &mut Vec<Manifold>,
) {
    with_surface(a, b, margin, out);
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
        Shape::Triangle(a) => surfaces(a, b, margin, same, out),
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
        (separation <= counted(margin)).then_some(Proximity { normal, contact })
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
    let (mut found, mut tangle) = (Vec::new(), Tangle::default());
    if !pairs.is_empty() {
        found = NearSurfaces::new(a, b, pairs, margin).proximities();
        tangle = Tangle::new((a, b), pairs, &found);
        found.retain(|proximity| !tangle.covers(proximity));
    }
    let mut parts = contained(a, b, &tangle.rims);
    // What leads it deeper is no contact before it is out.
    found.retain(|one| !parts.iter().any(|part| is_against(one.normal, part.0)));
    parts.append(&mut tangle.parts);
    for proximity in &mut found {
        let [feature, _] = &mut proximity.contact.features;
        *feature = name(*feature);
    }
    // Different ones may have become one.
    found.sort_unstable_by_key(Proximity::key);
    found.dedup_by_key(|proximity| proximity.contact.features);
    let first = out.len();
    manifolds(&found, out);
    for (normal, mut contacts) in parts {
        for contact in &mut contacts {
            contact.features[0] = name(contact.features[0]);
        }
        contacts.sort_unstable_by_key(|c| (c.features, c.separation, c.on_a, c.on_b));
        contacts.dedup_by_key(|contact| contact.features);
        out.extend(reduce(normal, &contacts));
    }
    out[first..].sort_unstable_by_key(|manifold| manifold.contacts()[0].features);
}

/// How far apart faces may be that touch or have passed through one another.
fn reach(margin: Real) -> Real {
    counted(margin).max(DEPTH_MAX)
}

/// A box grown to every side. Its coordinates and the reach are below 2^62.
pub(super) fn grown(bounds: &Aabb, reach: Real) -> Aabb {
    let reach = Vec3::new(reach, reach, reach);
    Aabb::new(bounds.min() - reach, bounds.max() + reach)
}
