//! Nearest points, against oracles in rational numbers.

pub mod oracle;
mod points;

use verlock::Vec3;
use verlock::math::Pcg;

/// A number from 0 to `most`.
fn below(rng: &mut Pcg, most: i64) -> i64 {
    (rng.next_u64() % (most.unsigned_abs() + 1)).cast_signed()
}

/// Where the points of a case are: on a grid from 0 to `most`, times `unit`.
#[derive(Clone, Copy, Debug)]
pub struct Class {
    most: i64,
    unit: i64,
}

/// Small grids, where everything degenerate happens, then the limits of both widths.
pub const CLASSES: [Class; 8] = [
    Class { most: 1, unit: 1 },
    Class { most: 2, unit: 1 },
    Class { most: 4, unit: 1 },
    Class { most: 60, unit: 1 },
    Class { most: 2, unit: 1 << 29 },
    Class { most: 1 << 30, unit: 1 },
    Class { most: 3, unit: ((1 << 41) - 1) / 3 },
    Class { most: (1 << 41) - 1, unit: 1 },
];

impl Class {
    /// Points, of which some coincide, lie on a line or in a plane.
    pub fn points<const N: usize>(self, rng: &mut Pcg) -> [Vec3; N] {
        let mut points = [(); N].map(|()| [(); 3].map(|()| below(rng, self.most) * self.unit));
        let last = N - 1;
        match rng.below(12) {
            0 => points[last] = points[0],
            1 => points[last] = [0, 1, 2].map(|k| i64::midpoint(points[0][k], points[1][k])),
            2 => points.iter_mut().for_each(|[x, y, _]| (*x, *y) = (0, 0)),
            3 => points.iter_mut().for_each(|[x, _, _]| *x = 0),
            // The last two along the first two: parallel segments.
            4 if N == 4 => {
                points[3] = [0, 1, 2].map(|k| points[2][k] + (points[1][k] - points[0][k]) / 2)
            }
            _ => {}
        }
        points.map(Vec3::from_raw)
    }
}
