//! Manifolds as they were accepted: the same on every machine.

use verlock::Hash;
use verlock::collision::{Manifold, manifold_convex_convex};
use verlock::math::Real;

use super::draw::{Draw, Kind, METRE};

fn bytes(found: &Manifold) -> Vec<u8> {
    let mut numbers = found.normal.raw().to_vec();
    for contact in found.contacts() {
        numbers.extend(contact.features.map(|feature| i64::from(feature.bits())));
        numbers.extend([contact.on_a, contact.on_b].into_iter().flat_map(|point| point.raw()));
        numbers.push(contact.separation.raw());
    }
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// Drawn by sums, products, quotients and roots, which IEEE 754 rounds alike everywhere.
#[test]
fn manifolds_are_as_accepted() {
    let mut draw = Draw::new(8);
    let (mut all, mut points) = (vec![], 0);
    for k in 0..3_000 {
        let size = [0.5, 20.0, 5000.0][k % 3];
        let [a, b] = [(); 2].map(|()| Kind::ALL[1 + draw.below(5) as usize]);
        let center = draw.within(0.5 * size);
        let [a, b] = [draw.shape(a, [0.0; 3], size), draw.shape(b, center, size)];
        let margin = Real::from_raw((0.01 * size * METRE) as i64);
        if let Some(found) = manifold_convex_convex(&a, &b, margin) {
            all.extend(bytes(&found));
            points += found.contacts().len();
        }
    }
    let expected = ("25ecbeb95b40ed41642fadf5942201a8", 3_702);
    assert_eq!((Hash::of(&all).to_string().as_str(), points), expected);
}
