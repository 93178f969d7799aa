//! Rounding, division and wide products.

#[cfg(panic = "unwind")]
use std::panic::catch_unwind;

use num_bigint::BigInt;
use proptest::prelude::*;
use verlock::math::wide::{
    NARROW_MAX, add, dot_narrow, dot_wide, is_narrow, round_div, round_div_magnitude,
    round_div_wide, round_shift, round_shift_wide, sub,
};

use super::{any_i64, any_i128, any_raw3, big, cases, nearest};

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn shifts_round_to_nearest_ties_away(
        v in any_i64(), w in any_i128(), s in 1..=62_u32, t in 1..=126_u32,
    ) {
        let v = v.min(i64::MAX - (1 << (s - 1)));
        let w = w.min(i128::MAX - (1 << (t - 1)));
        prop_assert_eq!(big(round_shift(v, s)), nearest(&big(v), &(big(1) << s)));
        prop_assert_eq!(big(round_shift_wide(w, t)), nearest(&big(w), &(big(1) << t)));
    }

    #[test]
    fn shifts_send_ties_away(k in any_i64(), s in 1..=62_u32) {
        // The tie between k and k + 1; what passes the range is drawn in.
        let k = k >> s;
        let tie = (2 * i128::from(k) + 1) << (s - 1);
        let away = if k < 0 { k } else { k + 1 };
        prop_assert_eq!(round_shift_wide(tie, s), i128::from(away));
        if let Ok(tie) = i64::try_from(tie) && tie <= i64::MAX - (1 << (s - 1)) {
            prop_assert_eq!(round_shift(tie, s), away);
        }
    }

    #[test]
    fn divisions_round_to_nearest_ties_away(
        n in any_i64(), d in any_i64(), w in any_i128(), e in any_i128(),
    ) {
        let (d, e) = (d.saturating_abs().max(1), e.saturating_abs().max(1));
        prop_assert_eq!(big(round_div(n, d)), nearest(&big(n), &big(d)));
        prop_assert_eq!(big(round_div_wide(w, e)), nearest(&big(w), &big(e)));
        prop_assert_eq!(round_div_wide(n.into(), d.into()), i128::from(round_div(n, d)));
        // At most 2^63 + 2^62.
        let (n, d) = (n.unsigned_abs(), d.unsigned_abs());
        prop_assert_eq!(big(round_div_magnitude(n, d)), nearest(&big(n), &big(d)));
    }

    #[test]
    fn divisions_send_ties_away(k in -1_000_000..1_000_000_i64, half in 1..1_000_000_i64) {
        let tie = (2 * k + 1) * half;
        let away = if k < 0 { k } else { k + 1 };
        prop_assert_eq!(round_div(tie, 2 * half), away);
        prop_assert_eq!(round_div_wide(tie.into(), (2 * half).into()), i128::from(away));
        let magnitude = round_div_magnitude(tie.unsigned_abs(), 2 * half.unsigned_abs());
        prop_assert_eq!(magnitude, away.unsigned_abs());
    }

    #[test]
    fn products_are_exact(a in any_raw3(), b in any_raw3()) {
        let exact = |a: [i64; 3], b: [i64; 3]| (0..3).map(|i| big(a[i]) * b[i]).sum::<BigInt>();
        let (c, d) = (a.map(|v| v >> 1), b.map(|v| v >> 1));
        prop_assert_eq!(big(dot_wide(c, d)), exact(c, d));
        let (c, d) = (a.map(|v| v >> 2), b.map(|v| v >> 2));
        for i in 0..3 {
            prop_assert_eq!(big(add(c, d)[i]), big(c[i]) + d[i]);
            prop_assert_eq!(big(sub(c, d)[i]), big(c[i]) - d[i]);
        }
        let narrow = |v: i64| v.clamp(-NARROW_MAX, NARROW_MAX);
        let (c, d) = (a.map(narrow), b.map(narrow));
        prop_assert_eq!(big(dot_narrow(c, d)), exact(c, d));
        prop_assert_eq!(is_narrow(a), a.iter().all(|v| v.unsigned_abs() <= NARROW_MAX as u64));
    }
}

#[test]
fn narrow_ends_at_two_to_the_thirty_inclusive() {
    for i in 0..3 {
        for sign in [-1, 1] {
            let mut v = [0; 3];
            v[i] = sign * NARROW_MAX;
            assert!(is_narrow(v));
            v[i] += sign;
            assert!(!is_narrow(v));
        }
    }
    assert!(!is_narrow([i64::MIN, 0, 0]) && !is_narrow([0, i64::MAX, 0]));
    assert!(is_narrow([-NARROW_MAX; 3]) && is_narrow([NARROW_MAX; 3]));
    assert_eq!(dot_narrow([-NARROW_MAX; 3], [NARROW_MAX; 3]), -3 << 60);
}

#[cfg(panic = "unwind")]
#[test]
fn divisors_must_be_positive() {
    for d in [0, -1, i64::MIN] {
        assert!(catch_unwind(|| round_div(1, d)).is_err());
        assert!(catch_unwind(|| round_div_wide(1, d.into())).is_err());
    }
}
