//! On which sides of a plane three corners are.

use super::Corners;
use crate::geometry::Triangle;

/// The sides of three corners: a code of three digits to the base of 3.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides(u8);

/// The orders of three corners: turned by 0, 1, 2, then the same mirrored about the first.
const ORDERS: [[u8; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]];

/// For every code: by how much to turn until the first corner is alone, and whether it is behind
/// the plane then.
const ALONE: [(u8, bool); 27] = {
    let mut table = [(0, false); 27];
    let mut code: u8 = 0;
    while code < 27 {
        let digits = [code / 9, code / 3 % 3, code % 3];
        table[code as usize] = alone(digits);
        code += 1;
    }
    table
};

/// The digits of a code.
const BEHIND: u8 = 0;
const ON: u8 = 1;
const BEFORE: u8 = 2;

/// The corner that is off the plane while no other is on its side; or else the one on the plane,
/// which then counts as opposite to the others.
const fn alone(sides: [u8; 3]) -> (u8, bool) {
    let mut corner: u8 = 0;
    while corner < 3 {
        let [own, next, last] = from(corner, sides);
        if own == BEFORE && next != BEFORE && last != BEFORE {
            return (corner, false);
        }
        if own == BEHIND && next != BEHIND && last != BEHIND {
            return (corner, true);
        }
        corner += 1;
    }
    corner = 0;
    while corner < 2 && from(corner, sides)[0] != ON {
        corner += 1;
    }
    (corner, from(corner, sides)[1] == BEFORE)
}

/// The sides of all corners, from one on.
const fn from(corner: u8, [a, b, c]: [u8; 3]) -> [u8; 3] {
    match corner {
        0 => [a, b, c],
        1 => [b, c, a],
        _ => [c, a, b],
    }
}

impl Sides {
    /// Of three signs, each -1, 0 or 1.
    #[inline]
    pub(super) fn of(signs: [i8; 3]) -> Self {
        let [a, b, c] = signs;
        Self((13 + 9 * a + 3 * b + c).cast_unsigned())
    }

    /// Whether all are off the plane, on one side.
    #[inline]
    pub(super) fn are_one(self) -> bool {
        self.0 == 13 * BEHIND || self.0 == 13 * BEFORE
    }

    /// Whether all are on the plane.
    #[inline]
    pub(super) fn are_none(self) -> bool {
        self.0 == 13 * ON
    }

    #[inline]
    fn alone(self) -> (u8, bool) {
        ALONE[usize::from(self.0)]
    }
}

/// The order of a triangle's corners in which the first is alone on its side of the other's plane,
/// and the first of the other is before the plane of this one.
#[inline]
pub(super) fn order(own: Sides, other: Sides) -> [u8; 3] {
    let (turn, _) = own.alone();
    let (_, behind) = other.alone();
    ORDERS[usize::from(turn + 3 * u8::from(behind))]
}

/// The corners in an order.
#[inline]
pub(super) fn ordered(triangle: &Triangle, order: [u8; 3]) -> Corners {
    let corner = |index: u8| triangle.corners()[usize::from(index)].raw();
    [corner(order[0]), corner(order[1]), corner(order[2])]
}
