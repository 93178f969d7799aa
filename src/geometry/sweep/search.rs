//! Boxes in the order of time.

use alloc::collections::BinaryHeap;

use super::Impact;
use super::cell::Cell;
use super::relation::{NARROW_BITS, Relation};
use super::row::Width;
use crate::math::Unit;

/// A box over which F may be 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Open {
    /// The earlier it begins, the higher; of those that begin together, the last is the highest:
    /// straight down to a contact instead of all of its neighbours first.
    rank: u64,
    cell: Cell,
    /// Along which axis it is to be halved; `None` if it is as small as can be.
    axis: Option<u8>,
    /// Whether the values over its halves fit 64 bits.
    is_narrow: bool,
}

/// The first box, no later than `until`, that is not shown to be free of contacts.
pub(super) fn search(relation: &Relation, work_max: u32, until: Unit) -> Option<Impact> {
    let until = until.raw().cast_unsigned();
    let mut work = 0;
    let mut open = BinaryHeap::new();
    open.extend(look(relation, Cell::ALL, relation.is_narrow(), work));
    while let Some(Open { cell, axis, is_narrow, .. }) = open.pop() {
        let Some(axis) = axis.filter(|_| work < work_max).map(usize::from) else {
            return Some(impact(relation, &cell, axis.is_some()));
        };
        for is_upper in [true, false] {
            let half = cell.half(axis, is_upper);
            if half.time() > until || relation.is_triangle() && half.is_beyond() {
                continue;
            }
            work = work.saturating_add(1);
            open.extend(look(relation, half, is_narrow, work));
        }
    }
    None
}

/// A box to be kept; `None` if F is not 0 in it.
#[inline]
fn look(relation: &Relation, cell: Cell, is_narrow: bool, order: u32) -> Option<Open> {
    let (axis, is_narrow) = if is_narrow {
        judge(relation, &cell, 1_i64 << NARROW_BITS)?
    } else {
        judge(relation, &cell, 1_i128 << NARROW_BITS)?
    };
    let rank = u64::from(u32::MAX - cell.time()) << u32::BITS | u64::from(order);
    Some(Open { rank, cell, axis, is_narrow })
}

/// Along which axis to halve a box, and whether the values over it are narrow; `None` if F is not
/// 0 in it.
///
/// A half's values are between those of the whole, in units that are half as large at the least:
/// where the whole's are below 2^60, they and their differences are below 2^62.
#[inline]
fn judge<W: Width>(relation: &Relation, cell: &Cell, narrow: W) -> Option<(Option<u8>, bool)> {
    let mut extents = [W::of(0); 3];
    let mut magnitude = W::of(0);
    let is_last = cell.is_last();
    let (axes, directions) = relation.rows();
    for row in axes {
        let span = row.span::<W>(cell);
        if span.is_clear(is_last) {
            return None;
        }
        magnitude = magnitude.max(span.magnitude());
        let found = span.extents();
        extents = [0, 1, 2].map(|k| extents[k].max(found[k]));
    }
    for row in directions {
        let span = row.span::<W>(cell);
        if span.is_clear(is_last) {
            return None;
        }
        magnitude = magnitude.max(span.magnitude());
    }
    // Where F does not change there is nothing to be told apart.
    let mut widest = (W::of(0), None);
    for (axis, extent) in (0..).zip(extents) {
        if extent > widest.0 && cell.is_divisible(usize::from(axis)) {
            widest = (extent, Some(axis));
        }
    }
    Some((widest.1, magnitude < narrow))
}

fn impact(relation: &Relation, cell: &Cell, is_cut: bool) -> Impact {
    let unit = |axis| Unit::from_raw(cell.low(axis).cast_signed());
    let mut time = unit(0);
    if !is_cut && cell.is_last() && relation.is_clear_before_end(cell) {
        time = Unit::ONE;
    }
    Impact { time, weights: [unit(1), unit(2)], is_cut }
}
