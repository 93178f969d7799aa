//! Sums of squared distances from planes.

use core::ops::AddAssign;

use crate::math::UnitVec3;
use crate::math::wide::{round_div_wide, round_shift, to_i64};

/// Bits of the longest edge of the box around all points, in cells.
pub(super) const SPAN_BITS: u32 = 28;

/// What all weights sum to, but for those that are raised to 1.
pub(super) const WEIGHT_BITS: u32 = 24;

/// Bits of the length of a normal: a plane leans by 2 micrometres a metre at most.
const NORMAL_BITS: u32 = 18;

/// `sum w (n . x - d)^2` over weighted planes, as `x A x - 2 b x + c`: exact, whatever is added.
///
/// | what | at most | why |
/// |---|---|---|
/// | x, a plane's point | 2^28 along an axis | [`SPAN_BITS`], from the corner of their box |
/// | n | 2^18 | rounded from a unit vector |
/// | n . x - d | 2^46.8 | 2^18, and 2^28 sqrt(3) |
/// | sum w | 15 * 2^23 | `3 * 2^24 + 9 * 2^23`, see below |
/// | A | 2^62.92 | |
/// | b | 2^91.8 | |
/// | c, x A x, the sum | 2^120.6 | each a sum of squares; terms on the way are below 2^124 |
///
/// A plane counts at each of its corners, so that where they are all drawn together a face counts
/// three times and a boundary edge twice. All weights together are 2^24, and at most 1 more for
/// each of 2^23 faces and of at most three times as many boundary edges.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Quadric {
    /// xx, yy, zz, yz, zx, xy.
    a: [i64; 6],
    b: [i128; 3],
    c: i128,
}

impl Quadric {
    /// Of one plane through a point.
    pub(super) fn of_plane(normal: UnitVec3, point: [i64; 3], weight: i64) -> Self {
        let [x, y, z] = normal.raw().map(|c| round_shift(c, 30 - NORMAL_BITS));
        let d = i128::from(x * point[0] + y * point[1] + z * point[2]);
        let wide = i128::from(weight);
        Self {
            a: [x * x, y * y, z * z, y * z, z * x, x * y].map(|product| weight * product),
            b: [x, y, z].map(|c| wide * d * i128::from(c)),
            c: wide * d * d,
        }
    }

    /// The sum at a point.
    pub(super) fn at(&self, point: [i64; 3]) -> u128 {
        let (ax, x) = (self.product(point), point.map(i128::from));
        let term = |k: usize| (ax[k] - 2 * self.b[k]) * x[k];
        // A sum of squares: never negative.
        (term(0) + term(1) + term(2) + self.c).cast_unsigned()
    }

    /// The sum of the weights, times 2^36: of `w |n|^2`.
    pub(super) const fn trace(&self) -> i64 {
        // |n|^2 is 2^36 and less than 2^19 more by rounding: at most 2^62.92.
        self.a[0] + self.a[1] + self.a[2]
    }

    /// Where the sum is smallest, held to `middle` by a spring of 2^-16 of all weights, which
    /// decides where planes leave a choice. None if that is farther than `reach` along an axis.
    pub(super) fn lowest(&self, middle: [i64; 3], reach: i64) -> Option<[i64; 3]> {
        const BITS: u32 = 30;
        // One plane's trace has 36 bits and more; without any there is nothing to be near to.
        let shift = (i64::BITS - self.trace().leading_zeros()).checked_sub(BITS)?;
        if shift == 0 {
            return None;
        }
        let [xx, yy, zz, yz, zx, xy] = self.a.map(|c| i128::from(round_shift(c, shift)));
        let [xx, yy, zz] = [xx, yy, zz].map(|c| c + (1 << (BITS - 16)));
        // A is positive, and rounding it leans it by less than the spring: so is the determinant.
        // Elements are at most 2^30, and of a positive matrix those of the adjugate are at most
        // 2^60, the determinant below 2^90.
        let adjugate = [
            [yy * zz - yz * yz, zx * yz - xy * zz, xy * yz - yy * zx],
            [zx * yz - xy * zz, xx * zz - zx * zx, xy * zx - xx * yz],
            [xy * yz - yy * zx, xy * zx - xx * yz, xx * yy - xy * xy],
        ];
        let determinant = xx * adjugate[0][0] + xy * adjugate[0][1] + zx * adjugate[0][2];
        let ax = self.product(middle);
        let force = [0, 1, 2].map(|k| (self.b[k] - ax[k]) >> shift);
        // (A + spring) (x - middle) = force: beyond 2^62 the way is longer than 2^30.
        if force.iter().any(|c| c.unsigned_abs() >> 62 != 0) {
            return None;
        }
        let mut lowest = middle;
        for (c, row) in lowest.iter_mut().zip(adjugate) {
            let way: i128 = row.into_iter().zip(force).map(|(a, f)| a * f).sum(); // below 2^124
            let way = round_div_wide(way, determinant);
            if way.abs() > i128::from(reach) {
                return None;
            }
            *c += to_i64(way);
        }
        Some(lowest)
    }

    /// `A x`: at most 2^91.8.
    fn product(&self, x: [i64; 3]) -> [i128; 3] {
        let [xx, yy, zz, yz, zx, xy] = self.a;
        let row = |row: [i64; 3]| -> i128 {
            row.into_iter().zip(x).map(|(a, x)| i128::from(a) * i128::from(x)).sum()
        };
        [row([xx, xy, zx]), row([xy, yy, yz]), row([zx, yz, zz])]
    }
}

impl AddAssign<&Self> for Quadric {
    fn add_assign(&mut self, other: &Self) {
        self.a.iter_mut().zip(other.a).for_each(|(sum, term)| *sum += term);
        self.b.iter_mut().zip(other.b).for_each(|(sum, term)| *sum += term);
        self.c += other.c;
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;
    use crate::math::{Pcg, Vec3};

    type Plane = (UnitVec3, [i64; 3], i64);

    fn quadric(planes: &[Plane]) -> Quadric {
        let mut sum = Quadric::default();
        for &(normal, point, weight) in planes {
            sum += &Quadric::of_plane(normal, point, weight);
        }
        sum
    }

    /// Plane after plane: each square is at most 2^93.6, and with its weight below 2^120.6.
    fn naive(planes: &[Plane], x: [i64; 3]) -> i128 {
        let square = |&(normal, point, weight): &Plane| {
            let n = normal.raw().map(|c| round_shift(c, 12));
            let off: i64 = (0..3).map(|k| n[k] * (x[k] - point[k])).sum();
            i128::from(off).pow(2) * i128::from(weight)
        };
        planes.iter().map(square).sum()
    }

    fn direction(x: i32, y: i32, z: i32) -> UnitVec3 {
        UnitVec3::normalize(Vec3::from_ints(x, y, z)).unwrap_or(UnitVec3::X)
    }

    #[test]
    fn sums_are_exact() {
        const END: i64 = 1 << SPAN_BITS;
        let mut rng = Pcg::new(1, 0);
        for _ in 0..2_000 {
            let mut place = || match rng.below(3) {
                0 => 0,
                1 => END,
                _ => i64::from(rng.below(1 << 28)),
            };
            let points = [(); 5].map(|()| [(); 3].map(|()| place()));
            let planes: Vec<_> = points[1..]
                .iter()
                .map(|&point| {
                    let mut part = || rng.below(9).cast_signed() - 4;
                    let normal = direction(part(), part(), part());
                    (normal, point, 1 + i64::from(rng.below(1 << 24)))
                })
                .collect();
            let sum = quadric(&planes);
            for x in points {
                assert_eq!(Ok(sum.at(x)), naive(&planes, x).try_into());
            }
        }
    }

    /// As many planes as there can be, as far from a point as they can be.
    #[test]
    fn the_largest_sums_fit() {
        const WEIGHT: i64 = 15 << 23;
        let far = [1 << SPAN_BITS; 3];
        for normal in [direction(1, 1, 1), direction(-1, -1, -1), direction(0, 1, 0)] {
            for (point, x) in [([0; 3], far), (far, [0; 3]), (far, far)] {
                let planes = [(normal, point, WEIGHT)];
                let sum = quadric(&planes);
                assert_eq!(Ok(sum.at(x)), naive(&planes, x).try_into());
                assert!(sum.trace() > 0);
            }
        }
    }

    /// Three planes meet in a point, two in a line of which the nearest point is found, and one has
    /// a foot.
    #[test]
    fn the_lowest_place_is_where_planes_meet() {
        let corner = [1000, 2000, 3000];
        let planes = [direction(1, 2, 2), direction(2, 1, -2), direction(2, -2, 1)]
            .map(|normal| (normal, corner, 99));
        let near = |found: Option<[i64; 3]>, wanted: [i64; 3]| {
            let found = found.expect("a place");
            let off = (0..3).map(|k| (found[k] - wanted[k]).abs()).max();
            assert!(off <= Some(1), "{found:?} is not {wanted:?}");
        };
        let middle = [1300, 1900, 2700];
        near(quadric(&planes).lowest(middle, 400), corner);
        assert_eq!(quadric(&planes).lowest(middle, 200), None);
        // The middle is (300, -100, -300) away: 166 2/3 along (2, -2, 1) / 3.
        let line = [0, 1, 2].map(|k| corner[k] + [2, -2, 1][k] * 500 / 9);
        near(quadric(&planes[..2]).lowest(middle, 400), line);
        // And 166 2/3 against (1, 2, 2) / 3.
        let foot = [0, 1, 2].map(|k| middle[k] + [1, 2, 2][k] * 500 / 9);
        near(quadric(&planes[..1]).lowest(middle, 400), foot);
        assert_eq!(Quadric::default().lowest(middle, 400), None);
    }
}
