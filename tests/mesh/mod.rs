//! Meshes against naive twins that look at every pair, and files against what they say.

mod adjacency;
mod limits;
mod obj;
mod weld;

use std::fs;
use std::path::PathBuf;

use proptest::collection::vec;
use proptest::prelude::*;
use verlock::Vec3;
use verlock::geometry::TriangleMesh;
use verlock::scene::Obj;

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// The files of a folder of fixtures with their texts, sorted by name.
fn fixtures(folder: &str) -> Vec<(String, String)> {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), "fixtures", folder].iter().collect();
    let entries = fs::read_dir(path).expect("a folder of fixtures");
    let mut files: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "obj"))
        .map(|path| (path.display().to_string(), fs::read_to_string(path).expect("a text")))
        .collect();
    files.sort();
    files
}

/// The mesh of a fixture.
fn mesh(name: &str) -> TriangleMesh {
    let files = fixtures("meshes");
    let (_, text) = files.iter().find(|(path, _)| path.ends_with(name)).expect("a fixture");
    Obj::parse(text).expect("a mesh").into_mesh()
}

/// Small meshes in which vertices coincide, faces repeat corners, and edges have many faces; some
/// far from the origin.
fn any_mesh() -> impl Strategy<Value = TriangleMesh> {
    let vertices = (prop::array::uniform3(-4..=4_i64), -9..=9_i64);
    let place = prop_oneof![Just(0), Just(1 << 59), Just(-(1 << 59))];
    (vec(vertices, 1..24), place).prop_flat_map(|(vertices, place)| {
        // Steps of 100 raw, each vertex a little off.
        let vertex = move |(cell, off): ([i64; 3], i64)| cell.map(|c| place + 100 * c + off);
        let positions: Vec<Vec3> = vertices.into_iter().map(vertex).map(Vec3::from_raw).collect();
        let corner = 0..u32::try_from(positions.len()).expect("few vertices");
        vec(prop::array::uniform3(corner), 1..24)
            .prop_map(move |faces| TriangleMesh::new(positions.clone(), faces).expect("in range"))
    })
}
