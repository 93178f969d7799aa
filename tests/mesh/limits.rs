//! What a mesh can be, to the step.

use std::iter::repeat_n;

use verlock::Vec3;
use verlock::geometry::{MeshBuilder, MeshError, Triangle, TriangleMesh};
use verlock::particle::{PARTICLES_MAX, WORLD_LIMIT};

const FAR: i64 = Triangle::COORDINATE_MAX;
const SPAN: i64 = Triangle::SPAN_MAX;

fn triangle(corners: [[i64; 3]; 3]) -> Result<TriangleMesh, MeshError> {
    TriangleMesh::new(corners.map(Vec3::from_raw), [[0, 1, 2]])
}

#[test]
fn limits_are_those_of_a_world() {
    assert_eq!((TriangleMesh::VERTICES_MAX, FAR), (PARTICLES_MAX, WORLD_LIMIT));
}

#[test]
fn limits_are_exact() {
    for k in 0..3 {
        for sign in [-1, 1] {
            let mut corners = [[sign * FAR; 3]; 3];
            assert!(triangle(corners).is_ok());
            corners[k][k] -= sign * SPAN;
            assert!(triangle(corners).is_ok());
            corners[k][k] -= sign;
            assert_eq!(triangle(corners), Err(MeshError::TooLong { face: 0 }));
            corners[k][k] = sign * (FAR + 1);
            let vertex = k as u32;
            assert_eq!(triangle(corners), Err(MeshError::OutOfRange { vertex }));
            corners[k][k] = if sign < 0 { i64::MIN } else { i64::MAX };
            assert_eq!(triangle(corners), Err(MeshError::OutOfRange { vertex }));
        }
    }
}

#[test]
fn what_is_no_mesh_is_refused_by_its_first_mistake() {
    let mesh = |faces: &[[u32; 3]]| TriangleMesh::new([Vec3::ZERO; 3], faces.iter().copied());
    for (faces, error, text) in [
        (&[][..], MeshError::NoFace, "mesh has no face"),
        (
            &[[0, 1, 2], [0, 3, 9], [5, 5, 5]],
            MeshError::NoSuchVertex { face: 1, vertex: 3 },
            "face 1 names vertex 3, which is not there",
        ),
        (
            &[[u32::MAX, 0, 1]],
            MeshError::NoSuchVertex { face: 0, vertex: u32::MAX },
            "face 0 names vertex 4294967295, which is not there",
        ),
    ] {
        assert_eq!(mesh(faces), Err(error));
        assert_eq!(error.to_string(), text);
    }
    assert_eq!(TriangleMesh::new([], []), Err(MeshError::NoFace));
}

#[test]
fn one_vertex_or_face_too_many_is_refused() {
    let vertices = |count| repeat_n(Vec3::ZERO, count);
    let faces = |count| repeat_n([0; 3], count);
    let (v, f) = (TriangleMesh::VERTICES_MAX, TriangleMesh::FACES_MAX);
    let most = TriangleMesh::new(vertices(v), faces(f)).expect("just within");
    assert_eq!((most.vertices().len(), most.faces().len()), (v, f));
    drop(most);
    assert_eq!(TriangleMesh::new(vertices(v + 1), faces(1)), Err(MeshError::TooManyVertices));
    assert_eq!(TriangleMesh::new(vertices(1), faces(f + 1)), Err(MeshError::TooManyFaces));
}

#[test]
fn a_builder_goes_on_after_a_refusal() {
    let mut builder = MeshBuilder::default();
    assert_eq!(builder.vertex(Vec3::ZERO), Ok(0));
    let far = Vec3::from_raw([0, FAR + 1, 0]);
    assert_eq!(builder.vertex(far), Err(MeshError::OutOfRange { vertex: 1 }));
    assert_eq!(builder.face([0, 1, 0]), Err(MeshError::NoSuchVertex { face: 0, vertex: 1 }));
    assert_eq!(builder.vertex(Vec3::X), Ok(1));
    assert_eq!(builder.face([0, 1, 0]), Ok(0));
    let mesh = builder.build().expect("one face");
    assert_eq!((mesh.vertices(), mesh.faces()), (&[Vec3::ZERO, Vec3::X][..], &[[0, 1, 0]][..]));
}

#[test]
fn faces_without_an_area_are_listed_exactly() {
    // A line as long as a face may be, and the same line bent by a step.
    let line = [[0, 0, 0], [SPAN, SPAN - 1, 0], [0, 0, 0]];
    let middle = [(SPAN - 1) / 2, (SPAN - 1) / 2, 0];
    let places = [line[0], line[1], middle, [SPAN - 1, SPAN - 1, 0], [7, 0, 0], [7, 0, 0]];
    let faces = [[0, 1, 2], [0, 2, 3], [0, 1, 3], [4, 5, 0], [0, 1, 1], [2, 2, 2], [1, 3, 4]];
    let mesh = TriangleMesh::new(places.map(Vec3::from_raw), faces).expect("in range");
    assert_eq!(mesh.degenerate_faces().collect::<Vec<_>>(), [1, 3, 4, 5]);
    assert_eq!(mesh.triangles().len(), 7);
}

#[test]
fn the_hash_names_the_contents() {
    let places = [[0; 3], [1 << 24, 0, 0], [0, -(1 << 24), 1 << 40]].map(Vec3::from_raw);
    let mesh = |faces: [[u32; 3]; 1]| TriangleMesh::new(places, faces).expect("in range");
    // By another program: 3 in 64 bits, nine coordinates, three corners.
    let expected = "0b1bfb1f563ebfc4caae7afb21bd81c4";
    assert_eq!(mesh([[0, 1, 2]]).content_hash().to_string(), expected);
    assert_ne!(mesh([[1, 2, 0]]).content_hash(), mesh([[0, 1, 2]]).content_hash());
}
