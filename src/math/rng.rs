//! Random numbers that are part of the state.

use serde::{Deserialize, Serialize};

use super::Real;

/// PCG-XSH-RR 64/32: M. E. O'Neill, *PCG: A Family of Simple Fast Space-Efficient Statistically
/// Good Algorithms for Random Number Generation*, Harvey Mudd College HMC-CS-2014-0905, 2014.
///
/// Bit for bit the reference `pcg32`, bounded numbers included. Its two words are the whole
/// state. Not for secrets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Pcg {
    state: u64,
    increment: u64,
}

impl Pcg {
    /// Generators with the same `seed` and another `stream` (of which the lower 63 bits count)
    /// are independent of one another.
    #[must_use]
    pub const fn new(seed: u64, stream: u64) -> Self {
        let mut pcg = Self { state: 0, increment: (stream << 1) | 1 };
        pcg.next_u32();
        pcg.state = pcg.state.wrapping_add(seed);
        pcg.next_u32();
        pcg
    }

    /// The state and the increment, for [`from_state`](Self::from_state).
    #[must_use]
    pub const fn state(&self) -> [u64; 2] {
        let Self { state, increment } = *self;
        [state, increment]
    }

    /// The generator that [`state`](Self::state) was taken from. Any two words are legal; an even
    /// increment, which [`new`](Self::new) never makes, has a shorter period.
    #[must_use]
    pub const fn from_state(words: [u64; 2]) -> Self {
        let [state, increment] = words;
        Self { state, increment }
    }

    /// The next 32 bits.
    #[inline]
    pub const fn next_u32(&mut self) -> u32 {
        let old = self.state;
        self.state = old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(self.increment);
        // Truncations are the algorithm: the upper 37 bits are folded into 32, then turned by
        // the upper 5.
        let folded = (((old >> 18) ^ old) >> 27) as u32;
        folded.rotate_right((old >> 59) as u32)
    }

    /// The next 64 bits: two draws, the higher half first.
    #[inline]
    pub const fn next_u64(&mut self) -> u64 {
        let high = self.next_u32() as u64;
        (high << 32) | self.next_u32() as u64
    }

    /// A uniform number below `n`, without bias: values that would favour the low numbers are
    /// drawn again, less than once on average.
    ///
    /// # Panics
    ///
    /// When `n` is 0, for no number is below it.
    #[inline]
    pub const fn below(&mut self, n: u32) -> u32 {
        assert!(n > 0, "Pcg::below: no number is below 0");
        // 2^32 mod n: what remains above it is a multiple of n.
        let surplus = n.wrapping_neg() % n;
        loop {
            let draw = self.next_u32();
            if draw >= surplus {
                return draw % n;
            }
        }
    }

    /// A number `lo <= r < hi`, uniform over all values of [`Real`] there are, without bias.
    ///
    /// # Panics
    ///
    /// When `lo >= hi`, for there is no such number.
    #[inline]
    pub const fn real(&mut self, lo: Real, hi: Real) -> Real {
        assert!(lo.raw() < hi.raw(), "Pcg::real: the range is empty");
        // Exact modulo 2^64, and between 1 and 2^64 - 1.
        let n = hi.raw().wrapping_sub(lo.raw()).cast_unsigned();
        let surplus = n.wrapping_neg() % n;
        loop {
            let draw = self.next_u64();
            if draw >= surplus {
                // Below hi, so the sum fits; modulo 2^64 it is exact.
                return Real::from_raw(lo.raw().wrapping_add_unsigned(draw % n));
            }
        }
    }
}
