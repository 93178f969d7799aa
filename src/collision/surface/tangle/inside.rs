//! The vertices of a surface that are inside another one.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::contour::Knot;
use super::groups::Groups;
use crate::collision::{FeatureId, FeatureKind};
use crate::geometry::{Surface, orient3d};
use crate::math::wide::{dot_wide, sub};

/// A knot on an edge, on the way from its lower vertex to the higher one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Piercing {
    edge: u32,
    /// How far along the edge.
    along: i128,
    knot: u32,
    /// Whether the edge goes in there, or out; neither if it only runs through an edge.
    enters: Option<bool>,
}

/// The vertices inside, each with its number among the groups, and those yet to be left.
struct Flood<'a> {
    groups: &'a mut Groups,
    numbers: BTreeMap<u32, u32>,
    open: Vec<u32>,
}

/// The vertices of `own` that are inside `other`, with the numbers that they are given in `groups`,
/// where they join the knots around them; `k` is 0 if `own` is A, 1 if it is B.
///
/// An edge that goes in at a knot ends inside, or comes out at the next knot. From the vertices so
/// found inside are all others that edges without knots lead to.
pub(super) fn inside<S: Surface, T: Surface>(
    (own, other, k): (&S, &T, usize),
    knots: &[Knot],
    groups: &mut Groups,
) -> BTreeMap<u32, u32> {
    let piercings = piercings((own, other, k), knots);
    let mut flood = Flood { groups, numbers: BTreeMap::new(), open: Vec::new() };
    for same in piercings.chunk_by(|one, next| one.edge == next.edge) {
        let [low, high] = own.ends(same[0].edge);
        if let Some(first) = same.first().filter(|first| first.enters == Some(false)) {
            flood.reach(low, first.knot);
        }
        if let Some(last) = same.last().filter(|last| last.enters == Some(true)) {
            flood.reach(high, last.knot);
        }
        for pair in same.windows(2) {
            if [pair[0].enters, pair[1].enters] == [Some(true), Some(false)] {
                flood.groups.join(pair[0].knot, pair[1].knot);
            }
        }
    }
    // Where a vertex is a knot itself, beyond it may be outside.
    let mut dams: Vec<FeatureId> = knots.iter().map(|knot| knot.features[k]).collect();
    dams.sort_unstable();
    while let Some(vertex) = flood.open.pop() {
        if dams.binary_search(&FeatureId::vertex(vertex)).is_ok() {
            continue;
        }
        let number = flood.numbers[&vertex];
        for face in own.faces_at_vertex(vertex) {
            for edge in own.sides(face) {
                let ends = own.ends(edge);
                let end = ends.into_iter().find(|&end| end != vertex);
                let is_free = dams.binary_search(&FeatureId::edge(edge)).is_err();
                if let Some(end) = end.filter(|_| ends.contains(&vertex) && is_free) {
                    flood.reach(end, number);
                }
            }
        }
    }
    flood.numbers
}

impl Flood<'_> {
    /// A vertex is inside, in the group of this number.
    fn reach(&mut self, vertex: u32, from: u32) {
        let Self { groups, numbers, open } = self;
        let number = *numbers.entry(vertex).or_insert_with(|| {
            open.push(vertex);
            groups.push()
        });
        groups.join(number, from);
    }
}

/// All knots on edges of `own`, along every edge.
fn piercings<S: Surface, T: Surface>(
    (own, other, k): (&S, &T, usize),
    knots: &[Knot],
) -> Vec<Piercing> {
    let on_edges =
        (0..).zip(knots).filter(|(_, knot)| knot.features[k].kind() == FeatureKind::Edge);
    let mut piercings: Vec<_> = on_edges
        .map(|(number, knot)| {
            let edge = knot.features[k].index();
            let [low, high] = own.ends(edge).map(|end| own.position(end));
            let [a, b, c] = *other.triangle(knot.faces[1 - k]).corners();
            let enters = match orient3d(a, b, c, high) {
                _ if knot.features[1 - k].kind() != FeatureKind::Face => None,
                Ordering::Less => Some(true),
                Ordering::Greater => Some(false),
                // It ends in the plane.
                Ordering::Equal => Some(orient3d(a, b, c, low) == Ordering::Greater),
            };
            let (way, part) = (sub(high.raw(), low.raw()), sub(knot.position.raw(), low.raw()));
            Piercing { edge, along: dot_wide(way, part), knot: number, enters }
        })
        .collect();
    piercings.sort_unstable();
    piercings
}
