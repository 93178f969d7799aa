//! Shapes without an edge.

use verlock::Vec3;
use verlock::geometry::TriangleMesh;
use verlock::math::UnitVec3;

use super::circle::{circle, raw_mm, times};
use super::noise::noise;
use super::patches::Patches;

/// A ring of 30 cm, 10 cm thick.
pub fn torus(detail: u32) -> TriangleMesh {
    let (around, across) = (24 * detail, 12 * detail);
    let path = |k: u32| {
        let [x, z] = circle(k, around).map(|c| times(raw_mm(300), c));
        [x, 0, z]
    };
    tube(&mut Patches::default(), around, across, path, |_| raw_mm(100)).mesh()
}

/// A trefoil knot, 60 cm across.
pub fn knot(detail: u32) -> TriangleMesh {
    let (around, across) = (48 * detail, 8 * detail);
    let path = |k: u32| {
        let ([c2, s2], [c3, s3]) = (circle(2 * k, around), circle(3 * k, around));
        let radius = raw_mm(200) + times(raw_mm(90), c3);
        [times(radius, c2), times(raw_mm(110), s3), times(radius, s2)]
    };
    tube(&mut Patches::default(), around, across, path, |_| raw_mm(45)).mesh()
}

/// Five turns of a wire, 40 cm high, with round ends.
pub fn spring(detail: u32) -> TriangleMesh {
    const TURNS: u32 = 5;
    let (turn, across) = (24 * detail, 6 * detail);
    let along = TURNS * turn;
    let path = |k: u32| {
        let [c, s] = circle(k, turn);
        let rise = raw_mm(400) * i64::from(k) / i64::from(along);
        [times(raw_mm(150), c), rise, times(raw_mm(150), s)]
    };
    let wire = raw_mm(20);
    let mut patches = Patches::default();
    let radius = |k: u32| {
        // Two rings at either end close it.
        let end = k.min(along - k);
        if end == 0 {
            0
        } else if end == 1 {
            wire * 3 / 4
        } else {
            wire
        }
    };
    tube(&mut patches, along, across, path, radius).mesh()
}

/// A vase, 50 cm high, open at the top.
pub fn vase(detail: u32) -> TriangleMesh {
    let (around, up) = (20 * detail, 16 * detail);
    let mut patches = Patches::default();
    patches.add(around, up, |i, j| {
        let height = raw_mm(500) * i64::from(j) / i64::from(up);
        // From a foot over a belly to a neck: two waves.
        let [wave, _] = circle(3 * j, 4 * up);
        let [ripple, _] = circle(3 * j, up);
        let radius = raw_mm(110) - times(raw_mm(50), wave) + times(raw_mm(12), ripple);
        let [c, s] = circle(around - i, around);
        Vec3::from_raw([times(radius, c), height, times(radius, s)])
    });
    let [wave, ripple] = [1 << 30; 2];
    let foot = raw_mm(110) - times(raw_mm(50), wave) + times(raw_mm(12), ripple);
    patches.add(around, 4 * detail, |i, j| {
        let radius = foot * i64::from(j) / i64::from(4 * detail);
        let [c, s] = circle(around - i, around);
        Vec3::from_raw([times(radius, c), 0, times(radius, s)])
    });
    patches.mesh()
}

/// A boulder of about a metre: a cube that is made round, then rough.
pub fn rock(detail: u32) -> TriangleMesh {
    let cells = 8 * detail;
    let corner = Vec3::from_ints(1, 1, 1);
    let cube = Patches::default().block(-corner, corner, [cells; 3]).mesh();
    let vertices = cube.vertices().iter().map(|&place| {
        let direction = UnitVec3::normalize(place).expect("on a cube").raw();
        let rough = |scale: u32| noise(direction.map(|c| (c >> (14 - scale)) + (37 << 16)));
        let radius = raw_mm(500)
            + times(raw_mm(140), rough(0))
            + times(raw_mm(70), rough(1))
            + times(raw_mm(25), rough(2));
        Vec3::from_raw([0, 1, 2].map(|k| times(radius, direction[k])))
    });
    TriangleMesh::new(vertices, cube.faces().iter().copied()).expect("a mesh")
}

/// Adds a tube around a path of `along` steps, closed if the path is.
pub fn tube(
    patches: &mut Patches,
    along: u32,
    across: u32,
    path: impl Fn(u32) -> [i64; 3],
    radius: impl Fn(u32) -> i64,
) -> &mut Patches {
    let is_closed = path(0) == path(along);
    let ring = |k: u32, i: u32| {
        let (before, after) = if is_closed {
            ((k + along - 1) % along, (k + 1) % along)
        } else {
            (k.saturating_sub(1), (k + 1).min(along))
        };
        let (from, to) = (path(before), path(after));
        let ahead = UnitVec3::normalize(Vec3::from_raw([0, 1, 2].map(|k| to[k] - from[k])));
        let ahead = ahead.expect("a path goes on").raw();
        // Across the path and level; what is upright has none that is better than another.
        let level = UnitVec3::normalize(Vec3::from_raw([ahead[2], 0, -ahead[0]]));
        let level = level.unwrap_or(UnitVec3::X).raw();
        let minor = |a: usize, b: usize| times(ahead[a], level[b]) - times(ahead[b], level[a]);
        let up = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let ([c, s], center, radius) = (circle(i, across), path(k), radius(k));
        Vec3::from_raw([0, 1, 2].map(|axis| {
            center[axis] + times(times(radius, c), level[axis]) + times(times(radius, s), up[axis])
        }))
    };
    patches.add(across, along, |i, k| ring(if is_closed { k % along } else { k }, i % across))
}
