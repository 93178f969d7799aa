//! Whole meshes against looking at every pair of faces, and against roots in big integers.

use std::sync::Arc;

use verlock::collision::{FeatureKind, MeshMotion, MeshShape};
use verlock::geometry::sweep::{Motion, Sweep};
use verlock::geometry::{Triangle, TriangleMesh};
use verlock::math::{Pcg, Unit};
use verlock::partition::bvh::Precision;
use verlock::{Real, Vec3};

use super::{Corners, number, oracle};

/// Faces between random vertices around a place; some share corners, some are lines or points.
fn soup(rng: &mut Pcg, centre: [i64; 3], size: i64) -> MeshShape {
    let vertices: Vec<_> =
        (0..9).map(|_| Vec3::from_raw(centre.map(|c| c + number(rng, size)))).collect();
    let faces = (0..10).map(|_| [(); 3].map(|()| rng.below(9)));
    MeshShape::new(Arc::new(TriangleMesh::new(vertices, faces).expect("in range")))
}

fn moved(rng: &mut Pcg, shape: &MeshShape, by: [i64; 3], own: i64) -> Vec<Vec3> {
    let corner = |&p: &Vec3| p + Vec3::from_raw(by.map(|c| c + number(rng, own)));
    shape.vertices().iter().map(corner).collect()
}

/// The faces in motion.
fn faces(shape: &MeshShape, end: &[Vec3]) -> Vec<Motion<Triangle>> {
    let faces = shape.mesh().faces().iter();
    let triangle = |corners: &[u32; 3], positions: &[Vec3]| {
        Triangle::new(corners.map(|v| positions[v as usize])).expect("in range")
    };
    faces.map(|f| Motion::new(triangle(f, shape.vertices()), triangle(f, end))).collect()
}

/// Returns whether they touch.
fn check(rng: &mut Pcg, size: i64, gap: i64) -> bool {
    let away = [number(rng, size), number(rng, size), 9 * size / 4];
    let [a, b] = [soup(rng, [0; 3], size), soup(rng, away, size)];
    let rise = [0, 0, number(rng, size) + size];
    let ends_a = moved(rng, &a, rise, size / 4);
    let ends_b = moved(rng, &b, [0; 3], size / 4);
    let sweep = Sweep { gap: Real::from_raw(gap), ..Sweep::default() };
    let motion = |shape, ends| MeshMotion::new(shape, ends).expect("in range");
    let (moving_a, moving_b) = (motion(&a, &ends_a), motion(&b, &ends_b));
    let found = moving_a.time_of_impact(&moving_b, &sweep);
    let mut first = None;
    for face_a in faces(&a, &ends_a) {
        for &face_b in &faces(&b, &ends_b) {
            let impact = sweep.triangle_triangle(face_a, face_b);
            let time = impact.map(|impact| impact.time);
            first = [first, time].into_iter().flatten().min();
        }
    }
    match (&found, first) {
        (None, None) => {}
        (Some(found), Some(first)) => {
            // Either may be early by a few units. That it is never late is told in big integers.
            let late = found.time.raw() - first.raw();
            assert!(late <= 64, "{found:?}, all pairs: {first}");
            assert!(late >= -64 || found.is_cut, "{found:?}, all pairs: {first}");
            assert!(found.features.is_sorted(), "{found:?}");
            let kinds = found.features.iter().map(|features| features.map(|f| f.kind()));
            use FeatureKind::{Edge, Face, Vertex};
            let legal = [[Vertex, Face], [Face, Vertex], [Edge, Edge], [Face, Face]];
            assert!(kinds.clone().all(|kinds| legal.contains(&kinds)), "{found:?}");
        }
        (found, first) => panic!("{found:?}, all pairs: {first:?}"),
    }
    let time = moving_a.advance(&moving_b, &sweep);
    let [mut landed_a, mut landed_b] = [a.clone(), b.clone()];
    landed_a.move_to(&moving_a.at(time)).expect("in range");
    landed_b.move_to(&moving_b.at(time)).expect("in range");
    let met = landed_a.tree().overlaps(landed_b.tree(), Precision::Exact);
    let met_at_start = a.tree().overlaps(b.tree(), Precision::Exact);
    assert_eq!(met, met_at_start, "{time}");
    assert!(!met || time == Unit::ZERO);
    match found {
        Some(found) => assert!(time <= found.time),
        None => assert_eq!(time, Unit::ONE),
    }
    first.is_some()
}

fn all(seed: u64, pairs: u32) {
    let mut rng = Pcg::new(seed, 31);
    let mut hits = 0;
    for round in 0..pairs {
        let size = [20, 1 << 20, 1 << 24, 1 << 31, 1 << 37][rng.below(5) as usize];
        let gap = if round % 4 == 0 { size / 8 } else { 2 };
        hits += u32::from(check(&mut rng, size, gap));
    }
    println!("{hits} of {pairs} touch");
    assert!(pairs / 5 < hits && hits < pairs, "{hits}");
}

#[test]
fn meshes_touch_when_their_faces_do() {
    all(1, 60);
}

#[test]
#[ignore = "ten thousand pairs of meshes: some minutes with --release"]
fn ten_thousand_meshes_touch_when_their_faces_do() {
    all(2, 10_000);
}

/// Two meshes of a few faces, and where their vertices end.
#[derive(Debug)]
struct Pair {
    shapes: [MeshShape; 2],
    ends: [Vec<Vec3>; 2],
}

/// Small flat triangles that fall flat on large ones, in two places side by side: all in multiples
/// of a power of two.
fn flat(rng: &mut Pcg, shift: u32) -> Pair {
    let mut below = |n: u32| i64::from(rng.below(n));
    let fall = 8 + below(25);
    let mut corners = [vec![], vec![]];
    for place in 0..2 {
        let (x, h, a, b) = (100 * place, 1 + below(7), below(8), below(8));
        corners[0].extend([[x + 4 + a, 0, 4 + b], [x + 5 + a, 0, 4 + b], [x + 4 + a, 0, 5 + b]]);
        corners[1].extend([[x, -h, 0], [x + 40, -h, 0], [x, -h, 40]]);
    }
    Pair::rigid(corners, [[0, -fall, 0], [0; 3]], shift)
}

/// Few places, so that much is parallel, in one plane or in one point.
fn few(rng: &mut Pcg, shift: u32) -> Pair {
    let mut near = |most: i64| [(); 3].map(|()| number(rng, most));
    let corners = [0, 1].map(|_| (0..6).map(|_| near(4)).collect::<Vec<_>>());
    let motions = [near(8), near(2)];
    Pair::rigid(corners, motions, shift)
}

impl Pair {
    /// Two faces each, which do not turn.
    fn rigid(corners: [Vec<[i64; 3]>; 2], motions: [[i64; 3]; 2], shift: u32) -> Self {
        let point = |p: [i64; 3]| Vec3::from_raw(p.map(|c| c << shift));
        let shapes = corners.map(|corners| {
            let mesh = TriangleMesh::new(corners.into_iter().map(point), [[0, 1, 2], [3, 4, 5]]);
            MeshShape::new(Arc::new(mesh.expect("in range")))
        });
        let end = |k: usize| shapes[k].vertices().iter().map(|&p| p + point(motions[k])).collect();
        let ends = [end(0), end(1)];
        Self { shapes, ends }
    }

    fn motions<'a>(&'a self, ends: &'a [Vec<Vec3>; 2]) -> [MeshMotion<'a>; 2] {
        [0, 1].map(|k| MeshMotion::new(&self.shapes[k], &ends[k]).expect("in range"))
    }

    fn faces(&self) -> [Vec<[[[i64; 3]; 2]; 3]>; 2] {
        [0, 1].map(|k| {
            let faces = faces(&self.shapes[k], &self.ends[k]).into_iter();
            let raw = |c: Motion<Vec3>| [c.start.raw(), c.end.raw()];
            faces.map(|face| face.corners().map(raw)).collect()
        })
    }

    /// All pairs of features of two faces.
    fn features(&self) -> Vec<(Corners, bool)> {
        let [of_a, of_b] = self.faces();
        let mut features = vec![];
        for a in &of_a {
            for b in &of_b {
                for k in 0..3 {
                    features.push(([a[k], b[0], b[1], b[2]], true));
                    features.push(([b[k], a[0], a[1], a[2]], true));
                    for j in 0..3 {
                        features.push(([a[k], a[(k + 1) % 3], b[j], b[(j + 1) % 3]], false));
                    }
                }
            }
        }
        features
    }

    /// Whatever the work, the time is not late, nor is what they advance to, and rounded they do
    /// not touch on the way there. Returns whether they touch.
    fn check(&self) -> bool {
        let features = self.features();
        let contacts =
            features.iter().flat_map(|(corners, is_face)| oracle::contacts(corners, *is_face));
        let mut contacts: Vec<_> = contacts.collect();
        let [a, b] = self.motions(&self.ends);
        for work_max in [0, 1, 2, 5, 40, 4096] {
            for gap in [0, 2] {
                let sweep = Sweep { gap: Real::from_raw(gap), work_max };
                let found = a.time_of_impact(&b, &sweep);
                let time = found.as_ref().map_or(Unit::ONE, |found| found.time);
                assert!(found.is_some() || contacts.is_empty(), "{self:?} {sweep:?}");
                for contact in &mut contacts {
                    let is_early = contact.is_at_least(time.raw());
                    assert!(is_early, "{self:?} {sweep:?}: {found:?}, {contact:?}");
                }
                let landing = a.advance(&b, &sweep);
                assert!(landing < time || found.is_none() || landing == Unit::ZERO);
                let landed = [a.at(landing), b.at(landing)];
                let [way_a, way_b] = self.motions(&landed);
                let met = way_a.time_of_impact(&way_b, &Sweep::default());
                // A gap that no rounding bridges.
                let is_apart = met.is_none() || landing == Unit::ZERO || gap < 2;
                assert!(is_apart, "{self:?} {sweep:?} {landing}: {met:?}");
            }
        }
        !contacts.is_empty()
    }
}

fn all_rigid(seed: u64, pairs: u32) {
    let mut rng = Pcg::new(seed, 32);
    let mut hits = 0;
    for round in 0..pairs {
        let shift = [0, 4, 8, 16, 24][rng.below(5) as usize];
        let pair = if round % 2 == 0 { flat(&mut rng, shift) } else { few(&mut rng, shift) };
        hits += u32::from(pair.check());
    }
    println!("{hits} of {pairs} touch");
    assert!(pairs / 2 < hits && hits < pairs, "{hits}");
}

#[test]
fn what_moves_without_turning_is_never_late() {
    all_rigid(1, 60);
}

#[test]
#[ignore = "thousands of pairs of meshes in big integers: some minutes with --release"]
fn what_moves_without_turning_is_never_late_many_times() {
    all_rigid(2, 4_000);
}

/// Found as late: a contact that is known stays, whatever is looked at after it.
#[test]
fn a_later_contact_does_not_replace_an_earlier_one() {
    let a = [
        [2304, 0, 2560],
        [2560, 0, 2560],
        [2304, 0, 2816],
        [26624, 0, 2816],
        [26880, 0, 2816],
        [26624, 0, 3072],
    ];
    let b = [
        [0, -256, 0],
        [10240, -256, 0],
        [0, -256, 10240],
        [25600, -1280, 0],
        [35840, -1280, 0],
        [25600, -1280, 10240],
    ];
    let pair = Pair::rigid([a.to_vec(), b.to_vec()], [[0, -2560, 0], [0; 3]], 0);
    assert!(pair.check());
    let [a, b] = pair.motions(&pair.ends);
    let found = a.time_of_impact(&b, &Sweep::default()).expect("touches");
    assert_eq!((found.time.raw(), found.is_cut), ((1 << 30) / 10, false), "{found:?}");
}
