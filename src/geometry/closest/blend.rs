//! Points between corners.

use super::width::Area;
use crate::math::wide::{add, sub, to_i32, to_i64};
use crate::math::{Unit, Vec3};

/// Fraction bits of an estimated share.
const SHARE_BITS: u32 = 62;

/// The point `sum(corner * share) / sum(share)`, and the shares as fractions of the whole.
///
/// No share is negative, and the whole is positive and leaves three bits free. Corners are less
/// than 2^42 apart.
///
/// Shares are estimated to 2^-60, which puts every coordinate within 3 * 2^42 * 2^-60 of its
/// place, so that its floor is missed by one at most; then the exact rest decides.
#[inline]
pub(super) fn blend<A: Area, const N: usize>(
    corners: [Vec3; N],
    shares: [A; N],
) -> (Vec3, [Unit; N]) {
    // Loops, as `map` of arrays is not inlined.
    let mut whole = A::default();
    let mut base = corners[0];
    for i in 0..N {
        whole = whole.plus(shares[i]);
        base = base.min(corners[i]);
    }
    let shift = whole.bits().saturating_sub(SHARE_BITS);
    let divisor = u128::from(whole.leading(shift));
    let mut estimates = [0; N];
    let mut sides = [[0; 3]; N];
    for i in 0..N {
        // At most 2^124 / 2^61: no share is more than the whole.
        let share = u128::from(shares[i].leading(shift)) << SHARE_BITS;
        estimates[i] = to_i64((share / divisor).cast_signed());
        sides[i] = sub(corners[i].raw(), base.raw());
    }
    let along = |k: usize| {
        let mut estimate = 0;
        let mut exact = A::default();
        for i in 0..N {
            estimate += i128::from(sides[i][k]) * i128::from(estimates[i]);
            exact = exact.plus(shares[i].times(sides[i][k]));
        }
        nearest(exact, whole, to_i64(estimate >> SHARE_BITS))
    };
    let position = add(base.raw(), [along(0), along(1), along(2)]);
    (Vec3::from_raw(position), weights(shares, whole, estimates))
}

/// The shares as fractions whose sum is 1.
#[inline]
fn weights<A: Area, const N: usize>(shares: [A; N], whole: A, estimates: [i64; N]) -> [Unit; N] {
    let mut weights = [0; N];
    let mut largest = 0;
    for i in 0..N {
        let exact = shares[i].times(Unit::ONE.raw().into());
        weights[i] = nearest(exact, whole, estimates[i] >> (SHARE_BITS - Unit::FRACTION_BITS));
        if shares[i] > shares[largest] {
            largest = i;
        }
    }
    let sum: i64 = weights.iter().sum();
    // The sum is wrong by less than N / 2 + 1, and the largest weight not below 1 / N.
    weights[largest] += i64::from(Unit::ONE.raw()) - sum;
    let mut fractions = [Unit::ZERO; N];
    for i in 0..N {
        fractions[i] = Unit::from_raw(to_i32(weights[i]));
    }
    fractions
}

/// `n / d` to nearest, ties away from zero, given its floor or a number next to that. What `n` does
/// in its highest bits cancels out.
#[inline]
fn nearest<A: Area>(n: A, d: A, estimate: i64) -> i64 {
    let mut floor = estimate;
    let mut rest = n.minus(d.times(floor));
    while rest < A::default() {
        floor -= 1;
        rest = rest.plus(d);
    }
    while rest >= d {
        floor += 1;
        rest = rest.minus(d);
    }
    let rest = rest.plus(rest);
    // Below zero the lower one is farther away from it.
    let up = if floor < 0 { rest > d } else { rest >= d };
    floor + i64::from(up)
}
