//! Two small meshes, any three volumes.

use std::sync::Arc;

use verlock::Vec3;
use verlock::geometry::{Triangle, TriangleMesh, overlap_triangle_triangle};
use verlock::partition::bvh::{Bvh, CellBox, CellCylinder, CellSphere, Precision, Volume};

use super::draw::Draw;

/// No more vertices and faces are in a mesh.
const VERTICES_MAX: usize = 12;
const FACES_MAX: usize = 24;

/// Where meshes are along an axis, raw: cells of a step about them are still in range, or not.
const PLACES: [i64; 8] = [0, 0, 1, 3, -(1 << 28), 1 << 31, (1 << 60) - (1 << 41), -(1 << 60) + 2];

/// A mesh, and where its vertices go.
struct Part {
    mesh: Arc<TriangleMesh>,
    moved: Vec<Vec3>,
}

/// Trees of boxes, spheres and cylinders are sound and find the pairs of faces that looking at all
/// of them finds, before and after the vertices move; stopping at the volumes finds them too. True
/// if there are two meshes.
pub fn bvh(bytes: &[u8]) -> bool {
    let mut draw = Draw::new(bytes);
    let [Some(a), Some(b)] = [Part::draw(&mut draw), Part::draw(&mut draw)] else { return false };
    finds_all::<CellBox>(&a, &b);
    finds_all::<CellSphere>(&a, &b);
    finds_all::<CellCylinder>(&a, &b);
    true
}

fn finds_all<V: Volume>(a: &Part, b: &Part) {
    let [mut tree_a, mut tree_b] = [a, b].map(|part| Bvh::<V>::new(part.mesh.clone()));
    let [from_a, from_b] = [a, b].map(|part| part.triangles(part.mesh.vertices()));
    agree(&tree_a, &tree_b, &from_a, &from_b);
    // Faces that would be too long stay where they are.
    let to_a = if tree_a.refit(&a.moved).is_ok() { a.triangles(&a.moved) } else { from_a };
    agree(&tree_a, &tree_b, &to_a, &from_b);
    let to_b = if tree_b.refit(&b.moved).is_ok() { b.triangles(&b.moved) } else { from_b };
    agree(&tree_a, &tree_b, &to_a, &to_b);
}

fn agree<V: Volume>(a: &Bvh<V>, b: &Bvh<V>, faces_a: &[Triangle], faces_b: &[Triangle]) {
    assert_eq!([a.validate(), b.validate()], [Ok(()); 2]);
    let mut expected = vec![];
    for (i, one) in (0..).zip(faces_a) {
        for (j, other) in (0..).zip(faces_b) {
            if overlap_triangle_triangle(one, other) {
                expected.push([i, j]);
            }
        }
    }
    assert_eq!(a.pairs(b, Precision::Exact), expected, "exact pairs");
    assert_eq!(a.overlaps(b, Precision::Exact), !expected.is_empty());
    let mut turned = b.pairs(a, Precision::Exact);
    turned.iter_mut().for_each(|pair| pair.reverse());
    turned.sort_unstable();
    assert_eq!(turned, expected, "the other way round");
    let near = a.pairs(b, Precision::Volumes);
    assert!(expected.iter().all(|pair| near.binary_search(pair).is_ok()), "{expected:?} {near:?}");
    let bounds = faces_b[0].bounds();
    let is_near = |&face: &u32| faces_a[face as usize].bounds().overlaps(&bounds);
    let expected: Vec<_> = (0..).take(faces_a.len()).filter(is_near).collect();
    assert_eq!(a.faces_near(&bounds), expected, "faces near a box");
}

impl Part {
    /// Small numbers times a step, from one of a few places: much coincides, much touches, and much
    /// is as far apart as can be. `None` if no mesh comes of it.
    fn draw(draw: &mut Draw<'_>) -> Option<Self> {
        let step = [1, 7, 1 << 20, 1 << 30, (1 << 36) + 1, 1 << 40][draw.below(6)];
        let count = 1 + draw.below(VERTICES_MAX);
        let places = [(); 2].map(|()| [(); 3].map(|()| PLACES[draw.below(PLACES.len())]));
        let mut vertices = || -> Vec<Vec3> {
            let vertex = |_| {
                let place = places[draw.below(8) / 7]; // the second one now and then
                let cell = [(); 3].map(|()| draw.below(5) as i64 - 2);
                Vec3::from_raw([0, 1, 2].map(|k| place[k] + cell[k] * step))
            };
            (0..count).map(vertex).collect()
        };
        let (rest, moved) = (vertices(), vertices());
        let faces: Vec<_> = (0..1 + draw.below(FACES_MAX))
            .map(|_| [(); 3].map(|()| u32::try_from(draw.below(count)).unwrap_or(0)))
            .collect();
        let long = |corners: &[u32; 3]| {
            let corners = corners.map(|vertex| rest[vertex as usize]);
            Triangle::new(corners).is_err()
        };
        let faces: Vec<_> = faces.into_iter().filter(|corners| !long(corners)).collect();
        let mesh = TriangleMesh::new(rest.iter().copied(), faces).ok()?;
        Some(Self { mesh: Arc::new(mesh), moved })
    }

    fn triangles(&self, positions: &[Vec3]) -> Vec<Triangle> {
        let triangle = |corners: &[u32; 3]| corners.map(|vertex| positions[vertex as usize]);
        let faces = self.mesh.faces().iter().map(triangle);
        faces.map(|corners| Triangle::new(corners).expect("it was accepted")).collect()
    }
}
