//! Floor 0 against arbitrary-precision arithmetic: every rounding, root, decimal and float.

use std::fmt::{Debug, Display};
use std::panic::catch_unwind;
use std::str::FromStr;

use num_bigint::BigInt;
use proptest::prelude::*;
use verlock::math::root::{isqrt, isqrt_wide, root_nearest, root_nearest_wide};
use verlock::math::wide::{
    NARROW_MAX, add, dot_narrow, dot_wide, is_narrow, round_div, round_div_wide, round_shift,
    round_shift_wide, sub,
};
use verlock::math::{DecimalError, Factor, Pcg, Real, RealError, Unit, UnitVec3, Vec3, Weight};
use verlock::real;

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn big<T: Into<BigInt>>(v: T) -> BigInt {
    v.into()
}

/// `n / d` to nearest, ties away from zero, for d > 0. Big integers divide towards zero.
fn nearest(n: &BigInt, d: &BigInt) -> BigInt {
    let half_up = |n: &BigInt| (n * 2 + d) / (d * 2);
    if *n < big(0) { -half_up(&-n) } else { half_up(n) }
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

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn shifts_round_to_nearest_ties_away(v in any_i64(), w in any_i128(), s in 1..=62_u32, t in 1..=126_u32) {
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
    fn divisions_round_to_nearest_ties_away(n in any_i64(), d in any_i64(), w in any_i128(), e in any_i128()) {
        let (d, e) = (d.saturating_abs().max(1), e.saturating_abs().max(1));
        prop_assert_eq!(big(round_div(n, d)), nearest(&big(n), &big(d)));
        prop_assert_eq!(big(round_div_wide(w, e)), nearest(&big(w), &big(e)));
        prop_assert_eq!(round_div_wide(n.into(), d.into()), i128::from(round_div(n, d)));
    }

    #[test]
    fn divisions_send_ties_away(k in -1_000_000..1_000_000_i64, half in 1..1_000_000_i64) {
        let tie = (2 * k + 1) * half;
        let away = if k < 0 { k } else { k + 1 };
        prop_assert_eq!(round_div(tie, 2 * half), away);
        prop_assert_eq!(round_div_wide(tie.into(), (2 * half).into()), i128::from(away));
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

    #[test]
    fn roots_floor_and_go_to_the_nearest(v in any_i64(), w in any_i128()) {
        check_roots((v as u64).into());
        check_roots(w as u128);
    }

    #[test]
    fn roots_of_squares_and_their_neighbours(k in any_i64(), j in any::<u32>()) {
        for k in [u128::from(k as u64), j.into()] {
            check_roots(k * k);
            check_roots(k * k + k);
            check_roots(k * k + k + 1);
            check_roots(k * k + 2 * k);
        }
    }
}

/// Against big integers: the floor root in its defining inequality, the nearest one likewise.
fn check_roots(v: u128) {
    let (floor, near) = (big(isqrt_wide(v)), big(root_nearest_wide(v)));
    assert!(floor.pow(2) <= big(v) && big(v) < (&floor + 1).pow(2), "isqrt_wide({v}) = {floor}");
    // near - 1/2 < root < near + 1/2, times 2, squared.
    assert!((&near * 2 + 1).pow(2) > big(v) * 4, "root_nearest_wide({v}) = {near}");
    assert!(v == 0 || (&near * 2 - 1).pow(2) < big(v) * 4, "root_nearest_wide({v}) = {near}");
    if let Ok(v) = u64::try_from(v) {
        assert_eq!(u128::from(isqrt(v)), isqrt_wide(v.into()));
        assert_eq!(u128::from(root_nearest(v)), root_nearest_wide(v.into()));
    }
}

#[test]
fn roots_at_the_ends_and_of_small_numbers() {
    for v in 0..3000 {
        check_roots(v);
    }
    for bits in 0..128 {
        for offset in 0..4 {
            check_roots((1_u128 << bits).saturating_add(offset));
            check_roots((1_u128 << bits).saturating_sub(offset));
            check_roots(u128::MAX - offset);
            check_roots(u128::from(u64::MAX) - offset);
        }
    }
    assert_eq!(root_nearest(u64::MAX), 1 << 32);
    assert_eq!(root_nearest_wide(u128::MAX), 1 << 64);
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

#[test]
fn divisors_must_be_positive() {
    for d in [0, -1, i64::MIN] {
        assert!(catch_unwind(|| round_div(1, d)).is_err());
        assert!(catch_unwind(|| round_div_wide(1, d.into())).is_err());
    }
}

/// What the tests need to know about a number type.
trait Number: Copy + Eq + Debug + Display + FromStr<Err = DecimalError> + serde::Serialize {
    const BITS: u32;
    const ENDS: (i64, i64);
    fn of(raw: i64) -> Self;
    fn raw64(self) -> i64;
    fn of_f64(v: f64) -> Result<Self, RealError>;
    fn of_f32(v: f32) -> Result<Self, RealError>;
    fn of_ratio(n: i64, d: i64) -> Result<Self, RealError>;
    fn floats(self) -> (f64, f32);

    /// The number with these exact raw digits, or the word that it does not fit.
    fn expect(raw: &BigInt) -> Option<Self> {
        i64::try_from(raw).ok().filter(|r| (Self::ENDS.0..=Self::ENDS.1).contains(r)).map(Self::of)
    }
}

macro_rules! number {
    ($number:ty, $raw:ty) => {
        impl Number for $number {
            const BITS: u32 = Self::FRACTION_BITS;
            const ENDS: (i64, i64) = (<$raw>::MIN as i64, <$raw>::MAX as i64);
            fn of(raw: i64) -> Self {
                Self::from_raw(raw as $raw)
            }
            fn raw64(self) -> i64 {
                self.raw() as i64
            }
            fn of_f64(v: f64) -> Result<Self, RealError> {
                Self::from_f64(v)
            }
            fn of_f32(v: f32) -> Result<Self, RealError> {
                Self::from_f32(v)
            }
            fn of_ratio(n: i64, d: i64) -> Result<Self, RealError> {
                Self::from_ratio(n, d)
            }
            fn floats(self) -> (f64, f32) {
                (self.to_f64(), self.to_f32())
            }
        }
    };
}

number!(Real, i64);
number!(Unit, i32);
number!(Weight, i32);
number!(Factor, i32);

/// The exact value of `[+-]digits[.digits]` as a fraction, by big integers.
fn rational(text: &str) -> (BigInt, BigInt) {
    let text = text.replace('_', "");
    let places = text.split_once('.').map_or(0, |(_, digits)| digits.len());
    (text.replace('.', "").parse().unwrap(), big(10).pow(places as u32))
}

fn check_decimal<N: Number>(text: &str) {
    let (n, d) = rational(text);
    let expected = N::expect(&nearest(&(n << N::BITS), &d)).ok_or(DecimalError::OutOfRange);
    assert_eq!(text.parse::<N>(), expected, "{text}");
}

/// Prints, reads back, and proves that one place fewer would not do.
fn check_display<N: Number>(raw: i64) {
    let value = N::of(raw);
    let text = value.to_string();
    assert_eq!(text.parse(), Ok(value), "{text}");
    assert_eq!(format!("{value:?}"), text);
    let Some((_, places)) = text.split_once('.') else { return };
    let (exact, unit) = (big(value.raw64()), big(1) << N::BITS);
    let floor: BigInt = exact * big(10).pow(places.len() as u32 - 1) / &unit;
    for candidate in [&floor - 1, floor.clone(), &floor + 1] {
        let shorter = nearest(&(candidate * &unit), &big(10).pow(places.len() as u32 - 1));
        assert_ne!(shorter, big(value.raw64()), "{text} is not the shortest");
    }
}

/// Rust prints every digit of a float when asked to: an exact decimal, made by other code.
fn check_float<N: Number>(double: f64, single: f32) {
    let expected = |text: String| {
        let (n, d) = rational(&text);
        N::expect(&nearest(&(n << N::BITS), &d)).ok_or(RealError::OutOfRange)
    };
    let refused = |nan| if nan { RealError::NotANumber } else { RealError::Infinite };
    let (got, got32) = (N::of_f64(double), N::of_f32(single));
    match double.is_finite() {
        true => assert_eq!(got, expected(format!("{double:.1074}")), "{double:e}"),
        false => assert_eq!(got, Err(refused(double.is_nan()))),
    }
    match single.is_finite() {
        true => assert_eq!(got32, expected(format!("{single:.149}")), "{single:e}"),
        false => assert_eq!(got32, Err(refused(single.is_nan()))),
    }
}

/// An integer becomes a float to nearest, ties to even; the power of two is exact.
fn check_to_float<N: Number>(raw: i64) {
    let value = N::of(raw);
    let (double, single) = value.floats();
    let scale = (1_u64 << N::BITS) as f64;
    assert_eq!(double.to_bits(), (value.raw64() as f64 / scale).to_bits());
    assert_eq!(single.to_bits(), (value.raw64() as f32 / scale as f32).to_bits());
}

fn check_ratio<N: Number>(n: i64, d: i64) {
    let (big_n, big_d) = if d < 0 { (-big(n), -big(d)) } else { (big(n), big(d)) };
    let expected = match d {
        0 => Err(RealError::ZeroDenominator),
        _ => N::expect(&nearest(&(big_n << N::BITS), &big_d)).ok_or(RealError::OutOfRange),
    };
    assert_eq!(N::of_ratio(n, d), expected, "{n} / {d}");
}

/// Calls a generic check for every number type.
macro_rules! for_each_number {
    ($check:ident($($argument:expr),*)) => {
        $check::<Real>($($argument),*);
        $check::<Unit>($($argument),*);
        $check::<Weight>($($argument),*);
        $check::<Factor>($($argument),*);
    };
}

/// A decimal whose digits hug the middle between two values: the tie, cut or pushed anywhere.
fn near_tie(raw: i64, bits: u32, zeros: usize, nudge: i64) -> String {
    // (2 raw + 1) / 2^(bits + 1) has bits + 1 places exactly.
    let places = bits as usize + 1;
    let digits = (big(raw) * 2 + 1) * big(5).pow(bits + 1);
    let digits = digits * big(10).pow(zeros as u32) + nudge;
    let (sign, digits) = if digits < big(0) { ("-", -digits) } else { ("", digits) };
    let digits = format!("{digits:0>width$}", width = places + zeros + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places - zeros);
    format!("{sign}{whole}.{fraction}")
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn decimals_are_read_to_nearest(text in "[+-]?[0-9]{1,14}(_[0-9]{1,3})?(\\.[0-9]{1,30}(_[0-9]{1,4})?)?") {
        for_each_number!(check_decimal(&text));
        // Small enough for the fractions too.
        for_each_number!(check_decimal(&format!("0.{}", text.replace(['+', '-', '.', '_'], ""))));
    }

    #[test]
    fn decimals_of_any_length_are_read_to_nearest(text in "[+-]?[0-9]{1,3}\\.[0-9]{100,200}", zeros in 0..200_usize) {
        for_each_number!(check_decimal(&text));
        let (sign, digits) = if text.starts_with(['+', '-']) { text.split_at(1) } else { ("", &*text) };
        for_each_number!(check_decimal(&format!("{sign}{}{digits}", "0".repeat(zeros))));
    }

    #[test]
    fn decimals_around_a_tie(raw in any_i64(), zeros in 0..180_usize, nudge in -1..=1_i64) {
        check_decimal::<Real>(&near_tie(raw, 24, zeros, nudge));
        check_decimal::<Unit>(&near_tie(raw >> 32, 30, zeros, nudge));
        check_decimal::<Weight>(&near_tie(raw >> 32, 27, zeros, nudge));
        check_decimal::<Factor>(&near_tie(raw >> 32, 16, zeros, nudge));
    }

    #[test]
    fn numbers_print_the_shortest_decimal(raw in any_i64()) {
        for_each_number!(check_display(raw));
    }

    #[test]
    fn floats_are_read_to_nearest(bits in any::<u64>(), raw in any_i64()) {
        // Any float at all, and those of a size that fits, ties among them.
        let (half, fits) = (0.5_f64, raw as f64 / (1_u64 << 31) as f64);
        for_each_number!(check_float(f64::from_bits(bits), f32::from_bits(bits as u32)));
        for_each_number!(check_float(fits, fits as f32));
        for bits in [16, 24, 27, 30] {
            let tie = ((raw >> 32) as f64 + half) / (1_u64 << bits) as f64;
            for_each_number!(check_float(tie, tie as f32));
        }
    }

    #[test]
    fn floats_are_written_to_nearest_even(raw in any_i64(), bits in 25..63_u32, nudge in -1..=1_i64) {
        for_each_number!(check_to_float(raw));
        // A tie of either format, at this size, and its neighbours.
        for significand in [24, 53] {
            let lost = bits.saturating_sub(significand) + 1;
            let tie = ((raw.unsigned_abs() >> 1) >> (63 - bits) >> lost << lost) | 1 << (lost - 1);
            for_each_number!(check_to_float((tie as i64).saturating_add(nudge)));
        }
    }
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn ratios_are_nearest(n in any_i64(), d in any_i64(), k in 1..40_i64) {
        for_each_number!(check_ratio(n, d));
        for_each_number!(check_ratio(n % 100, k));
        for_each_number!(check_ratio(n % 100, -k));
        for_each_number!(check_ratio(n, 1 << (k + 22)));
    }

    #[test]
    fn checked_operations_are_exact_or_rounded_once(a in any_i64(), b in any_i64()) {
        let (x, y) = (Real::from_raw(a), Real::from_raw(b));
        let (a, b) = (big(a), big(b));
        prop_assert_eq!(x.checked_add(y), Real::expect(&(&a + &b)));
        prop_assert_eq!(x.checked_sub(y), Real::expect(&(&a - &b)));
        prop_assert_eq!(x.checked_mul(y), Real::expect(&nearest(&(&a * &b), &(big(1) << 24))));
        let quotient = match y.raw().signum() {
            0 => None,
            sign => Real::expect(&nearest(&((&a << 24) * sign), &(&b * sign))),
        };
        prop_assert_eq!(x.checked_div(y), quotient);
        prop_assert_eq!(x.checked_neg(), Real::expect(&-&a));
        prop_assert_eq!(x.checked_abs(), Real::expect(&if a < big(0) { -&a } else { a.clone() }));
        prop_assert_eq!(x.is_negative(), a < big(0));
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
    }

    #[test]
    fn vector_products_are_rounded_once(a in any_raw3(), b in any_raw3()) {
        let (v, w) = (Vec3::from_raw(a), Vec3::from_raw(b));
        let (a, b) = (a.map(big), b.map(big));
        let product = |p: BigInt| Real::expect(&nearest(&p, &(big(1) << 24)));
        prop_assert_eq!(v.dot(w), product(&a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]));
        let minor = |i: usize, j: usize| product(&a[i] * &b[j] - &a[j] * &b[i]);
        let cross = match [minor(1, 2), minor(2, 0), minor(0, 1)] {
            [Some(x), Some(y), Some(z)] => Some(Vec3::new(x, y, z)),
            _ => None,
        };
        prop_assert_eq!(v.cross(w), cross);
        let square: BigInt = a.iter().map(|c| c * c).sum();
        prop_assert_eq!(big(v.length_sq_wide()), square);
        prop_assert_eq!(v.checked_add(w).map(|s| s.checked_sub(w)), v.checked_add(w).map(|_| Some(v)));
    }

    #[test]
    fn lengths_are_nearest(a in any_raw3(), b in any_raw3()) {
        let (v, w) = (Vec3::from_raw(a.map(|c| c >> 2)), Vec3::from_raw(b.map(|c| c >> 2)));
        prop_assert_eq!(v.length().raw() as u128, root_nearest_wide(v.length_sq_wide()));
        prop_assert_eq!(v.distance(w), (w - v).length());
        prop_assert_eq!((v + w) - w, v);
        prop_assert_eq!(-(-v), v);
    }

    #[test]
    fn directions_are_within_1_7_units(a in any_raw3(), b in prop::array::uniform3(any_i128()), shift in 0..60_u32) {
        // Unrelated components, and three of one size.
        let alike = a.map(|c| (c | 1).wrapping_mul(0x9E37_79B9_7F4A_7C15_u64 as i64) >> shift);
        for raw in [a, alike] {
            let direction = UnitVec3::normalize(Vec3::from_raw(raw));
            prop_assert_eq!(direction, UnitVec3::normalize_wide(raw.map(i128::from)));
            check_direction(direction, &raw.map(big));
        }
        check_direction(UnitVec3::normalize_wide(b), &b.map(big));
    }

    #[test]
    fn directions_are_odd_and_know_no_axis(a in any_raw3()) {
        let a = a.map(|c| c.max(-i64::MAX));
        let Some(n) = UnitVec3::normalize(Vec3::from_raw(a)) else { return Ok(()) };
        prop_assert_eq!(UnitVec3::normalize(-Vec3::from_raw(a)), Some(-n));
        for [i, j, k] in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let turned = UnitVec3::normalize(Vec3::from_raw([a[i], a[j], a[k]]));
            prop_assert_eq!(turned.map(UnitVec3::raw), Some([n.raw()[i], n.raw()[j], n.raw()[k]]));
        }
    }

    #[test]
    fn random_numbers_stay_in_their_range(seed in any::<[u64; 2]>(), a in any_i64(), b in any_i64(), n in 1..=u32::MAX) {
        let mut pcg = Pcg::new(seed[0], seed[1]);
        prop_assert!(pcg.below(n) < n);
        prop_assert_eq!(pcg.below(1), 0);
        if a != b {
            let (lo, hi) = (Real::from_raw(a.min(b)), Real::from_raw(a.max(b)));
            let drawn = pcg.real(lo, hi);
            prop_assert!(lo <= drawn && drawn < hi);
        }
        let mut twin = Pcg::from_state(pcg.state());
        prop_assert_eq!(twin.next_u64(), pcg.next_u64());
        prop_assert_eq!(twin, pcg);
    }
}

/// |n_i |v| - 2^30 v_i| <= 1.7 |v|, with |v| to 40 more bits.
fn check_direction(direction: Option<UnitVec3>, v: &[BigInt; 3]) {
    let Some(direction) = direction else {
        assert_eq!(*v, [0, 0, 0].map(big));
        return;
    };
    let length = (v.iter().map(|c| c * c).sum::<BigInt>() << 80_u32).sqrt();
    for (n, c) in direction.raw().into_iter().zip(v) {
        let error: BigInt = big(n) * &length - (c << 70_u32);
        assert!(error.pow(2) * 100 <= (&length * 17).pow(2), "{direction:?} of {v:?}");
    }
    assert!(direction.is_unit(), "{direction:?}");
}

#[test]
fn decimals_at_the_ends_of_the_range() {
    for (text, raw) in [("549755813887.99999994", i64::MAX), ("-549755813888", i64::MIN)] {
        assert_eq!(Real::parse(text), Ok(Real::from_raw(raw)));
        for_each_number!(check_display(raw));
    }
    // The tie above MAX and below MIN belongs to neither.
    for (max, bits) in [(i64::MAX, 24), (i32::MAX.into(), 30), (i32::MAX.into(), 16)] {
        for nudge in [-1, 0, 1] {
            for_each_number!(check_decimal(&near_tie(max, bits, 3, nudge)));
            for_each_number!(check_decimal(&near_tie(-max - 2, bits, 3, nudge)));
        }
    }
    for whole in ["18446744073709551616", "340282366920938463463374607431768211456", &"9".repeat(300)] {
        assert_eq!(Real::parse(whole), Err(DecimalError::OutOfRange));
    }
    assert_eq!(Unit::parse("2"), Err(DecimalError::OutOfRange));
    assert_eq!(Unit::parse("-2"), Ok(Unit::from_raw(i32::MIN)));
}

#[test]
fn what_is_no_decimal_is_refused_where_it_stops_being_one() {
    let at = |offset, byte| DecimalError::UnexpectedByte { offset, byte };
    for (text, error) in [
        ("", DecimalError::Empty),
        ("-", DecimalError::Empty),
        ("+", DecimalError::Empty),
        (".", at(0, b'.')),
        (".5", at(0, b'.')),
        ("5.", at(1, b'.')),
        ("-.5", at(1, b'.')),
        ("1.2.3", at(3, b'.')),
        ("_1", at(0, b'_')),
        ("1_", at(1, b'_')),
        ("1__0", at(1, b'_')),
        ("1_.5", at(1, b'_')),
        ("1._5", at(1, b'.')),
        ("--1", at(1, b'-')),
        ("1-", at(1, b'-')),
        (" 1", at(0, b' ')),
        ("1 ", at(1, b' ')),
        ("1e3", at(1, b'e')),
        ("0x1", at(1, b'x')),
        ("NaN", at(0, b'N')),
        ("\u{b2}", at(0, 0xC2)),
    ] {
        assert_eq!(Real::parse(text), Err(error), "{text:?}");
        assert_eq!(Unit::parse(text), Err(error), "{text:?}");
    }
    assert_eq!(at(1, b'e').to_string(), "unexpected byte 'e' at offset 1");
}

#[test]
fn decimals_print_as_people_write_them() {
    for (text, printed) in [
        ("9.81", "9.81"),
        ("-9.810", "-9.81"),
        ("-0", "0"),
        ("+1_000.250_0", "1000.25"),
        ("0.00000006", "0.00000006"),
        ("0.1", "0.1"),
        ("-0.000001", "-0.000001"),
        ("100", "100"),
    ] {
        assert_eq!(Real::parse(text).unwrap().to_string(), printed);
    }
    assert_eq!(format!("[{:>8}] [{:+}] [{:06}]", real!("1.5"), real!("2"), real!("-0.25")), "[     1.5] [+2] [-00.25]");
}

#[test]
fn floats_of_every_kind() {
    let halves = [f64::MIN_POSITIVE, f64::from_bits(1), -f64::from_bits(1), 0.0, -0.0, f64::MAX, f64::MIN];
    for v in halves.into_iter().chain([f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY]) {
        for_each_number!(check_float(v, v as f32));
    }
    for v in [f32::MIN_POSITIVE, f32::from_bits(1), f32::from_bits(0x007F_FFFF), f32::MAX] {
        for_each_number!(check_float(v.into(), v));
        for_each_number!(check_float((-v).into(), -v));
    }
    for exponent in -35..=70 {
        for v in [1.0, 1.5, 1.999_999_999_999_999_8, -1.0, -1.5] {
            let v = v * 2_f64.powi(exponent);
            for_each_number!(check_float(v, v as f32));
        }
    }
    for raw in [i64::MIN, i64::MIN + 1, i64::MAX, -1, 0, 1] {
        for_each_number!(check_to_float(raw));
    }
}

#[test]
fn operators_panic_in_every_profile() {
    let panics = |f: fn() -> Real| assert!(catch_unwind(f).is_err());
    panics(|| Real::MAX + Real::ULP);
    panics(|| Real::MIN - Real::ULP);
    panics(|| Real::MAX * Real::from_int(2));
    panics(|| Real::ONE / Real::ZERO);
    panics(|| Real::MAX / Real::ULP);
    panics(|| -Real::MIN);
    panics(|| Real::MIN.abs());
    panics(|| (-Vec3::new(Real::ZERO, Real::MIN, Real::ZERO)).y);
    panics(|| (Vec3::ONE * Real::MAX * Real::MAX).x);
    panics(|| Vec3::from_raw([i64::MAX; 3]).length());
    panics(|| Pcg::new(0, 0).real(Real::ONE, Real::ONE));
    assert!(catch_unwind(|| Pcg::new(0, 0).below(0)).is_err());
    assert_eq!(Real::MAX.checked_add(Real::ULP), None);
    assert_eq!(Real::from_int(-3) / Real::from_int(2) * Real::from_int(2), Real::from_int(-3));
    assert_eq!(real!("-2.5").abs().min(Real::ONE).clamp(Real::ZERO, Real::MAX), Real::ONE);
    assert_eq!((real!("-2.5").signum(), Real::ZERO.signum()), (Real::from_int(-1), Real::ZERO));
}

#[test]
fn constants_are_what_they_say() {
    const SHARE: Unit = match Unit::parse("0.3") {
        Ok(share) => share,
        Err(_) => Unit::ZERO,
    };
    assert_eq!(SHARE.raw(), 322_122_547);
    assert_eq!((Real::ONE.raw(), Real::ULP.raw(), Real::FRACTION_BITS), (1 << 24, 1, 24));
    assert_eq!((Unit::ONE.raw(), Weight::ONE.raw(), Factor::ONE.raw()), (1 << 30, 1 << 27, 1 << 16));
    assert_eq!(Vec3::X.cross(Vec3::Y), Some(Vec3::Z));
    assert_eq!(UnitVec3::normalize(Vec3::from_ints(0, -7, 0)), Some(-UnitVec3::Y));
    assert!(UnitVec3::X.is_unit() && UnitVec3::Z.is_unit());
    assert!(!UnitVec3::from_raw([0; 3]).is_unit() && !UnitVec3::from_raw([i32::MIN; 3]).is_unit());
}

/// The output of `pcg32-demo` as published with the reference implementation.
#[test]
fn pcg_is_the_reference() {
    let mut pcg = Pcg::new(42, 54);
    let words = [0; 6].map(|_: u32| pcg.next_u32());
    assert_eq!(words, [0xa15c_02b7, 0x7b47_f409, 0xba1d_3330, 0x83d2_f293, 0xbfa4_784b, 0xcbed_606e]);
    let coins: String = (0..65).map(|_| if pcg.below(2) == 1 { 'H' } else { 'T' }).collect();
    assert_eq!(coins, "HHTTTHTHHHTHTTTHHHHHTTTHHHTHTHTHTTHTTTHHHHHHTTTTHHTTTTTHTTTTTTTHT");
    let rolls: String = (0..33).map(|_| (pcg.below(6) + 1).to_string()).collect();
    assert_eq!(rolls, "341122324324335231315141564662633");
}

#[test]
fn mint_carries_floats_both_ways() {
    let v = Vec3::new(real!("0.5"), real!("-2"), real!("0.1"));
    let point: mint::Point3<f64> = v.into();
    assert_eq!(Vec3::try_from(point), Ok(v));
    assert_eq!(<[f32; 3]>::from(mint::Vector3::<f32>::from(v)), v.to_f32());
    let broken = mint::Vector3 { x: 0.0, y: f32::NAN, z: 0.0 };
    assert_eq!(Vec3::try_from(broken), Err(RealError::NotANumber));
}

#[test]
fn text_formats_carry_decimals_and_binary_ones_raw_integers() {
    let v = Vec3::new(real!("9.81"), Real::ZERO, real!("-0.5"));
    let n = UnitVec3::normalize(v).unwrap();
    assert_eq!(ron::to_string(&v).unwrap(), r#"("9.81","0","-0.5")"#);
    assert_eq!(ron::from_str(r#"("9.81","0","-0.5")"#), Ok(v));
    assert_eq!(ron::from_str(&ron::to_string(&n).unwrap()), Ok(n));
    assert!(ron::from_str::<Real>("9.81").is_err(), "a number would have been an f64");
    assert!(ron::from_str::<Real>("\"9.8x\"").unwrap_err().to_string().contains("offset 3"));
    assert!(ron::from_str::<UnitVec3>(r#"("1","1","0")"#).is_err());

    let config = bincode::config::standard().with_fixed_int_encoding();
    let bytes = bincode::serde::encode_to_vec((v, n), config).unwrap();
    let words = v.raw().map(i64::to_le_bytes).concat();
    let halves = n.raw().map(|c| (c as i32).to_le_bytes()).concat();
    assert_eq!(bytes, [words, halves].concat());
    let (back, read) = bincode::serde::decode_from_slice(&bytes, config).unwrap();
    assert_eq!((back, read), ((v, n), 36));
}
