//! Every pair of convex shapes, in random poses.

use verlock::collision::{Shape, manifold_convex_convex};
use verlock::geometry::Capsule;
use verlock::{Real, Vec3, real};

use super::draw::{Draw, Kind, METRE, anchor, mapped, raw, twin};
use super::{check, float, twin::gap};

/// How large shapes are, metres.
const SCALES: [f64; 4] = [0.5, 0.02, 15.0, 6000.0];

/// A random pair, often close to touching.
fn pair(draw: &mut Draw, kinds: [Kind; 2], size: f64) -> [Shape; 2] {
    let a = draw.shape(kinds[0], [0.0; 3], size);
    let center = draw.within(1.5 * size);
    let b = draw.shape(kinds[1], center, size);
    if draw.below(3) == 0 {
        return [a, b];
    }
    let Some(found) = manifold_convex_convex(&a, &b, real!("16384")) else { return [a, b] };
    let origin = anchor(&a);
    let apart = gap(&twin(&a, origin), &twin(&b, origin));
    let way = float(found.normal).map(|c| c * (0.02 * size * draw.number() - apart));
    let b = mapped(&b, |point| point + raw(way));
    [a, b]
}

fn agree(kinds: [Kind; 2], seed: u64, pairs: usize) {
    println!("{kinds:?}");
    let mut draw = Draw::new(seed);
    let (mut touching, mut strays) = (0, 0);
    for k in 0..pairs {
        let size = SCALES[k % SCALES.len()];
        let [a, b] = pair(&mut draw, kinds, size);
        let margin = Real::from_raw((size * 0.05 * METRE * draw.number().abs()) as i64);
        let found = manifold_convex_convex(&a, &b, margin);
        let origin = anchor(&a);
        let twins = [&a, &b].map(|shape| twin(shape, origin));
        strays += check(found.as_ref(), twins.each_ref(), origin, margin);
        touching += usize::from(found.is_some());
    }
    assert!(strays <= 1 + pairs / 10_000, "{strays} contacts beside shapes");
    assert!(touching > pairs / 5 && touching < pairs, "{kinds:?}: {touching} of {pairs}");
}

/// Capsules side by side touch at both ends, but only where they are beside one another: seen from
/// above these cross.
#[test]
fn crossing_capsules_touch_in_one_point() {
    let capsule = |y: Real, z: Real| -> Shape {
        let ends = [Vec3::new(real!("-1"), y, -z), Vec3::new(real!("1"), y, z)];
        Capsule::new(ends, real!("0.125")).expect("in range").into()
    };
    let below = capsule(Real::ZERO, Real::ZERO);
    for (z, contacts) in [("0", 2), ("0.003", 2), ("0.006", 1), ("0.02", 1), ("0.5", 1)] {
        let above = capsule(real!("0.25"), Real::parse(z).expect("a number"));
        let found = manifold_convex_convex(&below, &above, real!("0.01")).expect("they touch");
        assert_eq!(found.contacts().len(), contacts, "{z}");
        assert_eq!(found.separation(), Real::ZERO);
        for contact in found.contacts() {
            assert_eq!(contact.on_b - contact.on_a, Vec3::ZERO, "{z}");
        }
    }
}

fn for_kinds(mut law: impl FnMut([Kind; 2])) {
    for a in Kind::ALL {
        for b in Kind::ALL {
            if [a, b] != [Kind::HalfSpace; 2] {
                law([a, b]);
            }
        }
    }
}

#[test]
fn manifolds_are_those_of_the_twin() {
    for_kinds(|kinds| agree(kinds, 5, 200));
}

#[test]
#[ignore = "a million poses of each of 35 pairs: an hour"]
fn a_million_manifolds_of_every_pair_are_those_of_the_twin() {
    let pairs = 1_000_000;
    for_kinds(|kinds| agree(kinds, 6, pairs));
}
