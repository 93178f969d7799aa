//! The table of pairs: every two kinds of shapes have a distance, overlap, and are cast.

use std::sync::Arc;

use verlock::collision::{MeshShape, Shape, cast, closest_points, distance, overlap};
use verlock::geometry::{
    Capsule, ConvexHull, Cuboid, Grid, HalfSpace, HeightField, Sphere, Triangle, TriangleMesh,
};
use verlock::math::{Unit, UnitVec3};
use verlock::{Real, Vec3, real};

use super::{KINDS, moved};

/// A shape of that kind whose lowest or, if it is to be below, highest point is the origin. All are
/// flat there, or round.
fn shape(kind: &str, is_below: bool) -> Shape {
    let up = |y: i32| Vec3::from_ints(0, if is_below { -y } else { y }, 0);
    let flat = |x: i32, z: i32| Vec3::from_ints(x, 0, z);
    match kind {
        "half-space" => {
            let normal = if is_below { UnitVec3::Y } else { -UnitVec3::Y };
            HalfSpace::new(Vec3::ZERO, normal).expect("legal").into()
        }
        "sphere" => Sphere::new(up(2), real!("2")).expect("legal").into(),
        "capsule" => Capsule::new([up(1), up(1) + Vec3::X], Real::ONE).expect("legal").into(),
        "box" => Cuboid::upright(up(1), Vec3::ONE).expect("legal").into(),
        "hull" => {
            let base = [flat(-1, -1), flat(2, -1), flat(0, 2), up(3)];
            ConvexHull::around(base).expect("legal").into()
        }
        "mesh" => {
            let edge = |x, z| Vec3::from_ints(x, 0, z);
            let grid = Grid {
                corner: Vec3::from_ints(-3, 0, -3),
                edge_u: edge(6, 0),
                edge_v: edge(0, 6),
                columns: 4,
                rows: 4,
            };
            MeshShape::new(Arc::new(TriangleMesh::grid(&grid).expect("legal"))).into()
        }
        "height field" => {
            let corner = Vec3::from_ints(-3, 0, -3);
            HeightField::new(corner, [real!("3"); 2], 3, vec![Real::ZERO; 9]).expect("legal").into()
        }
        _ => Triangle::new([flat(-2, -1), flat(3, -2), flat(0, 3)]).expect("legal").into(),
    }
}

/// One above the other: apart by what they are lifted, touching, and in each other.
#[test]
fn every_two_kinds_have_a_distance() {
    let gap = real!("0.75");
    for below in KINDS {
        for above in KINDS {
            let (a, b) = (shape(below, true), shape(above, false));
            let case = format!("{below} below {above}");
            let lifted = moved(&b, Vec3::Y * gap);
            assert_eq!(distance(&a, &lifted), gap, "{case}");
            let found = closest_points(&a, &lifted).expect("apart");
            assert_eq!(found.normal, UnitVec3::Y, "{case}");
            assert_eq!(found.on_b - found.on_a, Vec3::Y * gap, "{case}");
            assert!(overlap(&a, &b), "{case} touching");
            assert!(!overlap(&a, &moved(&b, Vec3::from_raw([0, 1, 0]))), "{case} a step apart");
            assert_eq!(distance(&a, &b), Real::ZERO, "{case}");
            // A quarter of the way down, less a few nanometres where the radius is not certain.
            let hit = cast(&lifted, Vec3::Y * real!("-3"), &a).expect(&case);
            assert!((0..=4).contains(&(Unit::ONE.raw() / 4 - hit.time.raw())), "{case}: {hit:?}");
            assert_eq!(hit.touch.map(|touch| touch.normal), Some(-UnitVec3::Y), "{case}");
            assert_eq!(cast(&lifted, Vec3::Y, &a), None, "{case}");
            assert_eq!(cast(&b, Vec3::Y, &a).map(|cast| cast.touch), Some(None), "{case}");
        }
    }
}

/// The table in the documentation names every kind, and no other.
#[test]
fn the_table_names_every_kind() {
    let source = include_str!("../../src/collision/mod.rs");
    let rows: Vec<_> = source.lines().filter_map(|line| line.strip_prefix("//! | ")).collect();
    for kind in KINDS {
        assert!(rows.iter().any(|row| row.starts_with(kind)), "no row of {kind}");
    }
}
