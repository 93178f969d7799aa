//! A point beside small meshes, against the definition: which features it is nearest to, of all
//! around, and whether it is inside.

use std::collections::BTreeMap;
use std::sync::Arc;

use verlock::collision::{FeatureId, FeatureKind, MeshShape, manifolds_sphere_surface};
use verlock::geometry::{Sphere, Surface, TriangleMesh};
use verlock::math::Pcg;
use verlock::{Real, Vec3};

use super::solids::Solid;

type Point = [i64; 3];

fn sub(a: Point, b: Point) -> Point {
    [0, 1, 2].map(|k| a[k] - b[k])
}

fn dot(a: Point, b: Point) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Everything that touches the point, as features with separations.
fn touches(shape: &MeshShape, point: Point, radius: i64) -> BTreeMap<FeatureId, Real> {
    let sphere = Sphere::new(Vec3::from_raw(point), Real::ZERO).expect("legal");
    let mut manifolds = Vec::new();
    manifolds_sphere_surface(&sphere, shape, Real::from_raw(radius), &mut manifolds);
    let contacts = manifolds.iter().flat_map(|manifold| manifold.contacts());
    contacts.map(|contact| (contact.features[1], contact.separation)).collect()
}

/// Whether the region of a feature holds a point: closed for edges and vertices, open for faces,
/// which so leave their borders to what is smaller.
fn holds(shape: &MeshShape, feature: FeatureId, point: Point) -> bool {
    let at = |vertex: u32| shape.position(vertex).raw();
    let index = feature.index();
    match feature.kind() {
        FeatureKind::Face => {
            let [a, b, c] = shape.corners(index).map(at);
            let normal = cross(sub(b, a), sub(c, a));
            let inside = |p, q| dot(cross(normal, sub(q, p)), sub(point, p)) > 0;
            inside(a, b) && inside(b, c) && inside(c, a)
        }
        FeatureKind::Edge => {
            let [a, b] = shape.ends(index).map(at);
            let (edge, way) = (sub(b, a), sub(point, a));
            let beyond = |face: u32| {
                let tip = shape.corners(face).into_iter().find(|v| !shape.ends(index).contains(v));
                let tip = sub(at(tip.expect("a triangle")), a);
                dot(tip, way) * dot(edge, edge) <= dot(edge, way) * dot(edge, tip)
            };
            let along = dot(edge, way);
            0 < along && along < dot(edge, edge) && shape.faces_at_edge(index).all(beyond)
        }
        FeatureKind::Vertex => {
            let way = sub(point, at(index));
            let mut others = shape.faces_at_vertex(index).flat_map(|face| shape.corners(face));
            others.all(|other| dot(way, sub(at(other), at(index))) <= 0)
        }
    }
}

/// All features whose regions hold a point.
fn expected(shape: &MeshShape, point: Point) -> Vec<FeatureId> {
    let faces = shape.mesh().faces().len() as u32;
    let used = |vertex: &u32| shape.faces_at_vertex(*vertex).next().is_some();
    let vertices = (0..shape.vertices().len() as u32).filter(used).map(FeatureId::vertex);
    let edges = (0..shape.edges_len() as u32).map(FeatureId::edge);
    let all = vertices.chain(edges).chain((0..faces).map(FeatureId::face));
    all.filter(|&feature| holds(shape, feature, point)).collect()
}

/// Open and crumpled sheets, from both sides: what is found is what the regions say.
#[test]
fn feet_are_local_minima() {
    let mut rng = Pcg::new(5, 0);
    let mut seen = [0; 3];
    for round in 0..400 {
        // Small numbers: points over edges and vertices, flat parts, right angles.
        let size = [3, 4, 30][round % 3];
        let [columns, rows] = [2 + rng.below(2), 2 + rng.below(2)];
        let step = i64::from(size);
        let vertices = (0..columns * rows).map(|k| {
            let [x, z] = [k % columns, k / columns].map(|c| i64::from(c) * step);
            let mut off = || i64::from(rng.below(size)) - step / 2;
            Vec3::from_raw([x + off() / 2, off(), z + off() / 2])
        });
        let vertices: Vec<_> = vertices.collect();
        let faces = (0..rows - 1).flat_map(|row| {
            (0..columns - 1).flat_map(move |column| {
                let a = row * columns + column;
                [[a, a + columns, a + columns + 1], [a, a + columns + 1, a + 1]]
            })
        });
        let mesh = TriangleMesh::new(vertices, faces).expect("legal");
        if mesh.degenerate_faces().next().is_some() {
            continue;
        }
        let shape = MeshShape::new(Arc::new(mesh)).two_sided();
        for _ in 0..100 {
            let point = [(); 3].map(|()| i64::from(rng.below(6 * size)) - 2 * step);
            let expected = expected(&shape, point);
            let found = touches(&shape, point, 1 << 20);
            assert!(found.keys().all(|feature| expected.contains(feature)), "{found:?} {point:?}");
            // More than four of like normals are reduced.
            if expected.len() <= 4 {
                assert_eq!(found.into_keys().collect::<Vec<_>>(), {
                    let mut expected = expected.clone();
                    expected.sort_unstable();
                    expected
                });
            }
            expected.iter().for_each(|feature| seen[feature.kind() as usize] += 1);
        }
    }
    assert!(seen.iter().all(|&count| count > 2_000), "{seen:?}");
}

/// Whether a point with odd coordinates is in a solid of cubes with even ones.
fn is_inside(full: &[[i32; 3]], point: Point, edge: i64) -> bool {
    let cube = point.map(|c| c.div_euclid(edge) as i32);
    full.contains(&cube)
}

/// Solids of cubes, told inside from outside by nothing but their surfaces: at flat parts, ridges,
/// valleys, corners, dents and saddles.
#[test]
fn sides_are_right() {
    const EDGE: i64 = 8;
    let mut rng = Pcg::new(6, 0);
    let mut seen = BTreeMap::new();
    for _ in 0..150 {
        // Cubes around one vertex, and what keeps them from touching at an edge only.
        let full: Vec<[i32; 3]> =
            (0..8).filter(|_| rng.below(4) != 0).map(|k| [k & 1, k >> 1 & 1, k >> 2]).collect();
        let solid = Solid::cubes([2; 3], 1 + rng.below(2) as i32, |c| full.contains(&c));
        let Some(shape) = sound(&solid, EDGE) else { continue };
        for round in 0..200 {
            let reach = [16, 4][round % 2];
            let near = |c: u32| 2 * i64::from(c) + 9 - i64::from(reach);
            let point = [(); 3].map(|()| near(rng.below(reach)));
            let found = touches(&shape, point, 1 << 20);
            let nearest = found.iter().min_by_key(|(feature, s)| (s.raw().abs(), **feature));
            let (feature, separation) = nearest.expect("something is near");
            let is_inside = is_inside(&full, point, EDGE);
            assert_eq!(*separation < Real::ZERO, is_inside, "{full:?} {point:?} {found:?}");
            if is_inside {
                assert_eq!(found.len(), 1);
            }
            assert_eq!(shape.contains(Vec3::from_raw(point)), is_inside);
            *seen.entry((is_inside, feature.kind())).or_insert(0) += 1;
        }
    }
    assert!(seen.len() == 6 && seen.values().all(|&count| count > 20), "{seen:?}");
}

/// The shape of a solid in raw units, if it is closed with two faces at every edge.
fn sound(solid: &Solid, edge: i64) -> Option<MeshShape> {
    let vertices =
        solid.vertices.iter().map(|p| Vec3::from_raw(p.map(|c| (c * edge as f64) as i64)));
    let mesh = TriangleMesh::new(vertices, solid.faces.iter().copied()).ok()?;
    let shape = MeshShape::new(Arc::new(mesh));
    shape.is_closed().then_some(shape)
}

/// On the surface is inside, wherever a ray along an axis would run through edges and vertices.
#[test]
fn surfaces_belong_to_solids() {
    let solid = Solid::cubes([2; 3], 1, |[x, y, z]| x + y + z < 2);
    let shape = sound(&solid, 8).expect("closed");
    let full = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    for x in -4..20 {
        for y in -4..20 {
            for z in -4..20 {
                let near = |c: i64| [c - 1, c].map(|c| c.div_euclid(8) as i32);
                let [xs, ys, zs] = [x, y, z].map(near);
                let cubes = || xs.iter().flat_map(|&x| ys.iter().map(move |&y| [x, y]));
                let mut around = cubes().flat_map(|[x, y]| zs.iter().map(move |&z| [x, y, z]));
                let expected = around.any(|cube| full.contains(&cube));
                assert_eq!(shape.contains(Vec3::from_raw([x, y, z])), expected, "{x} {y} {z}");
            }
        }
    }
}
