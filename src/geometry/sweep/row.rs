//! The way between two moving features along one direction.

use super::cell::Cell;

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
    begin: Instant<W>,
    end: Instant<W>,
    slack: W,
}

/// The values over a box at one time.
#[derive(Clone, Copy, Debug)]
struct Instant<W> {
    low: W,
    high: W,
    /// By how much they grow along u and along v.
    sides: [W; 2],
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
        let (start, gain) = (self.start, self.gain);
        let end = [start[0] + gain[0], start[1] + gain[1], start[2] + gain[2]];
        let (mut low, mut high) = (i64::MAX, i64::MIN);
        for [a, b, c] in [start, end] {
            // Each is a difference of points that there are: not larger than A can be.
            let last = if is_triangle { a } else { a + b + c };
            for value in [a, a + b, a + c, last] {
                (low, high) = (low.min(value), high.max(value));
            }
        }
        low > self.slack || high < -self.slack
    }

    /// The values over a box, in units that are smaller by the level of t and by the higher of
    /// those of u and v.
    ///
    /// In 64 bits only if all values are below 2^61: then sums may wrap on the way, while all that
    /// is compared are values, and differences of two. 128 bits hold any: 3 * 2^62 * 2^60.
    #[inline]
    pub(super) fn span<W: Width>(&self, cell: &Cell) -> Span<W> {
        let [of_t, of_u, of_v] = cell.levels();
        let [t, u, v] = cell.places();
        let finest = of_u.max(of_v);
        let (finer_u, finer_v) = (finest - of_u, finest - of_v);
        // Below 2^30.
        let (u, v) = (u << finer_u, v << finer_v);
        let zero = W::of(0);
        let at = |[a, b, c]: [W; 3]| {
            let corner = a.doubled(finest).plus(b.times(u)).plus(c.times(v));
            let [b, c] = [b.doubled(finer_u), c.doubled(finer_v)];
            let low = corner.plus(b.min(zero)).plus(c.min(zero));
            Instant { low, high: corner.plus(b.max(zero)).plus(c.max(zero)), sides: [b, c] }
        };
        let (start, gain) = (self.start, self.gain);
        let begin = [0, 1, 2].map(|k| W::of(start[k]).doubled(of_t).plus(W::of(gain[k]).times(t)));
        let end = [0, 1, 2].map(|k| begin[k].plus(W::of(gain[k])));
        Span { begin: at(begin), end: at(end), slack: W::of(self.slack).doubled(of_t + finest) }
    }
}

impl<W: Width> Span<W> {
    /// Whether no value is within the slack: all are above it, or all below. The time at which the
    /// box ends does not count, unless it is the last of all.
    #[inline]
    pub(super) fn is_clear(&self, is_last: bool) -> bool {
        let Self { begin, end, slack } = *self;
        let under = W::of(0).minus(slack);
        // A value changes evenly, so that it reaches what it is at the end only there.
        begin.low > slack && (end.low > slack || !is_last && end.low == slack)
            || begin.high < under && (end.high < under || !is_last && end.high == under)
    }

    /// The largest magnitude, of the slack too.
    #[inline]
    pub(super) fn magnitude(&self) -> W {
        let Self { begin, end, slack } = *self;
        let depth = W::of(0).minus(begin.low.min(end.low));
        depth.max(begin.high.max(end.high)).max(slack)
    }

    /// By how much values differ along t, u and v.
    #[inline]
    pub(super) fn extents(&self) -> [W; 3] {
        let Self { begin, end, .. } = self;
        let size = |v: W| v.max(W::of(0).minus(v));
        let of_t = size(end.low.minus(begin.low)).max(size(end.high.minus(begin.high)));
        let along = |k: usize| size(begin.sides[k]).max(size(end.sides[k]));
        [of_t, along(0), along(1)]
    }
}
