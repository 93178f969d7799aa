//! Batches give what `Link::correct` gives, on this processor and on any.

use alloc::vec;

use super::*;
use crate::constraint::DistanceForm;
use crate::constraint::correction::Memory;
use crate::math::Pcg;
use crate::store::slot_index;

/// Release builds take a minute's worth of cases for a debug build: `cargo test --release lanes`.
const CASES: u32 = if cfg!(debug_assertions) { 8_000 } else { 800_000 };

fn gain(random: &mut Pcg) -> i32 {
    [0, 1, 1 << 29, 1 << 30, (random.next_u32() >> 2).cast_signed()][random.below(5) as usize]
}

/// More than two batches of one group, if they fall into one.
const LINKS: usize = 11;

/// A rod or rope whose length suits the difference of its ends, or not at all; or which is like the
/// others, so that they fall into one group.
fn link(random: &mut Pcg, ends: [u32; 2], places: &[Place], alike: Option<i64>) -> Link {
    let [a, b] = ends.map(|end| places[end as usize]);
    let longest = [0, 1, 2].map(|c| i64::from(b[c]) - i64::from(a[c])).map(i64::abs);
    let longest = longest.into_iter().max().unwrap_or(0);
    let length = match random.below(4) {
        0 => 1 << (13 + random.below(18)),
        1 => longest,
        2 => longest / 4 + longest / i64::from(1 + random.below(8)),
        _ => longest + i64::from(random.next_u32()) % (longest / 2 + 1) - longest / 8,
    };
    let longest = alike.unwrap_or(length).clamp(1 << 13, 1 << 30);
    let shortest =
        if random.below(if alike.is_some() { 16 } else { 3 }) == 0 { 0 } else { longest };
    let first = gain(random);
    let same = random.below(if alike.is_some() { 16 } else { 2 }) != 0;
    let gains = [first, if same { first } else { gain(random) }];
    let form = DistanceForm::DivisionFree;
    let free = [true; 2];
    Link { ends, gains, free, shortest, longest, give: 0, memory: 0, form }
}

#[test]
fn batches_do_what_single_links_do() {
    let mut random = Pcg::new(5, 0);
    let (mut moved, mut far, mut most) = (0, 0, 0);
    for _ in 0..CASES {
        let random = &mut random;
        let mut places = vec![[0; 4]; 2 * LINKS];
        for place in &mut places {
            let reach = random.below(30);
            let one = |random: &mut Pcg| (random.next_u32() >> 2).cast_signed() - (1 << 29);
            *place = [one(random) >> reach, one(random) >> reach, one(random) >> reach, 0];
        }
        if random.below(16) == 0 {
            places[1] = places[0];
        }
        let alike = (random.below(2) == 0).then(|| i64::from(random.next_u32() >> 1));
        let links: [Link; LINKS] = core::array::from_fn(|index| {
            let first = slot_index(2 * index);
            let ends = if index % 4 == 3 { [first + 1, first] } else { [first, first + 1] };
            link(random, ends, &places, alike)
        });
        let mut expected = places.clone();
        for link in &links {
            let now = link.ends.map(|end| {
                let [x, y, z, _] = places[end as usize].map(i64::from);
                [x, y, z]
            });
            let moves = link.correct(now, now, &mut Memory::default());
            for (end, by) in link.ends.into_iter().zip(moves) {
                for (c, by) in by.into_iter().enumerate() {
                    expected[end as usize][c] += i32::try_from(by).expect("a short way");
                    moved += u32::from(by != 0);
                    far += u32::from(by.abs() > 1 << 20);
                }
            }
        }
        let mut lanes = links.map(|link| Lane::of(&link, link.ends));
        for group in groups(&mut lanes) {
            let mut portable = places.clone();
            match &group {
                Group::Even(shift, batches) => {
                    most = most.max(batches.len());
                    portable::relax_even(*shift, batches, &mut portable);
                }
                Group::Uneven(shift, batches) => {
                    portable::relax_uneven(*shift, batches, &mut portable);
                }
            }
            relax(&[group], &mut places);
            assert_eq!(places, portable, "{links:?}");
        }
        assert_eq!(places, expected, "{links:?}");
    }
    assert!(moved > 10 * CASES && far > 3 * CASES, "{moved} moved, {far} of them far");
    assert_eq!(most, LINKS.div_ceil(4), "batches in a group");
}
