//! The forms of the distance correction, and the two widths of those that reach beyond 64 m.
//!
//! With `d` the difference of the ends now, `r` the difference at the start of the substep, `L` the
//! end of the range that `|d|` is beyond, and `s_i = stiffness w_i / W` the gain of an end (30
//! bits, rounded once from the masses when the plan is made):
//!
//! ```text
//! exact:          g_i = s_i clamp(L - |d|) / |d|             a -= g_a d,  b += g_b d
//! start of step:  g_i = s_i (L^2 - d.d) / (2 d.r)            a -= g_a r,  b += g_b r
//! root-free:      g_i = s_i (L^2 - d.d) / (L^2 + d.d)        a -= g_a d,  b += g_b d
//! division-free:  g_i = s_i f(d.d / L^2), see `curve.rs`     a += g_a d,  b -= g_b d
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
//! A correction is never longer than 64 m (exact: `clamp`; root- and division-free: `|d|`) or
//! 0.23 * 1.42 * 1,024 m < 2^32.4 ulp (start of step: its guard). Particles that coincide have no
//! direction and are left alone.

#[cfg(test)]
mod tests;

use super::curve::{self, SHARE_BITS, Scale};
use super::distance::DistanceForm;
use super::link::{GAIN_BITS, GIVE_BITS, Link};
use crate::math::root::{root_nearest, root_nearest_wide};
use crate::math::wide::{
    dot_narrow, dot_wide, is_narrow, round_div, round_div_wide, round_shift, round_shift_wide, sub,
    to_i16, to_i64,
};
use crate::particle::DISPLACEMENT_LIMIT;

/// What is added to each end.
pub(crate) type Correction = [[i64; 3]; 2];

/// What rounding left over of the last start-of-step correction of each end: ulp with 15 fractional
/// bits, at most half an ulp.
pub(crate) type Carry = [[i16; 3]; 2];

/// Fractional bits of a carry.
const CARRY_BITS: u32 = 15;

/// Half an ulp: the greatest carry.
pub(crate) const CARRY_MAX: i16 = 1 << (CARRY_BITS - 1);

/// What a link remembers between its corrections.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Memory {
    /// Of a start-of-step link; part of the state.
    pub(super) carry: Carry,
    /// The length that a compliant link has taken in this substep, 16 fractional bits. With the
    /// error it shrinks what is left to take, so that iterations converge to the give.
    pub(super) taken: i64,
}

/// Beyond it no length within 64 m along each axis is too short: 2^31, so that squares fit `i64`.
const REACH: i64 = 1 << 31;

impl Link {
    /// The correction for the ends' positions `now` and at the `start` of the substep.
    #[inline]
    pub(super) fn correct(
        &self,
        start: [[i64; 3]; 2],
        now: [[i64; 3]; 2],
        memory: &mut Memory,
    ) -> Correction {
        let d = sub(now[1], now[0]);
        let r = match self.form {
            DistanceForm::StartOfStep => sub(start[1], start[0]),
            _ => [0; 3],
        };
        if is_narrow(d) && is_narrow(r) && self.shortest <= REACH {
            self.narrow(d, r, memory)
        } else {
            self.wide(d, r, memory)
        }
    }

    /// Components of `d` and `r` at most 2^30: products fit 64 bits.
    #[inline]
    fn narrow(&self, d: [i64; 3], r: [i64; 3], memory: &mut Memory) -> Correction {
        let length_sq = dot_narrow(d, d); // <= 3 * 2^60
        if self.form == DistanceForm::DivisionFree {
            // Near the length the ratio alone decides, as in `lanes`: no comparison of squares.
            let share = curve::share(Scale::of(self.longest).ratio(length_sq.unsigned_abs()));
            let pushes = self.shortest > 0;
            return self.division_free(d, if pushes { share } else { share.max(0) });
        }
        let longest = self.longest.min(REACH);
        let rest = if length_sq > longest * longest {
            longest
        } else if length_sq < self.shortest * self.shortest {
            self.shortest
        } else {
            return [[0; 3]; 2];
        };
        let rest_sq = rest * rest; // <= 2^62
        let error = rest_sq - length_sq;
        match self.form {
            DistanceForm::StartOfStep => {
                let along = dot_narrow(d, r);
                let part = rest_sq >> 4;
                let sound = along > 11 * part && error.abs() < 5 * part;
                if sound && dot_narrow(r, r) >> 1 < rest_sq {
                    return self.along_start(r, i128::from(error), i128::from(along), memory);
                }
            }
            DistanceForm::RootFree => {
                let sum = rest_sq.unsigned_abs() + length_sq.unsigned_abs(); // < 2^63
                // At most 32 bits are left, and 30 are the gain's; |error| <= sum.
                let shift = 32_u32.saturating_sub(sum.leading_zeros());
                let (error, sum) = (error >> shift, (sum >> shift).cast_signed());
                return self.along(d, |gain| round_div(error * gain, sum));
            }
            DistanceForm::Exact | DistanceForm::DivisionFree => {}
        }
        // Below 2^31, and not below any |component|.
        let length = root_nearest(length_sq.cast_unsigned()).cast_signed();
        if length == 0 {
            return [[0; 3]; 2];
        }
        let error = (rest - length).clamp(-DISPLACEMENT_LIMIT, DISPLACEMENT_LIMIT);
        let error = self.yielded(error, memory);
        // |c| <= length, so |c g| <= |error| 2^30 + |c| / 2 < 2^61.
        self.along(d, |gain| round_div(error * gain, length))
    }

    /// The exact and the start-of-step form for components of `d` and `r` up to 2^61.8.
    #[cold]
    fn wide(&self, d: [i64; 3], r: [i64; 3], memory: &mut Memory) -> Correction {
        let length_sq = dot_wide(d, d); // < 2^126
        let [shortest, longest] = [self.shortest, self.longest].map(i128::from);
        let rest = if length_sq > longest * longest {
            longest
        } else if length_sq < shortest * shortest {
            shortest
        } else {
            return [[0; 3]; 2];
        };
        if self.form == DistanceForm::StartOfStep {
            let rest_sq = rest * rest; // <= 2^68
            let error = rest_sq - length_sq;
            let along = dot_wide(d, r);
            let part = rest_sq >> 4;
            let sound = along > 11 * part && error.abs() < 5 * part;
            if sound && dot_wide(r, r) >> 1 < rest_sq {
                return self.along_start(r, error, along, memory);
            }
        }
        let length = root_nearest_wide(length_sq.cast_unsigned()).cast_signed(); // < 2^63
        if length == 0 {
            return [[0; 3]; 2];
        }
        let limit = i128::from(DISPLACEMENT_LIMIT);
        let error = to_i64((rest - length).clamp(-limit, limit));
        let error = i128::from(self.yielded(error, memory));
        self.at_ends(|end| {
            let g = round_div_wide(error * i128::from(self.gains[end]), length);
            // |c g| <= |error| 2^30 + |c| / 2
            d.map(|c| to_i64(round_shift_wide(i128::from(c) * g, GAIN_BITS)))
        })
    }

    /// Opposite moves of the ends; the same integer where the gains are equal.
    #[inline]
    fn at_ends(&self, mut moved: impl FnMut(usize) -> [i64; 3]) -> Correction {
        let mut at = |end: usize| if self.gains[end] == 0 { [0; 3] } else { moved(end) };
        let b = at(1);
        let near = cfg!(planted) && self.gains[0] >> 20 == self.gains[1] >> 20;
        let a = if near || self.gains[0] == self.gains[1] { b } else { at(0) };
        [a.map(|c| -c), b]
    }

    /// Moves along the difference as it is now: components at most 2^30, `|c g| < 2^62`.
    #[inline]
    fn along(&self, d: [i64; 3], g: impl Fn(i64) -> i64) -> Correction {
        self.at_ends(|end| {
            let g = g(i64::from(self.gains[end]));
            d.map(|c| round_shift(c * g, GAIN_BITS))
        })
    }

    /// Moves along the difference at the start of the substep, by `error / (2 along)` of it.
    #[inline]
    fn along_start(
        &self,
        r: [i64; 3],
        error: i128,
        along: i128,
        memory: &mut Memory,
    ) -> Correction {
        self.at_ends(|end| {
            // 67 + 30 bits over 71: |d| and |r| are below 1.42 rest lengths here. Below 0.23.
            let g = round_div_wide(error * i128::from(self.gains[end]), 2 * along);
            let mut at = |k: usize| {
                let carry = &mut memory.carry[end][k];
                let before = i128::from(*carry) << (GAIN_BITS - CARRY_BITS);
                let exact = i128::from(r[k]) * g + before; // 35 + 28 bits
                let rounded = round_shift_wide(exact, GAIN_BITS);
                // At most half an ulp, 2^29.
                let left = to_i64(exact - (rounded << GAIN_BITS));
                *carry = to_i16(round_shift(left, GAIN_BITS - CARRY_BITS));
                to_i64(rounded)
            };
            [at(0), at(1), at(2)]
        })
    }

    /// Moves by a share of the difference, components at most 2^30, as `lanes` do four at a time:
    /// on magnitudes, with gains of 32 fractional bits.
    #[inline]
    fn division_free(&self, d: [i64; 3], share: i32) -> Correction {
        let part = share.unsigned_abs() << (32 - SHARE_BITS);
        self.at_ends(|end| {
            let g = u64::from(curve::high(part, lane_gain(self.gains[end])));
            let scale = |c: i64| {
                let size = (c.unsigned_abs() * g + (1 << 31)) >> 32; // 30 + 32 bits
                let size = size.cast_signed();
                if (c < 0) == (share < 0) { -size } else { size }
            };
            d.map(scale)
        })
    }

    /// What is left of an error when the link gives: `error - give taken`.
    #[inline]
    fn yielded(&self, error: i64, memory: &mut Memory) -> i64 {
        if self.give == 0 {
            return error;
        }
        // taken <= 64 * 2^46, give <= 2^47: 99 bits, 32 of them fractional.
        let given = round_shift_wide(i128::from(memory.taken) * i128::from(self.give), 32);
        let limit = i128::from(DISPLACEMENT_LIMIT);
        let left = to_i64((i128::from(error) - given).clamp(-limit, limit));
        let one = 1 << GIVE_BITS;
        // left / (1 + give), both with 16 fractional bits: 30 + 32 bits.
        memory.taken += round_div(left << (2 * GIVE_BITS), one + self.give);
        left
    }
}

/// A gain with 32 fractional bits; 1 is one unit short.
pub(super) fn lane_gain(gain: i32) -> u32 {
    gain.unsigned_abs().saturating_mul(4)
}
