//! Meshes of fewer faces, and how far they are from what they stand for: against brute force in
//! floats, which knows nothing of trees, bounds and quadrics.

mod decimation;
mod deviation;
mod golden;
mod nearest;
mod shapes;

use std::sync::Arc;

use proptest::prelude::*;
use verlock::Vec3;
use verlock::geometry::{Adjacency, TriangleMesh};
use verlock::math::Pcg;
use verlock::partition::bvh::Bvh;

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn tree(mesh: &TriangleMesh) -> Bvh {
    Bvh::new(Arc::new(mesh.clone()))
}

/// What collapsing edges must not change.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Topology {
    /// Of those with faces.
    parts: usize,
    /// Vertices and faces less edges.
    euler: i64,
    /// Closed ways along the boundary.
    rims: usize,
}

impl Topology {
    /// Of a mesh of which every vertex has a face.
    fn of(mesh: &TriangleMesh) -> Self {
        let adjacency = Adjacency::new(mesh);
        let [v, e, f] = [mesh.vertices().len(), adjacency.edges().len(), mesh.faces().len()];
        let parts = 1 + adjacency.components().into_iter().max().expect("vertices") as usize;
        let mut rims: Vec<[u32; 2]> = adjacency.boundary().collect();
        let mut count = 0;
        while let Some([start, mut at]) = rims.pop() {
            while at != start {
                let next = rims.iter().position(|ends| ends.contains(&at)).expect("a closed way");
                let [a, b] = rims.swap_remove(next);
                at = if a == at { b } else { a };
            }
            count += 1;
        }
        Self { parts, euler: v as i64 + f as i64 - e as i64, rims: count }
    }
}

/// Whether at most two faces meet in every edge, and both see it from the same side.
fn is_surface(mesh: &TriangleMesh) -> bool {
    let adjacency = Adjacency::new(mesh);
    let turn = |face: u32, [a, b]: [u32; 2]| {
        let [p, q, r] = mesh.faces()[face as usize];
        [[p, q], [q, r], [r, p]].contains(&[a, b])
    };
    adjacency.edges().all(|edge| match *edge.faces {
        [_] => true,
        [a, b] => turn(a, edge.ends) != turn(b, edge.ends),
        _ => false,
    })
}

/// Faces between random vertices: no surface at all, in `places` places along an axis, 2^`bits` raw
/// units from one to the next.
fn soup(seed: u64, faces: u32, places: u32, bits: u32) -> TriangleMesh {
    let mut rng = Pcg::new(seed, 7);
    let vertices = (0..faces + 3).map(|_| {
        Vec3::from_raw([(); 3].map(|()| (i64::from(rng.below(places)) << bits) - (1 << bits)))
    });
    let vertices: Vec<_> = vertices.collect();
    let corners = (0..faces).map(|_| [(); 3].map(|()| rng.below(faces + 3)));
    TriangleMesh::new(vertices, corners).expect("in range")
}

/// The same mesh elsewhere.
fn moved(mesh: &TriangleMesh, way: Vec3) -> TriangleMesh {
    let vertices = mesh.vertices().iter().map(|&vertex| vertex + way);
    TriangleMesh::new(vertices, mesh.faces().iter().copied()).expect("in range")
}

/// The same mesh, so many times as large.
fn scaled(mesh: &TriangleMesh, factor: i64) -> TriangleMesh {
    let vertices = mesh.vertices().iter().map(|v| Vec3::from_raw(v.raw().map(|c| c * factor)));
    TriangleMesh::new(vertices, mesh.faces().iter().copied()).expect("in range")
}
