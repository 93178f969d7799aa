//! Moving shapes: never late, never missed, never far.

use std::sync::Arc;

use verlock::Vec3;
use verlock::collision::{Cast, MeshShape, Shape, cast, cast_segment, distance, overlap};
use verlock::geometry::{HalfSpace, Segment, Sphere, Triangle, TriangleMesh};
use verlock::math::{Pcg, Real, Unit, UnitVec3};

use super::twin::Twin;
use super::{CLASSES, Draw, KINDS, kinds, moved};
use crate::query::distance::{near, slack};

/// A part of a way, rounded to nearest.
fn part(motion: Vec3, time: Unit) -> Vec3 {
    Vec3::from_raw(motion.raw().map(|c| {
        let exact = i128::from(c) * i128::from(time.raw());
        let rounded = (exact.abs() + (1 << 29)) >> 30;
        i64::try_from(rounded * exact.signum()).expect("no farther than the way")
    }))
}

fn check(a: &Shape, motion: Vec3, b: &Shape, size: f64) -> Option<Cast> {
    let found = cast(a, motion, b);
    let case = || format!("{found:?} of {a:?} by {motion:?} and {b:?}");
    assert_eq!(found.is_some_and(|cast| cast.touch.is_none()), overlap(a, b), "{}", case());
    let end = found.map_or(Unit::ONE, |cast| cast.time);
    // Before, there is nothing; what is rounded may stand in something by a unit.
    for k in 0..16 {
        let time = Unit::from_raw((i64::from(end.raw()) * k / 16) as i32);
        let twin = apart(&moved(a, part(motion, time)), b);
        assert!(twin >= -4.0 - size * 1e-8 || end == Unit::ZERO, "{} at {time:?}", case());
    }
    let Some(Cast { time, touch: Some(touch), .. }) = found else { return found };
    let there = moved(a, part(motion, time));
    let way = motion.length().raw() as f64;
    // What comes near at right angles to its way may be taken for a touch.
    let most = slack(0.0, size) + way / f64::from(1 << 29);
    assert!(distance(&there, b).raw() as f64 <= most, "{}", case());
    let point = Sphere::new(touch.position, Real::ZERO).expect("near").into();
    assert!(distance(b, &point).raw() as f64 <= most, "{}", case());
    assert!(distance(&there, &point).raw() as f64 <= most, "{}", case());
    found
}

/// The distance by the twin.
fn apart(a: &Shape, b: &Shape) -> f64 {
    let origin = near(a);
    let twin = Twin::of(a, origin).distance(&Twin::of(b, origin));
    // The sign is all it knows of depth: the exact test decides.
    if twin.is_finite() || !overlap(a, b) { twin.max(-1e300) } else { depth(a, b) }
}

/// How deep two shapes overlap: 0 where a way of one or two units along each axis parts them.
fn depth(a: &Shape, b: &Shape) -> f64 {
    let ways = (0..125).map(|code| [code % 5 - 2, code / 5 % 5 - 2, code / 25 - 2]);
    let mut parted = ways.map(|way| !overlap(&moved(a, Vec3::from_raw(way)), b));
    if parted.any(|is_parted| is_parted) { 0.0 } else { f64::NEG_INFINITY }
}

fn compare(pairs: u32, stream: u64) {
    for (index, (unit, most)) in (0..).zip(CLASSES) {
        // A moved shape is rounded, which must be little beside the gaps in it.
        let unit = unit.max(1 << 8);
        let mut hits = [0; 3];
        for kinds in kinds() {
            let rng = Pcg::new(index, stream + (kinds[0] * KINDS.len() + kinds[1]) as u64);
            let mut draw = Draw { rng, unit, most };
            for _ in 0..pairs {
                let [a, b] = draw.pair(kinds);
                let motion = draw.way(3 * most);
                let a = moved(&a, -part(motion, Unit::from_raw(1 << 29)));
                let size = (unit * most) as f64;
                let found = check(&a, motion, &b, size);
                hits[found.map_or(0, |cast| 1 + usize::from(cast.touch.is_some()))] += 1;
            }
        }
        assert!(hits.iter().all(|&n| n > pairs), "class {index}: {hits:?}");
    }
}

#[test]
fn casts_are_never_late() {
    compare(2, 500);
}

/// `cargo test --release -- --ignored casts`.
#[test]
#[ignore = "takes minutes in a release build"]
fn casts_are_never_late_in_many_pairs() {
    compare(500, 700);
}

/// Balls meet when a quadratic equation says.
#[test]
fn balls_meet_when_they_should() {
    let mut draw = Draw { rng: Pcg::new(9, 9), unit: 1 << 10, most: 1 << 16 };
    let mut hits = 0;
    for _ in 0..2000 {
        let [a, b] = draw.pair([1, 1]);
        let motion = draw.way(1 << 18);
        let (Shape::Sphere(p), Shape::Sphere(q)) = (&a, &b) else { unreachable!("spheres") };
        let float = |v: Vec3| v.raw().map(|c| c as f64);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let (w, m) = (float(p.center() - q.center()), float(motion));
        let r = (p.radius() + q.radius()).raw() as f64;
        let (x, y, z) = (dot(m, m), dot(w, m), dot(w, w) - r * r);
        let square = y * y - x * z;
        let exact = (-y - square.max(0.0).sqrt()) / x;
        let found = cast(&a, motion, &b);
        let is_hit = z <= 0.0 || (square >= 0.0 && (0.0..=1.0).contains(&exact));
        // Not those that pass by within a unit.
        if (square / (y * y)).abs() > 1e-6 && (exact - 1.0).abs() > 1e-6 && exact.abs() > 1e-6 {
            assert_eq!(found.is_some(), is_hit, "{a:?} by {motion:?} and {b:?}");
            let time = found.filter(|cast| cast.touch.is_some()).map(|cast| cast.time.raw());
            if let Some(time) = time {
                let off = exact - f64::from(time) / f64::from(1 << 30);
                assert!((-1e-8..1e-6).contains(&off), "{off} of {exact}");
                hits += 1;
            }
        }
    }
    assert!(hits > 100, "only {hits}");
}

/// A face that overlaps from the start counts before one that touches at once.
#[test]
fn what_overlaps_is_told_before_what_touches_at_once() {
    let floor = HalfSpace::new(Vec3::ZERO, UnitVec3::Y).expect("legal").into();
    let corner = |x: i32, y: i64| Vec3::from_raw([i64::from(x) << 24, y, i64::from(x * x) << 24]);
    let vertices = [corner(0, 1), corner(1, 1), corner(2, 1), corner(3, 0)];
    let mesh = TriangleMesh::new(vertices, [[0, 1, 2], [1, 2, 3]]).expect("legal");
    let mesh = MeshShape::new(Arc::new(mesh)).into();
    // One unit of a way of 2^31.
    let hit = cast(&mesh, Vec3::from_ints(0, -128, 0), &floor).expect("a hit");
    assert_eq!((hit.time, hit.touch, hit.part_a), (Unit::ZERO, None, 1));
    let hit = cast(&floor, Vec3::from_ints(0, 128, 0), &mesh).expect("a hit");
    assert_eq!((hit.time, hit.touch, hit.part_b), (Unit::ZERO, None, 1));
}

/// No segment slips through a triangle, between two, or past a corner of a fan.
#[test]
fn segments_do_not_slip_between_triangles() {
    let mut draw = Draw { rng: Pcg::new(10, 10), unit: 1, most: 1 << 24 };
    for _ in 0..500 {
        let middle = draw.way(1 << 24);
        let ring: Vec<_> = [[1, 0], [0, 1], [-1, 0], [0, -1]]
            .map(|[x, z]| {
                let y = draw.below(1 << 22);
                middle + Vec3::from_raw([x << 25, y - (1 << 21), z << 25])
            })
            .into();
        let fan: Vec<Shape> = (0..4)
            .map(|k| Triangle::new([middle, ring[k], ring[(k + 1) % 4]]).expect("near").into())
            .collect();
        // Down, through the hub, a spoke or anywhere.
        let (a, b) = (draw.below(8), draw.below(8));
        let spoke = ring[draw.below(3) as usize] - middle;
        let aim = middle + Vec3::from_raw(spoke.raw().map(|c| c * a / 16));
        let tilt = Vec3::from_raw([b << 10, 0, a << 11]);
        let [top, bottom] = [1 << 24, -(1 << 24)].map(|y| Vec3::from_raw([0, y, 0]));
        let segment = Segment::new([aim + top + tilt, aim + bottom - tilt]).expect("near");
        assert!(fan.iter().any(|face| cast_segment(&segment, face).is_some()), "{segment:?}");
    }
}
