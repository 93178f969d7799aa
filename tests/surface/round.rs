//! Balls and capsules in surfaces, however deep: what overlaps is told, and led out.

use std::sync::Arc;

use verlock::collision::{MARGIN_MAX, Manifold, MeshShape, Shape, collide, overlap};
use verlock::geometry::{Capsule, Cuboid, HalfSpace, HeightField, Sphere, Triangle, TriangleMesh};
use verlock::math::{Pcg, UnitVec3};
use verlock::{Real, Vec3, real};

use super::solids::{Solid, fixed, number};

fn found(a: &Shape, b: &Shape, margin: Real) -> Vec<Manifold> {
    let mut manifolds = Vec::new();
    collide(a, b, margin, &mut manifolds);
    manifolds
}

fn mesh(vertices: Vec<Vec3>, faces: Vec<[u32; 3]>) -> MeshShape {
    MeshShape::new(Arc::new(TriangleMesh::new(vertices, faces).expect("legal")))
}

fn capsule(ends: [[f64; 3]; 2], radius: f64) -> Shape {
    let radius = Real::from_f64(radius).expect("in range");
    Capsule::new(ends.map(fixed), radius).expect("legal").into()
}

fn ball(center: [f64; 3], radius: f64) -> Shape {
    Sphere::new(fixed(center), Real::from_f64(radius).expect("in range")).expect("legal").into()
}

/// A cube of 2 m about 0, closed.
fn cube() -> MeshShape {
    let middle = Vec3::from_ints(1, 1, 1);
    let mut cube = Solid::cubes([2; 3], 1, |_| true).shape();
    let vertices: Vec<_> = cube.vertices().iter().map(|&p| p - middle).collect();
    cube.move_to(&vertices).expect("in range");
    cube
}

/// From -5 to 5 m along x and z, at a height of 0.
fn floor() -> MeshShape {
    let corners = [[-5, -5], [-5, 5], [5, 5], [5, -5]].map(|[x, z]| Vec3::from_ints(x, 0, z));
    mesh(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]])
}

fn hills(rng: &mut Pcg, height: f64) -> HeightField {
    let heights: Vec<_> = (0..49).map(|_| fixed([height * number(rng); 3]).x).collect();
    let corner = Vec3::from_ints(-3, 0, -3);
    HeightField::new(corner, [Real::ONE; 2], 7, heights).expect("legal")
}

/// Surfaces of all kinds about 0.
fn surfaces(rng: &mut Pcg) -> Vec<(&'static str, Shape)> {
    let hills = hills(rng, 0.6);
    let crumpled = MeshShape::new(Arc::new(hills.mesh().expect("legal")));
    let corners = [(); 3].map(|()| fixed([(); 3].map(|()| 2.0 * number(rng))));
    vec![
        ("cube", cube().into()),
        ("ring", Solid::ring(10).shape().into()),
        ("floor", floor().into()),
        ("sheet", floor().two_sided().into()),
        ("hills", hills.into()),
        ("terrain", crumpled.clone().into()),
        ("cloth", crumpled.two_sided().into()),
        ("triangle", Triangle::new(corners).expect("legal").into()),
    ]
}

/// A ball or a capsule; sometimes on a coarse grid, where much touches or is in one plane.
fn round(rng: &mut Pcg) -> Shape {
    let is_coarse = rng.below(3) == 0;
    let mut place = || {
        let place = [(); 3].map(|()| 2.5 * number(rng));
        if is_coarse { place.map(|c| (2.0 * c).round() / 2.0) } else { place }
    };
    let ends = [place(), place()];
    let radius = [0.0, 0.05, 0.25, 0.5][rng.below(4) as usize];
    if rng.below(4) == 0 { ball(ends[0], radius) } else { capsule(ends, radius) }
}

/// Whatever overlaps a surface has a contact that says so, from either side.
#[test]
fn overlap_implies_a_manifold() {
    let mut rng = Pcg::new(21, 0);
    let mut counts = std::collections::BTreeMap::<_, [u32; 2]>::new();
    for _ in 0..150 {
        for (name, surface) in surfaces(&mut rng) {
            for _ in 0..20 {
                let body = round(&mut rng);
                let is_over = overlap(&body, &surface);
                let margin = [Real::ZERO, real!("0.02")][rng.below(2) as usize];
                let manifolds = found(&body, &surface, margin);
                counts.entry(name).or_default()[usize::from(is_over)] += 1;
                if !is_over {
                    continue;
                }
                let least = manifolds.iter().map(Manifold::separation).min();
                assert!(least.is_some_and(|least| least.raw() <= 4), "{name} {body:?} {least:?}");
                if name == "triangle" {
                    continue; // which is convex
                }
                let back = found(&surface, &body, margin);
                assert_eq!(back.len(), manifolds.len());
                assert!(back.iter().all(|back| manifolds.contains(&back.flipped())));
                for manifold in &manifolds {
                    let keys: Vec<_> = manifold.contacts().iter().map(|c| c.features).collect();
                    assert!(keys.is_sorted_by(|a, b| a < b), "{keys:?}");
                }
            }
        }
    }
    assert!(counts.values().flatten().all(|&count| count > 300), "{counts:?}");
}

/// The shape as far along the normal as the deepest manifold says, and a tenth of a millimetre.
pub fn pushed(body: &Shape, manifolds: &[Manifold]) -> Option<Shape> {
    let deepest = manifolds.iter().min_by_key(|manifold| manifold.separation())?;
    let depth = real!("0.0001") - deepest.separation();
    let way = deepest.normal.raw().map(|c| -((c * depth.raw()) >> 30));
    let moved = |point: Vec3| point + Vec3::from_raw(way);
    Some(match body {
        Shape::Sphere(ball) => {
            Sphere::new(moved(ball.center()), ball.radius()).expect("in range").into()
        }
        Shape::Capsule(it) => {
            Capsule::new(it.ends().map(moved), it.radius()).expect("in range").into()
        }
        Shape::Cuboid(it) => {
            Cuboid::new(moved(it.center()), it.half_edges()).expect("in range").into()
        }
        _ => return None,
    })
}

/// Both ends in front of the floor.
fn is_above(body: &Shape) -> bool {
    body.bounds().is_some_and(|bounds| bounds.min().y > Real::ZERO)
}

#[test]
fn a_flat_floor_pushes_up_at_once() {
    let mut rng = Pcg::new(22, 0);
    let field =
        HeightField::new(Vec3::from_ints(-5, 0, -5), [Real::ONE; 2], 11, vec![Real::ZERO; 121]);
    let fields: [Shape; 2] = [floor().into(), field.expect("legal").into()];
    let mut count = 0;
    for k in 0..600 {
        let surface = &fields[k % 2];
        let body = round(&mut rng);
        if !overlap(&body, surface) {
            continue;
        }
        count += 1;
        let after = pushed(&body, &found(&body, surface, Real::ZERO)).expect("told");
        assert!(is_above(&after), "{body:?} goes to {after:?}");
    }
    assert!(count > 200, "only {count}");
    // A person in the ground up to the knees.
    let person = capsule([[1.0, -0.4, 2.0], [1.0, 0.6, 2.0]], 0.3);
    for surface in &fields {
        let manifolds = found(&person, surface, real!("0.01"));
        assert_eq!(manifolds.len(), 1);
        let off = manifolds[0].separation() + real!("0.7");
        assert!(manifolds[0].normal == -UnitVec3::Y && off.raw().abs() <= 2);
    }
}

/// A two-sided sheet is left on the side where more of the capsule is.
#[test]
fn a_sheet_pushes_to_the_nearer_side() {
    let sheet: Shape = floor().two_sided().into();
    for (low, high, up, depth) in [(-0.1, 0.9, true, 0.3), (-0.8, 0.3, false, 0.5)] {
        let body = capsule([[1.0, low, 2.0], [1.5, high, 2.0]], 0.2);
        let manifolds = found(&body, &sheet, Real::ZERO);
        let [manifold] = manifolds.as_slice() else { panic!("{manifolds:?}") };
        assert_eq!(manifold.normal, if up { -UnitVec3::Y } else { UnitVec3::Y });
        let off = manifold.separation().raw() as f64 / 16_777_216.0 + depth;
        assert!(off.abs() < 1e-6, "{off}");
        assert!(!overlap(&pushed(&body, &manifolds).expect("told"), &sheet));
    }
}

/// Whether none of it is in the cube, nor on it.
fn is_free(body: &Shape, cube: &MeshShape) -> bool {
    let center = body.bounds().map(|bounds| bounds.min());
    let ends = match body {
        Shape::Sphere(ball) => [ball.center(); 2],
        Shape::Capsule(capsule) => capsule.ends(),
        _ => [center.expect("has one"); 2],
    };
    !overlap(body, &cube.clone().into()) && !ends.into_iter().any(|end| cube.contains(end))
}

/// Whatever is in a closed cube, wholly or partly, gets out of it: at once where it is led as a
/// whole, else in a few steps.
#[test]
fn a_closed_cube_lets_everything_out() {
    let cube = cube();
    let surface: Shape = cube.clone().into();
    let mut rng = Pcg::new(23, 0);
    let mut steps = [0; 4];
    for _ in 0..4000 {
        let mut body = round(&mut rng);
        if is_free(&body, &cube) {
            continue;
        }
        let first = body.clone();
        let mut count = 0;
        while !is_free(&body, &cube) {
            assert!(count < 3, "{first:?} has come to {body:?}");
            let manifolds = found(&body, &surface, Real::ZERO);
            body = pushed(&body, &manifolds).unwrap_or_else(|| panic!("{first:?}: {body:?}"));
            count += 1;
        }
        steps[count] += 1;
    }
    assert!(steps[1] > 1500 && 10 * (steps[2] + steps[3]) < steps[1], "{steps:?}");
}

/// What is swallowed touches nothing, and is yet led out.
#[test]
fn what_is_swallowed_is_led_out_the_nearest_way() {
    let cube: Shape = cube().into();
    for body in [ball([0.1, 0.3, 0.2], 0.01), capsule([[0.1, 0.3, -0.5], [0.0, 0.2, 0.5]], 0.01)] {
        assert!(!overlap(&body, &cube));
        let manifolds = found(&body, &cube, Real::ZERO);
        let [manifold] = manifolds.as_slice() else { panic!("{manifolds:?}") };
        assert_eq!(manifold.normal, -UnitVec3::Y);
    }
    let hollow = cube_without_a_lid();
    assert!(found(&ball([0.1, 0.3, 0.2], 0.01), &hollow, Real::ZERO).is_empty());
}

fn cube_without_a_lid() -> Shape {
    let closed = cube();
    let is_lid = |face: &&[u32; 3]| {
        face.iter().all(|&vertex| closed.vertices()[vertex as usize].y == Real::ONE)
    };
    let faces = closed.mesh().faces().iter().filter(|face| !is_lid(face)).copied().collect();
    mesh(closed.vertices().to_vec(), faces).into()
}

/// Beside the rim of a one-sided floor a ball is held off, from above and from below; right below
/// the floor it is pushed up.
#[test]
fn a_rim_is_touched_from_below() {
    let floor: Shape = floor().into();
    for (x, y) in [(5.1, 0.2), (5.1, -0.2), (5.3, -0.01), (5.001, -0.4)] {
        for z in [0.0, 1.0, 5.1] {
            let body = ball([x, y, z], 0.5);
            let manifolds = found(&body, &floor, Real::ZERO);
            assert_eq!(manifolds.len(), usize::from(overlap(&body, &floor)), "{x} {y} {z}");
            for manifold in &manifolds {
                assert!(manifold.normal.x.raw() < 0, "{x} {y} {z}: {manifold:?}");
                assert_eq!(manifold.normal.y.raw() < 0, y > 0.0, "{x} {y} {z}: {manifold:?}");
            }
        }
    }
    for (x, z) in [(4.9, 0.0), (5.0, 0.0), (5.0, 5.0)] {
        let manifolds = found(&ball([x, -0.2, z], 0.5), &floor, Real::ZERO);
        assert_eq!(manifolds.len(), 1);
        assert_eq!(manifolds[0].normal, -UnitVec3::Y, "{x} {z}");
    }
}

/// Of twelve faces that look twelve ways the eight nearest are kept, whatever their numbers are.
#[test]
fn the_shallowest_clusters_are_dropped() {
    let (mut vertices, mut faces, mut distances) = (vec![], vec![], vec![]);
    for k in 0..12_u32 {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 12.0).sin_cos();
        let distance = 1.0 + 0.001 * f64::from(k * 5 % 12);
        for (u, w) in [(-0.1, -0.1), (0.1, -0.1), (0.0, 0.1)] {
            vertices.push(fixed([distance * cos - u * sin, distance * sin + u * cos, w]));
        }
        faces.push([3 * k, 3 * k + 1, 3 * k + 2]);
        distances.push(distance - 1.0);
    }
    let around: Shape = mesh(vertices, faces).two_sided().into();
    let manifolds = found(&ball([0.0; 3], 1.0), &around, real!("0.05"));
    let mut depths: Vec<_> = manifolds.iter().map(Manifold::separation).collect();
    depths.sort_unstable();
    distances.sort_by(f64::total_cmp);
    assert_eq!(depths.len(), 8);
    for (depth, distance) in depths.into_iter().zip(distances) {
        let off = depth.raw() as f64 / 16_777_216.0 - distance;
        assert!(off.abs() < 1e-6, "{off}");
    }
}

/// Margins below 0 are 0, and those beyond the greatest are that, for every kind of pair.
#[test]
fn margins_count_alike() {
    let sunk = real!("0.9999");
    let half_space: Shape = HalfSpace::new(Vec3::ZERO, UnitVec3::Y).expect("legal").into();
    let place = Vec3::Y * sunk;
    let mut cube = cube();
    let vertices: Vec<_> = cube.vertices().iter().map(|&p| p + place).collect();
    cube.move_to(&vertices).expect("in range");
    let grounds: [Shape; 3] = [half_space, floor().into(), {
        let center = Vec3::Y * real!("-1");
        Cuboid::upright(center, Vec3::from_ints(5, 1, 5)).expect("legal").into()
    }];
    let lifted = |height: Real| -> [Shape; 4] {
        let place = Vec3::Y * (sunk + height);
        let mut mesh = cube.clone();
        let vertices: Vec<_> = cube.vertices().iter().map(|&p| p + Vec3::Y * height).collect();
        mesh.move_to(&vertices).expect("in range");
        [
            Sphere::new(place, Real::ONE).expect("legal").into(),
            Capsule::new([place, place + Vec3::X], Real::ONE).expect("legal").into(),
            Cuboid::upright(place, Vec3::ONE).expect("legal").into(),
            mesh.into(),
        ]
    };
    for ground in &grounds {
        for body in &lifted(Real::ZERO) {
            let at_zero = found(body, ground, Real::ZERO);
            assert!(!at_zero.is_empty(), "{body:?} {ground:?}");
            for margin in [real!("-0.01"), real!("-5"), Real::MIN] {
                assert_eq!(found(body, ground, margin), at_zero, "{body:?} {ground:?}");
            }
        }
        for (height, is_near) in [(real!("16000"), true), (real!("17000"), false)] {
            for body in &lifted(height) {
                for margin in [MARGIN_MAX, real!("30000"), Real::MAX] {
                    let manifolds = found(body, ground, margin);
                    assert_eq!(!manifolds.is_empty(), is_near, "{height} {body:?} {ground:?}");
                }
            }
        }
    }
}
