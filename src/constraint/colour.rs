//! Which constraints may be relaxed at the same time.

use alloc::vec;
use alloc::vec::Vec;

/// The last colour: constraints that found no free one. They are relaxed one after the other.
pub(crate) const OVERFLOW: u8 = 63;

/// Greedy colouring: each constraint, in order, takes the lowest colour that no earlier constraint
/// on one of its *movable* ends has.
///
/// A pure function of the list and of who can move; threads play no part. O(constraints).
pub(crate) fn colour(ends: &[[Option<u32>; 2]], particles: usize) -> Vec<u8> {
    let mut taken = vec![0_u64; particles];
    let one = |ends: &[Option<u32>; 2]| {
        let movable = || ends.iter().flatten().map(|&end| end as usize);
        let used = movable().fold(0, |used, end| used | taken[end]);
        let free = used.trailing_ones().min(u32::from(OVERFLOW));
        for end in movable() {
            taken[end] |= 1 << free;
        }
        // At most 63, the lowest byte.
        free.to_le_bytes()[0]
    };
    ends.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_differ_and_pinned_ends_do_not_count() {
        let star = |end: fn(u32) -> Option<u32>| {
            let ends: Vec<_> = (1..80).map(|spoke| [end(0), end(spoke)]).collect();
            colour(&ends, 80)
        };
        let movable = star(Some);
        assert!((0..80).zip(&movable).all(|(k, &c)| c == k.min(OVERFLOW)));
        let pinned_hub = star(|index| (index > 0).then_some(index));
        assert!(pinned_hub.iter().all(|&c| c == 0));
    }
}
