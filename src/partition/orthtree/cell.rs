//! Cells that halve along each axis, as numbers.

/// A cell: which of the 2^`level` parts of the world along each axis.
///
/// The key is the Morton code of its lowest corner (the bits of the coordinates in turn, as many as
/// the deepest level has), then the level in 6 bits. Keys order cells depth first: a cell, then all
/// cells inside it, then the next one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Cell<const D: usize>(u128);

/// Bits of a key that hold the level.
const LEVEL_BITS: u32 = 6;

/// The world's edge, raw, as a power of two: coordinates are within +-2^60.
pub(super) const WORLD: u32 = 61;

/// The bits of a Morton code that belong to axis 0.
const fn mask(axes: u32, depth: u32) -> u128 {
    let mut bits = 0;
    let mut at = 0;
    while at < depth {
        bits |= 1 << (at * axes);
        at += 1;
    }
    bits
}

impl<const D: usize> Cell<D> {
    /// Number of axes. 2 or 3.
    const AXES: u32 = if D == 2 { 2 } else { 3 };
    /// The deepest level: 60 with 2 axes, where cells are 2 raw steps wide, and 40 with 3 axes,
    /// where they are 12.5 cm wide. All bits of all axes must fit 120 bits.
    pub(super) const DEPTH: u32 = 120 / Self::AXES;
    const MASK: u128 = mask(Self::AXES, Self::DEPTH);
    /// The whole world.
    pub(super) const ROOT: Self = Self(0);

    /// The cell of this level that holds a point, raw. A point on the upper edge of the world
    /// counts as inside: then cells differ by no more than they did.
    pub(super) fn around(point: [i64; D], level: u32) -> Self {
        let mut morton = 0;
        for (axis, c) in (0..).zip(point) {
            let c = (c + (1 << (WORLD - 1))).min((1 << WORLD) - 1); // 0 <= c < 2^61
            let c = c.unsigned_abs() >> (WORLD - Self::DEPTH);
            for bit in (Self::DEPTH - level)..Self::DEPTH {
                morton |= u128::from(c >> bit & 1) << (bit * Self::AXES + axis);
            }
        }
        Self(morton << LEVEL_BITS | u128::from(level))
    }

    /// Its level; the root's is 0.
    pub(super) const fn level(self) -> u32 {
        // Six bits.
        (self.0 & ((1 << LEVEL_BITS) - 1)) as u32
    }

    const fn morton(self) -> u128 {
        self.0 >> LEVEL_BITS
    }

    /// The least step between Morton codes of cells of this level.
    const fn step(level: u32) -> u128 {
        1 << (Self::AXES * (Self::DEPTH - level))
    }

    /// The cell of this level, at most its own, that it lies in.
    pub(super) const fn ancestor(self, level: u32) -> Self {
        let morton = self.morton() & !(Self::step(level) - 1);
        Self(morton << LEVEL_BITS | level as u128)
    }

    /// No cell inside has a key as large, and every cell behind has.
    pub(super) const fn end(self) -> Self {
        Self((self.morton() + Self::step(self.level())) << LEVEL_BITS)
    }

    /// The cell of its level so many cells away, each -1, 0 or 1; `None` beyond the world.
    pub(super) fn neighbour(self, offset: [i32; D]) -> Option<Self> {
        let step = Self::step(self.level());
        let mut morton = 0;
        for (axis, way) in (0..).zip(offset) {
            // Counting in every second or third bit: the others are filled, or cleared, so that
            // a carry runs over them.
            let mask = Self::MASK << axis;
            let old = self.morton() & mask;
            let new = match way {
                0 => old,
                1 => (self.morton() | !mask).wrapping_add(step << axis) & mask,
                _ => old.wrapping_sub(step << axis) & mask,
            };
            if (way > 0 && new <= old) || (way < 0 && new >= old) {
                return None;
            }
            morton |= new;
        }
        Some(Self(morton << LEVEL_BITS | u128::from(self.level())))
    }

    /// The lowest corner and the edge, raw.
    pub(super) fn extent(self) -> ([i64; D], i64) {
        let mut corner = [-(1 << (WORLD - 1)); D];
        for (axis, c) in (0..).zip(&mut corner) {
            for bit in (Self::DEPTH - self.level())..Self::DEPTH {
                let digit = self.morton() >> (bit * Self::AXES + axis) & 1;
                *c += (digit as i64) << (bit + WORLD - Self::DEPTH);
            }
        }
        (corner, 1 << (WORLD - self.level()))
    }
}
