//! Relaxation: projecting every distance constraint once, colour by colour.

use super::DistanceForm;
use super::correction::{Carry, Correction, Memory};
use super::link::Link;
use super::plan::Plan;

#[cfg(feature = "parallel")]
use alloc::vec::Vec;
#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// Colours with fewer links than this are not worth waking other threads for. Decided by the scene
/// alone; it changes no result in any case, since links of one colour share no movable particle.
#[cfg(feature = "parallel")]
const PARALLEL_MIN: usize = 1024;

/// What links remember from one correction to the next, each kind in the order of the slots.
#[derive(Debug)]
pub(crate) struct Memories<'a> {
    /// Of start-of-step links; state.
    pub(crate) carries: &'a mut [Carry],
    /// The lengths that compliant links have taken in this substep.
    pub(crate) taken: &'a mut [i64],
}

impl Memories<'_> {
    #[inline]
    fn get(&self, link: &Link) -> Memory {
        let place = link.memory as usize;
        match link.form {
            DistanceForm::StartOfStep => Memory { carry: self.carries[place], taken: 0 },
            _ if link.give > 0 => Memory { taken: self.taken[place], ..Memory::default() },
            _ => Memory::default(),
        }
    }

    #[inline]
    fn set(&mut self, link: &Link, Memory { carry, taken }: Memory) {
        let place = link.memory as usize;
        if link.form == DistanceForm::StartOfStep {
            self.carries[place] = carry;
        } else if link.give > 0 {
            self.taken[place] = taken;
        }
    }
}

impl Plan {
    /// One relaxation of the links that are relaxed one at a time; `start` are the positions at the
    /// start of the substep.
    pub(crate) fn relax(
        &self,
        start: &[[i64; 3]],
        position: &mut [[i64; 3]],
        mut memories: Memories<'_>,
    ) {
        for (range, independent) in self.colours() {
            relax_colour(&self.links()[range], independent, start, position, &mut memories);
        }
    }
}

#[cfg(not(feature = "parallel"))]
fn relax_colour(
    links: &[Link],
    _: bool,
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    memories: &mut Memories<'_>,
) {
    relax_serially(links, start, position, memories);
}

/// The corrections of one colour do not depend on one another, so they are computed by any number
/// of threads and then added by one.
#[cfg(feature = "parallel")]
fn relax_colour(
    links: &[Link],
    independent: bool,
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    memories: &mut Memories<'_>,
) {
    if !independent || links.len() < PARALLEL_MIN {
        return relax_serially(links, start, position, memories);
    }
    let (before, remembered): (&[_], &_) = (position, &*memories);
    let all = links.par_iter().with_min_len(256);
    let corrections: Vec<_> = all.map(|link| correction(link, start, before, remembered)).collect();
    for (link, correction) in links.iter().zip(corrections) {
        apply(link, correction, position, memories);
    }
}

fn relax_serially(
    links: &[Link],
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    memories: &mut Memories<'_>,
) {
    for link in links {
        apply(link, correction(link, start, position, memories), position, memories);
    }
}

#[inline]
fn correction(
    link: &Link,
    start: &[[i64; 3]],
    position: &[[i64; 3]],
    memories: &Memories<'_>,
) -> (Correction, Memory) {
    let [a, b] = link.ends.map(|end| end as usize);
    let mut memory = memories.get(link);
    (link.correct([start[a], start[b]], [position[a], position[b]], &mut memory), memory)
}

#[inline]
fn apply(
    link: &Link,
    (correction, memory): (Correction, Memory),
    position: &mut [[i64; 3]],
    memories: &mut Memories<'_>,
) {
    for (end, move_by) in link.ends.into_iter().zip(correction) {
        let position = &mut position[end as usize];
        for (x, dx) in position.iter_mut().zip(move_by) {
            *x += dx; // below 2^60.8, see DISTANCES_MAX
        }
    }
    memories.set(link, memory);
}
