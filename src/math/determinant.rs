//! Signs of determinants, exact for every 64-bit input.
//!
//! Wrapping arithmetic is right wherever the *final* value fits, whatever the parts do on the way:
//! that is what the narrow widths rest on.

use core::cmp::Ordering;

/// How wide the parts of a determinant of three differences are. Only signs come out.
///
/// `S` is the longest edge of the box around the points whose differences are taken. The cross
/// product of two differences from one point is at most `S^2` by components, and its dot product
/// with a third at most `2 S^3`: the volume of a tetrahedron in a cube is at most a third of it.
pub(crate) trait Width {
    /// A component of a cross product.
    type Minor: Copy;

    /// The cross product of two differences from one point.
    fn cross(u: [i64; 3], v: [i64; 3]) -> [Self::Minor; 3];

    /// The sign of the dot product of a cross product and a third difference: -1, 0 or 1.
    fn sign(normal: &[Self::Minor; 3], d: [i64; 3]) -> i8;
}

/// All in 64 bits, for `S <= 1,664,510` (9.9 cm): `2 S^3 < 2^63`.
#[derive(Debug)]
pub(crate) enum Narrow {}

/// Minors in 64 bits, sums in 128, for `S < 2^31` (128 m): `S^2 < 2^62`, `2 S^3 < 2^94`.
#[derive(Debug)]
pub(crate) enum Middle {}

/// All in 128 bits, for `S < 2^42` (262 km): `2 S^3 < 2^127`.
#[derive(Debug)]
pub(crate) enum Full {}

impl Narrow {
    pub(crate) const SPAN_MAX: u64 = 1_664_510;
}

impl Middle {
    pub(crate) const SPAN_MAX: u64 = (1 << 31) - 1;
}

impl Width for Narrow {
    type Minor = i64;

    #[inline]
    fn cross(u: [i64; 3], v: [i64; 3]) -> [i64; 3] {
        Middle::cross(u, v)
    }

    #[inline]
    fn sign(n: &[i64; 3], d: [i64; 3]) -> i8 {
        let term = |k: usize| n[k].wrapping_mul(d[k]);
        let sum = term(0).wrapping_add(term(1)).wrapping_add(term(2));
        i8::from(sum > 0) - i8::from(sum < 0)
    }
}

impl Width for Middle {
    type Minor = i64;

    #[inline]
    fn cross(u: [i64; 3], v: [i64; 3]) -> [i64; 3] {
        let minor =
            |j: usize, k: usize| u[j].wrapping_mul(v[k]).wrapping_sub(u[k].wrapping_mul(v[j]));
        [minor(1, 2), minor(2, 0), minor(0, 1)]
    }

    #[inline]
    fn sign(n: &[i64; 3], d: [i64; 3]) -> i8 {
        let term = |k: usize| i128::from(n[k]) * i128::from(d[k]);
        sign(term(0) + term(1) + term(2))
    }
}

impl Width for Full {
    type Minor = i128;

    #[inline]
    fn cross(u: [i64; 3], v: [i64; 3]) -> [i128; 3] {
        cross(u, v)
    }

    #[inline]
    fn sign(n: &[i128; 3], d: [i64; 3]) -> i8 {
        sign(dot(n, d))
    }
}

/// The cross product of two differences, for `S < 2^62`: at most `2 S^2`.
#[inline]
pub(crate) fn cross(u: [i64; 3], v: [i64; 3]) -> [i128; 3] {
    let product = |j: usize, k: usize| i128::from(u[j]) * i128::from(v[k]);
    let minor = |j, k| product(j, k) - product(k, j);
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The dot product of a cross product and a third difference, for `S < 2^42`.
#[inline]
pub(crate) fn dot(n: &[i128; 3], d: [i64; 3]) -> i128 {
    let term = |k: usize| n[k].wrapping_mul(i128::from(d[k]));
    term(0).wrapping_add(term(1)).wrapping_add(term(2))
}

#[inline]
fn sign(v: i128) -> i8 {
    i8::from(v > 0) - i8::from(v < 0)
}

/// A difference of two numbers of 64 bits: its magnitude has 64 bits too.
#[derive(Clone, Copy, Debug)]
struct Difference {
    magnitude: u64,
    is_negative: bool,
}

impl Difference {
    fn of(a: i64, b: i64) -> Self {
        Self { magnitude: a.abs_diff(b), is_negative: a < b }
    }
}

/// The sign of `u x v`, all differences from one point of the plane, whatever they are.
#[cold]
pub(crate) fn sign_of_det2(o: [i64; 2], a: [i64; 2], b: [i64; 2]) -> Ordering {
    let [u, v] = [a, b].map(|p| [0, 1].map(|k| Difference::of(p[k], o[k])));
    let mut sums = [0; 2]; // of what counts as positive, and as negative: at most 2^129
    let mut carries = [0; 2];
    for (a, b, turn) in [(u[0], v[1], false), (u[1], v[0], true)] {
        let side = usize::from(a.is_negative ^ b.is_negative ^ turn);
        let product = u128::from(a.magnitude) * u128::from(b.magnitude);
        let (sum, carry) = product.overflowing_add(sums[side]);
        sums[side] = sum;
        carries[side] += u32::from(carry);
    }
    (carries[0], sums[0]).cmp(&(carries[1], sums[1]))
}

/// The sign of `(u x v) . w`, all differences from one point, whatever they are.
#[cold]
pub(crate) fn sign_of_det3(o: [i64; 3], a: [i64; 3], b: [i64; 3], c: [i64; 3]) -> Ordering {
    const TERMS: [([usize; 3], bool); 6] = [
        ([0, 1, 2], false),
        ([1, 2, 0], false),
        ([2, 0, 1], false),
        ([0, 2, 1], true),
        ([1, 0, 2], true),
        ([2, 1, 0], true),
    ];
    let [u, v, w] = [a, b, c].map(|p| [0, 1, 2].map(|k| Difference::of(p[k], o[k])));
    // What counts as positive, and as negative; each at most 6 * 2^192. Most significant first.
    let mut sums = [[0_u64; 4]; 2];
    for ([i, j, k], odd) in TERMS {
        let factors = [u[i], v[j], w[k]];
        let side = factors.iter().fold(odd, |side, factor| side ^ factor.is_negative);
        add(&mut sums[usize::from(side)], factors.map(|factor| factor.magnitude));
    }
    sums[0].cmp(&sums[1])
}

/// `sum += a b c`.
fn add(sum: &mut [u64; 4], [a, b, c]: [u64; 3]) {
    let ab = u128::from(a) * u128::from(b);
    let low = (ab & u128::from(u64::MAX)) * u128::from(c);
    let high = (ab >> 64) * u128::from(c) + (low >> 64); // below 2^128
    let product = [0, (high >> 64) as u64, high as u64, low as u64];
    let mut carry = false;
    for (digit, term) in sum.iter_mut().zip(product).rev() {
        let (with_term, over) = digit.overflowing_add(term);
        let (with_carry, over_again) = with_term.overflowing_add(u64::from(carry));
        (*digit, carry) = (with_carry, over | over_again);
    }
}

/// The floor of `a n / d`, and what is left of it, in units of `1 / d`.
///
/// Requires `n <= d` and `0 < d < 2^126`, so that the floor is at most `a`. Exact.
pub(crate) fn scale_floor(a: u64, n: u128, d: u128) -> (u64, u128) {
    debug_assert!(n <= d && 0 < d && d < 1 << 126, "scale_floor: not a share");
    if let Some(product) = n.checked_mul(u128::from(a)) {
        return ((product / d) as u64, product % d); // at most a
    }
    // Bit by bit: what is left stays below d, and 2 d + n below 2^128.
    let (mut quotient, mut rest) = (0, 0);
    for bit in (0..u64::BITS - a.leading_zeros()).rev() {
        rest = 2 * rest + if a >> bit & 1 == 1 { n } else { 0 };
        quotient *= 2;
        while rest >= d {
            rest -= d;
            quotient += 1;
        }
    }
    (quotient, rest)
}
