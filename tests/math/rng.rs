//! The generator against its published output.

#[cfg(panic = "unwind")]
use std::panic::catch_unwind;

use proptest::prelude::*;
use verlock::math::{Pcg, Real};

use super::{any_i64, cases};

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn random_numbers_stay_in_their_range(
        seed in any::<[u64; 2]>(), a in any_i64(), b in any_i64(), n in 1..=u32::MAX,
    ) {
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

/// The output of `pcg32-demo` as published with the reference implementation.
#[test]
fn pcg_is_the_reference() {
    let mut pcg = Pcg::new(42, 54);
    let words = [0; 6].map(|_: u32| pcg.next_u32());
    assert_eq!(
        words,
        [0xa15c_02b7, 0x7b47_f409, 0xba1d_3330, 0x83d2_f293, 0xbfa4_784b, 0xcbed_606e]
    );
    let coins: String = (0..65).map(|_| if pcg.below(2) == 1 { 'H' } else { 'T' }).collect();
    assert_eq!(coins, "HHTTTHTHHHTHTTTHHHHHTTTHHHTHTHTHTTHTTTHHHHHHTTTTHHTTTTTHTTTTTTTHT");
    let rolls: String = (0..33).map(|_| (pcg.below(6) + 1).to_string()).collect();
    assert_eq!(rolls, "341122324324335231315141564662633");
}

#[cfg(panic = "unwind")]
#[test]
fn empty_ranges_panic() {
    assert!(catch_unwind(|| Pcg::new(0, 0).real(Real::ONE, Real::ONE)).is_err());
    assert!(catch_unwind(|| Pcg::new(0, 0).below(0)).is_err());
}

/// A range of 3/4 of the words: without rejection its lowest third would come up half the time.
#[test]
fn draws_have_no_bias() {
    let mut pcg = Pcg::new(1, 2);
    let (lo, hi) = (Real::from_raw(-3 << 61), Real::from_raw(3 << 61));
    let low = (0..6000).filter(|_| pcg.below(3 << 30) < 1 << 30).count();
    let low_real = (0..6000).filter(|_| pcg.real(lo, hi).raw() < -1 << 61).count();
    // 2000 expected, with a standard deviation of 37.
    assert!((1850..2150).contains(&low) && (1850..2150).contains(&low_real), "{low} {low_real}");
}
