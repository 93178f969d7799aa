//! The nearest point of a mesh, against a look at every face.

use proptest::prelude::*;
use verlock::Vec3;
use verlock::geometry::{Triangle, TriangleMesh, closest_point_triangle};
use verlock::math::Pcg;

use super::{soup, tree};

proptest! {
    #![proptest_config(super::cases(100))]

    /// No face is nearer, and of equally near ones it is the lowest.
    #[test]
    fn no_face_is_nearer(seed: u64, faces in 1..80_u32, places in 2..9_u32, bits in 0..38_u32) {
        let mesh = soup(seed, faces, places, bits);
        let tree = tree(&mesh);
        let mut rng = Pcg::new(seed, 8);
        for _ in 0..20 {
            let mut along = || i64::from(rng.below(4 * places + 8)) * (1 << bits) / 3 - (4 << bits);
            let point = Vec3::from_raw([along(), along(), along()]);
            let all = (0..).zip(mesh.triangles()).map(|(face, triangle)| {
                let nearest = closest_point_triangle(point, &triangle);
                ((point - nearest.position).length_sq_wide(), face)
            });
            let found = tree.nearest(point);
            prop_assert_eq!(Some((found.distance_sq, found.face)), all.min());
            prop_assert_eq!(found.point, closest_point_triangle(point, &mesh.triangle(found.face)));
        }
    }
}

/// Points far outside of where vertices can be have a nearest point like any other.
#[test]
fn any_point_is_near_something() {
    const FAR: i64 = Triangle::COORDINATE_MAX;
    for side in [-1, 1] {
        let corner = Vec3::from_raw([side * FAR; 3]);
        let at = |k: usize| {
            let mut place = corner.raw();
            place[k] -= side * 99;
            Vec3::from_raw(place)
        };
        let mesh = TriangleMesh::new([corner, at(0), at(1), at(2)], [[0, 1, 2], [1, 2, 3]]);
        let tree = tree(&mesh.expect("in range"));
        for raw in [i64::MAX, i64::MIN, side * (FAR + 1)] {
            let found = tree.nearest(Vec3::from_raw([raw; 3]));
            let way = u128::from(raw.abs_diff(side * FAR));
            if raw.signum() == side {
                assert_eq!((found.face, found.distance_sq), (0, 3 * way * way));
                assert_eq!(found.point.position, corner);
            } else {
                // The plane across from the corner is 33 nearer along every axis.
                assert_eq!((found.face, found.distance_sq), (1, 3 * (way - 33) * (way - 33)));
            }
        }
    }
}
