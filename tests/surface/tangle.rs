//! Ways out of overlaps that are known.

use std::sync::Arc;

use verlock::collision::{Manifold, MeshShape, Shape, collide};
use verlock::geometry::{ConvexHull, Cuboid, Grid, HeightField, Sphere, Triangle, TriangleMesh};
use verlock::math::Pcg;
use verlock::{Real, Vec3, real};

use super::solids::{Place, Solid, direction, fixed, float, number};

const MARGIN: Real = real!("0.005");

/// Of contacts that are as deep, up to this, a manifold keeps the one of the lowest features.
const TIE: Real = real!("0.00004");

/// The manifolds of two shapes, which are the same if they are exchanged.
fn manifolds(a: &Shape, b: &Shape) -> Vec<Manifold> {
    let mut manifolds = Vec::new();
    collide(a, b, MARGIN, &mut manifolds);
    let back = {
        let mut back = Vec::new();
        collide(b, a, MARGIN, &mut back);
        back
    };
    let mut back: Vec<_> = back.iter().map(|m| (-m.normal, m.separation())).collect();
    let mut ways: Vec<_> = manifolds.iter().map(|m| (m.normal, m.separation())).collect();
    back.sort_unstable();
    ways.sort_unstable();
    assert_eq!(ways.len(), back.len(), "exchanged");
    for (way, back) in ways.iter().zip(back) {
        assert_eq!(way.0, back.0, "exchanged");
        assert!((way.1.raw() - back.1.raw()).abs() <= TIE.raw(), "exchanged: {way:?} {back:?}");
    }
    manifolds
}

fn normal(manifold: &Manifold) -> [f64; 3] {
    manifold.normal.raw().map(|c| c as f64 / f64::from(1 << 30))
}

fn metres(length: Real) -> f64 {
    float(Vec3::X * length)[0]
}

/// The only manifold, which leads along a direction so far.
fn assert_way(found: &[Manifold], way: [f64; 3], depth: f64) {
    let [manifold] = found else { panic!("{} manifolds, not one", found.len()) };
    let off = [0, 1, 2].map(|k| (normal(manifold)[k] - way[k]).abs());
    assert!(off.iter().all(|&c| c < 1e-4), "{:?}, not {way:?}", normal(manifold));
    let separation = metres(manifold.separation());
    assert!((separation + depth).abs() < 1e-4, "{separation}, not {}", -depth);
}

fn cube() -> Solid {
    Solid::cubes([1, 1, 1], 1, |_| true)
}

fn moved(solid: &Solid, way: [f64; 3]) -> MeshShape {
    let place = Place { axis: [0.0, 1.0, 0.0], angle: 0.0, way };
    let mut shape = solid.shape();
    shape.move_to(&solid.placed(&place)).expect("in range");
    shape
}

fn cuboid(low: [f64; 3], size: [f64; 3]) -> Shape {
    let half = size.map(|c| c / 2.0);
    let center = [0, 1, 2].map(|k| low[k] + half[k]);
    Cuboid::upright(fixed(center), fixed(half)).expect("legal").into()
}

fn mesh(vertices: &[[f64; 3]], faces: &[[u32; 3]]) -> MeshShape {
    let vertices = vertices.iter().map(|&p| fixed(p));
    MeshShape::new(Arc::new(TriangleMesh::new(vertices, faces.iter().copied()).expect("legal")))
}

/// A square from -2 to 2 along x and z, at a height.
fn sheet(height: f64) -> MeshShape {
    let at = |x, z| [x, height, z];
    let corners = [at(-2.0, -2.0), at(-2.0, 2.0), at(2.0, 2.0), at(2.0, -2.0)];
    mesh(&corners, &[[0, 1, 2], [0, 2, 3]])
}

/// Cubes in one another go out the shortest way, and touch on their sides.
#[test]
fn cubes_part_the_shortest_way() {
    for depth in [0.005, 0.1, 0.6] {
        let way = [0.13, 1.0 - depth, 0.07];
        let shapes: [Shape; 2] = [cube().shape().into(), cuboid([0.0; 3], [1.0; 3])];
        let others: [Shape; 2] = [moved(&cube(), way).into(), cuboid(way, [1.0; 3])];
        for a in &shapes {
            for b in &others {
                let found = manifolds(a, b);
                assert_way(&found, [0.0, 1.0, 0.0], depth);
                for contact in found.iter().flat_map(Manifold::contacts) {
                    let [on_a, on_b] = [contact.on_a, contact.on_b].map(float);
                    assert!((on_a[1] - 1.0).abs() < 1e-6, "{contact:?}");
                    assert!((on_b[1] - way[1]).abs() < 1e-6, "{contact:?}");
                    for (point, low) in [(on_a, [0.0; 3]), (on_b, way)] {
                        let is_in = |k: usize| (-1e-6..1.0 + 1e-6).contains(&(point[k] - low[k]));
                        assert!((0..3).all(is_in), "{contact:?}");
                    }
                }
            }
        }
    }
}

/// What stands in the middle slab of three is not pushed out of the house.
#[test]
fn only_what_is_in_the_way_counts() {
    let Solid { vertices, faces } = cube();
    let slab = |height: f64| {
        let at = |&[x, y, z]: &[f64; 3]| [4.0 * x - 2.0, height + 0.2 * y, 4.0 * z - 2.0];
        vertices.iter().map(at).collect::<Vec<_>>()
    };
    let vertices = [0.0, 10.0, 20.0].map(slab).concat();
    let faces: Vec<_> =
        (0..3).flat_map(|k| faces.iter().map(move |face| face.map(|v| v + 8 * k))).collect();
    let house = Shape::from(mesh(&vertices, &faces));
    let rod = cuboid([0.5, 9.4, 0.5], [0.1, 2.0, 0.1]);
    assert_way(&manifolds(&house, &rod), [0.0, 1.0, 0.0], 0.8);
}

/// What is half through something without an inside goes back, or on, whichever is shorter.
#[test]
fn sheets_push_to_either_side() {
    let triangle = [[-3.0, 0.0, -3.0], [-3.0, 0.0, 5.0], [5.0, 0.0, -3.0]].map(fixed);
    let sheets =
        [Shape::from(sheet(0.0).two_sided()), Triangle::new(triangle).expect("legal").into()];
    for sheet in &sheets {
        for (low, depth, up) in [(-0.3, 0.3, 1.0), (-0.8, 0.2, -1.0)] {
            let way = [-0.4, low, -0.45];
            let hull = ConvexHull::around(cube().placed(&Place {
                axis: [0.0, 1.0, 0.0],
                angle: 0.0,
                way,
            }));
            let mut bodies = vec![Shape::from(moved(&cube(), way))];
            if matches!(sheet, Shape::MeshShape(_)) {
                bodies.extend([cuboid(way, [1.0; 3]), hull.expect("solid").into()]);
            }
            for body in &bodies {
                assert_way(&manifolds(sheet, body), [0.0, up, 0.0], depth);
            }
        }
    }
}

/// Sheets whose vertices and edges lie on those of what they go through part from it like others.
#[test]
fn what_stands_on_a_grid_parts() {
    let sheet = |corner: [f64; 3], cells: u32| {
        let (edge_u, edge_v) = (fixed([0.0, 0.0, 4.0]), fixed([4.0, 0.0, 0.0]));
        let (columns, rows) = (cells + 1, cells + 1);
        let grid = Grid { corner: fixed(corner), edge_u, edge_v, columns, rows };
        Shape::from(MeshShape::new(Arc::new(TriangleMesh::grid(&grid).expect("legal"))).two_sided())
    };
    let bodies: [Shape; 3] = [
        cube().shape().into(),
        Solid::cubes([1, 1, 1], 2, |_| true).shape().into(),
        cuboid([0.0; 3], [1.0; 3]),
    ];
    for body in &bodies {
        for cells in [1, 2, 4, 8, 16] {
            for place in 0..16 {
                let [x, z] = [place % 4, place / 4].map(|k| f64::from(k) * 0.5 - 2.5);
                for (height, depth, up) in [(0.25, 0.25, 1.0), (0.75, 0.25, -1.0), (0.9, 0.1, -1.0)]
                {
                    let mut found = manifolds(&sheet([x, height, z], cells), body);
                    // Vertices on its sides may touch these.
                    found.sort_by_key(Manifold::separation);
                    assert!(found[1..].iter().all(|touch| metres(touch.separation()) > -1e-5));
                    assert_way(&found[..1], [0.0, up, 0.0], depth);
                    // Exactly, though they were looked at elsewhere.
                    assert!((metres(found[0].separation()) + depth).abs() < 1e-7);
                }
            }
            // Half on it: as deep as beside.
            let deepest = |way: f64| {
                let sheet = sheet([0.5 + way, 0.75 + 1.3 * way, 0.5 + 0.7 * way], cells);
                let found = manifolds(&sheet, body);
                metres(found.iter().map(Manifold::separation).min().expect("they overlap"))
            };
            let depths = [0.0, 2e-5].map(deepest);
            assert!((depths[0] - depths[1]).abs() < 1e-4, "{cells}: {depths:?}");
            assert!((depths[0] + 0.25).abs() < 1e-4, "{cells}: {depths:?}");
        }
    }
}

/// What is pressed into a corner of a room is led out of it, not along it.
#[test]
fn corners_are_left_as_soon_as_they_are_free() {
    let at = |x: f64, y: f64| (0..5).map(move |k| [x, y, 2.0 * f64::from(k)]);
    let vertices: Vec<_> = at(0.0, 9.0).chain(at(0.0, 0.0)).chain(at(9.0, 0.0)).collect();
    let side = |k: u32| [[k, k + 1, k + 5], [k + 5, k + 1, k + 6]];
    let faces: Vec<_> = (0..4).chain(5..9).flat_map(side).collect();
    let room = Shape::from(mesh(&vertices, &faces));
    for body in [cuboid([0.0; 3], [1.0; 3]), cube().shape().into()] {
        let near_free = (700..1800).step_by(4).map(|raw| f64::from(raw) / f64::from(1 << 24));
        for depth in [0.0005, 0.005, 0.05].into_iter().chain(near_free) {
            let way = [-depth, -depth, 3.3];
            let body = match &body {
                Shape::Cuboid(_) => cuboid(way, [1.0; 3]),
                _ => moved(&cube(), way).into(),
            };
            let found = manifolds(&room, &body);
            let deepest = found.iter().map(|m| metres(-m.separation())).fold(0.0, f64::max);
            let far = depth * 2.0_f64.sqrt();
            assert!((0.99 * depth..1.07 * far).contains(&deepest), "{depth}: {deepest}");
            for manifold in &found {
                let [x, y, z] = normal(manifold);
                assert!(x > -1e-6 && y > -1e-6 && z.abs() < 1e-6, "{:?}", normal(manifold));
            }
        }
    }
}

/// A corner of one sheet through another one goes back.
#[test]
fn sheets_part() {
    let floor = Shape::from(sheet(0.0).two_sided());
    let corner = [[0.0, -0.05, 0.0], [1.0, 1.0, 0.3], [-0.4, 1.0, 0.8]].map(fixed);
    let corner = Shape::from(Triangle::new(corner).expect("legal"));
    assert_way(&manifolds(&floor, &corner), [0.0, 1.0, 0.0], 0.05);
}

/// What lies across the border of an open surface has one way out, however it is asked for.
#[test]
fn open_borders_know_no_order() {
    let mut rng = Pcg::new(5, 0);
    let cube = cube();
    let mut deep = 0;
    for _ in 0..200 {
        let height = |_| fixed([0.2 * number(&mut rng), 0.0, 0.0]).x;
        let heights: Vec<_> = (0..36).map(height).collect();
        let origin = fixed([-2.5, 0.0, -2.5]);
        let terrain = HeightField::new(origin, [Real::ONE; 2], 6, heights).expect("legal");
        let terrain = Shape::from(MeshShape::new(Arc::new(terrain.mesh().expect("legal"))));
        let mut body = cube.shape();
        let way = [2.0 + 0.4 * number(&mut rng), -0.5 + 0.3 * number(&mut rng), number(&mut rng)];
        let place = Place { axis: direction(&mut rng), angle: 3.0 * number(&mut rng), way };
        body.move_to(&cube.placed(&place)).expect("in range");
        let found = manifolds(&terrain, &body.into());
        deep += found.iter().filter(|manifold| manifold.separation() < real!("-0.01")).count();
    }
    assert!(deep > 100, "only {deep}");
}

/// What is inside something as a whole is led out through the nearest place.
#[test]
fn what_is_inside_is_led_out() {
    let outer = Solid::cubes([1, 1, 1], 2, |_| true);
    let vertices: Vec<_> = outer.vertices.iter().map(|p| p.map(|c| 4.0 * c)).collect();
    let outer = mesh(&vertices, &outer.faces);
    assert!(outer.is_closed());
    let outers = [Shape::from(outer), cuboid([0.0; 3], [4.0; 3])];
    let low = [1.2, 1.1, 0.3];
    let solid = Solid::cubes([1, 1, 1], 1, |_| true);
    let placed = solid.placed(&Place { axis: [1.0, 0.0, 0.0], angle: 0.0, way: low });
    let hull = ConvexHull::around(placed.iter().copied()).expect("solid");
    let triangle = Triangle::new([placed[0], placed[1], placed[2]]).expect("legal");
    assert!(triangle.corners().iter().all(|corner| corner.x == placed[0].x), "upright");
    let (along_x, along_z) = ([-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]);
    let inners: [(Shape, [f64; 3], f64); 5] = [
        (moved(&solid, low).into(), along_z, 1.3),
        (cuboid(low, [1.0; 3]), along_z, 1.3),
        (hull.into(), along_z, 1.3),
        (moved(&solid, low).two_sided().into(), along_z, 1.3),
        (triangle.into(), along_x, 1.2),
    ];
    for outer in &outers {
        for (inner, way, depth) in &inners {
            let is_mesh = |shape: &Shape| matches!(shape, Shape::MeshShape(_));
            if is_mesh(outer) || is_mesh(inner) {
                assert_way(&manifolds(outer, inner), *way, *depth);
            }
        }
    }
    // Inside the hole of a ring is not inside.
    let ring = Shape::from(Solid::ring(12).shape());
    let small = cuboid([-0.1; 3], [0.2; 3]);
    assert!(manifolds(&ring, &small).is_empty());
}

/// A mesh of a point touches, and is not closed.
#[test]
fn points_are_meshes() {
    let point = mesh(&[[0.0, 1.0, 0.0], [0.0, 2.0, 0.0]], &[[0, 0, 0]]);
    assert!(!point.is_closed());
    let point = Shape::from(point);
    let ball = Shape::from(Sphere::new(Vec3::ZERO, real!("1.001")).expect("legal"));
    let others = [ball, cuboid([-1.0; 3], [2.0, 2.0, 2.0]), cube().shape().into()];
    for other in &others {
        for [a, b] in [[other, &point], [&point, other], [&point, &point]] {
            let mut found = Vec::new();
            collide(a, b, MARGIN, &mut found);
            assert!(!found.is_empty());
        }
    }
}

/// Features of a manifold differ, also where faces of many sides are cut.
#[test]
fn features_are_unique() {
    let mut rng = Pcg::new(6, 0);
    let ring = Solid::ring(8);
    let around = |k: u32| {
        let angle = f64::from(k) * 0.7;
        [angle.cos(), 0.4 * f64::from(k % 2), angle.sin()]
    };
    for _ in 0..300 {
        let place = Place {
            axis: direction(&mut rng),
            angle: 3.0 * number(&mut rng),
            way: [(); 3].map(|()| 1.2 * number(&mut rng)),
        };
        let disc = (0..18).map(|k| fixed(place.of(around(k))));
        let disc = Shape::from(ConvexHull::around(disc).expect("solid"));
        let mut found = Vec::new();
        collide(&disc, &ring.shape().into(), real!("0.1"), &mut found);
        for manifold in &found {
            let features: Vec<_> = manifold.contacts().iter().map(|c| c.features).collect();
            assert!(features.is_sorted_by(|a, b| a < b), "{features:?}");
        }
    }
}

/// Neither is the first, where both have the same box.
#[test]
fn what_has_the_same_box_parts_the_same_way_exchanged() {
    let low: Shape = Solid::cubes([3, 3, 3], 1, |c| c[0] == 0 || c[1] == 0).shape().into();
    let high: Shape = Solid::cubes([3, 3, 3], 1, |c| c[0] == 2 || c[1] == 2).shape().into();
    assert_eq!(low.bounds(), high.bounds());
    let deepest = |a: &Shape, b: &Shape| {
        let mut manifolds = Vec::new();
        collide(a, b, MARGIN, &mut manifolds);
        manifolds.iter().map(|m| m.separation().raw()).min().expect("they overlap")
    };
    let (there, back) = (deepest(&low, &high), deepest(&high, &low));
    assert!(there < 0 && (there - back).abs() <= TIE.raw(), "{there} {back}");
}

/// A room may be a box turned inside out: what is outside of its faces is inside of the box.
#[test]
fn rooms_may_be_inside_out() {
    let room: Shape = Solid::cuboid([-5.0; 3], [5.0; 3]).turned().shape().into();
    for depth in [0.001, 0.003, 0.2] {
        let crate_in_floor = cuboid([0.3, -5.0 - depth, 0.7], [1.0; 3]);
        assert_way(&manifolds(&room, &crate_in_floor), [0.0, 1.0, 0.0], depth);
    }
}

/// Each end of a plank that lies on two pillars of one mesh is as deep as it is there.
#[test]
fn pillars_are_left_one_by_one() {
    let pillar = |x: f64, y: f64| Solid::cuboid([x, -2.0, -0.5], [x + 0.6, y, 0.5]);
    let pillars: Shape = pillar(0.0, 0.0).and(pillar(4.0, 0.0)).shape().into();
    // From 5 mm deep at one end to 100 mm at the other one.
    for slope in [0.095 / 4.6, -0.095 / 4.6] {
        let along = [2.3, -2.3 * slope, 0.0];
        let across = [0.1 * slope, 0.1, 0.0];
        let center = [2.3, 0.1 - 0.0525, 0.0];
        let plank = Cuboid::new(fixed(center), [along, across, [0.0, 0.0, 0.4]].map(fixed));
        let found = manifolds(&pillars, &plank.expect("a box").into());
        let deepest = |is_there: fn(f64) -> bool| {
            let there = |m: &&Manifold| is_there(float(m.contacts()[0].on_b)[0]);
            found.iter().filter(there).map(|m| metres(-m.separation())).fold(0.0, f64::max)
        };
        let mut depths = [deepest(|x| x < 2.0), deepest(|x| x > 2.0)];
        if slope < 0.0 {
            depths.reverse();
        }
        assert!((0.005..0.025).contains(&depths[0]), "{depths:?}");
        assert!((0.09..0.11).contains(&depths[1]), "{depths:?}");
    }
}

/// An open sheet that stands on a floor stays there, whichever way it is bent.
#[test]
fn bent_sheets_stand_on_floors() {
    let floor = Shape::from(moved(&Solid::cuboid([-9.0, -1.0, -9.0], [9.0, 0.0, 9.0]), [0.0; 3]));
    for (bend, low) in [(0.4, -0.001), (-0.4, -0.001), (0.4, -0.0001), (-0.4, -0.0001)] {
        let corners = [[-1.0, bend], [0.0, 0.0], [1.0, bend]];
        let at = |y: f64| corners.map(|[x, z]| [x + 5.0, y, z + 0.9]);
        let vertices = [at(low), at(1.0)].concat();
        let sheet = mesh(&vertices, &[[0, 1, 3], [3, 1, 4], [1, 2, 4], [4, 2, 5]]);
        let found = manifolds(&floor, &sheet.into());
        assert!(!found.is_empty(), "{bend} {low}");
        for manifold in found {
            let depth = metres(-manifold.separation());
            assert!(depth < 0.0011, "{bend} {low}: {depth} along {:?}", normal(&manifold));
        }
    }
}

/// How deep a box is in a solid does not depend on which comes first, nor on how faces and vertices
/// are numbered.
#[test]
fn names_and_order_do_not_matter() {
    let deepest = |a: &Shape, b: &Shape| {
        manifolds(a, b).iter().map(|m| metres(-m.separation())).fold(0.0, f64::max)
    };
    let mut rng = Pcg::new(5, 0);
    let (mut deep, mut off) = (0, Vec::new());
    for (solid, tilt) in [(8, 0.0), (16, 3.0), (8, 3.0)].map(|(n, tilt)| (Solid::ring(n), tilt)) {
        let solid: Shape = solid.shape().into();
        for _ in 0..1000 {
            let way = [(); 3].map(|()| 1.2 * number(&mut rng));
            let half = [(); 3].map(|()| 0.05 + 0.9 * number(&mut rng).abs());
            let axis = direction(&mut rng);
            let place = Place { axis, angle: tilt * number(&mut rng), way };
            let mut body = Solid::cuboid(half.map(|c| -c), half);
            body.vertices.iter_mut().for_each(|p| *p = place.of(*p));
            let mut renamed = body.clone();
            renamed.vertices.reverse();
            renamed.faces.rotate_left(5);
            renamed.faces.iter_mut().for_each(|face| *face = face.map(|vertex| 7 - vertex));
            renamed.faces.iter_mut().for_each(|face| face.rotate_left(1));
            let [body, renamed] = [body, renamed].map(|solid| Shape::from(solid.shape()));
            let depth = deepest(&solid, &body);
            deep += i32::from(depth > 0.01);
            let others =
                [deepest(&body, &solid), deepest(&solid, &renamed), deepest(&renamed, &solid)];
            if others.iter().any(|other| (other - depth).abs() > 0.0001) {
                off.push((depth, others, place, half));
            }
        }
    }
    assert!(deep > 2000, "{deep}");
    assert!(off.is_empty(), "{} of {deep}: {off:?}", off.len());
}
