//! Batches in the registers that every 64-bit x86 processor has.
//!
//! SSE2 multiplies 32 x 32 to 64 bits unsigned and in every other lane only (`pmuludq`), so all
//! factors are magnitudes, and a product of four lanes takes two multiplications: of the lanes 0
//! and 2, and of 1 and 3 moved down. Putting their upper halves together leaves the lanes in the
//! order 0 2 1 3; a second product puts them right.

#![allow(unsafe_code, reason = "calls what this target always has; twice as fast as without")]

use core::arch::x86_64::{
    __m128i, _mm_add_epi32, _mm_add_epi64, _mm_and_si128, _mm_andnot_si128, _mm_castps_si128,
    _mm_castsi128_ps, _mm_cmpgt_epi32, _mm_cvtsi32_si128, _mm_movemask_epi8, _mm_mul_epu32,
    _mm_or_si128, _mm_shuffle_epi32, _mm_shuffle_ps, _mm_slli_epi32, _mm_srai_epi32, _mm_srl_epi64,
    _mm_srli_epi32, _mm_srli_epi64, _mm_sub_epi32, _mm_unpackhi_epi32, _mm_unpackhi_epi64,
    _mm_unpacklo_epi32, _mm_unpacklo_epi64, _mm_xor_si128,
};

use bytemuck::cast;

use super::{Batch, Place, UnevenBatch};
use crate::constraint::curve::{COEFFICIENTS, RATIO_ONE, SHARE_BITS, SHARE_ONE};

pub(in super::super) fn relax_even(shift: u32, batches: &[Batch], places: &mut [Place]) {
    // SAFETY: this module is compiled only where SSE2 is there.
    unsafe { relax(shift, batches, places) }
}

pub(in super::super) fn relax_uneven(shift: u32, batches: &[UnevenBatch], places: &mut [Place]) {
    // SAFETY: this module is compiled only where SSE2 is there.
    unsafe { relax(shift, batches, places) }
}

/// Either kind of batch. What takes it is generic so that each loop has a copy of its own, which is
/// inlined: calls would pass all registers through memory and cost half as much again.
trait Quad {
    fn batch(&self) -> &Batch;

    /// The gains of the second ends and whether they may be pushed, where they differ.
    fn second(&self) -> Option<(__m128i, __m128i)>;
}

impl Quad for Batch {
    #[inline]
    fn batch(&self) -> &Batch {
        self
    }

    #[inline]
    fn second(&self) -> Option<(__m128i, __m128i)> {
        None
    }
}

impl Quad for UnevenBatch {
    #[inline]
    fn batch(&self) -> &Batch {
        &self.even
    }

    #[inline]
    fn second(&self) -> Option<(__m128i, __m128i)> {
        Some((cast(self.gain_b), cast(self.push)))
    }
}

#[target_feature(enable = "sse2")]
fn relax<Q: Quad>(shift: u32, quads: &[Q], places: &mut [Place]) {
    let shift = _mm_cvtsi32_si128(shift.cast_signed());
    for quad in quads {
        let batch = quad.batch();
        let [x, y, z] = differences(quad, places);
        let sign = [sign(x), sign(y), sign(z)];
        let size = [negate(x, sign[0]), negate(y, sign[1]), negate(z, sign[2])];
        let mut share = share(ratio(quad, size, shift));
        if let Some((_, push)) = quad.second() {
            let pushes = self::sign(share);
            share = select(pushes, _mm_and_si128(share, push), share);
        }
        let moves_a = moves(quad, size, sign, share, cast(batch.gain));
        let moves_b = match quad.second() {
            None => moves_a,
            Some((gain_b, _)) => moves(quad, size, sign, share, gain_b),
        };
        // Lanes come back in the order 0 2 1 3.
        for (row, k) in [0, 2, 1, 3].into_iter().enumerate() {
            let [a, b] = [batch.a[k], batch.b[k]].map(|end| end as usize);
            places[a] = cast(_mm_add_epi32(cast(places[a]), moves_a[row]));
            places[b] = cast(_mm_sub_epi32(cast(places[b]), moves_b[row]));
        }
    }
}

/// Lanes of x, y and z of `b - a`.
#[inline]
#[target_feature(enable = "sse2")]
fn differences<Q: Quad>(quad: &Q, places: &[Place]) -> [__m128i; 3] {
    let Batch { a, b, .. } = quad.batch();
    let d0 = difference(places, a[0], b[0]);
    let d1 = difference(places, a[1], b[1]);
    let d2 = difference(places, a[2], b[2]);
    let d3 = difference(places, a[3], b[3]);
    let (xy01, xy23) = (_mm_unpacklo_epi32(d0, d1), _mm_unpacklo_epi32(d2, d3));
    let (z01, z23) = (_mm_unpackhi_epi32(d0, d1), _mm_unpackhi_epi32(d2, d3));
    let (x, y) = (_mm_unpacklo_epi64(xy01, xy23), _mm_unpackhi_epi64(xy01, xy23));
    [x, y, _mm_unpacklo_epi64(z01, z23)]
}

/// `d.d / L^2`, 26 fractional bits, saturated.
#[inline]
#[target_feature(enable = "sse2")]
fn ratio<Q: Quad>(quad: &Q, [x, y, z]: [__m128i; 3], shift: __m128i) -> __m128i {
    let even = sum(_mm_mul_epu32(x, x), _mm_mul_epu32(y, y), _mm_mul_epu32(z, z));
    let [x, y, z] = [odd(x), odd(y), odd(z)];
    let odds = sum(_mm_mul_epu32(x, x), _mm_mul_epu32(y, y), _mm_mul_epu32(z, z));
    let (even, odds) = (_mm_srl_epi64(even, shift), _mm_srl_epi64(odds, shift));
    let inverse = cast(quad.batch().inverse);
    let ratio = upper(_mm_mul_epu32(even, inverse), _mm_mul_epu32(odds, odd(inverse)));
    // More than 32 bits.
    let over = _mm_cmpgt_epi32(upper(even, odds), cast([0_i32; 4]));
    swap(_mm_or_si128(ratio, over))
}

/// Rows of `share gain d`, rounded to nearest, ties away from zero, in the order 0 2 1 3.
#[inline]
#[target_feature(enable = "sse2")]
fn moves<Q: Quad>(
    _: &Q,
    size: [__m128i; 3],
    sign: [__m128i; 3],
    share: __m128i,
    gain: __m128i,
) -> [__m128i; 4] {
    let pushes = self::sign(share);
    let part = _mm_slli_epi32::<{ 32 - SHARE_BITS.cast_signed() }>(negate(share, pushes));
    let part = swap(high(part, odd(part), gain));
    let odd_part = odd(part);
    let half: __m128i = cast([1_u64 << 31; 2]);
    let component = |size: __m128i, sign: __m128i| {
        let even = _mm_add_epi64(_mm_mul_epu32(part, size), half);
        let odds = _mm_add_epi64(_mm_mul_epu32(odd_part, odd(size)), half);
        negate(upper(even, odds), swap(_mm_xor_si128(sign, pushes)))
    };
    let x = component(size[0], sign[0]);
    let y = component(size[1], sign[1]);
    let z = component(size[2], sign[2]);
    let none = cast([0_i32; 4]);
    let (xy01, xy23) = (_mm_unpacklo_epi32(x, y), _mm_unpackhi_epi32(x, y));
    let (z01, z23) = (_mm_unpacklo_epi32(z, none), _mm_unpackhi_epi32(z, none));
    [
        _mm_unpacklo_epi64(xy01, z01),
        _mm_unpackhi_epi64(xy01, z01),
        _mm_unpacklo_epi64(xy23, z23),
        _mm_unpackhi_epi64(xy23, z23),
    ]
}

/// `curve::share` of four ratios.
#[inline]
#[target_feature(enable = "sse2")]
fn share(ratio: __m128i) -> __m128i {
    let out = _mm_or_si128(below_half(ratio), above_two(ratio));
    if _mm_movemask_epi8(out) == 0 { polynomial(ratio) } else { share_far(ratio) }
}

/// The same where a ratio is below 1/2 or above 2.
#[cold]
#[inline(never)]
#[target_feature(enable = "sse2")]
fn share_far(ratio: __m128i) -> __m128i {
    let [half, two] = [RATIO_ONE / 2, 2 * RATIO_ONE - 1].map(|limit| cast([limit; 4]));
    // From 2^31 on a ratio looks negative.
    let huge = sign(ratio);
    let ratio = _mm_and_si128(_mm_or_si128(ratio, huge), cast([i32::MAX; 4]));
    let long = above_two(ratio);
    let once = select(long, _mm_srli_epi32::<2>(ratio), ratio);
    let longer = above_two(once);
    let twice = select(longer, _mm_srli_epi32::<2>(once), once);
    let short = below_half(ratio);
    let near = select(short, _mm_slli_epi32::<2>(twice), twice);
    let near = select(below_half(near), half, near);
    let near = select(above_two(near), two, near);
    let share = polynomial(near);
    let one = cast([SHARE_ONE; 4]);
    let halved = |share| _mm_add_epi32(_mm_srai_epi32::<1>(share), cast([SHARE_ONE / 2; 4]));
    let share = select(long, halved(share), share);
    let share = select(longer, halved(share), share);
    let doubled = _mm_sub_epi32(_mm_add_epi32(share, share), one);
    let least = cast([1 - SHARE_ONE; 4]);
    let doubled = select(_mm_cmpgt_epi32(least, doubled), least, doubled);
    select(short, doubled, share)
}

/// `curve::polynomial` of four ratios.
#[inline]
#[target_feature(enable = "sse2")]
fn polynomial(ratio: __m128i) -> __m128i {
    let v = _mm_slli_epi32::<5>(ratio);
    let swapped = swap(v);
    let (v_odd, swapped_odd) = (odd(v), odd(swapped));
    let [c0, c1, c2, c3, c4] = COEFFICIENTS.map(|c| cast::<_, __m128i>([c; 4]));
    let p = _mm_sub_epi32(c3, high(v, v_odd, c4));
    let p = _mm_sub_epi32(c2, high(swapped, swapped_odd, p));
    let p = _mm_sub_epi32(c1, high(v, v_odd, p));
    let p = _mm_sub_epi32(c0, high(swapped, swapped_odd, p));
    _mm_sub_epi32(cast([SHARE_ONE; 4]), p)
}

#[inline]
#[target_feature(enable = "sse2")]
fn difference(places: &[Place], a: u32, b: u32) -> __m128i {
    _mm_sub_epi32(cast(places[b as usize]), cast(places[a as usize]))
}

/// Signed, so that a ratio from 2^31 on counts as below.
#[inline]
#[target_feature(enable = "sse2")]
fn below_half(ratio: __m128i) -> __m128i {
    _mm_cmpgt_epi32(cast([RATIO_ONE / 2; 4]), ratio)
}

#[inline]
#[target_feature(enable = "sse2")]
fn above_two(ratio: __m128i) -> __m128i {
    _mm_cmpgt_epi32(ratio, cast([2 * RATIO_ONE - 1; 4]))
}

/// The lanes 1 and 3 where the lanes 0 and 2 were.
#[inline]
#[target_feature(enable = "sse2")]
fn odd(v: __m128i) -> __m128i {
    _mm_srli_epi64::<32>(v)
}

/// The upper halves of two pairs of products, of the lanes 0 and 2 and of 1 and 3.
#[inline]
#[target_feature(enable = "sse2")]
fn upper(even: __m128i, odd: __m128i) -> __m128i {
    let halves = (_mm_castsi128_ps(even), _mm_castsi128_ps(odd));
    _mm_castps_si128(_mm_shuffle_ps::<0b11_01_11_01>(halves.0, halves.1))
}

/// The upper halves of four products, in the order 0 2 1 3.
#[inline]
#[target_feature(enable = "sse2")]
fn high(a: __m128i, a_odd: __m128i, b: __m128i) -> __m128i {
    upper(_mm_mul_epu32(a, b), _mm_mul_epu32(a_odd, odd(b)))
}

/// Exchanges the lanes 1 and 2.
#[inline]
#[target_feature(enable = "sse2")]
fn swap(v: __m128i) -> __m128i {
    _mm_shuffle_epi32::<0b11_01_10_00>(v)
}

/// All ones where a lane is negative.
#[inline]
#[target_feature(enable = "sse2")]
fn sign(v: __m128i) -> __m128i {
    _mm_srai_epi32::<31>(v)
}

/// `v`, or `-v` where the mask is all ones.
#[inline]
#[target_feature(enable = "sse2")]
fn negate(v: __m128i, mask: __m128i) -> __m128i {
    _mm_sub_epi32(_mm_xor_si128(v, mask), mask)
}

/// `yes` where the mask is all ones, else `no`.
#[inline]
#[target_feature(enable = "sse2")]
fn select(mask: __m128i, yes: __m128i, no: __m128i) -> __m128i {
    _mm_or_si128(_mm_and_si128(mask, yes), _mm_andnot_si128(mask, no))
}

#[inline]
#[target_feature(enable = "sse2")]
fn sum(a: __m128i, b: __m128i, c: __m128i) -> __m128i {
    _mm_add_epi64(_mm_add_epi64(a, b), c)
}
