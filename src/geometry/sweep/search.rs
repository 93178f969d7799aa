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

/// What looking at a box has told.
#[derive(Clone, Copy, Debug)]
struct View {
    /// Where in the box F may be 0: all of it, or the smallest box of halves around that.
    rest: Cell,
    /// Along which axis to halve the box itself.
    axis: Option<u8>,
    /// Whether the values over its halves and over `rest` fit 64 bits.
    is_narrow: bool,
}

/// The first contact no later than `until`, or that which cannot be told from one; `None` proves
/// that there is none.
///
/// What lands flat touches all over at once: then the order of time forbids to go straight down
/// to a contact. But axes often tell when it is, as for boxes along them, and a box that lasts no
/// longer than that is soon small.
pub(super) fn search(relation: &Relation, work_max: u32, until: Unit) -> Option<Impact> {
    let at = |first: Unit| descend(relation, Cell::at(first), work_max, first);
    if until < Unit::ONE {
        let first = relation.first();
        if first >= until {
            return if first == until { at(first) } else { None };
        }
    }
    let found = descend(relation, Cell::ALL, work_max, until)?;
    if !found.is_cut {
        return Some(found);
    }
    let first = relation.first();
    match at(first) {
        Some(at_first) => Some(at_first),
        None => Some(Impact { time: found.time.max(after(first)), ..found }),
    }
}

/// 2^-30 later; 1 at most.
fn after(time: Unit) -> Unit {
    Unit::from_raw(time.raw() + 1).min(Unit::ONE)
}

/// The first box in a box, no later than `until`, that is not shown to be free of contacts.
fn descend(relation: &Relation, all: Cell, work_max: u32, until: Unit) -> Option<Impact> {
    let latest = until.raw().cast_unsigned();
    let (mut work, mut in_the_end) = (0, None);
    let mut open = BinaryHeap::new();
    let is_narrow = relation.is_narrow() && all == Cell::ALL;
    let first = look(relation, all, is_narrow, &mut work);
    open.extend(first.filter(|first| first.cell.time() <= latest));
    while let Some(Open { cell, axis, is_narrow, .. }) = open.pop() {
        let Some(axis) = axis.filter(|_| work < work_max).map(usize::from) else {
            let impact = impact(relation, &cell, axis.is_some());
            if impact.time < Unit::ONE || relation.first() == Unit::ONE {
                return Some(impact).filter(|impact| impact.time <= until);
            }
            // Others may touch just before.
            in_the_end = in_the_end.or(Some(impact));
            continue;
        };
        for is_upper in [true, false] {
            let half = cell.half(axis, is_upper);
            if relation.is_triangle() && half.reach().is_eq() && cell.reach().is_lt() {
                // The lower half has that corner too.
                continue;
            }
            let half = look(relation, half, is_narrow, &mut work);
            open.extend(half.filter(|half| half.cell.time() <= latest));
        }
    }
    in_the_end.filter(|_| until == Unit::ONE)
}

/// What is left of a box to be kept; `None` if F is not 0 in it. It takes up less room with every
/// look, or that is the last.
#[inline]
fn look(relation: &Relation, mut cell: Cell, mut is_narrow: bool, work: &mut u32) -> Option<Open> {
    loop {
        if relation.is_triangle() && cell.reach().is_gt() {
            return None;
        }
        *work = work.saturating_add(1);
        let view =
            if is_narrow { view::<i64>(relation, &cell)? } else { view::<i128>(relation, &cell)? };
        if view.rest == cell {
            let rank = u64::from(u32::MAX - cell.time()) << u32::BITS | u64::from(*work);
            return Some(Open { rank, cell, axis: view.axis, is_narrow: view.is_narrow });
        }
        (cell, is_narrow) = (view.rest, view.is_narrow);
    }
}

/// Looks at a box in numbers of some width; `None` if F is not 0 in it.
#[inline]
fn view<W: Width>(relation: &Relation, cell: &Cell) -> Option<View> {
    let mut extents = [W::of(0); 3];
    let mut magnitude = W::of(0);
    let is_last = cell.is_last();
    for row in relation.axes() {
        let span = row.span::<W>(cell);
        if span.is_clear(is_last) {
            return None;
        }
        magnitude = magnitude.max(span.magnitude());
        let found = span.extents();
        extents = [0, 1, 2].map(|k| extents[k].max(found[k]));
    }
    let mut rest = *cell;
    for (axis, row) in relation.directions(cell).into_iter().enumerate() {
        let span = row.span::<W>(cell);
        if span.is_clear(is_last) {
            return None;
        }
        rest = rest.narrowed(axis, span.parts(axis, cell.levels_left(axis)));
    }
    // Where F does not change there is nothing to be told apart.
    let mut widest = (W::of(0), None);
    for (axis, extent) in (0..).zip(extents) {
        if extent > widest.0 && cell.levels_left(usize::from(axis)) > 0 {
            widest = (extent, Some(axis));
        }
    }
    // Values over a part are between those over the whole, in smaller units, and along a direction
    // they are larger by its size: below 2^60 if this holds, and their differences below 2^61.
    let deeper = (rest.scale() - cell.scale()).max(1);
    let room = NARROW_BITS.saturating_sub(Relation::DIRECTION_BITS + deeper);
    let is_narrow = relation.is_narrow() && magnitude < W::of(1).doubled(room);
    Some(View { rest, axis: widest.1, is_narrow })
}

fn impact(relation: &Relation, cell: &Cell, is_cut: bool) -> Impact {
    let unit = |axis| Unit::from_raw(cell.low(axis).cast_signed());
    let mut time = unit(0);
    if !is_cut && cell.is_last() && relation.is_clear_before_end(cell) {
        time = Unit::ONE;
    }
    Impact { time, weights: [unit(1), unit(2)], is_cut }
}
