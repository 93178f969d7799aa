//! Contact manifolds of meshes: capsules on hills, beside parry's, and pairs of rings and of hills,
//! which parry does not take.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use parry3d::math::{Pose, Vector};
use parry3d::query::{
    ContactManifold, ContactManifoldsWorkspace, DefaultQueryDispatcher, PersistentQueryDispatcher,
};
use parry3d::shape::{Capsule as PeerCapsule, TriMesh, TriMeshFlags};
use verlock::collision::{Manifold, MeshShape, manifolds_capsule_surface, manifolds_mesh_mesh};
use verlock::geometry::{Capsule, TriangleMesh};
use verlock::math::Pcg;
use verlock::{Real, Vec3};

use crate::clock::{rounds, shortest};

const CAPSULES: usize = 1024;
/// Metres.
const MARGIN: f64 = 0.02;
/// Cells along a side of the hills: 5,000 faces.
const CELLS: u32 = 50;
/// Metres from vertex to vertex.
const STEP: f64 = 0.5;

/// Vertices and faces.
type Lists = (Vec<[f64; 3]>, Vec<[u32; 3]>);

/// Prints all measurements.
pub fn run() {
    capsules("hills", |x, z| 0.6 * (0.9 * x).sin() * (0.7 * z).cos());
    capsules("a plain", |_, _| 0.0);
    rings();
    hills();
}

/// Numbers in 0..1.
fn number(rng: &mut Pcg) -> f64 {
    f64::from(rng.next_u32()) / 4_294_967_296.0
}

fn capsules(name: &str, height: fn(f64, f64) -> f64) {
    let (vertices, faces) = ground(height);
    let ours = shape(&vertices, &faces, |p| p);
    let theirs = peer(&vertices, &faces, TriMeshFlags::empty());
    let fixed = peer(&vertices, &faces, TriMeshFlags::FIX_INTERNAL_EDGES);
    let mut rng = Pcg::new(1, 0);
    // Lying, standing or tilted, just on the ground below the middle.
    let ends: Vec<[[f64; 3]; 2]> = (0..CAPSULES)
        .map(|_| {
            let mut within = || 2.0 + number(&mut rng) * (f64::from(CELLS) * STEP - 4.0);
            let [x, z] = [within(), within()];
            let way = [(); 3].map(|()| 0.6 * (2.0 * number(&mut rng) - 1.0));
            let y = height(x, z) + 0.3 + way[1].abs();
            [[x + way[0], y + way[1], z + way[2]], [x - way[0], y - way[1], z - way[2]]]
        })
        .collect();
    let own: Vec<_> = ends
        .iter()
        .map(|ends| Capsule::new(ends.map(fixed_point), real(0.3)).expect("a capsule"))
        .collect();
    let peers: Vec<_> =
        ends.iter().map(|[a, b]| PeerCapsule::new(vector(*a), vector(*b), 0.3)).collect();
    let (time, points) = pass(|| {
        let mut manifolds: Vec<Manifold> = Vec::new();
        let mut points = 0;
        for capsule in black_box(&own) {
            manifolds.clear();
            manifolds_capsule_surface(capsule, &ours, real(MARGIN), &mut manifolds);
            points += manifolds.iter().map(|m| m.contacts().len()).sum::<usize>();
        }
        points
    });
    println!("capsules on {name}: verlock {time:.0} ns, {points:.2} points");
    for (kind, mesh) in [("as is", &theirs), ("inner edges fixed", &fixed)] {
        let (peer_time, points) = pass(|| peer_pass(black_box(&peers), mesh));
        let ratio = time / peer_time;
        println!("  parry3d, {kind}: {peer_time:.0} ns, {points:.2} points: verlock * {ratio:.2}");
    }
}

fn peer_pass(capsules: &[PeerCapsule], mesh: &TriMesh) -> usize {
    let mut points = 0;
    for capsule in capsules {
        let mut manifolds: Vec<ContactManifold<(), ()>> = Vec::new();
        let mut workspace: Option<ContactManifoldsWorkspace> = None;
        DefaultQueryDispatcher
            .contact_manifolds(
                &Pose::identity(),
                mesh,
                capsule,
                MARGIN as f32,
                &mut manifolds,
                &mut workspace,
            )
            .expect("a mesh and a capsule");
        points += manifolds.iter().map(|m| m.points.len()).sum::<usize>();
    }
    points
}

/// Two rings of 5,000 faces each that touch.
fn rings() {
    let (vertices, faces) = ring();
    let first = shape(&vertices, &faces, |p| p);
    let places: [(&str, fn([f64; 3]) -> [f64; 3]); 5] = [
        ("side by side, 0.5 mm apart", |p| [p[0] + 2.8, p[1], p[2]]),
        ("side by side, 10 mm deep", |p| [p[0] + 2.79, p[1], p[2]]),
        ("stacked, 0.2 mm apart", |p| [p[0], p[1] + 0.7986, p[2]]),
        ("linked, touching", |[x, y, z]| [x + 1.2, -z, y]),
        ("linked, deep", |[x, y, z]| [x + 0.8, -z, y]),
    ];
    for (name, place) in places {
        let second = shape(&vertices, &faces, place);
        pair(&format!("rings {name}"), &first, &second);
    }
}

/// Hills that cut through hills in many places, none of which leads out of the others.
fn hills() {
    let (vertices, faces) = ground(|x, z| 0.3 * (3.1 * x).sin() * (2.3 * z).cos());
    let first = shape(&vertices, &faces, |p| p);
    let second = shape(&vertices, &faces, |p| [p[0] + 0.9, p[1] + 0.1, p[2] + 0.4]);
    pair("hills through hills", &first, &second);
    pair("cloth through cloth", &first.two_sided(), &second.two_sided());
}

fn pair(name: &str, first: &MeshShape, second: &MeshShape) {
    let mut manifolds = Vec::new();
    let time = shortest(&(), |()| {
        manifolds.clear();
        manifolds_mesh_mesh(first, second, real(0.005), &mut manifolds);
    });
    println!("{name}: {:.0} us, {} manifolds", time.as_secs_f64() * 1e6, manifolds.len());
}

/// The shortest time of a capsule in nanoseconds, and the points of one.
fn pass(mut run: impl FnMut() -> usize) -> (f64, f64) {
    let mut best = (Duration::MAX, 0);
    for _ in 0..2 * rounds() {
        let clock = Instant::now();
        let points = black_box(run());
        best = best.min((clock.elapsed(), points));
    }
    let each = |total: f64| total / CAPSULES as f64;
    (each(best.0.as_secs_f64() * 1e9), each(best.1 as f64))
}

fn ground(height: fn(f64, f64) -> f64) -> Lists {
    let row = CELLS + 1;
    let vertices = (0..row * row).map(|k| {
        let [x, z] = [k % row, k / row].map(|c| f64::from(c) * STEP);
        [x, height(x, z), z]
    });
    let faces = (0..CELLS * CELLS).flat_map(|cell| {
        let a = cell / CELLS * row + cell % CELLS;
        [[a, a + row, a + row + 1], [a, a + row + 1, a + 1]]
    });
    (vertices.collect(), faces.collect())
}

/// A torus about y, of radii 1 m and 0.4 m.
fn ring() -> Lists {
    let n = 50;
    let vertices = (0..n * n).map(|k| {
        let [around, across] = [k / n, k % n].map(|c| TAU * f64::from(c) / f64::from(n));
        let radius = 1.0 + 0.4 * across.cos();
        [radius * around.cos(), 0.4 * across.sin(), radius * around.sin()]
    });
    let at = |i: u32, j: u32| i % n * n + j % n;
    let faces = (0..n * n).flat_map(|k| {
        let (i, j) = (k / n, k % n);
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, d, c], [a, c, b]]
    });
    (vertices.collect(), faces.collect())
}

fn shape(
    vertices: &[[f64; 3]],
    faces: &[[u32; 3]],
    place: impl Fn([f64; 3]) -> [f64; 3],
) -> MeshShape {
    let vertices = vertices.iter().map(|&p| fixed_point(place(p)));
    MeshShape::new(Arc::new(TriangleMesh::new(vertices, faces.iter().copied()).expect("a mesh")))
}

fn peer(vertices: &[[f64; 3]], faces: &[[u32; 3]], flags: TriMeshFlags) -> TriMesh {
    let vertices = vertices.iter().map(|&p| vector(p)).collect();
    TriMesh::with_flags(vertices, faces.to_vec(), flags).expect("a mesh")
}

fn real(v: f64) -> Real {
    Real::from_f64(v).expect("in range")
}

fn fixed_point(p: [f64; 3]) -> Vec3 {
    let [x, y, z] = p.map(real);
    Vec3::new(x, y, z)
}

fn vector(p: [f64; 3]) -> Vector {
    let [x, y, z] = p.map(|c| c as f32);
    Vector::new(x, y, z)
}
