//! Decimals, floats and ratios, for every number type.

use std::fmt::{Debug, Display};
use std::str::FromStr;

use num_bigint::BigInt;
use proptest::prelude::*;
use verlock::math::{DecimalError, Factor, Real, RealError, Unit, Weight};
use verlock::real;

use super::{any_i64, big, cases, nearest};

/// What the tests need to know about a number type.
pub(super) trait Number:
    Copy + Eq + Debug + Display + FromStr<Err = DecimalError> + serde::Serialize
{
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

/// Calls a generic check for every number type.
macro_rules! for_each_number {
    ($check:ident($($argument:expr),*)) => {
        $check::<Real>($($argument),*);
        $check::<Unit>($($argument),*);
        $check::<Weight>($($argument),*);
        $check::<Factor>($($argument),*);
    };
}

/// The exact value of `[+-]digits[.[digits]]` as a fraction, by big integers.
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

/// An exponent moves the point: the oracle multiplies by the power of ten.
fn check_scientific(digits: &str, exponent: i32) {
    let (n, d) = rational(digits);
    let power = big(10).pow(exponent.unsigned_abs());
    let (n, d) = if exponent < 0 { (n, d * power) } else { (n * power, d) };
    let expected = Real::expect(&nearest(&(n << Real::BITS), &d)).ok_or(DecimalError::OutOfRange);
    for text in [format!("{digits}e{exponent}"), format!("{digits}E{exponent:+04}")] {
        assert_eq!(Real::parse_scientific(&text), expected, "{text}");
    }
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
    if double.is_finite() {
        assert_eq!(got, expected(format!("{double:.1074}")), "{double:e}");
    } else {
        assert_eq!(got, Err(refused(double.is_nan())));
    }
    if single.is_finite() {
        assert_eq!(got32, expected(format!("{single:.149}")), "{single:e}");
    } else {
        assert_eq!(got32, Err(refused(single.is_nan())));
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

/// A decimal whose digits hug the middle between two values: the tie, cut or pushed anywhere.
fn near_tie(raw: impl Into<BigInt>, bits: u32, zeros: usize, nudge: i64) -> String {
    // (2 raw + 1) / 2^(bits + 1) has bits + 1 places exactly.
    let places = bits as usize + 1;
    let digits = (raw.into() * 2 + 1) * big(5).pow(bits + 1);
    let digits: BigInt = digits * big(10).pow(zeros as u32) + nudge;
    let (sign, digits) = if digits < big(0) { ("-", -digits) } else { ("", digits) };
    let digits = format!("{digits:0>width$}", width = places + zeros + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places - zeros);
    format!("{sign}{whole}.{fraction}")
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn decimals_are_read_to_nearest(
        text in "[+-]?[0-9]{1,14}(_[0-9]{1,3})?(\\.[0-9]{1,30}(_[0-9]{1,4})?)?",
    ) {
        for_each_number!(check_decimal(&text));
        // Small enough for the fractions too.
        for_each_number!(check_decimal(&format!("0.{}", text.replace(['+', '-', '.', '_'], ""))));
    }

    #[test]
    fn decimals_of_any_length_are_read_to_nearest(
        text in "[+-]?[0-9]{1,3}\\.[0-9]{100,200}", zeros in 0..200_usize,
    ) {
        for_each_number!(check_decimal(&text));
        let (sign, digits) = text.split_at(usize::from(text.starts_with(['+', '-'])));
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
    fn exponents_move_the_point(
        digits in "[+-]?[0-9]{1,14}(\\.[0-9]{0,40})?", exponent in -60..30_i32,
        raw in any_i64(), zeros in 0..40_usize, nudge in -1..=1_i64, moved in -20..20_i32,
    ) {
        check_scientific(&digits, exponent);
        // Around a tie, written with the point elsewhere.
        let tie = near_tie(raw, Real::BITS, zeros, nudge);
        let (sign, tie) = tie.split_at(usize::from(tie.starts_with('-')));
        let point = tie.find('.').unwrap().strict_add_signed(20 + moved as isize);
        let digits = format!("{}{}{}", "0".repeat(20), tie.replace('.', ""), "0".repeat(20));
        let (whole, fraction) = digits.split_at(point);
        check_scientific(&format!("{sign}{whole}.{fraction}"), -moved);
        prop_assert_eq!(Real::parse_scientific(&format!("{sign}{tie}")),
            Real::parse(&format!("{sign}{tie}")));
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
    fn floats_are_written_to_nearest_even(
        raw in any_i64(), bits in 25..63_u32, nudge in -1..=1_i64,
    ) {
        for_each_number!(check_to_float(raw));
        // A tie of either format, at this size, and its neighbours.
        for significand in [24, 53] {
            let lost = bits.saturating_sub(significand) + 1;
            let tie = ((raw.unsigned_abs() >> 1) >> (63 - bits) >> lost << lost) | 1 << (lost - 1);
            for_each_number!(check_to_float(tie.cast_signed().saturating_add(nudge)));
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
}

#[test]
fn decimals_at_the_ends_of_the_range() {
    for (text, raw) in [("549755813887.99999994", i64::MAX), ("-549755813888", i64::MIN)] {
        assert_eq!(Real::parse(text), Ok(Real::from_raw(raw)));
        for_each_number!(check_display(raw));
    }
    // The tie above MAX and below MIN belongs to neither.
    for (max, bits) in [(i128::from(i64::MAX), 24), (i32::MAX.into(), 30), (i32::MAX.into(), 16)] {
        for nudge in [-1, 0, 1] {
            for_each_number!(check_decimal(&near_tie(max, bits, 3, nudge)));
            for_each_number!(check_decimal(&near_tie(-max - 2, bits, 3, nudge)));
        }
    }
    for whole in
        ["18446744073709551616", "340282366920938463463374607431768211456", &"9".repeat(300)]
    {
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
fn decimals_of_other_programs_are_read_as_they_print_them() {
    let long = format!("0.{}1e1001", "0".repeat(999));
    for (text, plain) in [
        (".5", "0.5"),
        ("-5.", "-5"),
        ("+.25E1", "2.5"),
        ("0.000000e+00", "0"),
        ("-1e-05", "-0.00001"),
        ("1e-400", "0"),
        ("0e99999999999999999999", "0"),
        ("1e-99999999999999999999", "0"),
        ("5497558138.8799999994E2", "549755813887.99999994"),
        (&long, "10"),
    ] {
        assert_eq!(Real::parse_scientific(text), Real::parse(plain), "{text}");
    }
    let at = |offset, byte| DecimalError::UnexpectedByte { offset, byte };
    for (text, error) in [
        ("", DecimalError::Empty),
        ("-", DecimalError::Empty),
        ("+.", DecimalError::Empty),
        (".e5", at(1, b'e')),
        ("1e", at(1, b'e')),
        ("1.e+", at(2, b'e')),
        ("1e5.", at(3, b'.')),
        ("1e5e5", at(3, b'e')),
        ("1_0", at(1, b'_')),
        ("1,5", at(1, b',')),
        ("--1", at(1, b'-')),
        ("1 ", at(1, b' ')),
        ("0x10", at(1, b'x')),
        ("nan", at(0, b'n')),
        ("-inf", at(1, b'i')),
        ("1e12", DecimalError::OutOfRange),
        ("-1e99999999999999999999", DecimalError::OutOfRange),
    ] {
        assert_eq!(Real::parse_scientific(text), Err(error), "{text:?}");
    }
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
    assert_eq!(
        format!("[{:>8}] [{:+}] [{:06}]", real!("1.5"), real!("2"), real!("-0.25")),
        "[     1.5] [+2] [-00.25]"
    );
}

#[test]
fn floats_of_every_kind() {
    let halves =
        [f64::MIN_POSITIVE, f64::from_bits(1), -f64::from_bits(1), 0.0, -0.0, f64::MAX, f64::MIN];
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
