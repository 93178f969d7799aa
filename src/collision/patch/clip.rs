//! The polygon that two outlines have in common.

use super::contact;
use super::outline::{Outline, Plane, Table, after, sides};
use crate::collision::width::Width;
use crate::collision::{Contact, FeatureId};
use crate::math::UnitVec3;
use crate::math::wide::{add, round_div_magnitude, sub};

/// Finds the corners of what two outlines have in common, from the origin of the pair.
pub(super) fn common<W: Width>(
    normal: UnitVec3,
    [a, b]: [&Outline; 2],
    mut keep: impl FnMut(Contact),
) {
    let corners: [&[_]; 2] = [&a.corners, &b.corners];
    let over_a = Table::new::<W>(corners[0], normal, corners[1]);
    let mut is_within = false;
    let plane = Plane::<W>::new(a, normal);
    if let Some(plane) = &plane {
        is_within = true;
        for (j, corner) in corners[1].iter().enumerate() {
            if over_a.row(j).iter().any(|&volume| volume < 0) {
                is_within = false;
                continue;
            }
            let features = [a.face, FeatureId::vertex(corner.vertex)];
            keep(above::<W>(plane, normal, features, corner.at));
        }
    }
    if is_within {
        return;
    }
    let over_b = Table::new::<W>(corners[1], -normal, corners[0]);
    if let Some(plane) = Plane::<W>::new(b, -normal) {
        for (i, corner) in corners[0].iter().enumerate() {
            if over_b.row(i).iter().any(|&volume| volume <= 0) {
                continue;
            }
            let separation = plane.height(corner.at);
            let on_b = add(corner.at, W::scale(normal.raw(), separation));
            let features = [FeatureId::vertex(corner.vertex), b.face];
            keep(contact(features, [corner.at, on_b], separation));
        }
    }
    let level = plane.filter(Plane::is_level);
    for_crossings([&over_a, &over_b], corners.map(<[_]>::len), |[i, j], across_a, across_b| {
        let ends = |k: usize, i: usize| [i, after(i, corners[k].len())].map(|i| corners[k][i].at);
        let features = [corners[0][i].edge, corners[1][j].edge].map(FeatureId::edge);
        let on_b = between::<W>(ends(1, j), across_a);
        keep(match &level {
            Some(plane) => above::<W>(plane, normal, features, on_b),
            None => {
                let on_a = between::<W>(ends(0, i), across_b);
                let separation = W::round(W::along(normal, sub(on_b, on_a)));
                contact(features, [on_a, on_b], separation)
            }
        });
    });
}

/// The contact of a point of B with a plane of A.
#[inline]
fn above<W: Width>(
    plane: &Plane<W>,
    normal: UnitVec3,
    features: [FeatureId; 2],
    on_b: [i64; 3],
) -> Contact {
    let separation = plane.height(on_b);
    let on_a = sub(on_b, W::scale(normal.raw(), separation));
    contact(features, [on_a, on_b], separation)
}

/// Calls `found` with the sides of A and B that cross, with the volumes of the ends of B's side
/// across that of A, and with those of A's ends across that of B.
#[inline]
fn for_crossings(
    [over_a, over_b]: [&Table; 2],
    corners: [usize; 2],
    mut found: impl FnMut([usize; 2], [i128; 2], [i128; 2]),
) {
    for j in 0..sides(corners[1]) {
        let rows_a = [over_a.row(j), over_a.row(after(j, corners[1]))];
        for i in 0..sides(corners[0]) {
            let across_a = rows_a.map(|row| row[i]);
            if (across_a[0] < 0) == (across_a[1] < 0) {
                continue;
            }
            let across_b = [over_b.row(i)[j], over_b.row(after(i, corners[0]))[j]];
            if (across_b[0] > 0) != (across_b[1] > 0) {
                found([i, j], across_a, across_b);
            }
        }
    }
}

/// The point of a segment where a linear function is 0 that has these values at its ends, not both
/// on one side. From the end inside, so that it does not depend on which end comes first.
///
/// The share errs by less than 2^-30, so the point by less than a unit while the segment is shorter
/// than 64 m, and by a quarter of a millimetre where it is as long as may be.
#[inline]
fn between<W: Width>(ends: [[i64; 3]; 2], inside: [i128; 2]) -> [i64; 3] {
    let (from, to) = if inside[0] > inside[1] { (0, 1) } else { (1, 0) };
    let (near, far) = (inside[from].unsigned_abs(), inside[to].unsigned_abs());
    // Magnitudes are below 2^127, and one is above 0.
    let whole = near + far;
    let surplus = (u128::BITS - whole.leading_zeros()).saturating_sub(33);
    // Of 33 bits.
    let (near, whole) = ((near >> surplus) as u64, (whole >> surplus) as u64);
    // At most 2^30.
    let share = round_div_magnitude(near << 30, whole).cast_signed();
    add(ends[from], W::scale(sub(ends[to], ends[from]), share))
}
