//! Contact manifolds of pairs of boxes, beside parry's.
//!
//! Both get the same boxes, one pair after the other, with nothing kept between them. parry is
//! given poses, verlock boxes whose normals are known, which a body finds once a tick; what that
//! costs is told too.

use std::hint::black_box;
use std::time::{Duration, Instant};

use parry3d::math::{Pose, Rotation, Vector};
use parry3d::query::ContactManifold;
use parry3d::query::details::contact_manifold_cuboid_cuboid;
use parry3d::shape::Cuboid as PeerBox;
use verlock::collision::manifold_cuboid_cuboid;
use verlock::geometry::Cuboid;
use verlock::math::Pcg;
use verlock::{Real, Vec3};

use crate::clock::rounds;

/// So many that no branch predictor learns them.
const PAIRS: usize = 4096;
/// Metres, for both.
const MARGIN: f32 = 0.02;

/// How the pairs of a set lie.
#[derive(Clone, Copy, Debug)]
enum Set {
    /// Turned any way.
    Touching,
    /// The upper one flat on the lower one.
    Resting,
    /// The upper one on an edge or a corner.
    Tilted,
}

struct Body {
    half: Vector,
    pose: Pose,
}

/// Numbers in -1..1.
struct Draw(Pcg);

impl Draw {
    fn number(&mut self) -> f32 {
        f32::from((self.0.next_u64() >> 48) as u16) / 32768.0 - 1.0
    }

    fn vector(&mut self) -> Vector {
        Vector::new(self.number(), self.number(), self.number())
    }

    fn half(&mut self) -> Vector {
        self.vector().abs() * 0.5 + Vector::new(0.25, 0.25, 0.25)
    }

    fn pair(&mut self, set: Set) -> [Body; 2] {
        let turn = |axis: Vector, angle: f32| Rotation::from_scaled_axis(axis * angle);
        let yaw = turn(Vector::Y, 3.0 * self.number());
        let any = |draw: &mut Self| turn(draw.vector(), 3.0);
        let (first, second, way) = match set {
            Set::Touching => (any(self), any(self), self.vector()),
            Set::Resting => {
                let tilt = turn(self.vector(), 0.002);
                (yaw, tilt * turn(Vector::Y, 3.0 * self.number()), self.above())
            }
            Set::Tilted => (yaw, turn(self.vector(), 1.0) * yaw, self.above()),
        };
        let a = Body { half: self.half(), pose: Pose::from_parts(Vector::ZERO, first) };
        let half = self.half();
        let at = |s: f32| Body { half, pose: Pose::from_parts(way * s, second) };
        // Where they part.
        let (mut near, mut far) = (0.0, 100.0);
        for _ in 0..40 {
            let middle = (near + far) / 2.0;
            if a.meets(&at(middle)) { near = middle } else { far = middle }
        }
        let b = at(far + 0.01 * self.number() / way.length());
        [a, b]
    }

    fn above(&mut self) -> Vector {
        Vector::new(0.5 * self.number(), 1.0, 0.5 * self.number())
    }
}

impl Body {
    fn cuboid(&self) -> Cuboid {
        let raw = |v: Vector| {
            Vec3::from_raw([v.x, v.y, v.z].map(|c| (f64::from(c) * 16_777_216.0) as i64))
        };
        let edges = [Vector::X * self.half.x, Vector::Y * self.half.y, Vector::Z * self.half.z];
        let edges = edges.map(|edge| raw(self.pose.rotation * edge));
        Cuboid::new(raw(self.pose.translation), edges).expect("a box")
    }

    fn meets(&self, other: &Self) -> bool {
        let [a, b] = [self, other].map(|body| PeerBox::new(body.half));
        parry3d::query::intersection_test(&self.pose, &a, &other.pose, &b)
            .is_ok_and(|met| met.intersecting)
    }
}

/// Prints all measurements.
pub fn run() {
    for set in [Set::Touching, Set::Resting, Set::Tilted] {
        let mut draw = Draw(Pcg::new(1, set as u64));
        let pairs: Vec<_> = (0..PAIRS).map(|_| draw.pair(set)).collect();
        compare(set, &pairs);
    }
}

fn compare(set: Set, pairs: &[[Body; 2]]) {
    let theirs: Vec<_> = pairs
        .iter()
        .map(|pair| pair.each_ref().map(|body| (PeerBox::new(body.half), body.pose)))
        .collect();
    let ours: Vec<_> = pairs.iter().map(|pair| pair.each_ref().map(Body::cuboid)).collect();
    let margin = Real::from_f64(f64::from(MARGIN)).expect("fits");
    let mut manifold = ContactManifold::<(), ()>::new();
    let [(peer, found), (own, own_found), (both, _)] = passes([
        &mut || {
            let mut points = 0;
            for [(a, at_a), (b, at_b)] in black_box(&theirs) {
                manifold.clear();
                let between = at_a.inv_mul(at_b);
                contact_manifold_cuboid_cuboid(&between, a, b, MARGIN, &mut manifold);
                points += manifold.points.len();
            }
            points
        },
        &mut || {
            let mut points = 0;
            for [a, b] in black_box(&ours) {
                points +=
                    manifold_cuboid_cuboid(a, b, margin).map_or(0, |found| found.contacts().len());
            }
            points
        },
        &mut || {
            let mut points = 0;
            for [a, b] in black_box(&ours) {
                let [a, b] =
                    [a, b].map(|c| Cuboid::new(c.center(), c.half_edges()).expect("a box"));
                points += manifold_cuboid_cuboid(&a, &b, margin)
                    .map_or(0, |found| found.contacts().len());
            }
            points
        },
    ]);
    let per_pair = |points: usize| points as f64 / PAIRS as f64;
    println!(
        "{set:?}: parry {peer:.0} ns, {:.2} points; verlock {own:.0} ns, * {:.2}, {:.2} points; \
        with normals {both:.0} ns",
        per_pair(found),
        own / peer,
        per_pair(own_found)
    );
}

/// The shortest times of each test, taken in turns, in nanoseconds an item; and what it counted.
fn passes<const N: usize>(mut tests: [&mut dyn FnMut() -> usize; N]) -> [(f64, usize); N] {
    let mut best = [(Duration::MAX, 0); N];
    for _ in 0..rounds() {
        for (best, test) in best.iter_mut().zip(&mut tests) {
            for _ in 0..4 {
                let clock = Instant::now();
                let counted = black_box(test());
                *best = (*best).min((clock.elapsed(), counted));
            }
        }
    }
    best.map(|(time, counted)| (time.as_secs_f64() * 1e9 / PAIRS as f64, counted))
}
