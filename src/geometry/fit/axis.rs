//! Directions that are the best nearby.

use crate::geometry::hull::across;
use crate::math::wide::round_shift;
use crate::math::{Unit, UnitVec3, Vec3};

/// The first step: a quarter of the axis to each side.
const STEP_MAX: i64 = 1 << (Unit::FRACTION_BITS - 2);
/// The last one: a sixty-thousandth.
const STEP_MIN: i64 = 1 << (Unit::FRACTION_BITS - 16);

/// Something with the cost that makes it better than others if it is lower.
pub(super) struct Scored<T> {
    pub(super) cost: i128,
    pub(super) what: T,
}

/// The best of some; of equal ones the first.
pub(super) fn best<T>(of: impl IntoIterator<Item = Scored<T>>) -> Option<Scored<T>> {
    of.into_iter().min_by_key(|scored| scored.cost)
}

/// Turns an axis as long as that makes it better, by ever smaller steps.
pub(super) fn descend<T>(
    start: UnitVec3,
    score: impl Fn(UnitVec3) -> Option<Scored<T>>,
) -> Option<Scored<T>> {
    let (mut axis, mut found) = (start, score(start)?);
    let mut step = STEP_MAX;
    while step >= STEP_MIN {
        let Some([u, v]) = across(axis.raw()) else { break };
        let near = [u, -u, v, -v].into_iter().filter_map(|way| {
            let turned = turned(axis, way, step)?;
            let Scored { cost, what } = score(turned)?;
            Some(Scored { cost, what: (turned, what) })
        });
        match best(near) {
            Some(Scored { cost, what }) if cost < found.cost => {
                (axis, found) = (what.0, Scored { cost, what: what.1 });
            }
            _ => step /= 2,
        }
    }
    Some(found)
}

/// The axis, and a step away.
fn turned(axis: UnitVec3, way: UnitVec3, step: i64) -> Option<UnitVec3> {
    let along = |k: usize| {
        axis.raw()[k] + round_shift(way.raw()[k] * step, Unit::FRACTION_BITS) // 2^58
    };
    UnitVec3::normalize(Vec3::from_raw([0, 1, 2].map(along)))
}
