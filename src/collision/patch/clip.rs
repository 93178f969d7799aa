//! The polygon that two outlines have in common.

use super::Touch;
use super::outline::{Outline, Plane, Table};
use crate::collision::FeatureId;
use crate::collision::few::Few;
use crate::collision::width::Width;
use crate::math::UnitVec3;
use crate::math::wide::{add, round_div_magnitude, round_shift_wide, sub, to_i64};

/// The corners of what two outlines have in common, at most `margin` apart along the normal.
pub(super) fn common<W: Width>(
    normal: UnitVec3,
    [a, b]: [&Outline; 2],
    margin: i64,
) -> Few<Touch, 8> {
    let mut touches = Few::new();
    let mut keep = |touch: Touch| {
        if touch.separation <= margin {
            touches.push(touch);
        }
    };
    let over_a = Table::new::<W>(a, normal, b);
    let mut is_within = a.is_face();
    if let Some(plane) = Plane::<W>::new(a, normal).filter(|_| a.is_face()) {
        for (j, corner) in b.corners.iter().enumerate() {
            if over_a.least(j) < 0 {
                is_within = false;
                continue;
            }
            let separation = plane.height(corner.at);
            let on_a = sub(corner.at, W::step(normal, separation));
            let features = [a.face, FeatureId::vertex(corner.vertex)];
            keep(Touch { features, on: [on_a, corner.at], separation });
        }
    }
    if is_within {
        return touches;
    }
    let over_b = Table::new::<W>(b, -normal, a);
    if let Some(plane) = Plane::<W>::new(b, -normal).filter(|_| b.is_face()) {
        for (i, corner) in a.corners.iter().enumerate() {
            if over_b.least(i) <= 0 {
                continue;
            }
            let separation = plane.height(corner.at);
            let on_b = add(corner.at, W::step(normal, separation));
            let features = [FeatureId::vertex(corner.vertex), b.face];
            keep(Touch { features, on: [corner.at, on_b], separation });
        }
    }
    for [i, next_i] in a.sides() {
        for [j, next_j] in b.sides() {
            let across_a = [over_a.of(i, j), over_a.of(i, next_j)];
            let across_b = [over_b.of(j, i), over_b.of(j, next_i)];
            if (across_a[0] < 0) == (across_a[1] < 0) || (across_b[0] > 0) == (across_b[1] > 0) {
                continue;
            }
            let on_a = between([a.corners[i].at, a.corners[next_i].at], across_b);
            let on_b = between([b.corners[j].at, b.corners[next_j].at], across_a);
            let separation = W::round(W::along(normal, sub(on_b, on_a)));
            let features = [a.corners[i].edge, b.corners[j].edge].map(FeatureId::edge);
            keep(Touch { features, on: [on_a, on_b], separation });
        }
    }
    touches
}

/// The point of a segment where a linear function is 0 that has these values at its ends, not both
/// on one side. From the end inside, so that it does not depend on which end comes first.
///
/// The share errs by less than 2^-30, so the point by less than a unit while the segment is shorter
/// than 64 m, and by a quarter of a millimetre where it is as long as may be.
#[inline]
fn between(ends: [[i64; 3]; 2], inside: [i128; 2]) -> [i64; 3] {
    let (from, to) = if inside[0] > inside[1] { (0, 1) } else { (1, 0) };
    let (near, far) = (inside[from].unsigned_abs(), inside[to].unsigned_abs());
    // Magnitudes are below 2^127, and one is above 0.
    let whole = near + far;
    let surplus = (u128::BITS - whole.leading_zeros()).saturating_sub(33);
    // Of 33 bits.
    let (near, whole) = ((near >> surplus) as u64, (whole >> surplus) as u64);
    let share = i128::from(round_div_magnitude(near << 30, whole));
    let way = sub(ends[to], ends[from]);
    // The share is at most 2^30.
    add(ends[from], way.map(|c| to_i64(round_shift_wide(i128::from(c) * share, 30))))
}
