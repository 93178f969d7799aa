//! Integer square roots, exact and without floating point.
//!
//! ```text
//! n  = v shifted left by an even count, 2^62 <= n < 2^64
//! y  = table(n)                    about 2^62 / sqrt(n), too large by 2^-21 .. 2^-17.2 of itself
//! s0 = n y / 2^62                  about sqrt(n), too large likewise
//! s  = floor(s0 + (n - s0^2) y / 2^63)        Newton: the root, or one less
//! ```
//! The table is the chord of `1 / sqrt` between 385 nodes, so the error is that of a straight
//! line and one Newton step suffices. Shifting `s` back keeps "the root, or one less", and one
//! comparison with the rest finishes. 128 bits add one division (Zimmermann, *Karatsuba Square
//! Root*, INRIA RR-3805, 1999).

/// The largest `r` with `r^2 <= v`.
#[inline]
#[must_use]
pub const fn isqrt(v: u64) -> u64 {
    root_and_rest(v).0
}

/// The largest `r` with `r^2 <= v`, below 2^64.
#[inline]
#[must_use]
pub const fn isqrt_wide(v: u128) -> u128 {
    if v >> 64 == 0 {
        return isqrt(v as u64) as u128;
    }
    let shift = v.leading_zeros() & !1;
    let n = v << shift;
    let (s, rest) = root_and_rest((n >> 64) as u64);
    // With S = s 2^32, n = S^2 + R and q = R / 2S <= 2^32: (S + q)^2 = n + q^2, so S + q is not
    // below the root, and above it by less than q^2 / 2S <= 2^64 / 2^64 = 1.
    // rest <= 2 s < 2^33, so `rest << 31` fits; s is at least 2^31, never 0.
    let quotient = ((rest << 31) + ((n as u64) >> 33)) / s;
    // The root of n is below (s + 1) 2^32: larger quotients (2^32 exactly) are cut.
    let quotient = if quotient >> 32 == 0 { quotient } else { u32::MAX as u64 };
    let high = ((s << 32) | quotient) as u128;
    let root = if high * high > n { high - 1 } else { high };
    root >> (shift / 2)
}

/// The smallest `r` with `v <= r^2`, at most 2^64.
#[inline]
#[must_use]
pub const fn isqrt_wide_up(v: u128) -> u128 {
    let root = isqrt_wide(v);
    root + (root * root < v) as u128
}

/// The integer nearest to the real root of `v`, at most 2^32. There are no ties: `r + 1/2` has
/// the square `r^2 + r + 1/4`, which is no integer.
#[inline]
#[must_use]
pub const fn root_nearest(v: u64) -> u64 {
    let (root, rest) = root_and_rest(v);
    root + (rest > root) as u64
}

/// The integer nearest to the real root of `v`, at most 2^64.
#[inline]
#[must_use]
pub const fn root_nearest_wide(v: u128) -> u128 {
    let root = isqrt_wide(v);
    root + (v - root * root > root) as u128
}

/// Nodes `2^62 / sqrt(n)` at n = (128 + k) 2^55, plus 2^10: a surplus of 2^-21 that outweighs
/// every truncation on the way, so that the Newton step always lands below the root.
const NODES: [u32; 385] = {
    let mut nodes = [0; 385];
    let mut k = 0;
    while k < nodes.len() {
        // At most 2^31 + 2^10.
        nodes[k] = ((1u128 << 69) / (128 + k as u128)).isqrt() as u32 + (1 << 10);
        k += 1;
    }
    nodes
};

/// The floor of the root, and `v - root^2`.
#[inline]
const fn root_and_rest(v: u64) -> (u64, u64) {
    if v == 0 {
        return (0, 0);
    }
    let shift = v.leading_zeros() & !1;
    let n = v << shift;
    // The 9 leading bits, 128 <= .. < 512, name the chord; the next 32 are the way along it.
    let k = (n >> 55) as usize - 128;
    let (start, end) = (NODES[k] as u64, NODES[k + 1] as u64);
    let along = (n >> 23) & 0xFFFF_FFFF;
    let y = start - (((start - end) * along) >> 32);
    // 32 bits times 31.1 bits; s0 may pass 2^32, hence the wrapping square below: the
    // difference is exact modulo 2^64 and smaller than 2^48.
    let s0 = ((n >> 32) * y) >> 30;
    let rest = n.wrapping_sub(s0.wrapping_mul(s0)).cast_signed();
    // |rest >> 17| < 2^31, so the product is below 2^63; a loss of 2^-15 in the root.
    let step = ((rest >> 17) * y.cast_signed()) >> 46;
    let root = s0.wrapping_add_signed(step) >> (shift / 2);
    let rest = v - root * root;
    if rest > 2 * root { (root + 1, rest - 2 * root - 1) } else { (root, rest) }
}
