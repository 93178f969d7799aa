//! Smooth random numbers that are functions of a place.

/// A number of 30 fractional bits between -1 and 1 for every place in space, in cells of 2^16.
pub fn noise(place: [i64; 3]) -> i64 {
    let cell = place.map(|c| c >> 16);
    let part = place.map(|c| smooth(c & 0xffff));
    let mut sum = 0;
    for corner in 0..8 {
        let ends = [0, 1, 2].map(|k| corner >> k & 1);
        let weights = [0, 1, 2].map(|k| if ends[k] == 1 { part[k] } else { (1 << 16) - part[k] });
        let weight = (((weights[0] * weights[1]) >> 16) * weights[2]) >> 16;
        sum += weight * (random([0, 1, 2].map(|k| cell[k] + ends[k])) >> 16);
    }
    sum
}

/// 0 to 2^16, level at both ends.
fn smooth(t: i64) -> i64 {
    (((t * t) >> 16) * (3 * (1 << 16) - 2 * t)) >> 16
}

/// A number of 30 fractional bits between -1 and 1 for every cell.
fn random(cell: [i64; 3]) -> i64 {
    let mut hash = 0x9e37_79b9_7f4a_7c15_u64;
    for c in cell {
        hash = (hash ^ c.cast_unsigned()).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        hash ^= hash >> 29;
    }
    (hash >> 33).cast_signed() - (1 << 30)
}
