//! Floor 0 against arbitrary-precision arithmetic: every rounding, root, decimal and float.

#![allow(
    clippy::cast_lossless,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::disallowed_types,
    clippy::float_arithmetic,
    clippy::float_cmp,
    clippy::unwrap_used,
    reason = "oracles: floats are what is converted, and casts pick the bits of a case"
)]

mod number;
mod rng;
mod root;
mod vector;
mod wide;

use num_bigint::BigInt;
use proptest::prelude::*;

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn big<T: Into<BigInt>>(v: T) -> BigInt {
    v.into()
}

/// `n / d` to nearest, ties away from zero, for d > 0. Big integers divide towards zero.
fn nearest(n: &BigInt, d: &BigInt) -> BigInt {
    let half_up = |n: &BigInt| -> BigInt { (n * 2 + d) / (d * 2) };
    if *n < big(0) { -half_up(&-n) } else { half_up(n) }
}

fn square(v: &BigInt) -> BigInt {
    v.pow(2)
}

/// Integers of every magnitude, the ends of the range and their neighbours among them.
fn any_i64() -> impl Strategy<Value = i64> {
    let ends = [i64::MIN, i64::MIN + 1, -1, 0, 1, i64::MAX - 1, i64::MAX];
    prop_oneof![1 => prop::sample::select(ends.to_vec()),
        9 => (any::<i64>(), 0..64_u32).prop_map(|(v, s)| v >> s)]
}

fn any_i128() -> impl Strategy<Value = i128> {
    let ends = [i128::MIN, i128::MIN + 1, -1, 0, 1, i128::MAX - 1, i128::MAX];
    prop_oneof![1 => prop::sample::select(ends.to_vec()),
        9 => (any::<i128>(), 0..128_u32).prop_map(|(v, s)| v >> s)]
}

fn any_raw3() -> impl Strategy<Value = [i64; 3]> {
    prop::array::uniform3(any_i64())
}
