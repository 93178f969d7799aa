//! Vertices joined, by comparing all with all.

use proptest::prelude::*;
use verlock::geometry::{MeshError, Triangle, TriangleMesh};
use verlock::{Real, Vec3};

use super::{any_mesh, cases, mesh};

/// Joins each vertex to the first one kept that is near enough.
fn naive(mesh: &TriangleMesh, tolerance: i64) -> TriangleMesh {
    let is_near = |a: Vec3, b: Vec3| {
        let (a, b) = (a.raw(), b.raw());
        let squares = (0..3).map(|k| i128::from(a[k] - b[k]).pow(2));
        squares.sum::<i128>() <= i128::from(tolerance).pow(2)
    };
    let mut kept: Vec<Vec3> = vec![];
    let mut place = vec![];
    for &vertex in mesh.vertices() {
        let first = kept.iter().position(|&other| is_near(vertex, other));
        place.push(first.unwrap_or(kept.len()) as u32);
        if first.is_none() {
            kept.push(vertex);
        }
    }
    let faces = mesh.faces().iter().map(|face| face.map(|vertex| place[vertex as usize]));
    TriangleMesh::new(kept, faces).expect("in range")
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn welding_is_what_comparing_all_with_all_gives(
        mesh in any_mesh(), tolerance in prop_oneof![0..400_i64, Just(1 << 40), Just(i64::MAX)],
    ) {
        let welded = mesh.welded(Real::from_raw(tolerance)).expect("in range");
        prop_assert_eq!(&welded, &naive(&mesh, tolerance));
        prop_assert_eq!(&welded.welded(Real::from_raw(tolerance)).expect("again"), &welded);
    }
}

#[test]
fn a_cube_of_loose_faces_becomes_a_cube() {
    let cube = mesh("cube.obj");
    let loose = cube.triangles().flat_map(|triangle| *triangle.corners());
    let faces = (0..12).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]);
    let loose = TriangleMesh::new(loose, faces).expect("in range");
    assert_eq!(loose.vertices().len(), 36);
    let welded = loose.welded(Real::ZERO).expect("in range");
    assert_eq!((welded.vertices().len(), welded.faces().len()), (8, 12));
    assert!(welded.triangles().eq(cube.triangles()), "the same triangles");
}

#[test]
fn vertices_join_the_first_that_is_near_and_do_not_move_it() {
    // A chain: each is near its neighbour, the ends are not near each other.
    let chain = |order: [i64; 3]| {
        let places = order.map(|x| Vec3::from_raw([x, 0, 0]));
        let mesh = TriangleMesh::new(places, [[0, 1, 2]]).expect("in range");
        let welded = mesh.welded(Real::from_raw(10)).expect("in range");
        (welded.vertices().iter().map(|p| p.raw()[0]).collect::<Vec<_>>(), welded.faces()[0])
    };
    assert_eq!(chain([0, 10, 20]), (vec![0, 20], [0, 0, 1]));
    assert_eq!(chain([10, 0, 20]), (vec![10], [0, 0, 0]));
    assert_eq!(chain([20, 0, 10]), (vec![20, 0], [0, 1, 0]));
    assert_eq!(chain([0, 11, 22]), (vec![0, 11, 22], [0, 1, 2]));
}

#[test]
fn a_weld_that_makes_no_mesh_is_refused() {
    let far = Triangle::SPAN_MAX;
    let places = [[-5, 0, 0], [0, 0, 0], [far, 0, 0]].map(Vec3::from_raw);
    let mesh = TriangleMesh::new(places, [[1, 1, 2]]).expect("in range");
    assert_eq!(mesh.welded(Real::from_raw(5)), Err(MeshError::TooLong { face: 0 }));
    assert_eq!(mesh.welded(-Real::ULP), Err(MeshError::NegativeTolerance));
}

#[test]
fn many_vertices_in_one_place_are_welded_at_once() {
    // Comparing all with all would take 10^10 steps.
    let places = (0..100_000).map(|k| Vec3::from_raw([k % 7, k % 5, 0]));
    let mesh = TriangleMesh::new(places, [[0, 1, 2]]).expect("in range");
    assert_eq!(mesh.welded(Real::ZERO).expect("in range").vertices().len(), 35);
    assert_eq!(mesh.welded(Real::from_raw(8)).expect("in range").vertices().len(), 1);
}
