//! Batches in the registers of x86 processors: one in 128 bits, which every 64-bit one has, or two
//! in 256, where the processor turns out to have AVX2.
//!
//! SSE2 multiplies 32 x 32 to 64 bits unsigned and in every other lane only (`pmuludq`), so all
//! factors are magnitudes, and a product of four lanes takes two multiplications: of the lanes 0
//! and 2, and of 1 and 3 moved down. Putting their upper halves together leaves the lanes in the
//! order 0 2 1 3; a second product puts them right. AVX2 does the same in either half, so both are
//! one text. It is found out when the program runs, which changes no result.

#![allow(unsafe_code, reason = "calls what the processor has; twice as fast as without")]

use super::{Batch, Place, UnevenBatch};
use crate::constraint::curve::RATIO_ONE;

pub(in super::super) fn relax_even(shift: u32, batches: &[Batch], places: &mut [Place]) {
    relax(shift, batches, places);
}

pub(in super::super) fn relax_uneven(shift: u32, batches: &[UnevenBatch], places: &mut [Place]) {
    relax(shift, batches, places);
}

#[inline]
fn relax<Q: Quad>(shift: u32, quads: &[Q], places: &mut [Place]) {
    let rest = if has_avx2() {
        // SAFETY: the processor has AVX2.
        unsafe { avx2::relax(shift, quads, places) }
    } else {
        quads
    };
    // SAFETY: this module is compiled only where SSE2 is there.
    unsafe { sse2::relax(shift, rest, places) };
}

#[cfg(feature = "std")]
#[inline]
fn has_avx2() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
}

#[cfg(not(feature = "std"))]
#[inline]
fn has_avx2() -> bool {
    cfg!(target_feature = "avx2")
}

/// Either kind of batch. What takes it is generic so that each loop has a copy of its own, which is
/// inlined: calls would pass all registers through memory and cost half as much again.
trait Quad {
    /// Whether ends take equal shares and may be pushed.
    const IS_EVEN: bool;

    fn batch(&self) -> &Batch;

    /// The gains of the second ends.
    fn gain_b(&self) -> [u32; 4];

    /// Whether ends may be pushed.
    fn push(&self) -> [u32; 4];
}

impl Quad for Batch {
    const IS_EVEN: bool = true;

    #[inline]
    fn batch(&self) -> &Batch {
        self
    }

    #[inline]
    fn gain_b(&self) -> [u32; 4] {
        self.gain
    }

    #[inline]
    fn push(&self) -> [u32; 4] {
        [u32::MAX; 4]
    }
}

impl Quad for UnevenBatch {
    const IS_EVEN: bool = false;

    #[inline]
    fn batch(&self) -> &Batch {
        &self.even
    }

    #[inline]
    fn gain_b(&self) -> [u32; 4] {
        self.gain_b
    }

    #[inline]
    fn push(&self) -> [u32; 4] {
        self.push
    }
}

/// Limits of the ratios that the polynomial takes.
const HALF: i32 = (RATIO_ONE / 2).cast_signed();
const TWO: i32 = (2 * RATIO_ONE - 1).cast_signed();

/// What is done in registers, whatever they hold: instructions have the names that the modules
/// below give them.
macro_rules! in_registers {
    ($feature:literal) => {
        /// Projects as many links as fill registers; returns the others.
        #[target_feature(enable = $feature)]
        pub(super) fn relax<'a, Q: Quad>(
            shift: u32,
            quads: &'a [Q],
            places: &mut [Place],
        ) -> &'a [Q] {
            let shift = _mm_cvtsi32_si128(shift.cast_signed());
            let (filled, rest) = quads.as_chunks::<BATCHES>();
            for quads in filled {
                let [x, y, z] = differences(quads, places);
                let sign = [sign(x), sign(y), sign(z)];
                let size = [negate(x, sign[0]), negate(y, sign[1]), negate(z, sign[2])];
                let mut share = share(ratio(quads, size, shift));
                if !Q::IS_EVEN {
                    let pushes = self::sign(share);
                    share = select(pushes, and(share, all(quads, Q::push)), share);
                }
                let moves_a = moves(quads, size, sign, share, all(quads, |quad| quad.batch().gain));
                let moves_b = if Q::IS_EVEN {
                    moves_a
                } else {
                    moves(quads, size, sign, share, all(quads, Q::gain_b))
                };
                // Lanes come back in the order 0 2 1 3.
                for (row, k) in [0, 2, 1, 3].into_iter().enumerate() {
                    let (moves_a, moves_b) = (split(moves_a[row]), split(moves_b[row]));
                    for (index, quad) in quads.iter().enumerate() {
                        let [a, b] = [quad.batch().a[k], quad.batch().b[k]].map(|end| end as usize);
                        places[a] = cast(_mm_add_epi32(cast(places[a]), moves_a[index]));
                        places[b] = cast(_mm_sub_epi32(cast(places[b]), moves_b[index]));
                    }
                }
            }
            rest
        }

        /// A field of all batches.
        #[inline]
        #[target_feature(enable = $feature)]
        fn all<Q: Quad>(quads: &[Q; BATCHES], field: impl Fn(&Q) -> [u32; 4]) -> Register {
            join(core::array::from_fn(|index| cast(field(&quads[index]))))
        }

        /// Lanes of x, y and z of `b - a`.
        #[inline]
        #[target_feature(enable = $feature)]
        fn differences<Q: Quad>(quads: &[Q; BATCHES], places: &[Place]) -> [Register; 3] {
            let d0 = difference(quads, places, 0);
            let d1 = difference(quads, places, 1);
            let d2 = difference(quads, places, 2);
            let d3 = difference(quads, places, 3);
            let (xy01, xy23) = (low_32(d0, d1), low_32(d2, d3));
            let (z01, z23) = (high_32(d0, d1), high_32(d2, d3));
            let (x, y) = (low_64(xy01, xy23), high_64(xy01, xy23));
            [x, y, low_64(z01, z23)]
        }

        /// `d.d / L^2`, 26 fractional bits, saturated.
        #[inline]
        #[target_feature(enable = $feature)]
        fn ratio<Q: Quad>(
            quads: &[Q; BATCHES],
            [x, y, z]: [Register; 3],
            shift: __m128i,
        ) -> Register {
            let even = sum(mul(x, x), mul(y, y), mul(z, z));
            let [x, y, z] = [odd(x), odd(y), odd(z)];
            let odds = sum(mul(x, x), mul(y, y), mul(z, z));
            let (even, odds) = (shift_right_by(even, shift), shift_right_by(odds, shift));
            let inverse = all(quads, |quad| quad.batch().inverse);
            let ratio = upper(mul(even, inverse), mul(odds, odd(inverse)));
            // More than 32 bits.
            let over = greater(upper(even, odds), every(0));
            swap(or(ratio, over))
        }

        /// Rows of `share gain d`, rounded to nearest, ties away from zero, in the order 0 2 1 3.
        #[inline]
        #[target_feature(enable = $feature)]
        fn moves<Q: Quad>(
            _: &[Q; BATCHES],
            size: [Register; 3],
            sign: [Register; 3],
            share: Register,
            gain: Register,
        ) -> [Register; 4] {
            let pushes = self::sign(share);
            let part = shift_left::<{ 32 - SHARE_BITS.cast_signed() }>(negate(share, pushes));
            let part = swap(high(part, odd(part), gain));
            let odd_part = odd(part);
            let half = every_64(1 << 31);
            let component = |size: Register, sign: Register| {
                let even = add_64(mul(part, size), half);
                let odds = add_64(mul(odd_part, odd(size)), half);
                negate(upper(even, odds), swap(xor(sign, pushes)))
            };
            let x = component(size[0], sign[0]);
            let y = component(size[1], sign[1]);
            let z = component(size[2], sign[2]);
            let none = every(0);
            let (xy01, xy23) = (low_32(x, y), high_32(x, y));
            let (z01, z23) = (low_32(z, none), high_32(z, none));
            [low_64(xy01, z01), high_64(xy01, z01), low_64(xy23, z23), high_64(xy23, z23)]
        }

        /// `curve::share` of four ratios.
        #[inline]
        #[target_feature(enable = $feature)]
        fn share(ratio: Register) -> Register {
            let out = or(below_half(ratio), above_two(ratio));
            if sign_bits(out) == 0 { polynomial(ratio) } else { share_far(ratio) }
        }

        /// The same where a ratio is below 1/2 or above 2.
        #[cold]
        #[inline(never)]
        #[target_feature(enable = $feature)]
        fn share_far(ratio: Register) -> Register {
            let (half, two) = (every(HALF), every(TWO));
            // From 2^31 on a ratio looks negative.
            let huge = sign(ratio);
            let ratio = and(or(ratio, huge), every(i32::MAX));
            let long = above_two(ratio);
            let once = select(long, shift_right::<2>(ratio), ratio);
            let longer = above_two(once);
            let twice = select(longer, shift_right::<2>(once), once);
            let short = below_half(ratio);
            let near = select(short, shift_left::<2>(twice), twice);
            let near = select(below_half(near), half, near);
            let near = select(above_two(near), two, near);
            let share = polynomial(near);
            let one = every(SHARE_ONE);
            let halved = |share| add_32(shift_right_signed::<1>(share), every(SHARE_ONE / 2));
            let share = select(long, halved(share), share);
            let share = select(longer, halved(share), share);
            let doubled = sub_32(add_32(share, share), one);
            let least = every(1 - SHARE_ONE);
            let doubled = select(greater(least, doubled), least, doubled);
            select(short, doubled, share)
        }

        /// `curve::polynomial` of four ratios.
        #[inline]
        #[target_feature(enable = $feature)]
        fn polynomial(ratio: Register) -> Register {
            let v = shift_left::<5>(ratio);
            let swapped = swap(v);
            let (v_odd, swapped_odd) = (odd(v), odd(swapped));
            let [c0, c1, c2, c3, c4] = COEFFICIENTS;
            let (c0, c1, c2) =
                (every(c0.cast_signed()), every(c1.cast_signed()), every(c2.cast_signed()));
            let (c3, c4) = (every(c3.cast_signed()), every(c4.cast_signed()));
            let p = sub_32(c3, high(v, v_odd, c4));
            let p = sub_32(c2, high(swapped, swapped_odd, p));
            let p = sub_32(c1, high(v, v_odd, p));
            let p = sub_32(c0, high(swapped, swapped_odd, p));
            sub_32(every(SHARE_ONE), p)
        }

        /// `b - a` of one lane of each batch.
        #[inline]
        #[target_feature(enable = $feature)]
        fn difference<Q: Quad>(quads: &[Q; BATCHES], places: &[Place], lane: usize) -> Register {
            let place = |end: u32| cast(places[end as usize]);
            let a = join(core::array::from_fn(|index| place(quads[index].batch().a[lane])));
            let b = join(core::array::from_fn(|index| place(quads[index].batch().b[lane])));
            sub_32(b, a)
        }

        /// Signed, so that a ratio from 2^31 on counts as below.
        #[inline]
        #[target_feature(enable = $feature)]
        fn below_half(ratio: Register) -> Register {
            greater(every(HALF), ratio)
        }

        #[inline]
        #[target_feature(enable = $feature)]
        fn above_two(ratio: Register) -> Register {
            greater(ratio, every(TWO))
        }

        /// The lanes 1 and 3 where the lanes 0 and 2 were.
        #[inline]
        #[target_feature(enable = $feature)]
        fn odd(v: Register) -> Register {
            shift_right_64::<32>(v)
        }

        /// The upper halves of two pairs of products, of the lanes 0 and 2 and of 1 and 3.
        #[inline]
        #[target_feature(enable = $feature)]
        fn upper(even: Register, odd: Register) -> Register {
            let halves = (to_floats(even), to_floats(odd));
            from_floats(shuffle_floats::<0b11_01_11_01>(halves.0, halves.1))
        }

        /// The upper halves of four products, in the order 0 2 1 3.
        #[inline]
        #[target_feature(enable = $feature)]
        fn high(a: Register, a_odd: Register, b: Register) -> Register {
            upper(mul(a, b), mul(a_odd, odd(b)))
        }

        /// Exchanges the lanes 1 and 2.
        #[inline]
        #[target_feature(enable = $feature)]
        fn swap(v: Register) -> Register {
            shuffle::<0b11_01_10_00>(v)
        }

        /// All ones where a lane is negative.
        #[inline]
        #[target_feature(enable = $feature)]
        fn sign(v: Register) -> Register {
            shift_right_signed::<31>(v)
        }

        /// `v`, or `-v` where the mask is all ones.
        #[inline]
        #[target_feature(enable = $feature)]
        fn negate(v: Register, mask: Register) -> Register {
            sub_32(xor(v, mask), mask)
        }

        /// `yes` where the mask is all ones, else `no`.
        #[inline]
        #[target_feature(enable = $feature)]
        fn select(mask: Register, yes: Register, no: Register) -> Register {
            or(and(mask, yes), and_not(mask, no))
        }

        #[inline]
        #[target_feature(enable = $feature)]
        fn sum(a: Register, b: Register, c: Register) -> Register {
            add_64(add_64(a, b), c)
        }
    };
}

mod sse2 {
    use core::arch::x86_64::{
        __m128i, __m128i as Register, _mm_add_epi32, _mm_add_epi32 as add_32,
        _mm_add_epi64 as add_64, _mm_and_si128 as and, _mm_andnot_si128 as and_not,
        _mm_castps_si128 as from_floats, _mm_castsi128_ps as to_floats, _mm_cmpgt_epi32 as greater,
        _mm_cvtsi32_si128, _mm_movemask_epi8 as sign_bits, _mm_mul_epu32 as mul,
        _mm_or_si128 as or, _mm_set1_epi32 as every, _mm_set1_epi64x as every_64,
        _mm_shuffle_epi32 as shuffle, _mm_shuffle_ps as shuffle_floats,
        _mm_slli_epi32 as shift_left, _mm_srai_epi32 as shift_right_signed,
        _mm_srl_epi64 as shift_right_by, _mm_srli_epi32 as shift_right,
        _mm_srli_epi64 as shift_right_64, _mm_sub_epi32, _mm_sub_epi32 as sub_32,
        _mm_unpackhi_epi32 as high_32, _mm_unpackhi_epi64 as high_64, _mm_unpacklo_epi32 as low_32,
        _mm_unpacklo_epi64 as low_64, _mm_xor_si128 as xor,
    };

    use bytemuck::cast;

    use super::{HALF, Place, Quad, TWO};
    use crate::constraint::curve::{COEFFICIENTS, SHARE_BITS, SHARE_ONE};

    /// Batches in a register.
    const BATCHES: usize = 1;

    #[inline]
    fn join([batch]: [__m128i; BATCHES]) -> Register {
        batch
    }

    #[inline]
    fn split(batch: Register) -> [__m128i; BATCHES] {
        [batch]
    }

    in_registers!("sse2");
}

mod avx2 {
    use core::arch::x86_64::{
        __m128i, __m256i as Register, _mm_add_epi32, _mm_cvtsi32_si128, _mm_sub_epi32,
        _mm256_add_epi32 as add_32, _mm256_add_epi64 as add_64, _mm256_and_si256 as and,
        _mm256_andnot_si256 as and_not, _mm256_castps_si256 as from_floats, _mm256_castsi128_si256,
        _mm256_castsi256_ps as to_floats, _mm256_castsi256_si128, _mm256_cmpgt_epi32 as greater,
        _mm256_extracti128_si256, _mm256_inserti128_si256, _mm256_movemask_epi8 as sign_bits,
        _mm256_mul_epu32 as mul, _mm256_or_si256 as or, _mm256_set1_epi32 as every,
        _mm256_set1_epi64x as every_64, _mm256_shuffle_epi32 as shuffle,
        _mm256_shuffle_ps as shuffle_floats, _mm256_slli_epi32 as shift_left,
        _mm256_srai_epi32 as shift_right_signed, _mm256_srl_epi64 as shift_right_by,
        _mm256_srli_epi32 as shift_right, _mm256_srli_epi64 as shift_right_64,
        _mm256_sub_epi32 as sub_32, _mm256_unpackhi_epi32 as high_32,
        _mm256_unpackhi_epi64 as high_64, _mm256_unpacklo_epi32 as low_32,
        _mm256_unpacklo_epi64 as low_64, _mm256_xor_si256 as xor,
    };

    use bytemuck::cast;

    use super::{HALF, Place, Quad, TWO};
    use crate::constraint::curve::{COEFFICIENTS, SHARE_BITS, SHARE_ONE};

    /// Batches in a register.
    const BATCHES: usize = 2;

    #[inline]
    #[target_feature(enable = "avx2")]
    fn join([first, second]: [__m128i; BATCHES]) -> Register {
        _mm256_inserti128_si256::<1>(_mm256_castsi128_si256(first), second)
    }

    #[inline]
    #[target_feature(enable = "avx2")]
    fn split(batches: Register) -> [__m128i; BATCHES] {
        [_mm256_castsi256_si128(batches), _mm256_extracti128_si256::<1>(batches)]
    }

    in_registers!("avx2");
}
