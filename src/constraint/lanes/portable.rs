//! Batches on any processor, one lane after the other.

use super::{Batch, Place, UnevenBatch};
use crate::constraint::curve::{self, SHARE_BITS, Scale};

pub(in super::super) fn relax_even(shift: u32, batches: &[Batch], places: &mut [Place]) {
    for batch in batches {
        for k in 0..4 {
            let gain = batch.gain[k];
            relax(shift, batch, k, [gain; 2], |share| share, places);
        }
    }
}

pub(in super::super) fn relax_uneven(shift: u32, batches: &[UnevenBatch], places: &mut [Place]) {
    for UnevenBatch { even, gain_b, push } in batches {
        for k in 0..4 {
            let gains = [even.gain[k], gain_b[k]];
            let allowed = |share: i32| if push[k] == 0 { share.max(0) } else { share };
            relax(shift, even, k, gains, allowed, places);
        }
    }
}

/// One lane; the links of a batch share no movable particle, so their order does not matter.
#[inline]
fn relax(
    shift: u32,
    batch: &Batch,
    k: usize,
    gains: [u32; 2],
    allowed: impl Fn(i32) -> i32,
    places: &mut [Place],
) {
    let [a, b] = [batch.a[k], batch.b[k]].map(|end| end as usize);
    // Differences are within 2^30, see `local.rs`.
    let d = [0, 1, 2].map(|c| places[b][c] - places[a][c]);
    let square = |c: i32| u64::from(c.unsigned_abs()).pow(2);
    let length_sq = square(d[0]) + square(d[1]) + square(d[2]);
    let scale = Scale { shift, inverse: batch.inverse[k] };
    let share = allowed(curve::share(scale.ratio(length_sq)));
    let part = share.unsigned_abs() << (32 - SHARE_BITS);
    for (end, gain, pulled) in [(a, gains[0], share > 0), (b, gains[1], share < 0)] {
        let g = u64::from(curve::high(part, gain));
        for c in 0..3 {
            let size = (u64::from(d[c].unsigned_abs()) * g + (1 << 31)) >> 32;
            // At most |d|.
            let [low @ .., _, _, _, _] = size.to_le_bytes();
            let size = i32::from_le_bytes(low);
            places[end][c] += if (d[c] < 0) == pulled { -size } else { size };
        }
    }
}
