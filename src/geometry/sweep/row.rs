//! The way between two moving features along one direction.

use super::cell::Cell;
use super::motion::fall;
use crate::math::Unit;

/// Integers of one width. Sums may wrap on the way, if what they end in fits.
pub(super) trait Width: Copy + Ord {
    /// A number.
    fn of(value: i64) -> Self;
    /// The sum.
    fn plus(self, other: Self) -> Self;
    /// The difference.
    fn minus(self, other: Self) -> Self;
    /// The product.
    fn times(self, factor: i64) -> Self;
    /// Times 2^`bits`.
    fn doubled(self, bits: u32) -> Self;
    /// `part / whole` in units of 2^-`bits`, at most 30, rounded down, or a little less; 0 where it
    /// is negative or above 1.
    fn share(part: Self, whole: Self, bits: u32) -> u32;
}

macro_rules! width {
    ($integer:ty) => {
        impl Width for $integer {
            #[inline]
            fn of(value: i64) -> Self {
                Self::from(value)
            }
            #[inline]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }
            #[inline]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }
            #[inline]
            fn times(self, factor: i64) -> Self {
                self.wrapping_mul(Self::from(factor))
            }
            #[inline]
            fn doubled(self, bits: u32) -> Self {
                self << bits
            }
            #[inline]
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "32 bits that are not negative; a quotient of at most 2^30"
            )]
            fn share(part: Self, whole: Self, bits: u32) -> u32 {
                if part <= 0 || part > whole {
                    return 0;
                }
                // Both in 32 bits, the divisor rounded up.
                let surplus = (Self::BITS - whole.leading_zeros()).saturating_sub(32);
                let [part, whole] = [part >> surplus, (whole >> surplus) + Self::from(surplus > 0)];
                (((part as u64) << bits) / whole as u64) as u32
            }
        }
    };
}

width!(i64);
width!(i128);

/// `d . (A + u B + v C)` for an integer direction `d`, where `A`, `B` and `C` change evenly.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// `d . A`, `d . B` and `d . C` at time 0: at most 2^61.
    start: [i64; 3],
    /// What they gain until time 1: at most 2^62.
    gain: [i64; 3],
    /// Features closer than the gap have a value within `+-slack`.
    slack: i64,
}

/// The values of a row over a box; exact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span<W> {
    /// When it begins, and when it ends.
    ends: [Instant<W>; 2],
    slack: W,
}

/// The values over a box at one time: `corner`, and what they gain along u and along v.
#[derive(Clone, Copy, Debug)]
struct Instant<W> {
    corner: W,
    sides: [W; 2],
}

/// The lowest and the highest of some values.
#[derive(Clone, Copy, Debug)]
struct Range<W> {
    low: W,
    high: W,
}

impl Row {
    /// The row of values at time 0 and time 1.
    pub(super) fn new(start: [i64; 3], end: [i64; 3], slack: i64) -> Self {
        let gain = [end[0] - start[0], end[1] - start[1], end[2] - start[2]];
        Self { start, gain, slack }
    }

    /// Whether the features are apart along the direction at time 0 and at time 1, on the same side
    /// of one another, and hence always.
    #[inline]
    pub(super) fn is_apart(&self, is_triangle: bool) -> bool {
        let (mut low, mut high) = (i64::MAX, i64::MIN);
        for value in self.corners(is_triangle).into_iter().flatten() {
            (low, high) = (low.min(value), high.max(value));
        }
        low > self.slack || high < -self.slack
    }

    /// When the features are no longer apart along the direction, on the side of one another on
    /// which they start: rounded down, and 1 if they always are. Exact: the first value of a corner
    /// to come within the slack is that of all, as each changes evenly.
    pub(super) fn first(&self, is_triangle: bool) -> Unit {
        let [start, end] = self.corners(is_triangle);
        let first = |sign: i64| {
            let values = start.iter().zip(end);
            let falls =
                values.map(|(start, end)| fall(sign * start - self.slack, sign * end - self.slack));
            falls.map(|fall| fall.unwrap_or(Unit::ONE)).min().unwrap_or(Unit::ZERO)
        };
        first(1).max(first(-1))
    }

    /// The values at the corners of all u and v, at time 0 and at time 1.
    #[inline]
    fn corners(&self, is_triangle: bool) -> [[i64; 4]; 2] {
        let (start, gain) = (self.start, self.gain);
        let end = [start[0] + gain[0], start[1] + gain[1], start[2] + gain[2]];
        [start, end].map(|[a, b, c]| {
            // Each is a difference of points that there are: not larger than A can be.
            let last = if is_triangle { a } else { a + b + c };
            [a, a + b, a + c, last]
        })
    }

    /// The values over a box, in units that are smaller by the level of t and by the higher of
    /// those of u and v.
    ///
    /// In 64 bits only if all values are below 2^60: then sums may wrap on the way, while all that
    /// is compared are values, and differences of two. 128 bits hold any: 3 * 2^62 * 2^60.
    #[inline]
    pub(super) fn span<W: Width>(&self, cell: &Cell) -> Span<W> {
        let [of_t, of_u, of_v] = cell.levels();
        let [t, u, v] = cell.places();
        let finest = of_u.max(of_v);
        let (finer_u, finer_v) = (finest - of_u, finest - of_v);
        // Below 2^30.
        let (u, v) = (u << finer_u, v << finer_v);
        let at = |[a, b, c]: [W; 3]| Instant {
            corner: a.doubled(finest).plus(b.times(u)).plus(c.times(v)),
            sides: [b.doubled(finer_u), c.doubled(finer_v)],
        };
        let (start, gain) = (self.start, self.gain);
        let begin = [0, 1, 2].map(|k| W::of(start[k]).doubled(of_t).plus(W::of(gain[k]).times(t)));
        let end = [0, 1, 2].map(|k| begin[k].plus(W::of(gain[k])));
        Span { ends: [at(begin), at(end)], slack: W::of(self.slack).doubled(of_t + finest) }
    }
}

impl<W: Width> Instant<W> {
    #[inline]
    fn range(&self) -> Range<W> {
        self.side(0, false).widened(self.sides[0])
    }

    /// The values where u (0) or v (1) is lowest, or highest.
    #[inline]
    fn side(&self, axis: usize, is_upper: bool) -> Range<W> {
        let Self { corner, sides } = *self;
        let at = if is_upper { corner.plus(sides[axis]) } else { corner };
        Range { low: at, high: at }.widened(sides[1 - axis])
    }
}

impl<W: Width> Range<W> {
    /// With what is so far from each.
    #[inline]
    fn widened(self, by: W) -> Self {
        let zero = W::of(0);
        Self { low: self.low.plus(by.min(zero)), high: self.high.plus(by.max(zero)) }
    }

    #[inline]
    fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

impl<W: Width> Span<W> {
    /// Whether no value is within the slack: all are above it, or all below. The time at which the
    /// box ends does not count, unless it is the last of all.
    #[inline]
    pub(super) fn is_clear(&self, is_last: bool) -> bool {
        let [begin, end] = self.ends.map(|end| end.range());
        let (slack, under) = (self.slack, W::of(0).minus(self.slack));
        // A value changes evenly, so that it reaches what it is at the end only there.
        begin.low > slack && (end.low > slack || !is_last && end.low == slack)
            || begin.high < under && (end.high < under || !is_last && end.high == under)
    }

    /// The largest magnitude, of the slack too.
    #[inline]
    pub(super) fn magnitude(&self) -> W {
        let all = self.ends[0].range().union(self.ends[1].range());
        W::of(0).minus(all.low).max(all.high).max(self.slack)
    }

    /// By how much values differ along t, u and v.
    #[inline]
    pub(super) fn extents(&self) -> [W; 3] {
        let size = |v: W| v.max(W::of(0).minus(v));
        let [begin, end] = self.ends;
        let (first, last) = (begin.range(), end.range());
        let of_t = size(last.low.minus(first.low)).max(size(last.high.minus(first.high)));
        let along = |k: usize| size(begin.sides[k]).max(size(end.sides[k]));
        [of_t, along(0), along(1)]
    }

    /// Between which of its 2^`bits` parts along an axis, at most 2^30, a box that is not clear has
    /// values within the slack: the first and the last.
    ///
    /// Along an axis the lowest of the values is above the chord of its ends, and the highest below
    /// its own: where a chord comes within the slack, values may.
    #[inline]
    pub(super) fn parts(&self, axis: usize, bits: u32) -> [u32; 2] {
        let [begin, end] = self.ends;
        let [lower, upper] = if axis == 0 {
            [begin.range(), end.range()]
        } else {
            [false, true]
                .map(|is_upper| begin.side(axis - 1, is_upper).union(end.side(axis - 1, is_upper)))
        };
        let (slack, under) = (self.slack, W::of(0).minus(self.slack));
        // How far from one end the values there stay clear, towards the other.
        let clear = |here: Range<W>, there: Range<W>| {
            let above = W::share(here.low.minus(slack), here.low.minus(there.low), bits);
            above.max(W::share(under.minus(here.high), there.high.minus(here.high), bits))
        };
        let most = (1 << bits) - 1;
        let first = clear(lower, upper).min(most);
        // What ends where a part begins belongs to that part, since times do not hold their end.
        let last = (most + u32::from(axis == 0)).saturating_sub(clear(upper, lower)).min(most);
        [first.min(last), last]
    }
}
