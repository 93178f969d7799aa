//! Two features that move, as one function of time and place.

use super::Motion;
use super::cell::Cell;
use super::row::Row;
use crate::math::wide::{add, dot_wide, sub, to_i64};
use crate::math::{Vec3, determinant};

/// `F(t, u, v) = A(t) + u B(t) + v C(t)`, the way from a point of one feature to a point of the
/// other, along several directions. They touch where it is 0, and are apart wherever it is not 0
/// along one of them.
#[derive(Clone, Debug)]
pub(super) struct Relation {
    /// Along x, y and z.
    axes: [Row; 3],
    /// Along directions that suit the features.
    directions: [Row; 3],
    /// How many of them there are.
    len: usize,
    /// Whether `u + v <= 1`.
    is_triangle: bool,
    is_narrow: bool,
}

/// Values below this many bits are narrow.
pub(super) const NARROW_BITS: u32 = 60;

/// Directions of more bits would find little more.
const DIRECTION_BITS: u32 = 12;
/// Directions of fewer bits would find nothing.
const DIRECTION_BITS_MIN: u32 = 4;

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
        let mut bits = bits(start.iter().chain(&end)).max(u64::BITS - gap.leading_zeros());
        let mut relation = Self { axes, directions: axes, len: 0, is_triangle, is_narrow: false };
        // What a direction of k bits makes of b bits is below 3 * 2^(k + b) < 2^(k + b + 2).
        let fine = (NARROW_BITS - 2).saturating_sub(bits).min(DIRECTION_BITS);
        if fine >= DIRECTION_BITS_MIN {
            for direction in directions(&start, &end).map(|v| cut(v, fine)) {
                let size: i64 = direction.iter().map(|c| c.abs()).sum();
                // No component along it is longer than the longest of F times this.
                let row = Row::new(
                    start.map(|v| to_i64(dot_wide(direction, v))),
                    end.map(|v| to_i64(dot_wide(direction, v))),
                    gap * size,
                );
                if row.is_apart(is_triangle) {
                    return None;
                }
                if size > 0 {
                    relation.directions[relation.len] = row;
                    relation.len += 1;
                }
            }
            bits += fine + 2;
        }
        // A value is the sum of three.
        relation.is_narrow = bits + 2 <= NARROW_BITS;
        Some(relation)
    }

    /// The rows along x, y and z, and those along other directions.
    #[inline]
    pub(super) fn rows(&self) -> (&[Row; 3], &[Row]) {
        (&self.axes, &self.directions[..self.len])
    }

    /// Whether `u + v <= 1`, and not only `u <= 1` and `v <= 1`.
    #[inline]
    pub(super) fn is_triangle(&self) -> bool {
        self.is_triangle
    }

    /// Whether the values over the box of all t, u and v are narrow.
    #[inline]
    pub(super) fn is_narrow(&self) -> bool {
        self.is_narrow
    }

    /// Whether F is not 0 over a box unless when it ends.
    pub(super) fn is_clear_before_end(&self, cell: &Cell) -> bool {
        let (axes, directions) = self.rows();
        axes.iter().chain(directions).any(|row| row.span::<i128>(cell).is_clear(false))
    }
}

/// The bits of the largest magnitude.
fn bits<'a>(vectors: impl Iterator<Item = &'a Vector>) -> u32 {
    let all = vectors.flatten().fold(0, |all, c| all | c.unsigned_abs());
    u64::BITS - all.leading_zeros()
}

/// `B x C`, `C x V` and `V x B` in the middle of the step, and of the features: each has no
/// component along two of what t, u and v change F by, and so tells the third.
fn directions(start: &Frame, end: &Frame) -> [Vector; 3] {
    // Called for at most 54 bits: sums are below 2^58, and what is multiplied below 2^30.
    let [_, b, c] = [0, 1, 2].map(|k| add(start[k], end[k]));
    let [of_a, of_b, of_c] = [0, 1, 2].map(|k| sub(end[k], start[k]));
    let v = add(add(of_a, of_a), add(of_b, of_c));
    let [b, c, v] = [b, c, v].map(|vector| cut(vector, 30));
    [[b, c], [c, v], [v, b]].map(|[u, v]| determinant::cross(u, v).map(to_i64))
}

/// The leading `most` bits of a vector, cut towards zero: a mirrored vector is cut the same way.
fn cut(vector: Vector, most: u32) -> Vector {
    let surplus = bits([vector].iter()).saturating_sub(most);
    vector.map(|c| c / (1 << surplus))
}
