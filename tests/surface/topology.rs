//! Which features touch, and which faces are near: height fields beside the meshes they stand for.

use std::sync::Arc;

use verlock::collision::MeshShape;
use verlock::geometry::{Aabb, HeightField, ShapeError, Surface, Triangle, TriangleMesh};
use verlock::math::Pcg;
use verlock::{Real, Vec3, real};

/// Hills of whole numbers, so that boxes can touch them.
fn field(rng: &mut Pcg) -> HeightField {
    let (columns, rows) = (2 + rng.below(6), 2 + rng.below(6));
    let heights: Vec<_> =
        (0..columns * rows).map(|_| Real::from_raw(i64::from(rng.below(5)))).collect();
    let origin = Vec3::from_raw([1 << 50, -7, 3]);
    HeightField::new(origin, [2, 3].map(Real::from_raw), columns, heights).expect("legal")
}

/// Checks every promise of a surface's lists; its faces by the ends of their edges.
fn validate(surface: &impl Surface, faces: u32) -> Vec<[[u32; 2]; 3]> {
    let ends = |face: u32| surface.sides(face).map(|edge| surface.ends(edge));
    for face in 0..faces {
        let corners = surface.corners(face);
        for k in 0..3 {
            let [a, b] = [corners[k], corners[(k + 1) % 3]];
            assert_eq!(ends(face)[k], [a.min(b), a.max(b)]);
            let at_edge: Vec<_> = surface.faces_at_edge(surface.sides(face)[k]).collect();
            let holds = |f: &u32| [a, b].iter().all(|v| surface.corners(*f).contains(v));
            assert_eq!(at_edge, (0..faces).filter(holds).collect::<Vec<_>>());
            let at_vertex: Vec<_> = surface.faces_at_vertex(a).collect();
            let holds = |f: &u32| surface.corners(*f).contains(&a);
            assert_eq!(at_vertex, (0..faces).filter(holds).collect::<Vec<_>>());
        }
        assert_eq!(surface.triangle(face).corners(), &corners.map(|v| surface.position(v)));
    }
    (0..faces).map(ends).collect()
}

/// A field and its mesh have the same faces, edges and neighbours.
#[test]
fn fields_are_meshes() {
    let mut rng = Pcg::new(3, 0);
    for _ in 0..40 {
        let field = field(&mut rng);
        let shape = MeshShape::new(Arc::new(field.mesh().expect("legal")));
        let faces = field.faces_len();
        assert_eq!(shape.mesh().faces().len(), faces as usize);
        assert_eq!(validate(&field, faces), validate(&shape, faces));
        assert_eq!(field.bounds(), shape.bounds());
        assert!(!shape.is_closed());
    }
}

/// Faces near a box, one by one.
#[test]
fn near_faces_are_found() {
    let mut rng = Pcg::new(4, 0);
    let (mut found, mut missed) = (0, 0);
    for _ in 0..40 {
        let field = field(&mut rng);
        let shape = MeshShape::new(Arc::new(field.mesh().expect("legal")));
        for _ in 0..50 {
            let mut corner = || {
                let [x, y, z] = [26, 9, 26].map(|n| i64::from(rng.below(n)));
                field.origin() + Vec3::from_raw([x - 5, y - 3, z - 5])
            };
            let bounds = Aabb::new(corner(), corner());
            let near = |face: &u32| field.triangle(*face).bounds().overlaps(&bounds);
            let expected: Vec<_> = (0..field.faces_len()).filter(near).collect();
            let mut faces = vec![77];
            field.faces_near(&bounds, &mut faces);
            assert_eq!(faces, expected);
            shape.faces_near(&bounds, &mut faces);
            assert_eq!(faces, expected);
            found += faces.len();
            missed += field.faces_len() as usize - faces.len();
        }
    }
    assert!(found > 10_000 && missed > 10_000, "{found} found, {missed} missed");
}

/// Edges of three faces, faces that name a vertex twice, vertices of no face.
#[test]
fn odd_meshes_have_features() {
    let mesh = |faces: &[[u32; 3]]| {
        let vertices = (0..6).map(|k| Vec3::from_ints(k, k * k, k * k * k));
        MeshShape::new(Arc::new(TriangleMesh::new(vertices, faces.iter().copied()).expect("legal")))
    };
    let fan = mesh(&[[0, 1, 2], [1, 0, 3], [4, 0, 1]]);
    assert_eq!(fan.edges_len(), 7);
    let shared = fan.sides(0)[0];
    assert_eq!(fan.faces_at_edge(shared).collect::<Vec<_>>(), [0, 1, 2]);
    assert_eq!(fan.faces_at_vertex(5).count(), 0);
    assert_eq!(fan.bounds().max(), Vec3::from_ints(4, 16, 64), "of faces");
    let line = mesh(&[[3, 2, 2], [5, 5, 5], [2, 3, 4]]);
    assert_eq!(line.ends(line.sides(0)[0]), [2, 3]);
    assert_eq!(line.ends(line.sides(0)[2]), [2, 3]);
    assert_eq!(line.faces_at_edge(line.sides(0)[0]).collect::<Vec<_>>(), [0, 2]);
    assert_eq!(line.faces_at_vertex(5).collect::<Vec<_>>(), [1]);
    assert_eq!(line.faces_at_vertex(2).collect::<Vec<_>>(), [0, 2]);
    let tetrahedron = mesh(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    assert!(tetrahedron.is_closed());
    let twisted = mesh(&[[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    assert!(!twisted.is_closed() && !fan.is_closed() && !line.is_closed());
}

/// A mesh that moves is near where it has gone, and refuses to leave the world.
#[test]
fn meshes_move() {
    let mut shape = MeshShape::new(Arc::new(field(&mut Pcg::new(1, 0)).mesh().expect("legal")));
    let rest = shape.clone();
    let way = Vec3::from_ints(0, 9, 0);
    let there: Vec<_> = shape.vertices().iter().map(|&p| p + way).collect();
    shape.move_to(&there).expect("in range");
    assert_eq!(shape.vertices(), there);
    assert_eq!(shape.bounds().min(), rest.bounds().min() + way);
    let mut faces = vec![];
    shape.faces_near(&shape.bounds(), &mut faces);
    assert_eq!(faces.len(), shape.mesh().faces().len());
    shape.faces_near(&rest.bounds(), &mut faces);
    assert!(faces.is_empty());
    assert!(shape.move_to(&there[1..]).is_err());
    assert_eq!(shape.vertices(), there);
}

/// Every refusal of a height field names what is wrong.
#[test]
fn fields_have_limits() {
    let new = |origin, step, columns, heights: &[Real]| {
        HeightField::new(origin, [step; 2], columns, heights.to_vec())
    };
    let flat = [Real::ZERO; 6];
    let far = Vec3::from_raw([Triangle::COORDINATE_MAX; 3]);
    let refused = |field: Result<HeightField, _>| field.expect_err("refused");
    let (out, count) = (ShapeError::OutOfRange, ShapeError::WrongCount);
    assert!(new(Vec3::ZERO, Real::ULP, 3, &flat).is_ok());
    assert!(new(-far, real!("40000"), 2, &flat).is_ok());
    assert_eq!(refused(new(Vec3::ZERO, Real::ONE, 1, &flat)), count("columns"));
    assert_eq!(refused(new(Vec3::ZERO, Real::ONE, 4, &flat)), count("heights"));
    assert_eq!(refused(new(Vec3::ZERO, Real::ONE, 6, &flat)), count("heights"));
    assert_eq!(refused(new(Vec3::ZERO, Real::ZERO, 3, &flat)), out("steps"));
    assert_eq!(refused(new(far, Real::ONE, 3, &flat)), out("origin"));
    for far in [Real::MIN, Real::MAX] {
        assert_eq!(refused(new(Vec3::ZERO, Real::ONE, 3, &[far; 6])), out("heights"));
        let spike = [Real::ZERO, far, Real::ZERO, Real::ONE];
        assert_eq!(refused(new(Vec3::ZERO, Real::ONE, 2, &spike)), out("heights"));
    }
    assert_eq!(refused(new(Vec3::ZERO, Real::MAX, 3, &flat)), ShapeError::TooLong);
    let cliff = [real!("-65536"), real!("65536"), Real::ZERO, Real::ONE];
    assert_eq!(refused(new(Vec3::ZERO, Real::ONE, 2, &cliff)), ShapeError::TooLong);
}
