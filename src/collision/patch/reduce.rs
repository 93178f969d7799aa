//! Few points that hold as many do.

use super::{TIE, Touch};
use crate::collision::Manifold;
use crate::collision::few::Few;
use crate::math::UnitVec3;
use crate::math::determinant::cross;
use crate::math::wide::{dot_wide, round_shift_wide, sub};

/// What is closer to the rest than this adds nothing, raw: 0.5 mm.
const NEAR_SQ: i128 = 1 << 26;

/// At most four of some touches: the deepest, the one farthest from it, the one that makes the
/// largest triangle with both, and the one that adds most to that. Of equal ones the deeper, then
/// the one with lower features.
pub(in crate::collision) fn reduce(normal: UnitVec3, touches: &[Touch]) -> Few<Touch, 4> {
    if touches.len() <= Manifold::CONTACTS_MAX {
        return touches.iter().copied().collect();
    }
    let mut kept = Few::new();
    let mut keep = |touch: Option<Touch>| touch.inspect(|&touch| kept.push(touch));
    let _ = keep(deepest(touches)).and_then(|first| {
        let spread = |touch: &Touch| flat_length_sq(normal, sub(touch.on[0], first.on[0]));
        let second = keep(best(touches, spread))?;
        let third = keep(best(touches, |touch| area(normal, [&first, &second, touch]).abs()))?;
        let turn = area(normal, [&first, &second, &third]).signum();
        let sides = [[&first, &second], [&second, &third], [&third, &first]];
        let added = |touch: &Touch| {
            let beyond = sides.map(|[p, q]| -turn * area(normal, [p, q, touch]));
            beyond.into_iter().fold(0, i128::max)
        };
        keep(best(touches, added))
    });
    kept
}

/// Of those that are as deep as any, up to noise, the one with the lowest features.
fn deepest(touches: &[Touch]) -> Option<Touch> {
    let least = touches.iter().map(|touch| touch.separation).min()?;
    let deep = touches.iter().filter(|touch| touch.separation <= least + TIE);
    deep.min_by_key(|touch| touch.features).copied()
}

/// The touch with the greatest score, if that is worth a point.
fn best(touches: &[Touch], score: impl Fn(&Touch) -> i128) -> Option<Touch> {
    let (_, best) = touches
        .iter()
        .map(|touch| (score(touch), touch))
        .filter(|&(score, _)| score >= NEAR_SQ)
        .reduce(|best, next| {
            let rank = |(score, touch): (i128, &Touch)| (-score, touch.separation, touch.features);
            if rank(next) < rank(best) { next } else { best }
        })?;
    Some(*best)
}

/// The square of the part of `d` that is at right angles to the normal. Below 2^90.
fn flat_length_sq(normal: UnitVec3, d: [i64; 3]) -> i128 {
    let along = round_shift_wide(dot_wide(normal.raw(), d), 30);
    dot_wide(d, d) - along * along
}

/// Twice the area of a triangle, seen along the normal; positive if it is counter-clockwise.
///
/// Differences are below 2^43: minors are below 2^87, and with a normal and its sum below 2^119.
fn area(normal: UnitVec3, [p, q, r]: [&Touch; 3]) -> i128 {
    let minors = cross(sub(q.on[0], p.on[0]), sub(r.on[0], p.on[0]));
    let terms = normal.raw().into_iter().zip(minors).map(|(n, minor)| i128::from(n) * minor);
    round_shift_wide(terms.sum(), 30)
}
