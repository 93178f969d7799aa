//! The nearest point of a mesh, against a look at every face.

use proptest::prelude::*;
use verlock::Vec3;
use verlock::geometry::closest_point_triangle;
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
