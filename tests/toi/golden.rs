//! The same times on every machine.

use verlock::Hash;
use verlock::geometry::sweep::Sweep;
use verlock::math::Pcg;

use super::{CLASSES, sweep};

#[test]
fn times_are_as_accepted() {
    let mut bytes = Vec::new();
    let options = Sweep { work_max: 256, ..Sweep::default() };
    for (stream, class) in (0..).zip(CLASSES) {
        let mut rng = Pcg::new(stream, 105);
        for round in 0..60 {
            let size = [9, 1 << 20, 1 << 24, 1 << 41, 1 << 57][rng.below(5) as usize];
            let corners = class.corners(&mut rng, size);
            match sweep(&options, &corners, round % 2 == 0) {
                None => bytes.push(0),
                Some(impact) => {
                    bytes.push(1 + u8::from(impact.is_cut));
                    let [u, v] = impact.weights;
                    let raw = [impact.time, u, v].map(|fraction| fraction.raw().to_le_bytes());
                    bytes.extend(raw.concat());
                }
            }
        }
    }
    assert_eq!(Hash::of(&bytes).to_string(), "34d742d1467764f3061156729d815cff");
}
