//! Deviations, against points taken from all over and every face.

use std::time::Instant;

use proptest::prelude::*;
use verlock::geometry::{Triangle, TriangleMesh};
use verlock::partition::bvh::Farthest;
use verlock::{Real, Vec3};

use super::{moved, scaled, soup, tree};
use crate::support::float::{cross, dot, length, sub};
use crate::support::meshes::{SHAPES, shape};

/// Metres that floats and rounded points may be off.
const ROUNDING: f64 = 1e-6;

type Point = [f64; 3];

fn at(a: Point, b: Point, t: f64) -> Point {
    [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * t)
}

/// From a point to a triangle: to its plane if the foot is inside, else to the nearest edge.
fn distance(p: Point, corners: [Point; 3]) -> f64 {
    let [a, b, c] = corners;
    let normal = cross(sub(b, a), sub(c, a));
    let edges = [(a, b), (b, c), (c, a)];
    let inside =
        |&(from, to): &(Point, Point)| dot(cross(normal, sub(to, from)), sub(p, from)) >= 0.0;
    if dot(normal, normal) > 0.0 && edges.iter().all(inside) {
        return dot(normal, sub(p, a)).abs() / length(normal);
    }
    let to_edge = |(from, to): (Point, Point)| {
        let way = sub(to, from);
        let t = dot(sub(p, from), way) / dot(way, way).max(1e-300);
        length(sub(p, at(from, to, t.clamp(0.0, 1.0))))
    };
    edges.into_iter().map(to_edge).fold(f64::MAX, f64::min)
}

fn corners(triangle: &Triangle) -> [Point; 3] {
    triangle.corners().map(Vec3::to_f64)
}

/// From a point to a mesh, in floats.
fn to_mesh(p: Point, mesh: &[[Point; 3]]) -> f64 {
    mesh.iter().map(|&corners| distance(p, corners)).fold(f64::MAX, f64::min)
}

/// The greatest distance of points of one mesh from another, and how far from the next of these
/// points any other is at most: `steps` along each edge.
fn sampled(from: &TriangleMesh, to: &TriangleMesh, steps: u32) -> (f64, f64) {
    let to: Vec<_> = to.triangles().map(|triangle| corners(&triangle)).collect();
    let (mut greatest, mut apart) = (0.0_f64, 0.0_f64);
    for triangle in from.triangles() {
        let [a, b, c] = corners(&triangle);
        for (i, j) in (0..=steps).flat_map(|i| (0..=steps - i).map(move |j| (i, j))) {
            let (u, v) = (f64::from(i) / f64::from(steps), f64::from(j) / f64::from(steps));
            let point = [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * u + (c[k] - a[k]) * v);
            greatest = greatest.max(to_mesh(point, &to));
        }
        // A point is within a cell, whose longest edge bounds the way to its nearest corner.
        let longest = [sub(b, a), sub(c, b), sub(a, c)].map(length);
        apart = longest.into_iter().fold(apart, f64::max);
    }
    (greatest, apart / f64::from(steps))
}

/// Checks a deviation that was told.
fn check(from: &TriangleMesh, to: &TriangleMesh, told: Farthest, steps: u32, what: &str) {
    let [at_least, at_most] = [told.at_least, told.at_most].map(Real::to_f64);
    let (greatest, apart) = sampled(from, to, steps);
    assert!(greatest <= at_most + ROUNDING, "{what}: {greatest} is farther than {at_most}");
    let nearly = (at_least * (1.0 + 1.0 / 256.0)).max(at_least + 4e-6) + ROUNDING;
    assert!(at_most <= nearly, "{what}: {at_least} to {at_most}");
    assert!(at_least <= greatest + apart + ROUNDING, "{what}: {at_least} where {greatest} is met");
    // It is met where it is said to be.
    let [from, to] =
        [from, to].map(|mesh| mesh.triangles().map(|t| corners(&t)).collect::<Vec<_>>());
    let point = told.point.to_f64();
    assert!(to_mesh(point, &from) < ROUNDING, "{what}: {point:?} is not on it");
    let there = to_mesh(point, &to);
    assert!((at_least - ROUNDING..=at_most + ROUNDING).contains(&there), "{what}: {there}");
}

/// Ten shapes, each reduced: no sampled point is farther away than is told, and what is told is
/// met.
#[test]
fn shapes_are_as_far_off_as_is_told() {
    for (name, shape) in SHAPES {
        let mesh = shape(1);
        let small = mesh.decimated(130).expect("faces");
        let told = tree(&mesh).deviation(&tree(&small));
        check(&mesh, &small, told.of_original, 1, name);
        check(&small, &mesh, told.of_proxy, 3, name);
    }
}

/// The same, more closely and for larger meshes.
#[test]
#[ignore = "every point against every face: 3 min with --release"]
fn large_shapes_are_as_far_off_as_is_told() {
    for (name, shape) in SHAPES {
        let mesh = shape(3);
        for faces in [1000, 300] {
            let small = mesh.decimated(faces).expect("faces");
            let told = tree(&mesh).deviation(&tree(&small));
            println!("{name}: {} faces to {}: {told:?}", mesh.faces().len(), small.faces().len());
            check(&mesh, &small, told.of_original, 3, name);
            check(&small, &mesh, told.of_proxy, 12, name);
        }
    }
}

/// Two plates a metre apart, of which one is a finger longer; a mesh and itself.
#[test]
fn plain_cases_are_exact() {
    let plate = |z: i32, length: i32| {
        let corners = [(0, 0), (length, 0), (length, 4), (0, 4)];
        let corners = corners.map(|(x, y)| Vec3::from_ints(x, y, z));
        TriangleMesh::new(corners, [[0, 1, 2], [0, 2, 3]]).expect("a plate")
    };
    let told = tree(&plate(0, 8)).deviation(&tree(&plate(1, 8)));
    assert_eq!([told.at_most(), told.of_original.at_least], [Real::ONE; 2]);
    // The end of the longer one is 3 m farther, and 5 m away from the end of the shorter one.
    let told = tree(&plate(0, 11)).deviation(&tree(&plate(4, 8)));
    let [far, near] = [told.of_original, told.of_proxy];
    assert!((Real::from_int(5) - far.at_least).raw() <= 1, "{far:?}");
    assert_eq!(far.point.x, Real::from_int(11));
    assert!((near.at_most - Real::from_int(4)).raw() <= 2, "{near:?}");

    let rock = tree(&shape("rock", 1));
    let told = rock.deviation(&rock);
    assert_eq!((told.of_original.at_least, told.of_proxy.at_least), (Real::ZERO, Real::ZERO));
    assert!(told.at_most().raw() <= 64 + 2, "{told:?}");
}

/// Moved meshes are as far apart, to the bit; larger ones as much farther, but for rounding.
#[test]
fn deviations_move_and_grow_with_the_meshes() {
    let [mesh, small] = [shape("gear", 1), shape("gear", 1).decimated(150).expect("faces")];
    let told = tree(&mesh).deviation(&tree(&small));
    let way = Vec3::from_raw([(1 << 60) - (1 << 30), -123_456_789, 1 << 45]);
    let elsewhere = tree(&moved(&mesh, way)).deviation(&tree(&moved(&small, way)));
    for (here, there) in
        [(told.of_original, elsewhere.of_original), (told.of_proxy, elsewhere.of_proxy)]
    {
        assert_eq!(Farthest { point: here.point + way, ..here }, there);
    }
    let larger = tree(&scaled(&mesh, 1 << 13)).deviation(&tree(&scaled(&small, 1 << 13)));
    let [once, often] = [told, larger].map(|told| told.of_original.at_least.to_f64());
    assert!((often / once / f64::from(1 << 13) - 1.0).abs() < 0.01, "{often} of {once}");
}

/// Faces as long as they can be, cut along the same edges over and over: cuts are rounded by more
/// than a raw unit there.
#[test]
fn the_largest_faces_are_done_in_time() {
    const PLACES: [[i64; 3]; 7] = [
        [1677065944136, 1349592236934, 1132295651383],
        [372409980928, 1064230414260, 1582093007217],
        [2179250013993, 65887805029, 1754293629857],
        [506010991720, 1467053758716, 401305749307],
        [579098163305, 1155966321293, 2004376579153],
        [168730173537, 625224854264, 530547307489],
        [594033260310, 1765493859976, 1383809912083],
    ];
    const FACES: [[u32; 3]; 14] = [
        [6, 0, 2],
        [4, 1, 1],
        [5, 0, 3],
        [6, 5, 3],
        [5, 1, 6],
        [5, 6, 4],
        [1, 5, 6],
        [0, 2, 6],
        [2, 0, 3],
        [5, 2, 2],
        [0, 6, 1],
        [6, 2, 4],
        [6, 5, 1],
        [2, 3, 1],
    ];
    for shift in [0, 2, 4, 8] {
        let places = PLACES.map(|p| Vec3::from_raw(p.map(|c| (c >> shift) - (1 << 40))));
        let mesh = TriangleMesh::new(places, FACES).expect("in range");
        let small = mesh.decimated(11).expect("faces");
        let start = Instant::now();
        let told = tree(&mesh).deviation(&tree(&small));
        let taken = start.elapsed();
        assert!(taken.as_secs() < 20, "{taken:?}");
        let Farthest { at_least, at_most, .. } = told.of_original;
        let (greatest, apart) = sampled(&mesh, &small, 8);
        // Floats know places so far away to a thousandth of a millimetre.
        assert!(greatest <= at_most.to_f64() + 1e-3, "{greatest} is farther than {at_most}");
        assert!(at_least.to_f64() <= greatest + apart + 1e-3, "{at_least}, {greatest} is met");
    }
}

proptest! {
    #![proptest_config(super::cases(40))]

    /// Soups, whose faces cross, repeat and lie in lines, of every size.
    #[test]
    fn soups_are_as_far_off_as_is_told(
        seed: u64,
        faces in [1..12_u32, 1..12],
        places in 2..6_u32,
        bits in 8..26_u32,
    ) {
        let [a, b] = [0, 1].map(|k| soup(seed.wrapping_add(k), faces[k as usize], places, bits));
        let told = tree(&a).deviation(&tree(&b));
        check(&a, &b, told.of_original, 8, "of the first");
        check(&b, &a, told.of_proxy, 8, "of the second");
    }
}
