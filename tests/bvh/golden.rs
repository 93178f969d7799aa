//! Trees and pairs as they were accepted: the same on every machine.

use std::sync::Arc;

use verlock::Hash;
use verlock::geometry::TriangleMesh;
use verlock::partition::bvh::{Bvh, CellBox, CellCylinder, CellSphere, Precision, Volume};

use super::{Soup, valid};

/// The hashes of two trees' shapes and of the faces that meet, then of those whose volumes do.
fn hashes<V: Volume>(meshes: &[Arc<TriangleMesh>; 2]) -> ([String; 3], String) {
    let [a, b] = meshes.each_ref().map(valid::<V>);
    let pairs = |precision| {
        let pairs = a.pairs(&b, precision);
        assert!(pairs.len() > 50, "only {} pairs", pairs.len());
        let bytes: Vec<u8> = pairs.iter().flatten().flat_map(|face| face.to_le_bytes()).collect();
        Hash::of(&bytes)
    };
    let exact = [a.shape_hash(), b.shape_hash(), pairs(Precision::Exact)];
    (exact.map(|hash| hash.to_string()), pairs(Precision::Volumes).to_string())
}

/// Shapes and exact pairs do not depend on the volumes; what stops at boxes, at spheres and at
/// cylinders comes last.
fn are_as_accepted(soups: [Soup; 2], accepted: [&str; 6]) {
    let meshes = [soups[0].mesh(1), soups[1].mesh(2)];
    let (exact, boxes) = hashes::<CellBox>(&meshes);
    let (exact_too, spheres) = hashes::<CellSphere>(&meshes);
    assert_eq!(exact, exact_too);
    let (exact_too, cylinders) = hashes::<CellCylinder>(&meshes);
    assert_eq!(exact, exact_too);
    let [a, b, pairs] = exact;
    assert_eq!([a, b, pairs, boxes, spheres, cylinders], accepted);
}

/// Two meshes whose cells are raw units, and two whose cells are larger, each its own size.
#[test]
fn trees_and_pairs_are_as_accepted() {
    let fine = Soup { faces: 400, places: 40, step: 10, scattered: false, origin: 1 << 50 };
    let coarse = Soup { faces: 300, step: 34, ..fine };
    let of_fine = [
        "e395f6ad756ff9974bd6603dfc891e16",
        "df28c589425ad10ff00df91b77af9f33",
        "4979cfbafaffabe695028de96360a52f",
        "d076f8be878a98af8533944879b0e57e",
        "940a8ef180260e4a898f26526bf9c1e0",
        "dc3983475c7c86fea4a78ef053c6dc83",
    ];
    let of_coarse = [
        "92d7f6316c655fe8a4631a880d59ca82",
        "a68f3ec53860d8b56064934ac9a774ba",
        "0ac0f15beb627a71aa88ef55bdad984b",
        "95b89afb17d919cff07581b8f2dc9b8f",
        "cebb49404250200a770bb71ee5c94311",
        "04ee454eee99b8ebb81ba2c8ee389bcf",
    ];
    let accepted = [([fine; 2], of_fine), ([coarse, Soup { places: 11, ..coarse }], of_coarse)];
    for (soups, hashes) in accepted {
        are_as_accepted(soups, hashes);
    }
}

/// The same mesh gives the same tree, and so does one that comes back to where it was.
#[test]
fn trees_are_functions_of_the_mesh() {
    let soup = Soup { faces: 300, places: 9, step: 24, scattered: true, origin: 0 };
    let mesh = soup.mesh(5);
    let tree = valid::<CellCylinder>(&mesh);
    assert_eq!(tree, Bvh::new(soup.mesh(5)));
    let mut moved = tree.clone();
    moved.refit(&soup.moved(6)).expect("in range");
    assert_ne!(tree, moved);
    assert_eq!(tree.shape_hash(), moved.shape_hash());
    moved.refit(mesh.vertices()).expect("in range");
    assert_eq!(tree, moved);
}
