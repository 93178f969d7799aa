//! What is refused, and meshes made to hurt.

use std::sync::Arc;

use verlock::Vec3;
use verlock::geometry::{Triangle, TriangleMesh};
use verlock::partition::bvh::{Bvh, CellBox, CellCylinder, CellSphere, Precision, RefitError};

use super::{Soup, valid};

fn refused(change: impl FnOnce(&mut Vec<Vec3>)) -> RefitError {
    let soup = Soup { faces: 30, places: 5, step: 20, scattered: false, origin: 0 };
    let mesh = soup.mesh(1);
    let mut tree = valid::<CellBox>(&mesh);
    let before = tree.clone();
    let mut positions = mesh.vertices().to_vec();
    change(&mut positions);
    let error = tree.refit(&positions).expect_err("refused");
    assert_eq!(tree, before, "refused, but changed");
    error
}

#[test]
fn wrong_positions_are_refused_and_change_nothing() {
    const MAX: i64 = Triangle::COORDINATE_MAX;
    assert_eq!(refused(|p| p.truncate(9)), RefitError::WrongLength);
    assert_eq!(refused(|p| p.push(Vec3::ZERO)), RefitError::WrongLength);
    let far = |at: i64| move |p: &mut Vec<Vec3>| p[7] = Vec3::from_raw([0, at, 0]);
    assert_eq!(refused(far(MAX + 1)), RefitError::OutOfRange { vertex: 7 });
    assert_eq!(refused(far(-MAX - 1)), RefitError::OutOfRange { vertex: 7 });
    assert_eq!(refused(far(i64::MIN)), RefitError::OutOfRange { vertex: 7 });
    let long = refused(far(MAX));
    assert!(matches!(long, RefitError::TooLong { .. }), "{long}");
    assert_eq!(RefitError::WrongLength.to_string(), "mesh has another number of vertices");
    assert_eq!(long.to_string().split(" spans").count(), 2);
}

/// Faces in one place, faces at the corners of the range, and faces so spread that every cut by
/// the heuristic takes only a few away: the tree stays valid and small.
#[test]
fn hostile_meshes_make_sound_trees() {
    const MAX: i64 = Triangle::COORDINATE_MAX;
    let point = |at: i64| [Vec3::from_raw([at; 3])];
    let soup = |places: &[Vec3]| {
        let faces = (0..).take(places.len()).map(|vertex: u32| [vertex; 3]);
        Arc::new(TriangleMesh::new(places.iter().copied(), faces).expect("a mesh"))
    };
    let one = vec![Vec3::ZERO; 400];
    let corners: Vec<_> =
        (0..400).flat_map(|k| point(if k % 3 == 0 { MAX } else { -MAX })).collect();
    // Each distance twice as long as the one before, many times over.
    let spread: Vec<_> = (0..1200).flat_map(|k| point((1 << (k % 60)) - MAX)).collect();
    let line: Vec<_> = (0..3000).map(|k: i64| Vec3::from_raw([k * k * k, 0, 0])).collect();
    for places in [one, corners, spread, line] {
        let mesh = soup(&places);
        let tree = valid::<CellBox>(&mesh);
        valid::<CellSphere>(&mesh);
        valid::<CellCylinder>(&mesh);
        assert!(tree.nodes() <= places.len() / 2, "{} nodes", tree.nodes());
        let pairs = tree.pairs(&tree, Precision::Exact);
        let mut sorted = places.clone();
        sorted.sort_unstable();
        let groups = sorted.chunk_by(|a, b| a == b);
        assert_eq!(pairs.len(), groups.map(|group| group.len().pow(2)).sum::<usize>());
    }
}

/// Far apart along one axis only, by a raw unit, or not at all.
#[test]
fn trees_far_apart_do_not_meet() {
    let sheet = |x: i64, y: i64| {
        let corners = [[x, y, 0], [x + 64, y, 0], [x, y + 64, 0]].map(Vec3::from_raw);
        Bvh::<CellBox>::new(Arc::new(TriangleMesh::new(corners, [[0, 1, 2]]).expect("a mesh")))
    };
    let here = sheet(0, 0);
    for away in [65, 1 << 28, (1 << 28) + 1, 1 << 29, 1 << 31, 1 << 32, 1 << 59] {
        for other in [sheet(away, 0), sheet(-away, 0), sheet(0, away), sheet(0, -away)] {
            assert!(here.pairs(&other, Precision::Volumes).is_empty());
            assert!(!other.overlaps(&here, Precision::Volumes));
        }
    }
    assert_eq!(here.pairs(&sheet(64, 0), Precision::Exact), [[0, 0]]);
    assert_eq!(here.pairs(&sheet(-64, 0), Precision::Exact), [[0, 0]]);
    assert!(here.pairs(&sheet(1, 64), Precision::Exact).is_empty());
    assert_eq!(here.pairs(&sheet(1, 64), Precision::Volumes), [[0, 0]]);
}
