//! Hierarchies against what looking at every pair of faces finds.

mod golden;
mod limits;
mod pairs;

use std::sync::Arc;

use proptest::prelude::*;
use verlock::Vec3;
use verlock::geometry::{Triangle, TriangleMesh, overlap_triangle_triangle};
use verlock::math::Pcg;
use verlock::partition::bvh::{Bvh, Volume};

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// What random meshes are like.
#[derive(Clone, Copy, Debug)]
struct Soup {
    faces: u32,
    /// How many places along an axis vertices have, so that many coincide or touch.
    places: u32,
    /// From one to the next, in bits.
    step: u32,
    /// Whether parts of the mesh lie as far apart as possible.
    scattered: bool,
    /// Where it is, along every axis.
    origin: i64,
}

impl Soup {
    /// The same mesh for the same seed; made with integers only.
    fn mesh(&self, seed: u64) -> Arc<TriangleMesh> {
        let mut rng = Pcg::new(seed, 0);
        let parts = if self.scattered { 3 } else { 1 };
        let vertices: Vec<_> = (0..parts).flat_map(|_| self.part(&mut rng)).collect();
        let each = u32::try_from(vertices.len()).expect("few vertices") / parts;
        let faces = (0..self.faces).map(|_| {
            let part = rng.below(parts) * each;
            [(); 3].map(|()| part + rng.below(each))
        });
        Arc::new(TriangleMesh::new(vertices, faces).expect("in range"))
    }

    /// Vertices near one another.
    fn part(&self, rng: &mut Pcg) -> Vec<Vec3> {
        const FAR: i64 = (1 << 60) - (1 << 41);
        let mut corner = [self.origin; 3];
        if self.scattered {
            corner = corner.map(|_| (i64::from(rng.below(3)) - 1) * FAR);
        }
        let step = 1_i64 << self.step;
        let mut along = |c: i64| {
            let off = i64::from(rng.below(3)) - 1; // a raw unit from touching
            c + i64::from(rng.below(self.places)) * step + off
        };
        (0..self.faces + 3).map(|_| Vec3::from_raw(corner.map(&mut along))).collect()
    }

    /// Other places for the vertices of its meshes.
    fn moved(&self, seed: u64) -> Vec<Vec3> {
        let parts = if self.scattered { 3 } else { 1 };
        let mut rng = Pcg::new(seed, 1);
        (0..parts).flat_map(|_| self.part(&mut rng)).collect()
    }
}

/// Small and large cells, near and far, in one place and in several.
fn any_soup() -> impl Strategy<Value = Soup> {
    let origin = prop_oneof![Just(0), Just((1 << 60) - (1 << 41)), Just(-(1 << 60) + 1)];
    let step = prop_oneof![Just(0), Just(5), Just(20), Just(30), Just(37)];
    (1..40_u32, 2..8_u32, step, any::<bool>(), origin).prop_map(
        |(faces, places, step, scattered, origin)| Soup { faces, places, step, scattered, origin },
    )
}

/// The pairs that meet, found by looking at all.
fn brute(a: &[Triangle], b: &[Triangle]) -> Vec<[u32; 2]> {
    let mut pairs = vec![];
    for (i, a) in (0..).zip(a) {
        for (j, b) in (0..).zip(b) {
            if overlap_triangle_triangle(a, b) {
                pairs.push([i, j]);
            }
        }
    }
    pairs
}

/// The faces of a mesh whose vertices have moved.
fn triangles(mesh: &TriangleMesh, positions: &[Vec3]) -> Vec<Triangle> {
    let triangle = |corners: &[u32; 3]| corners.map(|vertex| positions[vertex as usize]);
    let faces = mesh.faces().iter().map(triangle);
    faces.map(|corners| Triangle::new(corners).expect("in range")).collect()
}

fn valid<V: Volume>(mesh: &Arc<TriangleMesh>) -> Bvh<V> {
    let bvh = Bvh::new(mesh.clone());
    bvh.validate().expect("valid");
    bvh
}
