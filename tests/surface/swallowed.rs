//! Deep in closed solids that are not convex, or are made of several shells: nothing is silent, and
//! all get out.

use verlock::collision::{Manifold, MeshShape, Shape, collide, overlap};
use verlock::geometry::{Capsule, Cuboid, Sphere};
use verlock::math::{Pcg, UnitVec3};
use verlock::{Real, Vec3, real};

use super::round::pushed;
use super::solids::{Place, Solid, fixed, float, number};

fn cuboid(center: [f64; 3], half: [f64; 3]) -> Shape {
    Cuboid::upright(fixed(center), fixed(half)).expect("legal").into()
}

fn capsule(ends: [[f64; 3]; 2], radius: Real) -> Shape {
    Capsule::new(ends.map(fixed), radius).expect("legal").into()
}

fn ball(center: [f64; 3], radius: Real) -> Shape {
    Sphere::new(fixed(center), radius).expect("legal").into()
}

fn found(a: &Shape, b: &Shape) -> Vec<Manifold> {
    let mut manifolds = Vec::new();
    collide(a, b, real!("0.02"), &mut manifolds);
    manifolds
}

/// Two boxes, 5 m to each side, that have 2 m in common about 0.
fn overlapped() -> Solid {
    let sides = [[-5.0, 1.0], [-1.0, 5.0]];
    let [left, right] = sides.map(|[from, to]| Solid::cuboid([from, -5.0, -5.0], [to, 5.0, 5.0]));
    left.and(right)
}

/// Points of a body of which all are outside if it is, unless it goes through faces.
fn points(body: &Shape) -> Vec<Vec3> {
    match body {
        Shape::Sphere(ball) => vec![ball.center()],
        Shape::Capsule(capsule) => capsule.ends().to_vec(),
        Shape::Cuboid(cuboid) => cuboid.corners().to_vec(),
        _ => unreachable!("not made here"),
    }
}

/// Whether none of it is in a solid, nor on it; of what is round, none of what it is around.
fn is_out(body: &Shape, solid: &MeshShape) -> bool {
    let core = match body {
        Shape::Sphere(_) => None,
        Shape::Capsule(it) => Some(Capsule::new(it.ends(), Real::ZERO).expect("legal").into()),
        _ => Some(body.clone()),
    };
    let surface = solid.clone().into();
    !core.is_some_and(|core: Shape| overlap(&core, &surface))
        && !points(body).into_iter().any(|point| solid.contains(point))
}

/// After that many pushes, at most, each of the bodies is out.
const PUSHES_MAX: usize = 3;

/// Of bodies about 0, within `reach` along each axis, those that are in a solid get out of it.
fn check(name: &str, solid: &Solid, reach: [f64; 3]) {
    let mesh = solid.shape();
    let surface: Shape = mesh.clone().into();
    let mut rng = Pcg::new(31, 0);
    let (mut count, mut steps) = (0, [0; PUSHES_MAX + 1]);
    for k in 0..600 {
        let center = reach.map(|c| c * number(&mut rng));
        let half = [(); 3].map(|()| 0.5 * number(&mut rng));
        let radius = [real!("0.05"), real!("0.3")][k / 3 % 2];
        let mut body = match k % 3 {
            0 => ball(center, radius),
            1 => {
                let end = |sign: f64| [0, 1, 2].map(|k| center[k] + sign * half[k]);
                capsule([end(-1.0), end(1.0)], radius)
            }
            _ => cuboid(center, half.map(|c| 0.05 + 0.2 * c.abs())),
        };
        // Boxes that go through faces are led out part by part.
        let is_box = matches!(body, Shape::Cuboid(_));
        if is_out(&body, &mesh) || is_box && overlap(&body, &surface) {
            continue;
        }
        let first = body.clone();
        let mut pushes = 0;
        while !is_out(&body, &mesh) {
            assert!(pushes < PUSHES_MAX, "{name}: {first:?} has come to {body:?}");
            let manifolds = found(&body, &surface);
            body = pushed(&body, &manifolds).unwrap_or_else(|| panic!("{name}: {body:?}"));
            pushes += 1;
        }
        count += 1;
        steps[pushes] += 1;
    }
    assert!(count > 200 && 10 * steps[1] > 9 * count, "{name}: {steps:?}");
}

/// What is led out as a whole is out at once; what has ways of its parts needs some more.
#[test]
fn all_get_out_of_what_is_not_convex() {
    check("ring", &Solid::ring(12), [1.4, 0.5, 1.4]);
    check("star", &Solid::star(12, 0.35), [0.9, 0.5, 0.9]);
    check("gear", &Solid::star(12, 0.75), [0.9, 0.5, 0.9]);
    check("pit", &Solid::pit(), [1.0, 9.0, 1.0]);
    check("overlapped", &overlapped(), [5.0; 3]);
    let around = Solid::cuboid([-6.0; 3], [6.0; 3]);
    check("nested", &overlapped().and(around), [6.0; 3]);
}

/// Where shells overlap, or one is in another, is inside of all; a cavity is outside.
#[test]
fn shells_together_are_one_solid() {
    let mut rng = Pcg::new(32, 0);
    let nested = Solid::cuboid([-6.0; 3], [6.0; 3]).and(overlapped());
    let hollow =
        Solid::cuboid([-6.0; 3], [6.0; 3]).and(Solid::cuboid([-4.0; 3], [4.0; 3]).turned());
    let solids = [overlapped(), nested, hollow].map(|solid| solid.shape());
    let is_in = |p: [f64; 3], size: f64| p.iter().all(|c| c.abs() < size);
    for _ in 0..1000 {
        let p = [(); 3].map(|()| 7.0 * number(&mut rng));
        let expected = [is_in(p, 5.0), is_in(p, 6.0), is_in(p, 6.0) && !is_in(p, 4.0)];
        for (solid, expected) in solids.iter().zip(expected) {
            assert_eq!(solid.contains(fixed(p)), expected, "{p:?}");
        }
    }
}

/// Out of two boxes that overlap the way is as long as out of one that is as large as both.
#[test]
fn a_wall_within_is_no_way_out() {
    let [two, one] = [overlapped(), Solid::cuboid([-5.0; 3], [5.0; 3])].map(|s| s.shape().into());
    let mut rng = Pcg::new(33, 0);
    for k in 0..300 {
        // Where no wall within touches them.
        let x = [0.0, 2.75, -2.75][k % 3] + [0.4, 1.2, 1.2][k % 3] * number(&mut rng);
        let center = [x, 4.0 * number(&mut rng), 4.0 * number(&mut rng)];
        let end = [center[0] + 0.1, center[1] + 0.1, center[2]];
        let radius = real!("0.3");
        let bodies =
            [ball(center, radius), capsule([center, end], radius), cuboid(center, [0.3; 3])];
        for body in bodies {
            let [of_two, of_one] = [&two, &one].map(|surface| found(&body, surface));
            assert_eq!(of_two.len(), 1, "{body:?} {of_two:?}");
            let off = of_two[0].separation() - of_one[0].separation();
            assert!(off.raw().abs() <= 4, "{body:?} {of_two:?} {of_one:?}");
        }
    }
}

/// The tip of a pit, seen from inside, is nothing to rest on.
#[test]
fn a_tip_from_inside_holds_nothing_down() {
    let pit = Solid::pit().shape();
    for gap in [0.2, 3.0] {
        let body = capsule([[-3.0, -gap, 0.1], [3.0, -gap, 0.0]], real!("0.3"));
        let manifolds = found(&body, &pit.clone().into());
        let [manifold] = manifolds.as_slice() else { panic!("{manifolds:?}") };
        assert_eq!(manifold.normal, UnitVec3::Y, "through the bottom");
        let after = pushed(&body, &manifolds).expect("told");
        assert!(is_out(&after, &pit));
    }
}

/// Each shell that is inside is led out, whatever the numbers of its faces are.
#[test]
fn each_shell_is_led_out() {
    let outer: Shape = Solid::cuboid([-5.0; 3], [5.0; 3]).shape().into();
    let at = |x: f64, y: f64| Solid::cuboid([x - 0.5, y - 0.5, -0.5], [x + 0.5, y + 0.5, 0.5]);
    let places = [[0.0, 4.0], [3.0, 0.0], [0.0, 6.5]];
    for k in 0..3 {
        let [first, second, third] = [0, 1, 2].map(|n| places[(k + n) % 3]).map(|[x, y]| at(x, y));
        let inner = first.and(second).and(third).shape().into();
        for (a, b, sign) in [(&outer, &inner, 1), (&inner, &outer, -1)] {
            let mut ways: Vec<_> = found(a, b)
                .iter()
                .map(|manifold| {
                    let way = manifold.normal.raw().map(|c| sign * c / (1 << 30));
                    (way, float(Vec3::X * manifold.separation())[0])
                })
                .collect();
            ways.sort_by_key(|way| way.0);
            assert_eq!(ways, [([0, 1, 0], -1.5), ([1, 0, 0], -2.5)], "from {k}");
        }
    }
}

/// What is not touched yet does not bar the way out.
#[test]
fn a_pebble_within_bars_no_way() {
    let pebble = Solid::cuboid([-0.1, 1.0, -0.1], [0.1, 1.1, 0.1]);
    let outer = Solid::cuboid([-5.0, -5.0, -5.0], [5.0, 2.0, 5.0]).and(pebble).shape().into();
    let body = cuboid([0.0, 0.69, 0.0], [0.3; 3]);
    let manifolds = found(&body, &outer);
    let [manifold] = manifolds.as_slice() else { panic!("{manifolds:?}") };
    assert_eq!(manifold.normal, -UnitVec3::Y);
}

/// Boxes that go through walls get out too, also those that are too wide for the pit where they
/// are: they are not led to and fro. No push leads one that does into the solid.
#[test]
fn what_goes_through_walls_of_a_pit_gets_out() {
    let pit = Solid::pit().shape();
    let surface: Shape = pit.clone().into();
    let mut rng = Pcg::new(32, 0);
    let mut counts = [0; PUSHES_MAX + 1];
    while counts.iter().sum::<i32>() < 400 {
        let center = [number(&mut rng), 9.0 * number(&mut rng), number(&mut rng)];
        let half = [(); 3].map(|()| 0.05 + 0.2 * number(&mut rng).abs());
        let first = cuboid(center, half);
        if !overlap(&first, &surface) {
            continue;
        }
        let (mut body, mut pushes) = (first.clone(), 0);
        while !is_out(&body, &pit) {
            assert!(pushes < PUSHES_MAX, "{first:?} has come to {body:?}");
            pushes += 1;
            body = pushed(&body, &found(&body, &surface)).unwrap_or_else(|| panic!("{body:?}"));
            assert!(overlap(&body, &surface) || is_out(&body, &pit), "{first:?} went into it");
        }
        counts[pushes] += 1;
    }
    assert!(20 * counts[1] > 19 * 400, "{counts:?}");
}

/// A shell that is inside is led out, whatever others of the same body do: touch from outside,
/// rest, or have gone in themselves.
#[test]
fn what_is_inside_is_led_out_beside_what_is_not() {
    let outer: Shape = Solid::cuboid([-5.0; 3], [5.0; 3]).shape().into();
    let inside = Solid::cuboid([2.0; 3], [2.5; 3]);
    for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0)] {
        for depth in [0.0, 0.001, 0.3] {
            let corners = [0.0, 1.0].map(|side| {
                let mut corner = [side; 3];
                corner[axis] = sign * (5.0 - depth + side);
                corner
            });
            let [low, high] =
                [f64::min, f64::max].map(|of| [0, 1, 2].map(|k| of(corners[0][k], corners[1][k])));
            let other = Solid::cuboid(low, high);
            for body in [inside.clone().and(other.clone()), other.and(inside.clone())] {
                let body = body.shape().into();
                for found in [found(&outer, &body), found(&body, &outer)] {
                    let least = found.iter().map(Manifold::separation).min();
                    assert!(least <= Some(real!("-2.9")), "{axis} {sign} {depth}: {found:?}");
                    let is_deep = found.iter().any(|m| m.separation() == fixed([-depth; 3]).x);
                    assert!(depth < 0.01 || is_deep, "{axis} {sign}: {found:?}");
                }
            }
        }
    }
}

/// What intersects is not led out as a whole too, though all of its vertices are inside: a pit goes
/// through two sides of the box.
#[test]
fn what_intersects_is_led_out_once() {
    let pit = Solid::pit().shape().into();
    let body = Solid::cuboid([-0.2, 0.4, -0.2], [0.2, 0.8, 0.2]);
    let beside = Solid::cuboid([20.0; 3], [21.0; 3]);
    let alone = found(&body.clone().shape().into(), &pit);
    assert!(!alone.is_empty());
    assert_eq!(found(&body.and(beside).shape().into(), &pit), alone);
}

/// Crates that are up to 0.1 m deep in the floor and the walls of a corner are not led through a
/// wall that they touch with another part.
#[test]
fn crates_in_corners_stay_in_the_room() {
    let room: Shape = Solid::cubes([4; 3], 1, |c| c.iter().any(|&c| c < 1)).shape().into();
    let crates = [
        ([0.250, 0.250, 0.360], [0.001, -0.018, -0.024], [-0.72, -0.64, -0.26], 0.201),
        ([0.136, 0.375, 0.257], [-0.028, 0.004, 0.022], [-0.52, -0.68, -0.52], 0.245),
        ([0.211, 0.341, 0.165], [0.001, -0.012, -0.075], [-0.85, 0.21, 0.48], 0.203),
    ];
    for (half, depth, axis, angle) in crates {
        let way = [0, 1, 2].map(|k| 1.0 + half[k] - depth[k]);
        let mut body = Solid::cuboid(half.map(|c: f64| -c), half);
        body.vertices = body.placed(&Place { axis, angle, way }).into_iter().map(float).collect();
        let found = found(&body.shape().into(), &room);
        let deepest = found.iter().map(Manifold::separation).min();
        assert!(deepest > Some(real!("-0.1")), "{half:?} {depth:?}: {found:?}");
    }
}

/// A box in the walls of a room, whose corner is cut out of the middle of a face: no edge of the
/// box tells that its corners are in the walls.
#[test]
fn what_has_a_hole_cut_by_a_corner_is_deep() {
    let room = Solid::cubes([2, 2, 2], 1, |c| c != [1, 1, 1]).shape();
    let surface: Shape = room.clone().into();
    // Towards the room, and across: the diagonal of a face runs beside the corner.
    let (diagonal, across) = (1.0 / 3.0_f64.sqrt(), 1.0 / 2.0_f64.sqrt());
    for past in [0.005, 0.02, 0.04] {
        let way = [diagonal; 3];
        let sides = [[across, -across, 0.0], [1.0, 1.0, -2.0].map(|c| c / 6.0_f64.sqrt())];
        let center = [0, 1, 2].map(|k| 1.0 + (past - 0.2) * way[k] + 0.08 * sides[1][k]);
        let edges = [way, sides[0], sides[1]].map(|edge| fixed(edge.map(|c| 0.2 * c)));
        let body: Shape = Cuboid::new(fixed(center), edges).expect("a box").into();
        assert!(points(&body).into_iter().all(|point| room.contains(point)));
        let manifolds = found(&body, &surface);
        let deepest = manifolds.iter().map(Manifold::separation).min();
        assert!(deepest < Some(real!("-0.2")), "{past}: {manifolds:?}");
        let body = pushed(&body, &manifolds).expect("a way");
        assert!(is_out(&body, &room), "{past}: {manifolds:?}");
    }
}

/// It reaches 1 m from its middle along each axis.
fn octahedron(middle: [f64; 3]) -> Solid {
    let tip = |k: usize| {
        let mut tip = middle;
        tip[k / 2] += if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        tip
    };
    let mut faces = Vec::new();
    for k in 0..8_u32 {
        let [x, y, z] = [k & 1, 2 + (k >> 1 & 1), 4 + (k >> 2)];
        let is_turned = k.count_ones() % 2 == 1;
        faces.push(if is_turned { [x, z, y] } else { [x, y, z] });
    }
    Solid { vertices: (0..6).map(tip).collect(), faces }
}

/// What is inside just below the surface is led all of the way out.
#[test]
fn what_is_just_inside_is_led_out() {
    let solid: Shape = Solid::cuboid([-5.0; 3], [5.0; 3]).shape().into();
    for below in [0.0001, 0.0019, 0.0025] {
        let body = Solid::cuboid([-0.5, 4.0 - below, -0.5], [0.5, 5.0 - below, 0.5]).shape();
        let deepest = found(&body.into(), &solid).iter().map(Manifold::separation).min();
        assert!(deepest < Some(real!("-1")), "{below}: {deepest:?}");
    }
    // Flush, or up to a tip, whichever vertex comes first.
    let cube = |y: f64| (Solid::cuboid([-0.5, y - 0.5, -0.5], [0.5, y + 0.5, 0.5]), real!("1"));
    let tips = |y: f64| (octahedron([0.3, y, 0.2]), real!("2"));
    for (body, depth) in [cube(4.5), cube(-4.5), tips(4.0), tips(-4.0)] {
        for first in 0..body.faces.len() {
            for corner in 0..3 {
                let mut body = body.clone();
                body.faces.rotate_left(first);
                body.faces.iter_mut().for_each(|face| face.rotate_left(corner));
                let found = found(&body.shape().into(), &solid);
                let deepest = found.iter().map(Manifold::separation).min();
                assert!(deepest <= Some(-depth), "{first} {corner}: {deepest:?}");
            }
        }
    }
}
