//! Round shapes in motion.

use super::{Impact, Motion, Sweep, back_off};
use crate::geometry::{Capsule, Segment, Sphere, closest_segment_segment, normal_segment_segment};
use crate::math::root::isqrt_wide_up;
use crate::math::wide::{dot_wide, sub, to_i32, to_i64};
use crate::math::{Real, Unit, UnitVec3, Vec3};

/// More planes are hardly ever needed: usually it is 2 or 3.
const PLANES_MAX: u32 = 64;

impl Sweep {
    /// When two capsules touch; `None` proves that they do not. Of two radii of one capsule the
    /// larger counts, for all of the step. O(1).
    ///
    /// Conservative advancement, by planes: one that stands between the capsules, across the
    /// shortest way from axis to axis, parts them until one of the four ends has come too close to
    /// another along its normal. That time is a quotient of integers, whichever plane it is; there
    /// the next plane is looked for, and where it does not last, they touch but for a rounding.
    #[must_use]
    pub fn capsule_capsule(&self, a: Motion<Capsule>, b: Motion<Capsule>) -> Option<Impact> {
        // Three lengths of at most 2^39.
        let reach = a.radius().raw() + b.radius().raw() + self.gap();
        let (a, b) = (a.ends(), b.ends());
        let mut time = Unit::ZERO;
        for _ in 0..PLANES_MAX {
            let [segment_a, segment_b] =
                [&a, &b].map(|axis| Segment::between(axis.map(|end| end.at(time))));
            let [on_a, on_b] = closest_segment_segment(&segment_a, &segment_b);
            let weights = [on_a.weights[1], on_b.weights[1]];
            let impact = Impact { time, weights, is_cut: false };
            let parts = [on_a.feature, on_b.feature];
            let Some(normal) = normal_segment_segment(&segment_a, &segment_b, parts) else {
                return Some(impact);
            };
            match parted_until(normal, &a, &b, reach, time) {
                None => return None,
                Some(until) if until <= time => return Some(impact),
                Some(until) => time = until,
            }
        }
        Some(Impact { time, is_cut: true, ..Impact::UNKNOWN })
    }

    /// When two balls touch; `None` proves that they do not. Otherwise like
    /// [`capsule_capsule`](Self::capsule_capsule).
    #[must_use]
    pub fn sphere_sphere(&self, a: Motion<Sphere>, b: Motion<Sphere>) -> Option<Impact> {
        self.capsule_capsule(a.into(), b.into())
    }

    /// Until when both capsules can move such that, with ends rounded as [`Motion::at`] does, they
    /// have no point in common: 1 if they never touch, otherwise strictly before they do, or 0.
    /// O(1).
    #[must_use]
    pub fn advance_capsule_capsule(&self, a: Motion<Capsule>, b: Motion<Capsule>) -> Unit {
        let Some(impact) = self.capsule_capsule(a, b) else { return Unit::ONE };
        let bare = Self { gap: Real::ZERO, ..*self };
        back_off(impact.time, |time| {
            let [a, b] = [a, b].map(|capsule| Motion::rest(capsule.at(time)));
            bare.capsule_capsule(a, b).is_none()
        })
    }

    /// Until when both balls can move apart from one another. Otherwise like
    /// [`advance_capsule_capsule`](Self::advance_capsule_capsule).
    #[must_use]
    pub fn advance_sphere_sphere(&self, a: Motion<Sphere>, b: Motion<Sphere>) -> Unit {
        self.advance_capsule_capsule(a.into(), b.into())
    }
}

/// Until when, from a time on, the ends of A and of B are farther apart along a normal than
/// `reach`: rounded down, and the same time if they are not even then. `None`: to the end.
fn parted_until(
    normal: UnitVec3,
    a: &[Motion<Vec3>; 2],
    b: &[Motion<Vec3>; 2],
    reach: i64,
    time: Unit,
) -> Option<Unit> {
    // The normal is as long as 2^30, but for a rounding: its square is below 2^61, and the reach
    // along it below 2^72.
    let square = dot_wide(normal.raw(), normal.raw()).unsigned_abs();
    let reach = i128::from(reach) * isqrt_wide_up(square).cast_signed();
    let (now, end) = (i128::from(time.raw()), i128::from(Unit::ONE.raw()));
    let mut until = None;
    for p in a {
        for q in b {
            // At most 3 * 2^30 * 2^61, and below 2^123 times a time.
            let along = |p: Vec3, q: Vec3| dot_wide(normal.raw(), sub(q.raw(), p.raw())) - reach;
            let (first, last) = (along(p.start, q.start), along(p.end, q.end));
            if first * (end - now) + last * now <= 0 {
                return Some(time);
            }
            if last <= 0 {
                // Positive at `time` and not in the end: it falls. At most 2^30.
                let reached = to_i32(to_i64(first * end / (first - last)));
                until = Some(until.map_or(reached, |until: i32| until.min(reached)));
            }
        }
    }
    until.map(Unit::from_raw)
}
