//! Both widths of both forms give the same bits wherever both apply.

use super::*;
use crate::math::Pcg;
use crate::math::wide::NARROW_MAX;

/// Release builds take a minute's worth of cases for a debug build: `cargo test --release widths`.
const CASES: u32 = if cfg!(debug_assertions) { 100_000 } else { 10_000_000 };

/// A component of any magnitude up to exactly 2^30, either sign.
fn component(random: &mut Pcg) -> i64 {
    let sign = if random.below(2) == 0 { 1 } else { -1 };
    sign * match random.below(8) {
        0 => 0,
        1 => NARROW_MAX,
        _ => i64::from(random.next_u32() >> 2 >> random.below(30)),
    }
}

fn vector(random: &mut Pcg) -> [i64; 3] {
    [(); 3].map(|()| component(random))
}

fn gain(random: &mut Pcg) -> i32 {
    [0, 1, 1 << 29, 1 << 30, (random.next_u32() >> 2).cast_signed()][random.below(5) as usize]
}

fn rod(gains: [i32; 2], length: i64, form: DistanceForm) -> Link {
    let (shortest, longest) = (length, length);
    let free = [true; 2];
    Link { ends: [0, 1], gains, free, shortest, longest, give: 0, memory: 0, form }
}

/// A vector a little off another one, within the range.
fn near(random: &mut Pcg, v: [i64; 3]) -> [i64; 3] {
    let reach = v.map(i64::abs).into_iter().max().unwrap_or(0) >> random.below(12);
    let mut off = || if reach == 0 { 0 } else { i64::from(random.next_u32()) % reach - reach / 2 };
    v.map(|c| (c + off()).clamp(-NARROW_MAX, NARROW_MAX))
}

/// Rest lengths from far off down to the thresholds of the guard and to the length itself.
fn rest_length(random: &mut Pcg, d: [i64; 3], r: [i64; 3]) -> i64 {
    let length = |sq: i64| root_nearest(sq.unsigned_abs()).cast_signed();
    let (own, along) = (dot_narrow(d, d), dot_narrow(d, r));
    let wobble = i64::from(random.below(5)) - 2;
    let rest = match random.below(8) {
        0 => component(random).abs(),
        1 => NARROW_MAX,
        // 16 |L^2 - d.d| = 5 L^2: L^2 = 16/11 or 16/21 d.d
        2 => length(own / 11 * 16) + wobble,
        3 => length(own / 21 * 16) + wobble,
        // 16 d.r = 11 L^2, and r.r = 2 L^2
        4 => length(along.abs() / 11 * 16) + wobble,
        5 => length(dot_narrow(r, r) / 2) + wobble,
        _ => length(own) + wobble,
    };
    rest.clamp(1, NARROW_MAX)
}

/// Random links, and how many took the way along the start of the substep.
#[test]
fn both_widths_give_the_same_bits() {
    let mut random = Pcg::new(11, 0);
    let mut along_start = 0;
    for _ in 0..CASES {
        let random = &mut random;
        let d = vector(random);
        let r = if random.below(4) == 0 { vector(random) } else { near(random, d) };
        let gain_a = gain(random);
        let gains = [gain_a, if random.below(2) == 0 { gain_a } else { gain(random) }];
        let rest_length = rest_length(random, d, r);
        let slack = [0, 0, rest_length / 3, rest_length][random.below(4) as usize];
        let give = [0, 0, 1 << 10, 1 << 40][random.below(4) as usize];
        let taken = i64::from(random.next_u32()) << random.below(12);
        let mut half = || to_i16(i64::from(random.next_u32() >> 17)) - CARRY_MAX;
        let carry = [(); 3].map(|()| half());
        // Equal gains have equal carries.
        let before = [carry, if gains[0] == gains[1] { carry } else { [half(), half(), 0] }];
        let [exact, start] = [DistanceForm::Exact, DistanceForm::StartOfStep].map(|form| {
            let give = if form == DistanceForm::Exact { give } else { 0 };
            let link = Link { give, ..rod(gains, rest_length, form) };
            let link = Link { shortest: rest_length - slack, ..link };
            let mut memory = Memory { carry: before, taken };
            let mut wide_memory = memory;
            let narrow = link.narrow(d, r, &mut memory);
            let wide = link.wide(d, r, &mut wide_memory);
            assert_eq!((narrow, memory), (wide, wide_memory), "{link:?}, d {d:?}, r {r:?}");
            narrow
        });
        along_start += u32::from(exact != start);
    }
    assert!(along_start > CASES / 20, "only {along_start} cases passed the guard");
}

/// The border between the widths: one unit beyond it the other width answers, alike.
#[test]
fn the_border_shows_in_no_result() {
    for form in [DistanceForm::Exact, DistanceForm::StartOfStep] {
        let link = rod([1 << 29; 2], NARROW_MAX, form);
        let moved = [-4, 0, 4, 8].map(|beyond| {
            let b = [NARROW_MAX + beyond, 0, 0];
            let [a, b] = link.correct([[0; 3], b], [[0; 3], b], &mut Memory::default());
            assert_eq!(a.map(|c| -c), b);
            b[0]
        });
        // Half of what it is off, towards the rest length.
        assert_eq!(moved, [2, 0, -2, -4], "{form:?}");
    }
}

/// Ends that coincide have no direction.
#[test]
fn coincident_ends_stay() {
    let link = rod([1 << 30; 2], 1, DistanceForm::Exact);
    for place in [[0; 3], [1 << 60, -(1 << 60), 7]] {
        assert_eq!(link.correct([place; 2], [place; 2], &mut Memory::default()), [[0; 3]; 2]);
    }
}
