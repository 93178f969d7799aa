//! Relaxation: projecting every distance constraint once, colour by colour.

use super::correction::{Carry, Correction, Link};
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
    /// One relaxation of the positions; `start` are the positions at the start of the substep,
    /// `carries` belong to the links.
    pub(crate) fn relax(
        &self,
        start: &[[i64; 3]],
        position: &mut [[i64; 3]],
        carries: &mut [Carry],
    ) {
        for (range, independent) in self.colours() {
            let links = &self.links()[range.clone()];
            relax_colour(links, independent, start, position, &mut carries[range]);
        }
    }
}

#[cfg(not(feature = "parallel"))]
fn relax_colour(
    links: &[Link],
    _: bool,
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    carries: &mut [Carry],
) {
    relax_serially(links, start, position, carries);
}

/// The corrections of one colour do not depend on one another, so they are computed by any number
/// of threads and then added by one.
#[cfg(feature = "parallel")]
fn relax_colour(
    links: &[Link],
    independent: bool,
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    carries: &mut [Carry],
) {
    if !independent || links.len() < PARALLEL_MIN {
        return relax_serially(links, start, position, carries);
    }
    let before: &[[i64; 3]] = position;
    let all = links.par_iter().zip(carries).with_min_len(256);
    let corrections: Vec<Correction> =
        all.map(|(link, carry)| correction(link, start, before, carry)).collect();
    for (link, correction) in links.iter().zip(corrections) {
        apply(link, correction, position);
    }
}

fn relax_serially(
    links: &[Link],
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    carries: &mut [Carry],
) {
    for (link, carry) in links.iter().zip(carries) {
        apply(link, correction(link, start, position, carry), position);
    }
}

#[inline]
fn correction(
    link: &Link,
    start: &[[i64; 3]],
    position: &[[i64; 3]],
    carry: &mut Carry,
) -> Correction {
    let [a, b] = link.ends.map(|end| end as usize);
    link.correct([start[a], start[b]], [position[a], position[b]], carry)
}

#[inline]
fn apply(link: &Link, correction: Correction, position: &mut [[i64; 3]]) {
    for (end, move_by) in link.ends.into_iter().zip(correction) {
        let position = &mut position[end as usize];
        for (x, dx) in position.iter_mut().zip(move_by) {
            *x += dx; // below 2^60.8, see DISTANCES_MAX
        }
    }
}
