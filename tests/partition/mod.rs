//! Candidate pairs: every partition against every pair, whatever happens to it.

mod crowd;
mod golden;
mod laws;
mod misuse;
mod neighbours;

use verlock::Vec3;
use verlock::geometry::TriangleMesh;
use verlock::partition::{BruteForce, Bsp, DynamicTree, Orthtree, Pair, Partition, PartitionError};

/// A partition of each kind, the oracle first.
fn all() -> Vec<(&'static str, Box<dyn Partition>)> {
    let shallow = Orthtree::<3>::new().depth(33).objects_min(0);
    vec![
        ("brute force", Box::new(BruteForce::new())),
        ("dynamic tree", Box::new(DynamicTree::new())),
        ("octree", Box::new(Orthtree::<3>::new())),
        ("octree of 8 m cells", Box::new(shallow)),
        ("quadtree", Box::new(Orthtree::<2>::new())),
        ("quadtree seen from the front", Box::new(Orthtree::along([1, 0]))),
        ("bsp", Box::new(Bsp::<3>::new())),
        ("bsp with walls", Box::new(Bsp::<3>::new().walls(&rooms()))),
        ("bsp on the ground", Box::new(Bsp::<2>::new())),
        ("bsp on the ground with walls", Box::new(Bsp::<2>::new().walls(&rooms()))),
    ]
}

/// Four rooms: a wall along z, one along x, a slanted one, and a floor.
fn rooms() -> TriangleMesh {
    let corners = [
        (0, 0, -9),
        (0, 0, 9),
        (0, 9, 0), //
        (-9, 0, 0),
        (9, 0, 0),
        (0, 9, 0),
        (-9, 0, -9),
        (9, 0, 9),
        (0, 9, 0),
        (-9, 0, -9),
        (9, 0, -9),
        (0, 0, 9),
        (-9, 0, 5),
        (9, 0, 5),
        (0, 9, 5),
        (5, 0, -9),
        (5, 0, 9),
        (5, 9, 0),
    ];
    let corners = corners.map(|(x, y, z)| Vec3::from_ints(x, y, z));
    TriangleMesh::new(corners, (0..6).map(|face| [0, 1, 2].map(|k| 3 * face + k))).expect("a mesh")
}
