//! Landing before a contact, over and over again from where the last step has ended.

use verlock::geometry::sweep::{Motion, Sweep};
use verlock::geometry::{Triangle, overlap_triangle_triangle};
use verlock::math::{Pcg, Unit};
use verlock::{Real, Vec3};

use super::number;

/// How two triangles are pushed about.
#[derive(Clone, Copy, Debug)]
struct Push {
    /// How long they are, raw.
    size: i64,
    /// How far their corners move in a step, each on its own.
    own: i64,
    /// How far they move towards one another.
    common: i64,
    gap: i64,
}

const PUSHES: [Push; 6] = [
    Push { size: 1 << 20, own: 1 << 10, common: 1 << 18, gap: 2 },
    Push { size: 1 << 24, own: 1 << 22, common: 1 << 24, gap: 2 },
    Push { size: 1 << 24, own: 0, common: 1 << 19, gap: 1 << 15 },
    Push { size: 40, own: 3, common: 9, gap: 2 },
    Push { size: 1 << 20, own: 1 << 18, common: 1 << 20, gap: 0 },
    Push { size: 1 << 34, own: 1 << 28, common: 1 << 33, gap: 2 },
];

fn moved(triangle: &Triangle, mut by: impl FnMut() -> [i64; 3]) -> Triangle {
    let corner = |corner: Vec3| corner + Vec3::from_raw(by());
    Triangle::new(triangle.corners().map(corner)).expect("in range")
}

/// Steps from a random start; returns how many ended before their time.
fn run(push: Push, seed: u64, steps: u32) -> u32 {
    let sweep = Sweep { gap: Real::from_raw(push.gap), ..Sweep::default() };
    let mut rng = Pcg::new(seed, 11);
    let mut stopped = 0;
    let origin = Triangle::new([Vec3::ZERO; 3]).expect("in range");
    let mut pair = [origin; 2];
    for step in 0..steps {
        if step % 16 == 0 {
            // Somewhere else, side by side: sometimes with no more than the gap between.
            pair = [origin; 2]
                .map(|triangle| moved(&triangle, || [(); 3].map(|()| number(&mut rng, push.size))));
            let [a, b] = pair.map(|triangle| triangle.bounds());
            let beside = (a.max().x - b.min().x).raw() + push.gap + 1;
            let away = beside + number(&mut rng, push.common).max(0);
            pair[1] = moved(&pair[1], || [away, 0, 0]);
        }
        let [a, b] = pair;
        let way = |k: usize| b.corners()[0].raw()[k] - a.corners()[0].raw()[k];
        // Towards one another, and a little to the side.
        let towards = [0, 1, 2]
            .map(|k| way(k).clamp(-push.common, push.common) + number(&mut rng, push.common / 4));
        let end_a = moved(&a, || [0, 1, 2].map(|k| towards[k] + number(&mut rng, push.own)));
        let end_b = moved(&b, || [(); 3].map(|()| number(&mut rng, push.own)));
        let motions = [Motion::new(a, end_a), Motion::new(b, end_b)];
        let time = sweep.advance_triangle_triangle(motions[0], motions[1]);
        let impact = sweep.triangle_triangle(motions[0], motions[1]);
        match impact {
            None => assert_eq!(time, Unit::ONE),
            Some(impact) => assert!(time <= impact.time, "{motions:?}"),
        }
        let landed = motions.map(|motion| motion.at(time));
        assert!(!overlap_triangle_triangle(&landed[0], &landed[1]), "{push:?} {motions:?} {time}");
        if push.gap >= 2 {
            // Rounded, the way there is free as well.
            let ways = [Motion::new(a, landed[0]), Motion::new(b, landed[1])];
            let met = Sweep::default().triangle_triangle(ways[0], ways[1]);
            let is_small = push.size <= 1 << 24;
            assert!(met.is_none() || !is_small, "{push:?} {motions:?} {time}: {met:?}");
        }
        stopped += u32::from(time < Unit::ONE);
        pair = landed;
    }
    stopped
}

fn all(seed: u64, steps: u32) {
    for push in PUSHES {
        let stopped = run(push, seed, steps);
        println!("{push:?}: {stopped} of {steps} stopped");
        assert!(stopped > steps / 20, "{push:?}: {stopped} of {steps} stopped");
    }
}

#[test]
fn triangles_land_apart() {
    all(1, 300);
}

#[test]
#[ignore = "a million steps: a minute or two with --release"]
fn triangles_land_apart_a_million_times() {
    all(2, 1_000_000 / 6 + 1);
}
