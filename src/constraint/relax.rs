//! Relaxation: projecting every distance constraint once, colour by colour.

use super::correction::{Carry, Correction, Link};
use super::distance::DistanceForm;
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
    pub(crate) fn relax(
        &self,
        start: &[[i64; 3]],
        position: &mut [[i64; 3]],
        carries: &mut [Carry],
    ) {
        for (range, independent) in self.colours() {
            relax_colour(&self.links()[range], independent, start, position, carries);
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
    let (before, carried): (&[_], &[_]) = (position, carries);
    let corrections: Vec<_> = links
        .par_iter()
        .with_min_len(256)
        .map(|link| correction(link, start, before, carried))
        .collect();
    for (link, correction) in links.iter().zip(corrections) {
        apply(link, correction, position, carries);
    }
}

fn relax_serially(
    links: &[Link],
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    carries: &mut [Carry],
) {
    for link in links {
        apply(link, correction(link, start, position, carries), position, carries);
    }
}

#[inline]
fn correction(
    link: &Link,
    start: &[[i64; 3]],
    position: &[[i64; 3]],
    carries: &[Carry],
) -> (Correction, Carry) {
    let [a, b] = link.ends.map(|end| end as usize);
    let mut carry = match link.form {
        DistanceForm::Exact => Carry::default(),
        DistanceForm::StartOfStep => carries[link.carry as usize],
    };
    (link.correct([start[a], start[b]], [position[a], position[b]], &mut carry), carry)
}

#[inline]
fn apply(
    link: &Link,
    (correction, carry): (Correction, Carry),
    position: &mut [[i64; 3]],
    carries: &mut [Carry],
) {
    for (end, move_by) in link.ends.into_iter().zip(correction) {
        let position = &mut position[end as usize];
        for (x, dx) in position.iter_mut().zip(move_by) {
            *x += dx; // below 2^60.8, see DISTANCES_MAX
        }
    }
    if link.form == DistanceForm::StartOfStep {
        carries[link.carry as usize] = carry;
    }
}
