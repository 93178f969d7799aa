//! The shapes that are reduced.

use super::{Topology, is_surface};
use crate::support::meshes::{SHAPES, shape};

/// Parts, handles and boundaries of every shape are what its name says: the others are balls.
#[test]
fn shapes_are_surfaces_of_their_kind() {
    for (name, shape) in SHAPES {
        let (parts, euler, rims) = match name {
            "torus" | "knot" | "gear" => (1, 0, 0),
            "vase" | "terrain" => (1, 1, 1),
            "tree" => (21, 11 * 2 + 10, 10),
            "room" => (10, 9 * 2 + 1, 1),
            _ => (1, 2, 0),
        };
        for detail in [1, 2] {
            let mesh = shape(detail);
            assert!(is_surface(&mesh), "{name} {detail}");
            assert_eq!(mesh.degenerate_faces().count(), 0, "{name} {detail}");
            assert_eq!(Topology::of(&mesh), Topology { parts, euler, rims }, "{name} {detail}");
        }
    }
}

/// Closed shapes enclose a volume, and from outside, not from inside.
#[test]
fn shapes_face_outward() {
    for name in ["torus", "knot", "spring", "rock", "gear", "stairs"] {
        let mesh = shape(name, 1);
        let volume: i128 = mesh
            .triangles()
            .map(|triangle| {
                let [a, b, c] =
                    triangle.corners().map(|corner| corner.raw().map(|k| i128::from(k >> 8)));
                a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            })
            .sum();
        assert!(volume > 0, "{name}: {volume}");
    }
}
