//! Cylinders in cells.

use super::build::LANES;
use super::cell_box::CellBox;
use super::cells::Frame;
use super::volume::{Enclose, root_up};
use crate::math::root::isqrt;
use crate::math::wide::to_i32;

/// A cylinder along any axis, in cells of a [`Bvh`](super::Bvh): for meshes of long parts.
///
/// It holds the points `p` with `|(p - centre) . half| <= half . half` that are no farther than
/// `radius` from the axis; `half` is not 0. What it is around is within 0..=2^28 along each axis,
/// so that no point is farther than 2^27.8 from the centre; nor is `radius` longer, and `half` is
/// below 2^28.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CellCylinder {
    centre: [i32; 3],
    /// From the centre to one end.
    half: [i32; 3],
    radius: i32,
    /// No point is farther from the centre.
    reach: i32,
}

impl Enclose for CellCylinder {
    /// Along the way from the corner farthest from the first to the one farthest from that, through
    /// the middle of the box around all of them.
    fn around(parts: &[CellBox]) -> Self {
        let mut corners = [[0; 3]; 8 * LANES];
        let all = parts.iter().flat_map(CellBox::corners);
        let count =
            corners.iter_mut().zip(all).map(|(c, corner)| *c = corner.map(i64::from)).count();
        let corners = &corners[..count];
        let farthest = |from: [i64; 3]| {
            // The first of equals; `max_by_key` gives the last.
            let way_sq = |&&corner: &&[i64; 3]| square(way(from, corner));
            *corners.iter().rev().max_by_key(way_sq).unwrap_or(&from)
        };
        let end = farthest(corners[0]);
        let axis = match way(end, farthest(end)) {
            [0, 0, 0] => [1, 0, 0],
            axis => axis,
        };
        let centre = CellBox::around(parts).centre();
        let ways = corners.iter().map(|&corner| way(centre.map(i64::from), corner));
        let half = half(&ways, axis);
        let away_sq = ways.map(|way| cross_sq(way, half)).max().unwrap_or(0);
        // No point is farther from the axis than from the centre: below 2^56.
        let away_sq = away_sq.div_ceil(u128::from(square(half)));
        let radius = root_up(u64::try_from(away_sq).unwrap_or(u64::MAX));
        let reach = root_up(square(half)) + radius;
        let [radius, reach] = [radius, reach].map(to_i32);
        Self { centre, half: half.map(to_i32), radius, reach }
    }

    fn contains(&self, cell: &CellBox) -> bool {
        let [centre, half] = [self.centre, self.half].map(|v| v.map(i64::from));
        let radius_sq = u128::from(self.radius.unsigned_abs()).pow(2);
        cell.corners().into_iter().all(|corner| {
            let way = way(centre, corner.map(i64::from));
            // Below 2^56 * 2^56.
            dot(way, half).unsigned_abs() <= square(half)
                && cross_sq(way, half) <= radius_sq * u128::from(square(half))
        })
    }

    fn bounds(&self) -> CellBox {
        let Self { centre, half, radius, reach: _ } = *self;
        let low = |k: usize| centre[k] - half[k].abs() - radius;
        let high = |k: usize| centre[k] + half[k].abs() + radius;
        CellBox::new([0, 1, 2].map(low), [0, 1, 2].map(high))
    }

    fn framed(&self, frame: &Frame) -> Self {
        let Self { centre, half, radius, reach } = *self;
        Self {
            centre: frame.point(centre),
            half: frame.difference(half),
            radius: frame.radius(radius),
            reach: frame.radius(reach),
        }
    }

    /// They are apart if some direction shows it: tried are that from centre to centre, and about
    /// that of the shortest way between the axes. Worse ones only find fewer to be apart.
    fn overlaps(&self, other: &Self) -> bool {
        // Framed centres are within -2^28 - 2..=2^29 + 2.
        let between = way(self.centre.map(i64::from), other.centre.map(i64::from));
        let reach = i64::from(self.reach) + i64::from(other.reach);
        if dot(between, between) > reach * reach {
            return false;
        }
        let [half_a, half_b] = [self.half, other.half].map(|half| half.map(i64::from));
        let thick = i64::from(self.radius) + i64::from(other.radius);
        let parts = |direction: [i64; 3]| {
            // Below 3 * 2^20 * 2^30; what they take is below 2^30 * 2^21.
            let gap = dot(direction, between)
                - dot(direction, half_a).abs()
                - dot(direction, half_b).abs();
            gap > 0 && wide_sq(gap) > wide_sq(thick) * u128::from(square(direction))
        };
        let [direct] = shortened([between], 20);
        !parts(direct) && !parts(shortest(between, half_a, half_b))
    }
}

/// Half of an axis, so long that its ends are beyond all points; their ways from its middle are
/// given.
///
/// Rounding turns it a little, so that what it must hold is checked with the result. It is long
/// enough at the latest when it is as long as any way, a few rounds after the first guess: the axis
/// is at least half as long as the points are apart.
fn half(ways: &(impl Iterator<Item = [i64; 3]> + Clone), axis: [i64; 3]) -> [i64; 3] {
    // Not 0: below 2^28.8, as ways are below 2^27.8.
    let length = isqrt(square(axis)).cast_signed();
    let along = ways.clone().map(|way| dot(way, axis).abs() / length);
    let mut reach = along.max().unwrap_or(0).max(1);
    loop {
        // Rounded away from 0, so not shorter than `reach`. Below 2^28 * 2^29.
        let half = axis.map(|c| c.signum() * ((c.abs() * reach + length - 1) / length));
        let square = dot(half, half);
        if ways.clone().all(|way| dot(way, half).abs() <= square) {
            return half;
        }
        reach += reach / 64 + 1;
    }
}

/// About the shortest way from the axis through 0 to the one `between` away: components below
/// 2^20, the length does not matter. 0 if the axes meet, or nearly so.
fn shortest(between: [i64; 3], half_a: [i64; 3], half_b: [i64; 3]) -> [i64; 3] {
    const ONE: i64 = 1 << 10;
    let [w, p, q] = shortened([between, half_a, half_b], 12);
    // Components below 2^12: products below 2^26, their products below 2^53.
    let (pp, qq, pq, pw, qw) = (dot(p, p), dot(q, q), dot(p, q), dot(p, w), dot(q, w));
    let share = |over: i64, under: i64| {
        if under == 0 { 0 } else { (over * ONE / under).clamp(-ONE, ONE) }
    };
    let s = share(pw * qq - pq * qw, pp * qq - pq * pq);
    let t = share(s * pq / ONE - qw, qq);
    let s = share(t * pq / ONE + pw, pp);
    let way = [0, 1, 2].map(|k| between[k] * ONE + half_b[k] * t - half_a[k] * s);
    let [way] = shortened([way], 20);
    way
}

/// Vectors divided by a power of two, so that all components are below 2^`bits`.
fn shortened<const N: usize>(vectors: [[i64; 3]; N], bits: u32) -> [[i64; 3]; N] {
    let all = vectors.iter().flatten().fold(0, |all, c| all | c.unsigned_abs());
    let shift = (u64::BITS - all.leading_zeros()).saturating_sub(bits);
    vectors.map(|vector| vector.map(|c| c >> shift))
}

fn way(from: [i64; 3], to: [i64; 3]) -> [i64; 3] {
    [0, 1, 2].map(|k| to[k] - from[k])
}

/// Components below 2^30: at most 3 * 2^60.
fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn square(a: [i64; 3]) -> u64 {
    dot(a, a).unsigned_abs()
}

fn wide_sq(c: i64) -> u128 {
    u128::from(c.unsigned_abs()).pow(2)
}

/// The square of the length of the cross product: components as in [`dot`], minors below 2^61.
fn cross_sq(a: [i64; 3], b: [i64; 3]) -> u128 {
    let minor = |j: usize, k: usize| wide_sq(a[j] * b[k] - a[k] * b[j]);
    minor(0, 1) + minor(1, 2) + minor(2, 0)
}
