//! What meets what, against oracles in integers of any size.

mod golden;
mod intersection;
mod overlap;
mod predicates;

use verlock::Vec3;
use verlock::geometry::Triangle;
use verlock::math::Pcg;

/// Corners, raw.
type Corners = [[i64; 3]; 3];

fn triangle(corners: Corners) -> Triangle {
    Triangle::new(corners.map(Vec3::from_raw)).expect("in range")
}

/// The orders of three corners.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]];

/// A number from 0 to `most`.
fn below(rng: &mut Pcg, most: i64) -> i64 {
    (rng.next_u64() % (most.unsigned_abs() + 1)).cast_signed()
}
