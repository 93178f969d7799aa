//! Surroundings.

use verlock::Vec3;
use verlock::geometry::TriangleMesh;

use super::circle::{circle, mm, raw_mm, times};
use super::noise::noise;
use super::patches::Patches;
use super::round::tube;

/// Hills, 20 m long and wide: a sheet with a boundary.
pub fn terrain(detail: u32) -> TriangleMesh {
    let cells = 16 * detail;
    let mut patches = Patches::default();
    patches.add(cells, cells, |i, j| {
        let along = |k: u32| raw_mm(20_000) * i64::from(k) / i64::from(cells) - raw_mm(10_000);
        let (x, z) = (along(i), -along(j));
        // A hill every 8 m, smaller ones on them.
        let rough =
            |scale: u32| noise([(x >> (11 - scale)) + (9 << 16), 5 << 16, z >> (11 - scale)]);
        let height = times(raw_mm(1600), rough(0))
            + times(raw_mm(500), rough(1))
            + times(raw_mm(120), rough(3));
        Vec3::from_raw([x, height, z])
    });
    patches.mesh()
}

/// A trunk and ten branches, with two leaves each, which are sheets: 21 parts.
pub fn tree(detail: u32) -> TriangleMesh {
    const BRANCHES: u32 = 10;
    let across = 6 * detail;
    let mut patches = Patches::default();
    let mut limb = |from: Vec3, way: Vec3, thick: i64| {
        let steps = 8 * detail;
        let (from, way) = (from.raw(), way.raw());
        let path = |k: u32| {
            let along = |axis: usize| from[axis] + way[axis] * i64::from(k) / i64::from(steps);
            // Bent upwards by the square of the way.
            let bend = raw_mm(150) * i64::from(k * k) / i64::from(steps * steps);
            [along(0), along(1) + bend, along(2)]
        };
        let radius = |k: u32| {
            let end = k == 0 || k == steps;
            if end { 0 } else { thick - thick * 3 / 4 * i64::from(k) / i64::from(steps) }
        };
        tube(&mut patches, steps, across, path, radius);
    };
    limb(Vec3::ZERO, mm(120, 2600, 60), raw_mm(150));
    let branches: Vec<_> = (0..BRANCHES)
        .map(|branch| {
            let [c, s] = circle(branch * 3, BRANCHES);
            let height = 900 + 150 * i64::from(branch);
            let reach = raw_mm(1300 - 80 * i64::from(branch));
            let from = mm(height / 24, height, height / 48);
            let way = Vec3::from_raw([times(reach, c), raw_mm(500), times(reach, s)]);
            (from, way, [c, s])
        })
        .collect();
    for &(from, way, _) in &branches {
        limb(from, way, raw_mm(55));
    }
    for &(from, way, [c, s]) in &branches {
        for side in [-1, 1] {
            let (tip, cells) = ((from + way).raw(), 3 * detail);
            let part = |k: u32, length: i64| length * i64::from(k) / i64::from(cells);
            patches.add(cells, cells, |i, j| {
                let ahead = raw_mm(60) + part(j, raw_mm(380));
                let half = part(j, raw_mm(130)).min(raw_mm(130) - part(j, raw_mm(100)));
                let off =
                    side * raw_mm(110) * i64::from(j) / i64::from(cells) + half / 2 - part(i, half);
                let droop = times(raw_mm(90), noise([off >> 6, ahead >> 6, 3 << 16]));
                let x = tip[0] + times(ahead, c) - times(off, s);
                let z = tip[2] + times(ahead, s) + times(off, c);
                Vec3::from_raw([x, tip[1] + raw_mm(150) + droop, z])
            });
        }
    }
    patches.mesh()
}

/// A room of 6 by 3 by 5 m without a ceiling, with four pillars, a table and a lamp: 10 parts.
pub fn room(detail: u32) -> TriangleMesh {
    let cells = |x: u32, y: u32, z: u32| [x, y, z].map(|c| c * detail);
    let mut patches = Patches::default();
    patches.block(mm(-3000, 0, -2500), mm(3000, 3000, 2500), cells(12, 6, 10));
    let walls = patches.mesh();
    // Turned inside out, without a ceiling.
    let above = |corners: &[u32; 3]| {
        corners.iter().all(|&corner| walls.vertices()[corner as usize].raw()[1] == raw_mm(3000))
    };
    let faces = walls.faces().iter().filter(|corners| !above(corners));
    let faces = faces.map(|&[a, b, c]| [a, c, b]);
    let walls = TriangleMesh::new(walls.vertices().iter().copied(), faces).expect("walls");
    // Nothing is reduced but the vertices of no face.
    let mut parts = vec![walls.decimated(usize::MAX).expect("walls")];
    for (x, z) in [(-2200, -1700), (2200, -1700), (-2200, 1700), (2200, 1700)] {
        let (low, high) = (mm(x - 150, 0, z - 150), mm(x + 150, 3000, z + 150));
        parts.push(patches.block(low, high, cells(1, 8, 1)).mesh());
    }
    parts.push(patches.block(mm(-900, 700, -500), mm(900, 750, 500), cells(6, 1, 4)).mesh());
    for (x, z) in [(-800, -400), (800, 400)] {
        let (low, high) = (mm(x - 40, 0, z - 40), mm(x + 40, 690, z + 40));
        parts.push(patches.block(low, high, cells(1, 4, 1)).mesh());
    }
    let bulb = 8 * detail;
    patches.add(bulb, bulb, |i, j| {
        let ([c, s], [up, out]) = (circle(bulb - i % bulb, bulb), circle(j, 2 * bulb));
        let radius = times(raw_mm(160), out);
        let y = raw_mm(2400) - times(raw_mm(160), up);
        Vec3::from_raw([times(radius, c), y, times(radius, s)])
    });
    parts.push(patches.mesh());
    parts.push(patches.block(mm(-10, 2580, -10), mm(10, 2990, 10), cells(1, 2, 1)).mesh());
    joined(&parts)
}

/// All of these meshes in one, not welded.
fn joined(parts: &[TriangleMesh]) -> TriangleMesh {
    let mut faces = Vec::new();
    let mut first = 0;
    for part in parts {
        faces.extend(part.faces().iter().map(|corners| corners.map(|corner| first + corner)));
        first += u32::try_from(part.vertices().len()).expect("few vertices");
    }
    let vertices = parts.iter().flat_map(|part| part.vertices().iter().copied());
    TriangleMesh::new(vertices, faces).expect("a mesh")
}
