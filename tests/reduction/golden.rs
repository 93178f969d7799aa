//! Reduced meshes and deviations as they were accepted: the same on every machine.

use verlock::Hash;

use super::tree;
use crate::support::meshes::shape;

/// The shapes, what they become, and how far that is off.
#[test]
fn reduced_meshes_are_as_accepted() {
    let mut bytes = vec![];
    for name in ["knot", "terrain"] {
        let mesh = shape(name, 1);
        let small = mesh.decimated(120).expect("faces");
        let told = tree(&mesh).farthest_from(&tree(&small));
        for hash in [mesh.content_hash(), small.content_hash()] {
            bytes.extend(hash.to_bytes());
        }
        let [x, y, z] = told.point.raw();
        let numbers = [x, y, z, told.at_least.raw(), told.at_most.raw()];
        bytes.extend(numbers.into_iter().flat_map(i64::to_le_bytes));
    }
    assert_eq!(Hash::of(&bytes).to_string(), "b05da2e8b412860eb1387778a38b2e31");
}
