//! Relaxation: projecting every distance constraint once, colour by colour.

use super::correction::{Correction, Link};
use super::plan::Plan;

#[cfg(feature = "parallel")]
use alloc::vec::Vec;
#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// Colours with fewer links than this are not worth waking other threads for. Decided by the scene
/// alone; it changes no result in any case, since links of one colour share no movable particle.
#[cfg(feature = "parallel")]
const PARALLEL_MIN: usize = 1024;

impl Plan {
    /// One relaxation of the positions; `start` are the positions at the start of the substep.
    pub(crate) fn relax(&self, start: &[[i64; 3]], position: &mut [[i64; 3]]) {
        for (links, independent) in self.colours() {
            relax_colour(links, independent, start, position);
        }
    }
}

#[cfg(not(feature = "parallel"))]
fn relax_colour(links: &[Link], _: bool, start: &[[i64; 3]], position: &mut [[i64; 3]]) {
    relax_serially(links, start, position);
}

/// The corrections of one colour do not depend on one another, so they are computed by any number
/// of threads and then added by one.
#[cfg(feature = "parallel")]
fn relax_colour(links: &[Link], independent: bool, start: &[[i64; 3]], position: &mut [[i64; 3]]) {
    if !independent || links.len() < PARALLEL_MIN {
        return relax_serially(links, start, position);
    }
    let before: &[[i64; 3]] = position;
    let corrections: Vec<Correction> =
        links.par_iter().with_min_len(256).map(|link| correction(link, start, before)).collect();
    for (link, correction) in links.iter().zip(corrections) {
        apply(link, correction, position);
    }
}

fn relax_serially(links: &[Link], start: &[[i64; 3]], position: &mut [[i64; 3]]) {
    for link in links {
        apply(link, correction(link, start, position), position);
    }
}

#[inline]
fn correction(link: &Link, start: &[[i64; 3]], position: &[[i64; 3]]) -> Correction {
    let [a, b] = link.ends.map(|end| end as usize);
    link.correct([start[a], start[b]], [position[a], position[b]])
}

#[inline]
fn apply(link: &Link, correction: Correction, position: &mut [[i64; 3]]) {
    for (end, move_by) in link.ends.into_iter().zip(correction) {
        let position = &mut position[end as usize];
        for (x, dx) in position.iter_mut().zip(move_by) {
            *x += dx; // below 2^61.2, see DISTANCES_MAX
        }
    }
}
