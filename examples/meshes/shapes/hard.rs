//! Shapes with flat sides and sharp edges.

use verlock::Vec3;
use verlock::geometry::TriangleMesh;

use super::circle::{circle, raw_mm, times};
use super::patches::Patches;

/// A wheel of 16 teeth, 40 cm across and 8 cm thick, with a hole.
pub fn gear(detail: u32) -> TriangleMesh {
    wheel(detail, 0, 0)
}

/// The same wheel beside it, a quarter of a tooth further: tooth stands before gap, and 3 mm are
/// missing until they touch.
pub fn pinion(detail: u32) -> TriangleMesh {
    wheel(detail, 1, raw_mm(371))
}

/// A gear whose teeth are some quarters of a tooth further, and which stands `x` to the right.
fn wheel(detail: u32, quarters: u32, x: i64) -> TriangleMesh {
    const TEETH: u32 = 16;
    // Root, flank, tip, flank: a quarter of a tooth each.
    let tooth = 4 * detail;
    let around = TEETH * tooth;
    let outer = |i: u32| {
        let part = i64::from((i + tooth - quarters * detail) % tooth);
        let quarter = i64::from(detail);
        let rise = match part / quarter {
            0 => 0,
            1 => part - quarter,
            2 => quarter,
            _ => 4 * quarter - part,
        };
        raw_mm(165) + raw_mm(35) * rise / quarter
    };
    let at = |i: u32, radius: i64, y: i64| {
        let [c, s] = circle(i, around);
        Vec3::from_raw([x + times(radius, c), y, times(radius, s)])
    };
    let (bore, half) = (raw_mm(60), raw_mm(40));
    let (out, up) = (4 * detail, 2 * detail);
    let between = |i: u32, j: u32| bore + (outer(i) - bore) * i64::from(j) / i64::from(out);
    let height = |j: u32| half * (2 * i64::from(j) - i64::from(up)) / i64::from(up);
    let mut patches = Patches::default();
    patches.add(around, out, |i, j| at(i, between(i, j), half));
    patches.add(around, out, |i, j| at(i, between(i, out - j), -half));
    patches.add(around, up, |i, j| at(i, outer(i), height(up - j)));
    patches.add(around, up, |i, j| at(i, bore, height(j)));
    patches.mesh()
}

/// Six steps of 30 by 18 cm, a metre wide: a column under each.
pub fn stairs(detail: u32) -> TriangleMesh {
    const STEPS: u32 = 6;
    let (wide, deep) = (4 * detail, 2 * detail);
    let part = |length: i64, k: u32, cells: u32| raw_mm(length) * i64::from(k) / i64::from(cells);
    // To the right, up and back, in cells.
    let at = |i: u32, j: u32, k: u32| {
        Vec3::from_raw([part(1000, i, wide), part(180, j, detail), -part(300, k, deep)])
    };
    let mut patches = Patches::default();
    for step in 0..STEPS {
        let (front, top) = (deep * step, detail * (step + 1));
        patches.add(wide, deep, |i, k| at(i, top, front + k));
        patches.add(wide, deep, |i, k| at(i, 0, front + deep - k));
        patches.add(wide, detail, |i, j| at(i, top - detail + j, front));
        patches.add(deep, top, |k, j| at(wide, j, front + k));
        patches.add(deep, top, |k, j| at(0, j, front + deep - k));
    }
    patches.add(wide, detail * STEPS, |i, j| at(wide - i, j, deep * STEPS));
    patches.mesh()
}
