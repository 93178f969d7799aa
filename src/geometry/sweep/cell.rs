//! Boxes of times and places.

/// A box in `[0, 1]^3` of t, u and v that halving has led to: along each axis from
/// `place / 2^level` to `(place + 1) / 2^level`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Cell {
    places: [u32; 3],
    levels: [u8; 3],
}

impl Cell {
    /// The level at which an axis is halved no more.
    pub(super) const LEVEL_MAX: u8 = 30;

    /// All of it.
    pub(super) const ALL: Self = Self { places: [0; 3], levels: [0; 3] };

    /// The lower or upper half along an axis that [can be halved](Self::is_divisible).
    #[inline]
    pub(super) fn half(mut self, axis: usize, is_upper: bool) -> Self {
        self.levels[axis] += 1;
        self.places[axis] = 2 * self.places[axis] + u32::from(is_upper);
        self
    }

    #[inline]
    pub(super) fn is_divisible(&self, axis: usize) -> bool {
        self.levels[axis] < Self::LEVEL_MAX
    }

    #[inline]
    pub(super) fn levels(&self) -> [u32; 3] {
        self.levels.map(u32::from)
    }

    /// Below 2^30.
    #[inline]
    pub(super) fn places(&self) -> [i64; 3] {
        self.places.map(i64::from)
    }

    /// Where it begins along an axis, in units of 2^-30.
    #[inline]
    pub(super) fn low(&self, axis: usize) -> u32 {
        self.places[axis] << (Self::LEVEL_MAX - self.levels[axis])
    }

    /// When it begins, in units of 2^-30.
    #[inline]
    pub(super) fn time(&self) -> u32 {
        self.low(0)
    }

    /// Whether it lasts until time 1.
    #[inline]
    pub(super) fn is_last(&self) -> bool {
        (self.places[0] + 1) >> self.levels[0] == 1
    }

    /// Whether no more of it than a corner is where `u + v <= 1`. Boxes below hold that corner too.
    #[inline]
    pub(super) fn is_beyond(&self) -> bool {
        // Each is at most 2^30.
        self.low(1) + self.low(2) >= 1 << Self::LEVEL_MAX
    }
}
