//! Shapes as meshes, to be painted, written and measured.

use std::sync::Arc;

use verlock::geometry::{ConvexHull, Cuboid, MeshError, TriangleMesh, orient3d};
use verlock::math::trig::cos_sin;
use verlock::math::wide::{round_shift, round_shift_wide};
use verlock::math::{Unit, UnitVec3};
use verlock::{Real, Vec3};

/// What a shape looks like.
#[derive(Debug)]
pub(super) struct Look {
    pub(super) mesh: Arc<TriangleMesh>,
    /// Neither surface has a point that is farther from the other one.
    pub(super) rough: Real,
}

/// Sides of what is round.
const SIDES: u32 = 64;

/// The mesh of a hull: a fan for every face.
pub(super) fn of_hull(hull: &ConvexHull) -> Look {
    let fan = |corners: &[u32]| -> Vec<[u32; 3]> {
        corners.windows(2).skip(1).map(|pair| [corners[0], pair[0], pair[1]]).collect()
    };
    exact(hull.vertices().iter().copied(), hull.faces().flat_map(fan))
}

/// The mesh of a box.
pub(super) fn of_box(cuboid: &Cuboid) -> Look {
    // Around each side, counter-clockwise from outside if the edges are right-handed.
    let quads =
        [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let corners = cuboid.corners();
    let is_right = orient3d(corners[0], corners[1], corners[2], corners[4]).is_gt();
    let faces = quads.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    exact(corners, faces.map(|[a, b, c]| if is_right { [a, b, c] } else { [a, c, b] }))
}

/// The mesh of a ball, or of a capsule with ends that differ: rings of corners on its surface.
///
/// Between two corners the surface bulges by `1 - cos(pi / 64)` of the radius at most, along rings
/// and across, and rounding adds a raw unit or so: less than 2^-8 of the radius and 4 units.
///
/// Shapes have their centres where meshes can be, and may reach farther.
pub(super) fn round(ends: [Vec3; 2], radius: Real) -> Result<Look, MeshError> {
    let frame = frame(ends);
    // From one pole to the other; the widest ring is there once for each end.
    let quarter = SIDES / 4;
    let rings: Vec<_> = (0..=quarter)
        .map(|ring| (ends[0], ring))
        .chain((quarter..=2 * quarter).map(|ring| (ends[1], ring)))
        .collect();
    let mut vertices = vec![];
    for &(center, ring) in &rings {
        let [rise, out] = cos_sin(ring, SIDES).map(raw);
        vertices.extend((0..SIDES).map(|k| {
            let [c, s] = cos_sin(k, SIDES).map(raw);
            // Products are at most 2^60, and shortened to 2^30 again.
            let [c, s] = [c, s].map(|part| round_shift(part * out, 30));
            let reach = [-rise, c, s].map(|part| times(radius.raw(), part));
            let way = [0, 1, 2].map(|k| (0..3).map(|i| times(reach[i], frame[i][k])).sum());
            center + Vec3::from_raw(way)
        }));
    }
    let faces = (1..).take(rings.len() - 1).flat_map(|ring: u32| {
        let at = |ring: u32, k: u32| ring * SIDES + k % SIDES;
        (0..SIDES).flat_map(move |k| {
            let [a, b] = [at(ring - 1, k), at(ring - 1, k + 1)];
            let [c, d] = [at(ring, k + 1), at(ring, k)];
            [[a, b, c], [a, c, d]]
        })
    });
    let mesh = TriangleMesh::new(vertices, faces)?;
    // Poles become one vertex, and half the faces at them lines, which are left out.
    let mesh = mesh.welded(Real::ZERO)?.decimated(usize::MAX)?;
    let rough = Real::from_raw((radius.raw() >> 8) + 4);
    Ok(Look { mesh: Arc::new(mesh), rough })
}

/// Along a way, and two directions across, right-handed, 30 fractional bits.
fn frame(ends: [Vec3; 2]) -> [[i64; 3]; 3] {
    let axis = UnitVec3::normalize(ends[1] - ends[0]).unwrap_or(UnitVec3::Y).raw();
    // Any direction across: from the coordinate axis that it is farthest from lying along.
    let least = (0..3).min_by_key(|&k| axis[k].abs()).unwrap_or(0);
    let mut coordinate = [0; 3];
    coordinate[least] = raw(Unit::ONE);
    let across = UnitVec3::normalize(Vec3::from_raw(cross(axis, coordinate)));
    let across = across.unwrap_or(UnitVec3::X).raw();
    [axis, across, cross(axis, across)]
}

/// The cross product of two vectors of length 1, 30 fractional bits.
fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    let minor = |j: usize, k: usize| round_shift(a[j] * b[k] - a[k] * b[j], 30);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// A length of at most 2^40 times a number of at most 2^30, which has 30 fractional bits.
fn times(length: i64, factor: i64) -> i64 {
    let product = round_shift_wide(i128::from(length) * i128::from(factor), 30);
    i64::try_from(product).unwrap_or_default()
}

fn raw(unit: Unit) -> i64 {
    unit.raw().into()
}

fn exact(
    vertices: impl IntoIterator<Item = Vec3>,
    faces: impl IntoIterator<Item = [u32; 3]>,
) -> Look {
    let mesh = TriangleMesh::new(vertices, faces).expect("a shape is in range");
    Look { mesh: Arc::new(mesh), rough: Real::ZERO }
}
