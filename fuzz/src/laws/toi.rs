//! Any two features in motion, and small meshes of them: when they touch.

use std::sync::Arc;

use verlock::Vec3;
use verlock::collision::{MeshMotion, MeshShape};
use verlock::geometry::sweep::{Impact, Motion, Sweep};
use verlock::geometry::{Triangle, TriangleMesh};

use super::draw::Draw;
use super::oracle;

/// A vertex and the corners of a face, or the ends of two edges: each at the start and at the end.
type Corners = [[[i64; 3]; 2]; 4];

/// Looks at as many times, and at the start.
const LOOKS: i64 = 16;

/// Coordinates at the times that are looked at are within this: the oracle multiplies four
/// differences of them, in 128 bits.
const FAR: i64 = 1 << 23;

/// They touch no later than at any time at which an oracle sees them touch, wherever they are, and
/// whichever axis is which. True if they touch.
pub fn toi(bytes: &[u8]) -> bool {
    let mut draw = Draw::new(bytes);
    let is_face = draw.below(2) == 0;
    let unit = [1, FAR / 32][draw.below(2)];
    let grid = 1 + draw.below(15);
    let place = |draw: &mut Draw<'_>| {
        [(); 3].map(|()| match draw.below(8) {
            0 => draw.any::<i64>() % FAR,
            _ => unit * draw.below(grid + 1) as i64,
        })
    };
    let mut corners = [(); 4].map(|()| [place(&mut draw), place(&mut draw)]);
    if draw.below(2) == 0 {
        meet(&mut corners, &mut draw);
    }
    let found = sweep(&corners, is_face);
    let touch = (0..=LOOKS).find(|&look| overlap(&corners, is_face, look));
    if let Some(look) = touch {
        let time = found.map(|impact| i64::from(impact.time.raw()) * LOOKS);
        assert!(time.is_some_and(|time| time <= look << 30), "{corners:?} {look}: {found:?}");
    }
    let scale = draw.below(36);
    let way = [(); 3].map(|()| draw.any::<i64>() >> 5);
    let scaled = corners.map(|ends| ends.map(|p| p.map(|c| c << scale)));
    let here = sweep(&scaled, is_face);
    assert!(touch.is_none() || here.is_some(), "{scaled:?}");
    let moved = scaled.map(|ends| ends.map(|p| [0, 1, 2].map(|k| p[k] + way[k])));
    assert_eq!(sweep(&moved, is_face), here, "{scaled:?} moved by {way:?}");
    let turned = scaled.map(|ends| ends.map(|[x, y, z]| [-y, z, x]));
    assert_eq!(sweep(&turned, is_face), here, "{scaled:?} turned");
    meshes(&corners, &mut draw);
    found.is_some()
}

/// Two meshes, each of a face and the same one elsewhere, touch no later than any two of their
/// faces: what is told of one pair does not change what is known of another.
fn meshes(corners: &Corners, draw: &mut Draw<'_>) {
    let work_max = [1, 2, 50, 4096][draw.below(4)];
    let sweep = Sweep { work_max, ..Sweep::default() };
    let mut offset = || [(); 3].map(|()| (draw.any::<i64>() % 64) * (FAR / 64));
    let [away, also] = [offset(), offset()];
    let [p, q, r, s] = *corners;
    let places = |face: [[[i64; 3]; 2]; 3], away: [i64; 3]| {
        let there = face.map(|ends| ends.map(|p| [0, 1, 2].map(|k| p[k] + away[k])));
        let all = face.into_iter().chain(there);
        let all = all.map(|[start, end]| [Vec3::from_raw(start), Vec3::from_raw(end)]);
        all.collect::<Vec<_>>()
    };
    let meshes = [places([p, q, r], away), places([q, r, s], also)].map(|ends| {
        let faces = [[0, 1, 2], [3, 4, 5]];
        let mesh = TriangleMesh::new(ends.iter().map(|ends| ends[0]), faces).expect("in range");
        (MeshShape::new(Arc::new(mesh)), ends.iter().map(|ends| ends[1]).collect::<Vec<_>>())
    });
    let faces = meshes.each_ref().map(|(shape, ends)| {
        shape.mesh().faces().iter().map(|face| {
            let at = |places: &[Vec3]| Triangle::new(face.map(|corner| places[corner as usize]));
            let [start, end] = [shape.vertices(), ends].map(|places| at(places).expect("in range"));
            Motion::new(start, end)
        })
    });
    let [a, b] = meshes.each_ref().map(|(shape, ends)| MeshMotion::new(shape, ends));
    let found = a.expect("in range").time_of_impact(&b.expect("in range"), &sweep);
    let [faces_a, faces_b] = faces;
    for face_a in faces_a {
        for face_b in faces_b.clone() {
            let pair = sweep.triangle_triangle(face_a, face_b);
            // Where searches are not cut, a pair touches when the meshes do, or later.
            let is_known = pair.is_none_or(|pair| {
                pair.is_cut || found.as_ref().is_some_and(|found| found.time <= pair.time)
            });
            assert!(is_known, "{meshes:?} {sweep:?}: {found:?}, {pair:?}");
        }
    }
}

/// Lets the first corner end where another one does, or in the middle between two.
fn meet(corners: &mut Corners, draw: &mut Draw<'_>) {
    let [p, q] = [1 + draw.below(3), 1 + draw.below(3)].map(|corner| corners[corner][1]);
    corners[0][1] = [0, 1, 2].map(|k| (p[k] + q[k]) / 2);
}

fn sweep(corners: &Corners, is_face: bool) -> Option<Impact> {
    // Few boxes: what is cut short must not be late either.
    let sweep = Sweep { work_max: 200, ..Sweep::default() };
    let [p, q, r, s] = corners.map(|ends| {
        let [start, end] = ends.map(Vec3::from_raw);
        Motion::new(start, end)
    });
    if is_face { sweep.vertex_face(p, [q, r, s]) } else { sweep.edge_edge([p, q], [r, s]) }
}

/// Whether they touch at a time: triangles without an area, in units that are smaller by `LOOKS`.
fn overlap(corners: &Corners, is_face: bool, look: i64) -> bool {
    let at = |[start, end]: [[i64; 3]; 2]| {
        [0, 1, 2].map(|k| i128::from(start[k] * (LOOKS - look) + end[k] * look))
    };
    let [p, q, r, s] = corners.map(at);
    if is_face {
        oracle::overlap(&[p, p, p], &[q, r, s])
    } else {
        oracle::overlap(&[p, q, q], &[r, s, s])
    }
}
