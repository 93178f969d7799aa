//! Which planes divide space.

use alloc::vec::Vec;

use super::plane::{Plane, Side, Span};

/// Something that planes should not cut, and a plane that may be used.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<const D: usize> {
    pub(super) span: Span<D>,
    pub(super) plane: Plane<D>,
}

/// A part of space, or a leaf if it is not divided. Nodes stand depth first: the part behind the
/// plane comes next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node<const D: usize> {
    pub(super) plane: Option<Plane<D>>,
    /// The part before the plane.
    pub(super) front: u32,
    /// The first node that is not inside.
    pub(super) end: u32,
}

/// No part is divided more often, whatever the pieces are.
const DEPTH_MAX: u32 = 64;

/// Parts with no more pieces are not divided.
const PIECES_MAX: usize = 4;

/// So many planes are tried for a part, evenly spread over its pieces.
const TRIES: usize = 16;

/// A piece that is cut counts as much as so many that are on one side too many.
const ACROSS_COST: usize = 8;

/// A tree that divides these pieces. O(n) for each level; fewer than twice as many nodes as pieces,
/// or one, since every leaf has a piece, and one that lies across a plane has no further say.
pub(super) fn build<const D: usize>(pieces: &[Piece<D>]) -> Vec<Node<D>> {
    let mut nodes = Vec::new();
    divide(pieces, DEPTH_MAX, &mut nodes);
    nodes
}

fn divide<const D: usize>(pieces: &[Piece<D>], depth: u32, nodes: &mut Vec<Node<D>>) {
    let index = nodes.len();
    let plane = if depth == 0 { None } else { choose(pieces) };
    nodes.push(Node { plane, front: 0, end: 0 });
    if let Some(plane) = plane {
        let on = |side: Side| -> Vec<_> {
            pieces.iter().filter(|piece| plane.side(&piece.span) == side).copied().collect()
        };
        divide(&on(Side::Behind), depth - 1, nodes);
        nodes[index].front = count(nodes);
        divide(&on(Side::Front), depth - 1, nodes);
    }
    nodes[index].end = count(nodes);
}

/// There are no more nodes than twice the ids or faces.
fn count<T>(list: &[T]) -> u32 {
    u32::try_from(list.len()).unwrap_or(u32::MAX)
}

/// The plane of least `|front - behind| + 8 across`, the first of equals; `None` if all leave a
/// side empty, or there are few pieces.
fn choose<const D: usize>(pieces: &[Piece<D>]) -> Option<Plane<D>> {
    if pieces.len() <= PIECES_MAX {
        return None;
    }
    let stride = pieces.len().div_ceil(TRIES);
    let planes = pieces.iter().step_by(stride).map(|piece| piece.plane);
    let scored = planes.filter_map(|plane| {
        let sides = || pieces.iter().map(|piece| plane.side(&piece.span));
        let [behind, front] = [Side::Behind, Side::Front]
            .map(|wanted| sides().filter(|&side| side == wanted).count());
        let across = pieces.len() - behind - front;
        let cost = front.abs_diff(behind) + ACROSS_COST * across;
        (behind > 0 && front > 0).then_some((cost, plane))
    });
    scored.min_by_key(|&(cost, _)| cost).map(|(_, plane)| plane)
}
