//! Hollow meshes against hollow meshes, in many places: exact triangle pairs say whether they
//! overlap.

use verlock::collision::{Manifold, MeshShape, manifolds_mesh_mesh};
use verlock::math::Pcg;
use verlock::partition::bvh::Precision;
use verlock::{Real, Vec3, real};

use super::solids::{Place, Solid, direction, dot, float, number};

const MARGIN: Real = real!("0.005");

/// Of contacts that are as deep, up to this, a manifold keeps the one of the lowest features.
const TIE: Real = real!("0.00004");

const PUSHES_MAX: u32 = 20;

fn manifolds(a: &MeshShape, b: &MeshShape) -> Vec<Manifold> {
    let mut manifolds = Vec::new();
    manifolds_mesh_mesh(a, b, MARGIN, &mut manifolds);
    manifolds
}

fn overlap(a: &MeshShape, b: &MeshShape) -> bool {
    a.tree().overlaps(b.tree(), Precision::Exact)
}

fn normal(manifold: &Manifold) -> [f64; 3] {
    manifold.normal.raw().map(|c| c as f64 / f64::from(1 << 30))
}

/// What both meshes are, and where the second one goes.
struct Scene {
    solids: [Solid; 2],
    place: fn(&mut Pcg) -> Place,
    /// Whether a point of the middle of a solid is in it, without its mesh.
    holds: Option<fn([f64; 3]) -> bool>,
}

/// What came of some places.
#[derive(Debug, Default)]
struct Tally {
    overlapping: u32,
    touching: u32,
    pushed: u32,
    freed: u32,
}

impl Scene {
    fn check(&self, places: u32) -> Tally {
        let a = self.solids[0].shape();
        let mut b = self.solids[1].shape();
        let (mut rng, mut tally) = (Pcg::new(7, 0), Tally::default());
        for _ in 0..places {
            let place = (self.place)(&mut rng);
            b.move_to(&self.solids[1].placed(&place)).expect("in range");
            let manifolds = manifolds(&a, &b);
            let least = manifolds.iter().map(Manifold::separation).min();
            if !overlap(&a, &b) {
                tally.touching += u32::from(least.is_some());
                assert!(least.is_none_or(|least| least >= Real::ZERO), "{place:?}: {manifolds:?}");
                continue;
            }
            tally.overlapping += 1;
            assert!(least.is_some_and(|least| least <= TIE), "{place:?}: {manifolds:?}");
            let is_freed = frees(&a, &mut b);
            tally.freed += u32::from(is_freed);
            if let Some(holds) = self.holds {
                tally.pushed += u32::from(push_apart(holds, &place, &manifolds, is_freed));
            }
        }
        tally
    }
}

/// Whether B comes free if it is moved by the deepest manifold, and again, a few times.
fn frees(a: &MeshShape, b: &mut MeshShape) -> bool {
    for _ in 0..PUSHES_MAX {
        let Some(deepest) = manifolds(a, b).into_iter().min_by_key(Manifold::separation) else {
            return false;
        };
        let depth = (TIE - deepest.separation()).raw();
        let way = Vec3::from_raw(deepest.normal.raw().map(|c| (c * depth) >> 30));
        let moved: Vec<_> = b.vertices().iter().map(|&vertex| vertex + way).collect();
        b.move_to(&moved).expect("in range");
        if !overlap(a, b) {
            return true;
        }
    }
    false
}

/// Moves B along the normal of the only deep manifold: less of it is in A then, by counting points.
/// Or it goes right through, where the way out is no matter of volumes; then it must come free.
fn push_apart(
    holds: fn([f64; 3]) -> bool,
    place: &Place,
    manifolds: &[Manifold],
    is_freed: bool,
) -> bool {
    let deep: Vec<_> =
        manifolds.iter().filter(|manifold| manifold.separation() < real!("-0.03")).collect();
    let [manifold] = deep.as_slice() else { return false };
    let normal = normal(manifold);
    let count = |by: f64| {
        let moved = Place { way: [0, 1, 2].map(|k| place.way[k] + by * normal[k]), ..*place };
        let step = 0.04;
        let line = |low: f64, high: f64| {
            (0..((high - low) / step) as i32).map(move |k| low + step * f64::from(k))
        };
        let in_a = line(-1.4, 1.4).flat_map(|x| {
            line(-0.4, 0.4).flat_map(move |y| line(-1.4, 1.4).map(move |z| [x, y, z]))
        });
        in_a.filter(|&p| holds(p) && holds(moved.back(p))).count()
    };
    let [behind, before] = [count(-0.02), count(0.02)];
    assert!(
        before < behind || is_freed,
        "{place:?}: {before} of {behind} after a push along {normal:?}"
    );
    true
}

/// In a ring of radii 1 and 0.4 m about y.
fn in_ring(p: [f64; 3]) -> bool {
    (p[0].hypot(p[2]) - 1.0).hypot(p[1]) < 0.4
}

fn rings(n: u32) -> Scene {
    let place = |rng: &mut Pcg| {
        let distance = 2.6 * number(rng);
        let way = direction(rng).map(|c| c * distance);
        Place { axis: direction(rng), angle: 3.2 * number(rng), way }
    };
    Scene { solids: [Solid::ring(n), Solid::ring(n)], place, holds: Some(in_ring) }
}

/// One through the other, upright, nearly free or stuck.
fn links(n: u32) -> Scene {
    let place = |rng: &mut Pcg| {
        let off = [0.25, 0.3, 0.25].map(|reach| reach * number(rng));
        let [x, y, z] = off;
        let angle = std::f64::consts::FRAC_PI_2 + 0.2 * number(rng);
        Place { axis: [1.0, 0.0, 0.0], angle, way: [1.0 + x, y, z] }
    };
    Scene { solids: [Solid::ring(n), Solid::ring(n)], place, holds: Some(in_ring) }
}

/// Teeth of the key.
fn in_key([x, y, z]: [i32; 3]) -> bool {
    z == 1 && (y == 1 && (1..=9).contains(&x) || y == 2 && [2, 3, 6, 9].contains(&x))
}

/// A key with 2 mm of play in its lock.
fn key_in_lock(cuts: [i32; 2]) -> Scene {
    const SIZE: [i32; 3] = [11, 4, 3];
    let key = Solid::cubes(SIZE, cuts[1], in_key).shrunk(0.002);
    let lock =
        Solid::cubes(SIZE, cuts[0], |c| !(in_key(c) || c[0] == 10 && in_key([9, c[1], c[2]])));
    let place = |rng: &mut Pcg| {
        let [x, y, z] = [(); 3].map(|()| 0.0022 * number(rng));
        let out = if rng.below(4) == 0 { 2.0 * number(rng).abs() } else { 0.0 };
        Place { axis: direction(rng), angle: 0.0001 * number(rng), way: [x + out, y, z] }
    };
    Scene { solids: [lock, key], place, holds: None }
}

#[test]
fn no_overlap_of_rings_is_missed() {
    let tally = rings(16).check(60);
    assert!(tally.overlapping > 30 && tally.pushed > 10, "{tally:?}");
    assert_eq!(tally.freed, tally.overlapping);
}

#[test]
fn no_overlap_of_links_is_missed() {
    let tally = links(16).check(60);
    assert!(tally.overlapping > 20 && tally.pushed > 10, "{tally:?}");
    assert_eq!(tally.freed, tally.overlapping);
}

#[test]
fn no_overlap_of_a_key_in_a_lock_is_missed() {
    let tally = key_in_lock([1, 1]).check(60);
    assert!(tally.overlapping > 10 && tally.touching > 5, "{tally:?}");
    // Some are turned so that they are stuck at both ends.
    assert!(tally.freed * 4 > tally.overlapping * 3, "{tally:?}");
}

#[test]
#[ignore = "1,000 places of 5,000 faces each: 2 minutes"]
fn no_overlap_of_large_meshes_is_missed() {
    for (name, scene) in [("rings", rings(50)), ("links", links(50)), ("key", key_in_lock([4, 7]))]
    {
        println!("{name}: {:?} faces", scene.solids.each_ref().map(|solid| solid.faces.len()));
        let tally = scene.check(1000);
        println!("{name}: {tally:?}");
        assert!(tally.freed * 4 > tally.overlapping * 3, "{name}: {tally:?}");
    }
}

/// Exchanging the meshes turns the normals of deep parts round; moving both moves all points.
#[test]
fn pairs_are_symmetric_and_move() {
    let scene = rings(12);
    let mut rng = Pcg::new(8, 0);
    let mut a = scene.solids[0].shape();
    let mut b = scene.solids[1].shape();
    let (mut seen, far) = (0, Vec3::from_raw([-(1 << 55) + 7, 1 << 50, 12345]));
    for _ in 0..60 {
        let places = (scene.place)(&mut rng);
        let positions = scene.solids[1].placed(&places);
        b.move_to(&positions).expect("in range");
        let forward = manifolds(&a, &b);
        let back: Vec<_> = manifolds(&b, &a).iter().map(Manifold::flipped).collect();
        // Which of many near contacts lead a manifold, and which remain, is told by their names.
        let deep = |manifolds: &[Manifold]| {
            let deep = manifolds.iter().filter(|m| m.separation() < real!("-0.002"));
            let mut deep: Vec<_> = deep.map(|m| (m.normal, m.separation())).collect();
            deep.sort_unstable();
            deep
        };
        let is_like = |one: Real, other: Real| (one.raw() - other.raw()).abs() <= TIE.raw();
        assert_eq!(deep(&forward).len(), deep(&back).len());
        for (here, there) in deep(&forward).into_iter().zip(deep(&back)) {
            assert_eq!(here.0, there.0);
            assert!(is_like(here.1, there.1), "{here:?} {there:?}");
        }
        let least = |manifolds: &[Manifold]| manifolds.iter().map(Manifold::separation).min();
        assert_eq!(least(&forward).is_some(), least(&back).is_some());
        assert!(least(&forward).zip(least(&back)).is_none_or(|(one, other)| is_like(one, other)));
        seen += deep(&forward).len();
        let rest = a.vertices().to_vec();
        a.move_to(&rest.iter().map(|&p| p + far).collect::<Vec<_>>()).expect("in range");
        b.move_to(&positions.iter().map(|&p| p + far).collect::<Vec<_>>()).expect("in range");
        let moved = manifolds(&a, &b);
        a.move_to(&rest).expect("in range");
        assert_eq!(forward.len(), moved.len());
        for (here, there) in forward.iter().zip(&moved) {
            assert_eq!(here.normal, there.normal);
            for (here, there) in here.contacts().iter().zip(there.contacts()) {
                assert_eq!(here.features, there.features);
                assert_eq!(here.separation, there.separation);
                assert_eq!([here.on_a + far, here.on_b + far], [there.on_a, there.on_b]);
            }
        }
    }
    assert!(seen > 20, "only {seen} deep manifolds");
}

/// The points of shallow contacts lie on the surfaces they name, and the normal leads from one to
/// the other.
#[test]
fn points_are_as_far_apart_as_told() {
    let scene = key_in_lock([1, 1]);
    let [a, mut b] = scene.solids.each_ref().map(Solid::shape);
    let (mut rng, mut seen) = (Pcg::new(9, 0), 0);
    for _ in 0..30 {
        let place = (scene.place)(&mut rng);
        b.move_to(&scene.solids[1].placed(&place)).expect("in range");
        for manifold in manifolds(&a, &b) {
            for contact in manifold.contacts() {
                let way = float(contact.on_b - contact.on_a);
                let off = dot(way, normal(&manifold)) - float(Vec3::X * contact.separation)[0];
                assert!(off.abs() < 1e-6, "{off} of {contact:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 100, "only {seen} contacts");
}
