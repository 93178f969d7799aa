//! Which faces meet: exactly those, whatever the volumes.

use std::sync::Arc;

use proptest::prelude::*;
use proptest::sample::Index;
use verlock::Vec3;
use verlock::geometry::{Aabb, Triangle, TriangleMesh};
use verlock::partition::bvh::{CellBox, CellCylinder, CellSphere, Precision, Volume};

use super::{Soup, any_soup, brute, cases, triangles, valid};

/// Exact pairs are those of all pairs, before and after the vertices move; those of the volumes
/// are these and perhaps more. How many more there were.
fn finds_all<V: Volume>(soups: [Soup; 2], seed: u64) -> usize {
    let [a, b] = [soups[0].mesh(seed), soups[1].mesh(seed ^ 1)];
    let [mut tree_a, mut tree_b] = [&a, &b].map(valid::<V>);
    let mut more = 0;
    let mut faces = [&a, &b].map(|mesh| triangles(mesh, mesh.vertices()));
    for round in 0..3 {
        if round > 0 {
            // One, then the other.
            let places = soups[round - 1].moved(seed);
            let (tree, mesh) = if round == 1 { (&mut tree_a, &a) } else { (&mut tree_b, &b) };
            tree.refit(&places).expect("in range");
            tree.validate().expect("valid when moved");
            faces[round - 1] = triangles(mesh, &places);
        }
        let expected = brute(&faces[0], &faces[1]);
        let found = tree_a.pairs(&tree_b, Precision::Exact);
        assert_eq!(found, expected, "round {round}");
        assert_eq!(tree_a.overlaps(&tree_b, Precision::Exact), !expected.is_empty());
        let mut turned: Vec<_> = tree_b.pairs(&tree_a, Precision::Exact);
        turned.iter_mut().for_each(|pair| pair.reverse());
        turned.sort_unstable();
        assert_eq!(turned, expected, "the other way round");
        let near = tree_a.pairs(&tree_b, Precision::Volumes);
        assert!(near.is_sorted() && expected.iter().all(|pair| near.contains(pair)), "{near:?}");
        assert_eq!(tree_a.overlaps(&tree_b, Precision::Volumes), !near.is_empty());
        more += near.len() - expected.len();
    }
    more
}

/// The faces near a box are those whose boxes meet it.
fn finds_near<V: Volume>(mesh: &TriangleMesh, corners: [Vec3; 2]) {
    let query = Aabb::new(corners[0], corners[1]);
    let is_near = |(_, triangle): &(u32, &Triangle)| triangle.bounds().overlaps(&query);
    let faces: Vec<_> = mesh.triangles().collect();
    let expected: Vec<_> = (0..).zip(&faces).filter(is_near).map(|(face, _)| face).collect();
    assert_eq!(valid::<V>(&mesh.clone().into()).faces_near(&query), expected);
}

fn any_way() -> impl Strategy<Value = [i64; 3]> {
    prop::array::uniform3(-(1 << 40)..1_i64 << 40)
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn pairs_are_those_of_all_pairs(a in any_soup(), b in any_soup(), seed: u64, alike: bool) {
        // Alike, they meet more often.
        let soups = [a, if alike { Soup { faces: b.faces, ..a } } else { b }];
        finds_all::<CellBox>(soups, seed);
        finds_all::<CellSphere>(soups, seed);
        finds_all::<CellCylinder>(soups, seed);
    }

    #[test]
    fn faces_near_a_box_are_those_of_all(soup in any_soup(), seed: u64, ends: [Index; 2]) {
        let mesh = soup.mesh(seed);
        let corners = ends.map(|k| *k.get(mesh.vertices()));
        let point = [corners[0]; 2];
        let all = [Vec3::from_raw([i64::MIN; 3]), Vec3::from_raw([i64::MAX; 3])];
        for corners in [corners, point, all] {
            finds_near::<CellBox>(&mesh, corners);
            finds_near::<CellSphere>(&mesh, corners);
            finds_near::<CellCylinder>(&mesh, corners);
        }
    }

    /// A face is the same wherever its list of corners begins, and whichever way round it goes.
    #[test]
    fn the_order_of_corners_changes_nothing(soup in any_soup(), seed: u64) {
        let [a, b] = [soup.mesh(seed), soup.mesh(!seed)];
        let turned = |turn: fn([u32; 3]) -> [u32; 3]| {
            let faces = a.faces().iter().copied().map(turn);
            TriangleMesh::new(a.vertices().iter().copied(), faces).unwrap().into()
        };
        let tree = valid::<CellBox>(&b);
        let pairs = |mesh: Arc<TriangleMesh>| valid(&mesh).pairs(&tree, Precision::Exact);
        let expected = pairs(a.clone());
        prop_assert_eq!(&pairs(turned(|[a, b, c]| [b, c, a])), &expected);
        prop_assert_eq!(&pairs(turned(|[a, b, c]| [c, a, b])), &expected);
        prop_assert_eq!(&pairs(turned(|[a, b, c]| [c, b, a])), &expected);
    }

    /// Trees and pairs are the same wherever both meshes are, those of volumes included.
    #[test]
    fn moving_both_changes_nothing(soup in any_soup(), seed: u64, way in any_way()) {
        let soup = Soup { origin: 0, scattered: false, ..soup };
        let here = [soup.mesh(seed), soup.mesh(!seed)];
        let there = here.clone().map(|mesh| {
            let vertices = mesh.vertices().iter().map(|&p| p + Vec3::from_raw(way));
            TriangleMesh::new(vertices, mesh.faces().iter().copied()).unwrap().into()
        });
        let [a, b] = here.each_ref().map(valid::<CellCylinder>);
        let [c, d] = there.each_ref().map(valid::<CellCylinder>);
        prop_assert_eq!(a.shape_hash(), c.shape_hash());
        for precision in [Precision::Exact, Precision::Volumes] {
            prop_assert_eq!(a.pairs(&b, precision), c.pairs(&d, precision));
        }
    }
}

/// Stopping at the volumes finds strictly more somewhere, and the least with boxes here.
#[test]
fn volumes_are_coarser_than_triangles() {
    let soup = Soup { faces: 60, places: 6, step: 20, scattered: false, origin: 0 };
    let more = [
        finds_all::<CellBox>([soup; 2], 1),
        finds_all::<CellSphere>([soup; 2], 1),
        finds_all::<CellCylinder>([soup; 2], 1),
    ];
    assert!(more.iter().all(|&more| more > 0), "{more:?}");
}
