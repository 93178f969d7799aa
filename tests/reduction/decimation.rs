//! What collapsing edges keeps, and what it reaches.

use std::time::Instant;

use proptest::prelude::*;
use verlock::geometry::{Adjacency, Grid, MeshError, TriangleMesh};
use verlock::math::trig::cos_sin;
use verlock::{Real, Vec3, real};

use super::{Topology, is_surface, moved, scaled, soup, tree};
use crate::support::meshes::{SHAPES, shape};

/// Every shape is a surface of its kind with as few faces as asked for, and without flat ones.
#[test]
fn shapes_remain_what_they_are() {
    for (name, shape) in SHAPES {
        let mesh = shape(2);
        for faces in [1000, 200] {
            let small = mesh.decimated(faces).expect("faces");
            assert!(small.faces().len() <= faces, "{name} of {faces}: {}", small.faces().len());
            assert!(small.faces().len() + 2 >= faces, "{name} of {faces}: no more than that");
            assert!(is_surface(&small), "{name} of {faces}");
            assert_eq!(small.degenerate_faces().count(), 0, "{name} of {faces}");
            assert_eq!(Topology::of(&small), Topology::of(&mesh), "{name} of {faces}");
        }
    }
}

/// Where few enough cannot be had, as few as there can be are: 4 of a ball, 7 vertices of a torus
/// have 14 faces, of a disk 1 remains.
#[test]
fn kinds_of_surfaces_have_a_least_number_of_faces() {
    for (name, least) in [("rock", 4), ("torus", 14), ("terrain", 1)] {
        let mesh = shape(name, 1);
        let small = mesh.decimated(0).expect("faces");
        assert_eq!(Topology::of(&small), Topology::of(&mesh), "{name}");
        let len = small.faces().len();
        assert!((least..=least + 10).contains(&len), "{name}: {len}");
    }
}

/// Enough faces are left alone, to the bit.
#[test]
fn small_meshes_are_left_alone() {
    let mesh = shape("rock", 1);
    assert_eq!(mesh.decimated(mesh.faces().len()).expect("faces"), mesh);
}

/// Flat places cost nothing: what is flat comes down to its corners, exactly.
#[test]
fn flat_sides_come_down_to_their_corners() {
    let edges = [Vec3::from_ints(3, 0, 1), Vec3::from_ints(-1, 2, 0)];
    let [edge_u, edge_v] = edges;
    let grid = Grid { corner: Vec3::ONE, edge_u, edge_v, columns: 25, rows: 17 };
    let sheet = TriangleMesh::grid(&grid).expect("a sheet").decimated(2).expect("faces");
    let mut corners =
        [Vec3::ONE, Vec3::ONE + edge_u, Vec3::ONE + edge_v, Vec3::ONE + edge_u + edge_v];
    corners.sort_unstable();
    let mut found = sheet.vertices().to_vec();
    found.sort_unstable();
    assert_eq!((sheet.faces().len(), found), (2, corners.to_vec()));

    // Six steps: 28 corners, and 52 faces.
    let stairs = shape("stairs", 3);
    let small = stairs.decimated(52).expect("faces");
    assert_eq!((small.vertices().len(), small.faces().len()), (28, 52));
    assert!(small.vertices().iter().all(|vertex| stairs.vertices().contains(vertex)));
    assert!(tree(&stairs).deviation(&tree(&small)).at_most() < real!("0.00002"));
}

/// The boundary of a sheet costs as much as its folds: a square of 20 m keeps its outline, to 10 cm
/// where hills of half a metre are levelled.
#[test]
fn boundaries_stay_where_they_are() {
    let terrain = shape("terrain", 2);
    let small = terrain.decimated(300).expect("faces");
    let edge = real!("9.9");
    let corners = small.vertices().iter().filter(|v| v.x.abs() > edge && v.z.abs() > edge);
    assert_eq!(corners.count(), 4);
    // Every vertex at the boundary is where the boundary was.
    let adjacency = Adjacency::new(&small);
    let near = real!("0.1");
    for vertex in adjacency.boundary().flatten() {
        let Vec3 { x, y: _, z } = small.vertices()[vertex as usize];
        let off = (real!("10") - x.abs()).abs().min((real!("10") - z.abs()).abs());
        assert!(off < near, "{off} m off at {x}, {z}");
    }
}

/// Edges of three faces and more, and corners where fans meet, stay; around them things go on.
#[test]
fn what_is_no_surface_stays() {
    // Three sheets that share their first row.
    let fold = |way: Vec3| {
        let grid = Grid { corner: Vec3::ZERO, edge_u: Vec3::X, edge_v: way, columns: 9, rows: 9 };
        TriangleMesh::grid(&grid).expect("a sheet")
    };
    let sheets = [Vec3::Y, Vec3::Z, -Vec3::Z].map(fold);
    let vertices: Vec<_> = sheets.iter().flat_map(|sheet| sheet.vertices().to_vec()).collect();
    let faces = (0..).step_by(81).zip(&sheets).flat_map(|(first, sheet)| {
        sheet.faces().iter().map(move |corners| corners.map(|corner| first + corner))
    });
    let mesh =
        TriangleMesh::new(vertices, faces).expect("sheets").welded(Real::ZERO).expect("a book");
    let spine = |mesh: &TriangleMesh| {
        Adjacency::new(mesh).edges().filter(|edge| edge.faces.len() == 3).count()
    };
    assert_eq!((mesh.faces().len(), spine(&mesh)), (384, 8));
    let small = mesh.decimated(30).expect("faces");
    assert_eq!(spine(&small), 8);
    assert!(small.faces().len() < 50, "{}", small.faces().len());
    assert!(tree(&mesh).deviation(&tree(&small)).at_most() < real!("0.00002"));
}

/// Faces that name a vertex twice are left out, with what only they name; of nothing else there is
/// no mesh.
#[test]
fn lines_are_left_out() {
    let corners = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    let mesh = TriangleMesh::new(corners, [[3, 3, 0], [0, 1, 2], [1, 1, 1]]).expect("a mesh");
    let small = mesh.decimated(1).expect("a face");
    assert_eq!((small.vertices(), small.faces()), (&corners[..3], &[[0, 1, 2]][..]));
    let line = TriangleMesh::new(corners, [[0, 1, 1]]).expect("a mesh");
    assert_eq!(line.decimated(1), Err(MeshError::NoFace));
}

/// The same mesh elsewhere, even at the end of the world, becomes the same mesh there, to the bit;
/// a larger one becomes as much larger as long as cells are raw units.
#[test]
fn meshes_become_the_same_wherever_they_are() {
    for (name, shape) in SHAPES {
        let mesh = shape(1);
        let small = mesh.decimated(100).expect("faces");
        for way in
            [[-77_777, 5, 1 << 40], [(1 << 60) - (1 << 29), -(1 << 59), 1 - (1 << 60) + (1 << 30)]]
        {
            let way = Vec3::from_raw(way);
            let elsewhere = moved(&mesh, way).decimated(100).expect("faces");
            assert_eq!(elsewhere, moved(&small, way), "{name}");
        }
    }
}

/// A mesh of kilometres is reduced as well as one of metres: made small again, it is as near.
#[test]
fn size_does_not_matter() {
    let mesh = shape("rock", 1);
    let off = |small: &TriangleMesh| tree(&mesh).deviation(&tree(small)).at_most().raw();
    let once = off(&mesh.decimated(100).expect("faces"));
    for bits in [4, 17] {
        let large = scaled(&mesh, 1 << bits).decimated(100).expect("faces");
        let vertices = large.vertices().iter().map(|v| Vec3::from_raw(v.raw().map(|c| c >> bits)));
        let small = TriangleMesh::new(vertices, large.faces().iter().copied()).expect("in range");
        let often = off(&small);
        assert!((once / 2..once * 2).contains(&often), "{bits}: {often}, not {once}");
    }
}

proptest! {
    #![proptest_config(super::cases(200))]

    /// Whatever a mesh is, what is left is one, of its own vertices where nothing could move.
    #[test]
    fn soups_are_taken(
        seed: u64,
        faces in 1..60_u32,
        places in 2..6_u32,
        bits in 0..38_u32,
        target in 0..40_usize,
    ) {
        let mesh = soup(seed, faces, places, bits);
        match mesh.decimated(target) {
            Ok(small) => {
                prop_assert!(small.faces().len() <= mesh.faces().len());
                prop_assert!(small.faces().iter().all(|[a, b, c]| a != b && b != c && c != a));
                let (low, high) = ((-1) << bits, i64::from(places) << bits);
                let inside = |c: i64| (low..=high).contains(&c);
                prop_assert!(small.vertices().iter().all(|v| v.raw().into_iter().all(inside)));
            }
            Err(error) => prop_assert_eq!(error, MeshError::NoFace),
        }
    }
}

/// A fan about one vertex, whose edges are as many as its faces.
#[test]
fn fans_are_reduced_in_time() {
    const SPOKES: u32 = 32_000;
    let rim = |k: u32| {
        let [cos, sin] = cos_sin(k % 256, 256).map(|c| i64::from(c.raw()) << 8);
        Vec3::from_raw([cos, sin, i64::from(k / 256) << 28])
    };
    let places = [Vec3::ZERO].into_iter().chain((0..SPOKES).map(rim));
    let faces = (1..SPOKES).map(|k| [0, k, k + 1]);
    let mesh = TriangleMesh::new(places, faces).expect("in range");
    let start = Instant::now();
    let small = mesh.decimated(100).expect("faces");
    let taken = start.elapsed();
    println!("{} faces to {} in {taken:?}", mesh.faces().len(), small.faces().len());
    assert!(small.faces().len() < mesh.faces().len());
    assert!(is_surface(&small));
    assert!(taken.as_secs() < 20, "{taken:?}");
}

/// 76,800 faces become 500 within two seconds.
#[test]
#[ignore = "a matter of time: 1 s with --release"]
fn large_meshes_are_reduced_in_time() {
    let mesh = shape("rock", 10);
    let start = Instant::now();
    let small = mesh.decimated(500).expect("faces");
    let taken = start.elapsed();
    println!("{} faces to {} in {taken:?}", mesh.faces().len(), small.faces().len());
    assert!(taken.as_secs() < 2, "{taken:?}");
}
