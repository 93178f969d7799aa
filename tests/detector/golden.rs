//! The same bytes on every machine.

use verlock::geometry::{
    Feature, Intersection, intersection_triangle_triangle, orient3d, overlap_triangle_triangle,
};
use verlock::math::Pcg;
use verlock::{Hash, Vec3};

use super::overlap::CLASSES;
use super::{below, triangle};

#[test]
fn what_triangles_have_in_common_is_as_accepted() {
    let mut bytes = Vec::new();
    for (index, class) in (0..).zip(CLASSES) {
        let mut rng = Pcg::new(index, 103);
        for _ in 0..500 {
            let [a, b] = class.pair(&mut rng).map(triangle);
            let found = intersection_triangle_triangle(&a, &b);
            let points = found.as_ref().map_or(&[][..], Intersection::points);
            bytes.push(u8::from(overlap_triangle_triangle(&a, &b)));
            bytes.push(u8::try_from(points.len()).expect("at most 6"));
            for point in points {
                let raw = point.position.raw();
                raw.iter().for_each(|c| bytes.extend(c.to_le_bytes()));
                bytes.extend([point.on_a, point.on_b].map(|feature| match feature {
                    Feature::Vertex(corner) => corner,
                    Feature::Edge(edge) => 3 + edge,
                    Feature::Face => 6,
                }));
            }
        }
    }
    assert_eq!(Hash::of(&bytes).to_string(), "c3758e00c80d7bf759c22d1fea2e3cd2");
}

#[test]
fn signs_are_as_accepted() {
    let mut rng = Pcg::new(0, 104);
    let mut bytes = Vec::new();
    for bits in [1, 20, 30, 31, 41, 42, 61, 62] {
        for _ in 0..500 {
            let mut point =
                || Vec3::from_raw([(); 3].map(|()| below(&mut rng, 1 << bits) - (1 << (bits - 1))));
            let [a, b, c, d] = [(); 4].map(|()| point());
            bytes.push(orient3d(a, b, c, d) as u8);
        }
    }
    assert_eq!(Hash::of(&bytes).to_string(), "249d64d73862c2c25a51f50c56835c28");
}
