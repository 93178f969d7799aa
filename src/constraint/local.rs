//! Cloth in 32 bits: links of the division-free form, on positions relative to an anchor.
//!
//! A component whose particles stay near one of them needs 64 bits for that one only. The others'
//! differences from it fit 32 bits, which halves memory and doubles what a register holds; and as
//! the relaxation knows positions by their differences alone, its result is the same to the bit.
//!
//! **Nothing wraps.** Positions start within 3 2^27 of the anchor ([`Locals::gather`] refuses
//! others). A share below 1 moves an end towards the other, so within what is already there, or
//! apart by at most the rest length. The links of a colour are independent, so one colour adds at
//! most `L` (the greatest length that pushes) to the greatest coordinate, and a pass at most
//! `colours L`. After [`Cloth::passes`] passes that is at most 2^27: places are within 2^29, and
//! differences within 2^30, beyond which a single link would be projected in another way.
//!
//! Particles are dealt into *blocks* by their slots, 4,096 each. Links inside a block come first,
//! block by block, which the cache likes and which threads can share out; links between blocks come
//! after them. Which is which is a function of the slots, never of the number of threads.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::lanes::{self, Group, Lane, Place};
use super::link::Link;
use crate::math::wide::{NARROW_MAX, add, sub};
use crate::store::slot_index;

/// Fewer particles than this are not worth waking other threads for. Decided by the scene alone,
/// and without effect on the result.
#[cfg(feature = "parallel")]
const PARALLEL_MIN: usize = 4096;

/// Slots of a block, as a power of two.
const BLOCK_BITS: u32 = 12;

/// Coordinates start below this, 24 m.
const REACH: i64 = 3 << 27;

/// What the passes may add to them, 8 m.
const GROWTH: i64 = 1 << 27;

const _: () = assert!(2 * (REACH + GROWTH) <= NARROW_MAX);

/// The block of a link, or `None` if it joins two.
pub(super) fn block_of(link: &Link) -> Option<u32> {
    let mut blocks = link.movable().into_iter().flatten().map(|slot| slot >> BLOCK_BITS);
    let first = blocks.next()?;
    blocks.all(|block| block == first).then_some(first)
}

/// Links that are relaxed in 32 bits. A cache.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cloth {
    /// Those with places of their own, and last the links between them, which reach all places.
    blocks: Vec<Block>,
    /// How many have places of their own.
    inside: usize,
    /// The particles, block by block.
    members: Vec<Member>,
    /// The lowest slot of each component.
    anchors: Vec<u32>,
    passes: u32,
}

/// Links and the places that they reach.
#[derive(Clone, Debug, Default)]
struct Block {
    /// Where the particles are.
    places: Range<usize>,
    /// Colour by colour.
    groups: Vec<Group>,
}

/// A particle of a block. A pinned one is a member of every block that reads it.
#[derive(Clone, Copy, Debug)]
struct Member {
    slot: u32,
    /// Which of the anchors is its component's.
    anchor: u32,
    moves: bool,
}

/// Components have grown too large for 32 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TooFar {
    /// The lowest slots of all that have, so that one new plan does for them.
    pub(crate) anchors: BTreeSet<u32>,
}

/// The greatest length that may push, if one pass has so many colours.
pub(super) fn push_max(colours: u32) -> i64 {
    GROWTH / i64::from(colours.max(1))
}

impl Cloth {
    /// Of links with their blocks and colours, sorted by these, and the anchor of each slot's
    /// component; `colours` as for [`push_max`].
    pub(super) fn new(
        links: &[(Option<u32>, u8, Link)],
        colours: u32,
        slots: u32,
        anchor: impl FnMut(u32) -> u32,
    ) -> Self {
        let pushes = links.iter().map(|(_, _, link)| link.shortest);
        let longest = pushes.max().unwrap_or(0).max(1);
        let passes = push_max(colours) / longest;
        let mut seats = Seats::new(slots, anchor);
        let mut cloth =
            Self { passes: u32::try_from(passes).unwrap_or(u32::MAX), ..Self::default() };
        for links in links.chunk_by(|a, b| a.0 == b.0) {
            let start = if links[0].0.is_some() { seats.members.len() } else { 0 };
            let first = slot_index(start);
            seats.visitors.clear();
            let mut groups = Vec::new();
            for colour in links.chunk_by(|a, b| a.1 == b.1) {
                let lane = |(_, _, link): &(_, _, Link)| {
                    let [a, b] = [0, 1].map(|k| seats.place(link, k) - first);
                    Lane::of(link, [a, b])
                };
                let mut lanes: Vec<_> = colour.iter().map(lane).collect();
                groups.extend(lanes::groups(&mut lanes));
            }
            cloth.inside += usize::from(links[0].0.is_some());
            cloth.blocks.push(Block { places: start..seats.members.len(), groups });
        }
        let Seats { members, anchors, .. } = seats;
        Self { members, anchors, ..cloth }
    }

    /// How many passes may follow one another before positions are gathered anew, at least 1.
    pub(crate) fn passes(&self) -> u32 {
        self.passes
    }
}

/// Not a place.
const NOWHERE: u32 = u32::MAX;

/// Gives particles their places while blocks are made.
struct Seats<F> {
    members: Vec<Member>,
    anchors: Vec<u32>,
    /// The places of movable particles, by slot; [`NOWHERE`] so far.
    homes: Vec<u32>,
    /// The places of what the present block only reads.
    visitors: BTreeMap<u32, u32>,
    /// Where the anchors are in their list, by slot.
    known: Vec<u32>,
    anchor: F,
}

impl<F: FnMut(u32) -> u32> Seats<F> {
    fn new(slots: u32, anchor: F) -> Self {
        Self {
            members: Vec::new(),
            anchors: Vec::new(),
            homes: vec![NOWHERE; slots as usize],
            visitors: BTreeMap::new(),
            known: vec![NOWHERE; slots as usize],
            anchor,
        }
    }

    /// The place of an end of a link.
    fn place(&mut self, link: &Link, end: usize) -> u32 {
        let slot = link.ends[end];
        let moves = link.free[end];
        let place = if moves {
            &mut self.homes[slot as usize]
        } else {
            self.visitors.entry(slot).or_insert(NOWHERE)
        };
        if *place == NOWHERE {
            *place = slot_index(self.members.len());
            let place = *place;
            let anchor = self.anchor(slot);
            self.members.push(Member { slot, anchor, moves });
            return place;
        }
        *place
    }

    /// Which of the anchors the component of a slot has.
    fn anchor(&mut self, slot: u32) -> u32 {
        let name = (self.anchor)(slot);
        let anchor = &mut self.known[name as usize];
        if *anchor == NOWHERE {
            *anchor = slot_index(self.anchors.len());
            self.anchors.push(name);
        }
        *anchor
    }
}

/// The places of all members. Scratch.
#[derive(Debug, Default)]
pub(crate) struct Locals {
    places: Vec<Place>,
    /// The positions of the anchors when the places were gathered.
    bases: Vec<[i64; 3]>,
}

impl Locals {
    /// Reads the positions.
    ///
    /// # Errors
    /// The components that do not fit; nothing is changed then.
    pub(crate) fn gather(&mut self, cloth: &Cloth, position: &[[i64; 3]]) -> Result<(), TooFar> {
        self.bases.clear();
        self.bases.extend(cloth.anchors.iter().map(|&slot| position[slot as usize]));
        self.places.clear();
        let mut out = 0;
        self.places.extend(cloth.members.iter().map(|member| {
            let base = self.bases[member.anchor as usize];
            let [x, y, z] = sub(position[member.slot as usize], base);
            // Negative outside [-REACH, REACH).
            out |= [x, y, z].iter().fold(0, |out, c| out | (c + REACH) | (REACH - 1 - c));
            [x, y, z, 0].map(low)
        }));
        if out < 0 { Err(self.too_far(cloth, position)) } else { Ok(()) }
    }

    #[cold]
    fn too_far(&self, cloth: &Cloth, position: &[[i64; 3]]) -> TooFar {
        let far = |member: &&Member| {
            let d = sub(position[member.slot as usize], self.bases[member.anchor as usize]);
            d.iter().any(|c| !(-REACH..REACH).contains(c))
        };
        let members = cloth.members.iter().filter(far);
        TooFar { anchors: members.map(|member| cloth.anchors[member.anchor as usize]).collect() }
    }

    /// One relaxation of all links.
    pub(crate) fn relax(&mut self, cloth: &Cloth) {
        let (inside, between) = cloth.blocks.split_at(cloth.inside);
        relax_blocks(inside, &mut self.places);
        for Block { groups, .. } in between {
            lanes::relax(groups, &mut self.places);
        }
    }

    /// Writes the positions of what moves.
    pub(crate) fn scatter(&self, cloth: &Cloth, position: &mut [[i64; 3]]) {
        for (member, place) in cloth.members.iter().zip(&self.places) {
            if member.moves {
                let base = self.bases[member.anchor as usize];
                let [x, y, z, _] = place.map(i64::from);
                position[member.slot as usize] = add(base, [x, y, z]);
            }
        }
    }
}

/// Relaxes blocks that have places of their own.
#[cfg(not(feature = "parallel"))]
fn relax_blocks(blocks: &[Block], places: &mut [Place]) {
    for Block { places: own, groups } in blocks {
        lanes::relax(groups, &mut places[own.clone()]);
    }
}

/// Relaxes blocks that have places of their own: any number of threads, with the same result.
#[cfg(feature = "parallel")]
fn relax_blocks(blocks: &[Block], mut places: &mut [Place]) {
    use rayon::prelude::*;
    let mut parts = Vec::with_capacity(blocks.len());
    for Block { places: own, groups } in blocks {
        let (part, rest) = places.split_at_mut(own.len());
        parts.push((groups, part));
        places = rest;
    }
    if parts.len() < 2 || parts.iter().map(|(_, part)| part.len()).sum::<usize>() < PARALLEL_MIN {
        return parts.into_iter().for_each(|(groups, part)| lanes::relax(groups, part));
    }
    parts.into_par_iter().for_each(|(groups, part)| lanes::relax(groups, part));
}

/// The low half; of a place that is in range, all of it.
#[inline]
fn low(v: i64) -> i32 {
    let [low @ .., _, _, _, _] = v.to_le_bytes();
    i32::from_le_bytes(low)
}
