//! Arithmetic of scalars, vectors and directions, and their formats.

#[cfg(panic = "unwind")]
use std::panic::catch_unwind;

use num_bigint::BigInt;
use proptest::prelude::*;
use verlock::math::root::root_nearest_wide;
use verlock::math::{Factor, Real, RealError, Unit, UnitVec3, Vec3, Weight};
use verlock::real;

use super::number::Number;
use super::{any_i64, any_i128, any_raw3, big, cases, nearest, square};

/// Against the definition in big integers, and `|n_i |v| - 2^30 v_i| <= 1.7 |v|` with |v| to 40
/// more bits.
fn check_direction(direction: Option<UnitVec3>, v: &[BigInt; 3]) {
    let Some(direction) = direction else {
        assert_eq!(*v, [0, 0, 0].map(big));
        return;
    };
    let length = (v.iter().map(|c| c * c).sum::<BigInt>() << 80_u32).sqrt();
    for (n, c) in direction.raw().into_iter().zip(v) {
        let error: BigInt = big(n) * &length - (c << 70_u32);
        assert!(square(&error) * 100 <= square(&(&length * 17)), "{direction:?} of {v:?}");
    }
    assert!(direction.is_unit(), "{direction:?}");
    assert_eq!(direction.raw().map(big), defined_direction(v), "of {v:?}");
}

/// Scale the longest component to 31 bits, take the nearest root, divide.
fn defined_direction(v: &[BigInt; 3]) -> [BigInt; 3] {
    let bits = v.iter().map(BigInt::bits).max().unwrap_or(0);
    let scaled = |c: &BigInt| nearest(&(c << 31_u32), &(big(1) << bits));
    let y = v.each_ref().map(scaled);
    let square: BigInt = y.iter().map(|c| c * c).sum();
    // The nearest root is half the floor root of 4 N, rounded up.
    let length = ((square * 4_u32).sqrt() + 1_u32) / 2_u32;
    y.map(|c| nearest(&(c << 30_u32), &length))
}

proptest! {
    #![proptest_config(cases(3000))]

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
        if let Some(sum) = v.checked_add(w) {
            prop_assert_eq!(sum.checked_sub(w), Some(v));
        }
    }

    #[test]
    fn lengths_are_nearest(a in any_raw3(), b in any_raw3()) {
        let (v, w) = (Vec3::from_raw(a.map(|c| c >> 2)), Vec3::from_raw(b.map(|c| c >> 2)));
        prop_assert_eq!(big(v.length().raw()), big(root_nearest_wide(v.length_sq_wide())));
        prop_assert_eq!(v.distance(w), (w - v).length());
        prop_assert_eq!((v + w) - w, v);
        prop_assert_eq!(-(-v), v);
    }

    #[test]
    fn directions_are_within_1_7_units(
        a in any_raw3(), b in prop::array::uniform3(any_i128()), shift in 0..60_u32,
    ) {
        // Unrelated components, and three of one size.
        let alike = a.map(|c| (c | 1).wrapping_mul(0x1E37_79B9_7F4A_7C15) >> shift);
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
}

#[cfg(panic = "unwind")]
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
    assert_eq!(Real::MAX.checked_add(Real::ULP), None);
    for end in [Real::MIN, Real::MAX] {
        assert_eq!(end.checked_mul(Real::ONE), Some(end));
        assert_eq!(Vec3::new(Real::ONE, end, end).dot(Vec3::Y), Some(end));
    }
    // Rounds up to 2^63, which does not fit; down to -2^63, which does.
    assert_eq!(Real::from_product((1 << 87) - (1 << 23)), None);
    assert_eq!(Real::from_product(-(1 << 87) + (1 << 23)), Some(Real::MIN));
    assert_eq!(Real::from_product(-(1 << 87) - (1 << 23)), None);
    assert_eq!(Real::from_product(i128::MAX), None);
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
    assert_eq!(
        (Unit::ONE.raw(), Weight::ONE.raw(), Factor::ONE.raw()),
        (1 << 30, 1 << 27, 1 << 16)
    );
    assert_eq!(Vec3::X.cross(Vec3::Y), Some(Vec3::Z));
    assert_eq!(UnitVec3::normalize(Vec3::from_ints(0, -7, 0)), Some(-UnitVec3::Y));
    assert!(UnitVec3::X.is_unit() && UnitVec3::Z.is_unit());
    assert!(!UnitVec3::from_raw([0; 3]).is_unit() && !UnitVec3::from_raw([i32::MIN; 3]).is_unit());
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
    let long: UnitVec3 = ron::from_str(r#"("1","1","0")"#).unwrap();
    assert!(!long.is_unit(), "read as it is: whoever takes it from outside checks it");

    let config = bincode::config::standard().with_fixed_int_encoding();
    let bytes = bincode::serde::encode_to_vec((v, n), config).unwrap();
    let words = v.raw().map(i64::to_le_bytes).concat();
    let halves = n.raw().map(|c| (c as i32).to_le_bytes()).concat();
    assert_eq!(bytes, [words, halves].concat());
    let (back, read) = bincode::serde::decode_from_slice(&bytes, config).unwrap();
    assert_eq!((back, read), ((v, n), 36));
}
