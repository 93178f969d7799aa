//! Whole meshes against looking at every pair of faces.

use std::sync::Arc;

use verlock::collision::{FeatureKind, MeshMotion, MeshShape};
use verlock::geometry::sweep::{Motion, Sweep};
use verlock::geometry::{Triangle, TriangleMesh};
use verlock::math::{Pcg, Unit};
use verlock::partition::bvh::Precision;
use verlock::{Real, Vec3};

use super::number;

/// Faces between random vertices around a place; some share corners, some are lines or points.
fn soup(rng: &mut Pcg, centre: [i64; 3], size: i64) -> MeshShape {
    let vertices: Vec<_> =
        (0..9).map(|_| Vec3::from_raw(centre.map(|c| c + number(rng, size)))).collect();
    let faces = (0..10).map(|_| [(); 3].map(|()| rng.below(9)));
    MeshShape::new(Arc::new(TriangleMesh::new(vertices, faces).expect("in range")))
}

fn moved(rng: &mut Pcg, shape: &MeshShape, by: [i64; 3], own: i64) -> Vec<Vec3> {
    let corner = |&p: &Vec3| p + Vec3::from_raw(by.map(|c| c + number(rng, own)));
    shape.vertices().iter().map(corner).collect()
}

/// The faces in motion.
fn faces(shape: &MeshShape, end: &[Vec3]) -> Vec<Motion<Triangle>> {
    let faces = shape.mesh().faces().iter();
    let triangle = |corners: &[u32; 3], positions: &[Vec3]| {
        Triangle::new(corners.map(|v| positions[v as usize])).expect("in range")
    };
    faces.map(|f| Motion::new(triangle(f, shape.vertices()), triangle(f, end))).collect()
}

/// Returns whether they touch.
fn check(rng: &mut Pcg, size: i64, gap: i64) -> bool {
    let away = [number(rng, size), number(rng, size), 9 * size / 4];
    let [a, b] = [soup(rng, [0; 3], size), soup(rng, away, size)];
    let rise = [0, 0, number(rng, size) + size];
    let ends_a = moved(rng, &a, rise, size / 4);
    let ends_b = moved(rng, &b, [0; 3], size / 4);
    let sweep = Sweep { gap: Real::from_raw(gap), ..Sweep::default() };
    let motion = |shape, ends| MeshMotion::new(shape, ends).expect("in range");
    let (moving_a, moving_b) = (motion(&a, &ends_a), motion(&b, &ends_b));
    let found = moving_a.time_of_impact(&moving_b, &sweep);
    let mut first = None;
    for face_a in faces(&a, &ends_a) {
        for &face_b in &faces(&b, &ends_b) {
            let impact = sweep.triangle_triangle(face_a, face_b);
            let time = impact.map(|impact| impact.time);
            first = [first, time].into_iter().flatten().min();
        }
    }
    match (&found, first) {
        (None, None) => {}
        (Some(found), Some(first)) => {
            let off = (found.time.raw() - first.raw()).abs();
            assert!(off <= 64 || found.is_cut, "{found:?}, all pairs: {first}");
            assert!(found.features.is_sorted(), "{found:?}");
            let kinds = found.features.iter().map(|features| features.map(|f| f.kind()));
            use FeatureKind::{Edge, Face, Vertex};
            let legal = [[Vertex, Face], [Face, Vertex], [Edge, Edge], [Face, Face]];
            assert!(kinds.clone().all(|kinds| legal.contains(&kinds)), "{found:?}");
        }
        (found, first) => panic!("{found:?}, all pairs: {first:?}"),
    }
    let time = moving_a.advance(&moving_b, &sweep);
    let [mut landed_a, mut landed_b] = [a.clone(), b.clone()];
    landed_a.move_to(&moving_a.at(time)).expect("in range");
    landed_b.move_to(&moving_b.at(time)).expect("in range");
    let met = landed_a.tree().overlaps(landed_b.tree(), Precision::Exact);
    let met_at_start = a.tree().overlaps(b.tree(), Precision::Exact);
    assert_eq!(met, met_at_start, "{time}");
    assert!(!met || time == Unit::ZERO);
    match found {
        Some(found) => assert!(time <= found.time),
        None => assert_eq!(time, Unit::ONE),
    }
    first.is_some()
}

fn all(seed: u64, pairs: u32) {
    let mut rng = Pcg::new(seed, 31);
    let mut hits = 0;
    for round in 0..pairs {
        let size = [20, 1 << 20, 1 << 24, 1 << 31, 1 << 37][rng.below(5) as usize];
        let gap = if round % 4 == 0 { size / 8 } else { 2 };
        hits += u32::from(check(&mut rng, size, gap));
    }
    println!("{hits} of {pairs} touch");
    assert!(pairs / 5 < hits && hits < pairs, "{hits}");
}

#[test]
fn meshes_touch_when_their_faces_do() {
    all(1, 60);
}

#[test]
#[ignore = "ten thousand pairs of meshes: some minutes with --release"]
fn ten_thousand_meshes_touch_when_their_faces_do() {
    all(2, 10_000);
}
