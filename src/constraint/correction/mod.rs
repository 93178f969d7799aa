//! The two forms of the distance correction, each in two widths that give the same bits.
//!
//! With `d` the difference of the ends now, `r` the difference at the start of the substep, `L` the
//! rest length and `s_i = stiffness w_i / W` the gain of an end (30 bits, rounded once from the
//! masses when the plan is made):
//!
//! ```text
//! exact:          g_i = s_i clamp(L - |d|) / |d|         a -= g_a d,  b += g_b d
//! start of step:  g_i = s_i (L^2 - d.d) / (2 d.r)        a -= g_a r,  b += g_b r
//! ```
//!
//! `g_i` is rounded once to 30 bits, the product once to a position: with equal gains both ends get
//! the same integer and momentum is exact. Otherwise an end is wrong by at most half an ulp for the
//! product, `|v| / 2^31` for `g_i` and `|c| / 2^31` for `s_i`, where `v` is the vector that is
//! scaled (`d` or `r`) and `c` the correction of both ends together: the momentum error of a
//! projection is at most `(m_a + m_b) (1/2 + (|v| + |c|) / 2^31)` ulp, within 64 m below 2 ulp.
//!
//! Rounding moves a particle sideways, and the speed it so gains or loses would wander like the
//! square root of time. The start-of-step form, which otherwise keeps energy, therefore carries
//! what rounding left over to its next correction (the bound above is then 1 instead of 1/2 for one
//! projection, and still 1/2 for any number of them together): a pendulum keeps its height.
//!
//! A correction is never longer than 64 m (exact: `clamp`) or 0.23 * 1.42 * 1,024 m < 2^32.4 ulp
//! (start of step: its guard). Particles that coincide have no direction and are left alone.

#[cfg(test)]
mod tests;

use super::distance::DistanceForm;
use crate::math::root::{root_nearest, root_nearest_wide};
use crate::math::wide::{
    NARROW_MAX, dot_narrow, dot_wide, is_narrow, round_div, round_div_wide, round_shift,
    round_shift_wide, sub, to_i16, to_i64,
};
use crate::particle::DISPLACEMENT_LIMIT;

/// Fractional bits of gains.
const GAIN_BITS: u32 = 30;

/// A distance constraint, ready to be projected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Link {
    /// Slots of the two particles.
    pub(crate) ends: [u32; 2],
    /// Share of the error that each end takes, 0 to 2^30.
    pub(crate) gains: [i32; 2],
    /// At most 2^34 raw.
    pub(crate) rest_length: i64,
    /// Where the carry of a start-of-step link is kept.
    pub(crate) carry: u32,
    pub(crate) form: DistanceForm,
}

/// What is added to each end.
pub(crate) type Correction = [[i64; 3]; 2];

/// What rounding left over of the last start-of-step correction of each end: ulp with 15 fractional
/// bits, at most half an ulp.
pub(crate) type Carry = [[i16; 3]; 2];

/// Fractional bits of a carry.
const CARRY_BITS: u32 = 15;

/// Half an ulp: the greatest carry.
pub(crate) const CARRY_MAX: i16 = 1 << (CARRY_BITS - 1);

impl Link {
    /// The correction for the ends' positions `now` and at the `start` of the substep.
    #[inline]
    pub(crate) fn correct(
        &self,
        start: [[i64; 3]; 2],
        now: [[i64; 3]; 2],
        carry: &mut Carry,
    ) -> Correction {
        let d = sub(now[1], now[0]);
        let r = match self.form {
            DistanceForm::Exact => [0; 3],
            DistanceForm::StartOfStep => sub(start[1], start[0]),
        };
        if is_narrow(d) && is_narrow(r) && self.rest_length <= NARROW_MAX {
            self.narrow(d, r, carry)
        } else {
            self.wide(d, r, carry)
        }
    }

    /// Opposite moves of the ends; the same integer where the gains are equal.
    #[inline]
    fn at_ends(
        &self,
        carry: &mut Carry,
        scaled: impl Fn(i64, &mut [i16; 3]) -> [i64; 3],
    ) -> Correction {
        let [gain_a, gain_b] = self.gains.map(i64::from);
        let [carry_a, carry_b] = carry;
        let at = |gain, carry: &mut _| if gain == 0 { [0; 3] } else { scaled(gain, carry) };
        let b = at(gain_b, carry_b);
        let a = if gain_a == gain_b { b } else { at(gain_a, carry_a) };
        [a.map(|c| -c), b]
    }

    /// Components of `d` and `r` and the rest length at most 2^30: products fit 64 bits.
    #[inline]
    fn narrow(&self, d: [i64; 3], r: [i64; 3], carry: &mut Carry) -> Correction {
        let length_sq = dot_narrow(d, d); // <= 3 * 2^60
        if self.form == DistanceForm::StartOfStep {
            let rest_sq = self.rest_length * self.rest_length; // <= 2^60
            let error = rest_sq - length_sq;
            let along = dot_narrow(d, r);
            let part = rest_sq >> 4;
            let sound = along > 11 * part && error.abs() < 5 * part;
            if sound && dot_narrow(r, r) < 2 * rest_sq {
                return self.at_ends(carry, |gain, carry| {
                    // 59 + 30 bits over 62; the quotient is below 0.23.
                    let numerator = i128::from(error) * i128::from(gain);
                    let g = to_i64(round_div_wide(numerator, 2 * i128::from(along)));
                    each(r, carry, |c, carry| {
                        let exact = c * g + carried(*carry); // 30 + 28 bits and 29
                        let rounded = round_shift(exact, GAIN_BITS);
                        *carry = carry_of(exact - (rounded << GAIN_BITS));
                        rounded
                    })
                });
            }
        }
        // Below 2^31, and not below any |component|.
        let length = root_nearest(length_sq.cast_unsigned()).cast_signed();
        if length == 0 {
            return [[0; 3]; 2];
        }
        let error = (self.rest_length - length).clamp(-DISPLACEMENT_LIMIT, DISPLACEMENT_LIMIT);
        self.at_ends(carry, |gain, _| {
            let g = round_div(error * gain, length); // 30 + 30 bits
            // |c| <= length, so |c g| <= |error| 2^30 + |c| / 2 < 2^61.
            d.map(|c| round_shift(c * g, GAIN_BITS))
        })
    }

    /// The same formulas for components of `d` and `r` up to 2^61.8.
    #[cold]
    fn wide(&self, d: [i64; 3], r: [i64; 3], carry: &mut Carry) -> Correction {
        let length_sq = dot_wide(d, d); // < 2^126
        let rest_length = i128::from(self.rest_length);
        if self.form == DistanceForm::StartOfStep {
            let rest_sq = rest_length * rest_length; // <= 2^68
            let error = rest_sq - length_sq;
            let along = dot_wide(d, r);
            let part = rest_sq >> 4;
            let sound = along > 11 * part && error.abs() < 5 * part;
            if sound && dot_wide(r, r) < 2 * rest_sq {
                return self.at_ends(carry, |gain, carry| {
                    // 67 + 30 bits over 71: |d| and |r| are below 1.42 rest lengths here.
                    let g = round_div_wide(error * i128::from(gain), 2 * along);
                    each(r, carry, |c, carry| {
                        let exact = i128::from(c) * g + i128::from(carried(*carry));
                        let rounded = round_shift_wide(exact, GAIN_BITS);
                        *carry = carry_of(to_i64(exact - (rounded << GAIN_BITS)));
                        to_i64(rounded)
                    })
                });
            }
        }
        let length = root_nearest_wide(length_sq.cast_unsigned()).cast_signed(); // < 2^63
        if length == 0 {
            return [[0; 3]; 2];
        }
        let limit = i128::from(DISPLACEMENT_LIMIT);
        let error = (rest_length - length).clamp(-limit, limit);
        self.at_ends(carry, |gain, _| {
            let g = round_div_wide(error * i128::from(gain), length);
            // |c g| <= |error| 2^30 + |c| / 2
            d.map(|c| to_i64(round_shift_wide(i128::from(c) * g, GAIN_BITS)))
        })
    }
}

/// What is carried, with the fractional bits of a product.
#[inline]
fn carried(carry: i16) -> i64 {
    i64::from(carry) << (GAIN_BITS - CARRY_BITS)
}

/// What is left of a product, at most half an ulp, as it is carried.
#[inline]
fn carry_of(rest: i64) -> i16 {
    to_i16(round_shift(rest, GAIN_BITS - CARRY_BITS))
}

/// A function of each component and of what is carried for it.
#[inline]
fn each(v: [i64; 3], carry: &mut [i16; 3], scale: impl Fn(i64, &mut i16) -> i64) -> [i64; 3] {
    let [x, y, z] = carry;
    [scale(v[0], x), scale(v[1], y), scale(v[2], z)]
}
