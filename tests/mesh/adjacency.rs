//! What touches, by looking at every pair.

use std::collections::BTreeSet;

use proptest::prelude::*;
use verlock::Vec3;
use verlock::geometry::{Adjacency, Edge, Hinge, TriangleMesh};

use super::{any_mesh, cases, mesh};

/// The faces that two different vertices share.
fn shared(mesh: &TriangleMesh, a: u32, b: u32) -> Vec<u32> {
    let has = |corners: &[u32; 3]| a != b && corners.contains(&a) && corners.contains(&b);
    (0..).zip(mesh.faces()).filter(|(_, corners)| has(corners)).map(|(face, _)| face).collect()
}

/// The lowest vertex that each vertex can reach, taken over from neighbours until nothing changes.
fn lowest_reached(mesh: &TriangleMesh) -> Vec<usize> {
    let mut lowest: Vec<usize> = (0..mesh.vertices().len()).collect();
    loop {
        let before = lowest.clone();
        for corners in mesh.faces() {
            let least = corners.map(|vertex| lowest[vertex as usize]).into_iter().min().unwrap();
            corners.iter().for_each(|&vertex| lowest[vertex as usize] = least);
        }
        if lowest == before {
            return lowest;
        }
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn adjacency_is_what_looking_at_every_pair_finds(mesh in any_mesh()) {
        let adjacency = Adjacency::new(&mesh);
        let count = u32::try_from(mesh.vertices().len()).unwrap();
        let mut edges = adjacency.edges();
        let mut hinges = adjacency.hinges();
        let mut boundary = adjacency.boundary();
        for a in 0..count {
            let joined: Vec<_> = (0..count).filter(|&b| !shared(&mesh, a, b).is_empty()).collect();
            prop_assert_eq!(adjacency.neighbours(a), &joined);
            for b in a..count {
                let faces = shared(&mesh, a, b);
                let expected = Edge { ends: [a, b], faces: &faces };
                if faces.is_empty() {
                    prop_assert_eq!(adjacency.edge(a, b), None);
                    continue;
                }
                prop_assert_eq!(edges.next(), Some(expected));
                prop_assert_eq!(adjacency.edge(b, a), Some(expected));
                if faces.len() == 1 {
                    prop_assert_eq!(boundary.next(), Some([a, b]));
                }
                let tip = |&face: &u32| {
                    mesh.faces()[face as usize].into_iter().find(|&c| c != a && c != b)
                };
                let tips: Vec<u32> = faces.iter().filter_map(tip).collect();
                if let (2, &[c, d]) = (faces.len(), tips.as_slice())
                    && c != d
                {
                    prop_assert_eq!(hinges.next(), Some(Hinge { ends: [a, b], tips: [c, d] }));
                }
            }
        }
        prop_assert_eq!((edges.next(), boundary.next(), hinges.next()), (None, None, None));
        prop_assert_eq!(adjacency.neighbours(count), &[0; 0]);
        prop_assert_eq!(adjacency.neighbours(u32::MAX), &[0; 0]);
    }

    #[test]
    fn components_are_what_reaches_one_another(mesh in any_mesh()) {
        let lowest = lowest_reached(&mesh);
        let firsts: BTreeSet<usize> = lowest.iter().copied().collect();
        let number = |&low: &usize| firsts.range(..low).count() as u32;
        let expected: Vec<_> = lowest.iter().map(number).collect();
        prop_assert_eq!(Adjacency::new(&mesh).components(), expected);
    }
}

/// How many edges have 1, 2 and more faces, and how many components there are.
fn census(mesh: &TriangleMesh) -> [usize; 4] {
    let adjacency = Adjacency::new(mesh);
    let with =
        |faces: fn(usize) -> bool| adjacency.edges().filter(|edge| faces(edge.faces.len())).count();
    let components: BTreeSet<u32> = adjacency.components().into_iter().collect();
    [with(|n| n == 1), with(|n| n == 2), with(|n| n > 2), components.len()]
}

#[test]
fn fixtures_are_connected_as_they_should_be() {
    let sizes = |mesh: &TriangleMesh| (mesh.vertices().len(), mesh.faces().len());
    let (cube, curtain, plant) = (mesh("cube.obj"), mesh("curtain.obj"), mesh("plant.obj"));
    assert_eq!((sizes(&cube), census(&cube)), ((8, 12), [0, 18, 0, 1]));
    // 80 edges around it; inside, 2 * 20 * 19 along the rows and columns and 400 diagonals.
    assert_eq!((sizes(&curtain), census(&curtain)), ((441, 800), [80, 1160, 0, 1]));
    // Open below, with three edges there and 14 around each of 8 leaves; a leaf's foot has 3 faces.
    let leaves = 8 * 13;
    assert_eq!((sizes(&plant), plant.faces().len() - leaves), ((144, 179), 75));
    assert_eq!([census(&plant)[0], census(&plant)[2], census(&plant)[3]], [3 + 8 * 14, 8, 1]);
    for mesh in [cube, curtain, plant] {
        assert_eq!(mesh.degenerate_faces().count(), 0);
    }
}

#[test]
fn curtain_and_plant_stand_where_they_should() {
    let highest = |mesh: &TriangleMesh| mesh.vertices().iter().map(|p| p.y).max();
    let lowest = |mesh: &TriangleMesh| mesh.vertices().iter().map(|p| p.y).min();
    let (curtain, plant) = (mesh("curtain.obj"), mesh("plant.obj"));
    let two = Vec3::from_ints(0, 2, 0).y;
    assert_eq!((lowest(&curtain), highest(&curtain)), (Some(Vec3::ZERO.y), Some(two)));
    assert_eq!(lowest(&plant), Some(Vec3::ZERO.y));
    assert_eq!(plant.vertices().iter().filter(|p| p.y == Vec3::ZERO.y).count(), 3, "its root");
}

#[test]
fn odd_edges_are_shown_as_they_are() {
    let mesh = |faces: &[[u32; 3]]| {
        TriangleMesh::new([Vec3::ZERO; 6], faces.iter().copied()).expect("all in range")
    };
    let two_sided = mesh(&[[0, 1, 2], [0, 2, 1]]);
    assert_eq!(census(&two_sided), [0, 3, 0, 4], "three vertices are alone");
    assert_eq!(Adjacency::new(&two_sided).hinges().count(), 0, "nothing is across");

    let book = mesh(&[[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
    assert_eq!(census(&book), [6, 0, 1, 2]);
    assert_eq!(Adjacency::new(&book).edge(1, 0).map(|edge| edge.faces.len()), Some(3));

    let line = mesh(&[[3, 3, 1], [2, 2, 2], [1, 3, 0]]);
    let adjacency = Adjacency::new(&line);
    assert_eq!(
        adjacency.edges().map(|edge| edge.ends).collect::<Vec<_>>(),
        [[0, 1], [0, 3], [1, 3]]
    );
    assert_eq!(adjacency.edge(1, 3).map(|edge| edge.faces), Some(&[0, 2][..]));
    assert_eq!(adjacency.hinges().count(), 0, "a line has no corner across");
    assert_eq!(adjacency.components(), [0, 0, 1, 0, 2, 3]);
}
