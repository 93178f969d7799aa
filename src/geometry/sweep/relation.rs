//! Two features that move, as one function of time and place.

use super::Motion;
use super::cell::Cell;
use super::row::Row;
use crate::math::determinant::{Middle, Width};
use crate::math::wide::sub;
use crate::math::{Unit, Vec3};

/// `F(t, u, v) = A(t) + u B(t) + v C(t)`, the way from a point of one feature to a point of the
/// other, along several directions. They touch where it is 0, and are apart wherever it is not 0
/// along one of them.
#[derive(Clone, Debug)]
pub(super) struct Relation {
    /// Along x, y and z.
    axes: [Row; 3],
    /// The leading bits of A, B and C at time 0 and at time 1: below 2^44.
    frames: [Frame; 2],
    /// Features closer than the gap are within this of one another along every axis of `frames`.
    slack: i64,
    /// The leading bits of A, B and C at time 0, and of what they gain: below 2^28.
    coarse: [Frame; 2],
    /// Whether `u + v <= 1`.
    is_triangle: bool,
    is_narrow: bool,
}

/// Values below this many bits are narrow.
pub(super) const NARROW_BITS: u32 = 60;

/// Directions of more bits would find little more.
const DIRECTION_BITS: u32 = 12;
/// The bits of what directions are multiplied by: values along them, and sums of these, have less
/// than 2 more than both together, and leave times to be told apart that are 2^-30 of a step.
const FRAME_BITS: u32 = NARROW_BITS - DIRECTION_BITS - 4;
/// What directions are made of.
const COARSE_BITS: u32 = 28;

type Vector = [i64; 3];

/// A, B and C at one time: at most 2^61.
type Frame = [Vector; 3];

impl Relation {
    /// From a face to a vertex x: `x - ((1 - u - v) a + u b + v c)`. `None` if they are apart along
    /// one direction at both ends of the step, and hence always.
    pub(super) fn vertex_face(
        x: Motion<Vec3>,
        [a, b, c]: [Motion<Vec3>; 3],
        gap: i64,
    ) -> Option<Self> {
        let frame = |points: [Vec3; 4]| {
            let [x, a, b, c] = points.map(Vec3::raw);
            [sub(x, a), sub(a, b), sub(a, c)]
        };
        let start = frame([x.start, a.start, b.start, c.start]);
        let end = frame([x.end, a.end, b.end, c.end]);
        Self::new(start, end, gap, true)
    }

    /// From edge rs to edge pq: `(1 - u) p + u q - ((1 - v) r + v s)`. `None` as above.
    pub(super) fn edge_edge(
        [p, q]: [Motion<Vec3>; 2],
        [r, s]: [Motion<Vec3>; 2],
        gap: i64,
    ) -> Option<Self> {
        let frame = |points: [Vec3; 4]| {
            let [p, q, r, s] = points.map(Vec3::raw);
            [sub(p, r), sub(q, p), sub(r, s)]
        };
        let start = frame([p.start, q.start, r.start, s.start]);
        let end = frame([p.end, q.end, r.end, s.end]);
        Self::new(start, end, gap, false)
    }

    fn new(start: Frame, end: Frame, gap: i64, is_triangle: bool) -> Option<Self> {
        let along = |k: usize| Row::new(start.map(|v| v[k]), end.map(|v| v[k]), gap);
        let axes = [along(0), along(1), along(2)];
        if axes.iter().any(|row| row.is_apart(is_triangle)) {
            return None;
        }
        let bits = bits(start.iter().chain(&end)).max(u64::BITS - gap.leading_zeros());
        let gain = [0, 1, 2].map(|k| sub(end[k], start[k]));
        // A gain has one bit more.
        let coarse = [start, gain].map(|frame| frame.map(|v| scaled(v, bits + 1, COARSE_BITS)));
        let frames = [start, end].map(|frame| frame.map(|v| cut(v, bits, FRAME_BITS)));
        // What is cut off A, B and C is below 1 each, and so is what is cut off the gap.
        let surplus = bits.saturating_sub(FRAME_BITS);
        let slack = if surplus == 0 { gap } else { (gap >> surplus) + 4 };
        // A value is the sum of three, and nothing has been cut.
        const { assert!(FRAME_BITS + Self::DIRECTION_BITS + 2 <= NARROW_BITS) };
        let is_narrow = bits <= FRAME_BITS;
        let relation = Self { axes, frames, slack, coarse, is_triangle, is_narrow };
        let is_apart = relation.directions(&Cell::ALL).iter().any(|row| row.is_apart(is_triangle));
        (!is_apart).then_some(relation)
    }

    /// No value along a direction is larger than 2^this times one along an axis.
    pub(super) const DIRECTION_BITS: u32 = DIRECTION_BITS + 2;

    /// The rows along x, y and z.
    #[inline]
    pub(super) fn axes(&self) -> &[Row; 3] {
        &self.axes
    }

    /// The rows along `B x C`, `C x V` and `V x B`, where V is the velocity, all in the middle of a
    /// box: each has next to no component along two of what t, u and v change F by there, and so
    /// tells the third.
    #[inline]
    pub(super) fn directions(&self, cell: &Cell) -> [Row; 3] {
        let [t, u, v] = [0, 1, 2].map(|axis| cell.middle(axis));
        let [start, gain] = &self.coarse;
        // Below 2^28, and after sums below 2^30.
        let at = |p: Vector, q: Vector, by: i64| [0, 1, 2].map(|k| p[k] + q[k] * by / (1 << 30));
        let (b, c) = (at(start[1], gain[1], t), at(start[2], gain[2], t));
        let velocity = at(at(gain[0], gain[1], u), gain[2], v);
        [[b, c], [c, velocity], [velocity, b]].map(|[p, q]| self.along(Middle::cross(p, q)))
    }

    /// The row along a direction.
    #[inline]
    fn along(&self, direction: Vector) -> Row {
        let direction = cut(direction, bits([direction].iter()), DIRECTION_BITS);
        let [start, end] =
            self.frames.map(|frame| frame.map(|v| (0..3).map(|k| direction[k] * v[k]).sum()));
        // No component along it is longer than the longest of F times this.
        let size: i64 = direction.iter().map(|c| c.abs()).sum();
        Row::new(start, end, self.slack * size)
    }

    /// Whether `u + v <= 1`, and not only `u <= 1` and `v <= 1`.
    #[inline]
    pub(super) fn is_triangle(&self) -> bool {
        self.is_triangle
    }

    /// Whether the values over the box of all t, u and v are narrow; if not, frames may have been
    /// cut, and no values are to be taken for narrow.
    #[inline]
    pub(super) fn is_narrow(&self) -> bool {
        self.is_narrow
    }

    /// Before this they are apart along x, y or z: rounded down.
    pub(super) fn first(&self) -> Unit {
        let first = |row: &Row| row.first(self.is_triangle);
        self.axes.iter().map(first).max().unwrap_or(Unit::ZERO)
    }

    /// Whether F is not 0 over a box unless when it ends.
    pub(super) fn is_clear_before_end(&self, cell: &Cell) -> bool {
        let mut rows = self.axes.into_iter().chain(self.directions(cell));
        rows.any(|row| row.span::<i128>(cell).is_clear(false))
    }
}

/// The bits of the largest magnitude.
fn bits<'a>(vectors: impl Iterator<Item = &'a Vector>) -> u32 {
    let all = vectors.flatten().fold(0, |all, c| all | c.unsigned_abs());
    u64::BITS - all.leading_zeros()
}

/// The leading bits of a vector of so many: cut towards zero, so that a mirrored vector is cut the
/// same way.
fn cut(vector: Vector, bits: u32, most: u32) -> Vector {
    vector.map(|c| c / (1 << bits.saturating_sub(most)))
}

/// A vector of so many bits in others: cut, or times a power of two.
fn scaled(vector: Vector, bits: u32, wanted: u32) -> Vector {
    cut(vector, bits, wanted).map(|c| c << wanted.saturating_sub(bits))
}
