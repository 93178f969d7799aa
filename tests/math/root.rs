//! Roots in their defining inequalities.

use proptest::prelude::*;
use verlock::math::root::{isqrt, isqrt_wide, root_nearest, root_nearest_wide};

use super::{any_i64, any_i128, big, cases, square};

/// Against big integers: the floor root in its defining inequality, the nearest one likewise.
fn check_roots(v: u128) {
    let (floor, near) = (big(isqrt_wide(v)), big(root_nearest_wide(v)));
    assert!(
        square(&floor) <= big(v) && big(v) < square(&(&floor + 1)),
        "isqrt_wide({v}) = {floor}"
    );
    // near - 1/2 < root < near + 1/2, times 2, squared.
    assert!(square(&(&near * 2 + 1)) > big(v) * 4, "root_nearest_wide({v}) = {near}");
    assert!(v == 0 || square(&(&near * 2 - 1)) < big(v) * 4, "root_nearest_wide({v}) = {near}");
    if let Ok(v) = u64::try_from(v) {
        assert_eq!(u128::from(isqrt(v)), isqrt_wide(v.into()));
        assert_eq!(u128::from(root_nearest(v)), root_nearest_wide(v.into()));
    }
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn roots_floor_and_go_to_the_nearest(v in any_i64(), w in any_i128()) {
        check_roots(v.cast_unsigned().into());
        check_roots(w.cast_unsigned());
    }

    #[test]
    fn roots_of_squares_and_their_neighbours(k in any_i64(), j in any::<u32>()) {
        for k in [u128::from(k.cast_unsigned()), j.into()] {
            check_roots(k * k);
            check_roots(k * k + k);
            check_roots(k * k + k + 1);
            check_roots(k * k + 2 * k);
        }
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
