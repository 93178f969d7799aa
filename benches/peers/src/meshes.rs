//! Two spheres of 70,312 triangles each, a millimetre apart or into one another.

use std::f64::consts::{PI, TAU};
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use parry3d::math::{Pose, Vector};
use parry3d::query::intersection_test;
use parry3d::shape::TriMesh;
use verlock::geometry::TriangleMesh;
use verlock::partition::bvh::{Bvh, CellBox, CellCylinder, CellSphere, Precision, Volume};
use verlock::{Real, Vec3};

use crate::clock::{rounds, shortest};

/// Divisions along and across.
const DIVISIONS: u32 = 188;
/// From the first centre to the second.
const DIRECTION: [f64; 3] = [0.6, 0.48, 0.64];
/// Axis times angle, radians.
const TURN: [f64; 3] = [0.3, 0.5, 0.7];

/// A ball of radius 1 m about 0.
struct Ball {
    vertices: Vec<[f64; 3]>,
    faces: Vec<[u32; 3]>,
}

/// Where the second ball is.
#[derive(Clone, Copy)]
struct Place {
    name: &'static str,
    turn: [f64; 3],
    distance: f64,
}

/// Prints all measurements.
pub fn run() {
    let ball = Ball::new();
    let first = ball.mesh(|p| p);
    trees(&ball, &first);
    let peer = ball.peer();
    let places = [
        Place { name: "1 mm into one another", turn: [0.0; 3], distance: 1.999 },
        Place { name: "1 mm apart", turn: [0.0; 3], distance: 2.001 },
        Place { name: "turned, 1 mm into one another", turn: TURN, distance: 1.999 },
        Place { name: "turned, 1 mm apart", turn: TURN, distance: 2.001 },
        Place { name: "turned, 100 mm into one another", turn: TURN, distance: 1.9 },
    ];
    for place in places {
        let way = DIRECTION.map(|c| c * place.distance);
        let [pose, other] = [Pose::identity(), place.pose()];
        let meets =
            || intersection_test(&pose, &peer, &other, &peer).expect("two meshes").intersecting;
        let theirs = shortest(&(), |()| {
            black_box(meets());
        });
        println!("{}: parry3d says {} in {:.1} us", place.name, meets(), micros(theirs));
        let second = ball.mesh(|p| add(turned(p, place.turn), way));
        ours::<CellBox>("box", &first, &second, theirs);
        ours::<CellSphere>("sphere", &first, &second, theirs);
        ours::<CellCylinder>("cylinder", &first, &second, theirs);
    }
}

/// Making trees and moving their vertices.
fn trees(ball: &Ball, mesh: &Arc<TriangleMesh>) {
    println!("{} faces", mesh.faces().len());
    let made = once(|| ball.peer());
    println!("parry3d: made in {:.1} ms", micros(made) / 1e3);
    tree::<CellBox>("box", mesh);
    tree::<CellSphere>("sphere", mesh);
    tree::<CellCylinder>("cylinder", mesh);
}

fn tree<V: Volume>(name: &str, mesh: &Arc<TriangleMesh>) {
    let mut bvh = Bvh::<V>::new(mesh.clone());
    let made = once(|| Bvh::<V>::new(mesh.clone()));
    let refit = once(|| bvh.refit(mesh.vertices()));
    let [made, refit] = [made, refit].map(|time| micros(time) / 1e3);
    println!("{name:<8}: made in {made:.1} ms, refit in {refit:.2} ms, {} nodes", bvh.nodes());
}

/// All pairs, and whether there is one.
fn ours<V: Volume>(
    name: &str,
    first: &Arc<TriangleMesh>,
    second: &Arc<TriangleMesh>,
    theirs: Duration,
) {
    let [first, second] = [first, second].map(|mesh| Bvh::<V>::new(mesh.clone()));
    let all = shortest(&(), |()| {
        black_box(first.pairs(&second, Precision::Exact));
    });
    let any = shortest(&(), |()| {
        black_box(first.overlaps(&second, Precision::Exact));
    });
    let [found, near] = [Precision::Exact, Precision::Volumes]
        .map(|precision| first.pairs(&second, precision).len());
    let told = |time: Duration| {
        format!(
            "{:.1} us, parry3d * {:.2}",
            micros(time),
            time.as_secs_f64() / theirs.as_secs_f64()
        )
    };
    let (all, any) = (told(all), told(any));
    println!("  {name:<8}: all {found} pairs of {near}: {all}; whether any: {any}");
}

/// The shortest time of something that takes long.
fn once<T>(mut run: impl FnMut() -> T) -> Duration {
    let round = |_| {
        let clock = Instant::now();
        black_box(run());
        clock.elapsed()
    };
    (0..rounds()).map(round).min().unwrap_or_default()
}

impl Ball {
    fn new() -> Self {
        let n = DIVISIONS;
        let ring = |row: u32| {
            let polar = PI * f64::from(row) / f64::from(n);
            (0..n).map(move |column| {
                let around = TAU * f64::from(column) / f64::from(n);
                [polar.sin() * around.cos(), polar.cos(), polar.sin() * around.sin()]
            })
        };
        let mut vertices = vec![[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
        vertices.extend((1..n).flat_map(ring));
        // Row 1 is the first ring; row 0 and row n are the poles.
        let at = |row: u32, column: u32| match row {
            0 => 0,
            row if row == n => 1,
            row => 2 + (row - 1) * n + column % n,
        };
        let cell = |row: u32, column: u32| {
            let [a, b] = [at(row, column), at(row, column + 1)];
            let [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
            [[a, b, c], [b, d, c]]
        };
        let is_face = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
        let cells = (0..n).flat_map(|row| (0..n).flat_map(move |column| cell(row, column)));
        Self { vertices, faces: cells.filter(is_face).collect() }
    }

    fn mesh(&self, place: impl Fn([f64; 3]) -> [f64; 3]) -> Arc<TriangleMesh> {
        let fixed = |&p: &[f64; 3]| {
            let [x, y, z] = place(p).map(|c| Real::from_f64(c).expect("in range"));
            Vec3::new(x, y, z)
        };
        let mesh = TriangleMesh::new(self.vertices.iter().map(fixed), self.faces.iter().copied());
        Arc::new(mesh.expect("a mesh"))
    }

    fn peer(&self) -> TriMesh {
        let vertices = self.vertices.iter().map(|&p| vector(p)).collect();
        TriMesh::new(vertices, self.faces.clone()).expect("a mesh")
    }
}

impl Place {
    fn pose(&self) -> Pose {
        Pose::new(vector(DIRECTION.map(|c| c * self.distance)), vector(self.turn))
    }
}

/// The point turned about 0 (Rodrigues' formula).
fn turned(p: [f64; 3], turn: [f64; 3]) -> [f64; 3] {
    let angle = dot(turn, turn).sqrt();
    if angle == 0.0 {
        return p;
    }
    let k = turn.map(|c| c / angle);
    let cross = [0, 1, 2].map(|i| {
        let [j, l] = [(i + 1) % 3, (i + 2) % 3];
        k[j] * p[l] - k[l] * p[j]
    });
    let along = dot(k, p) * (1.0 - angle.cos());
    [0, 1, 2].map(|i| p[i] * angle.cos() + cross[i] * angle.sin() + k[i] * along)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn vector(p: [f64; 3]) -> Vector {
    let [x, y, z] = p.map(|c| c as f32);
    Vector::new(x, y, z)
}

fn micros(time: Duration) -> f64 {
    time.as_secs_f64() * 1e6
}
