//! The same bytes on every machine.

use verlock::collision::{cast, closest_points};
use verlock::math::Pcg;
use verlock::{Hash, Vec3};

use super::{CLASSES, Draw, kinds};

#[test]
fn distances_and_casts_are_as_accepted() {
    let mut bytes = Vec::new();
    let mut keep = |v: Vec3| v.raw().iter().for_each(|c| bytes.extend(c.to_le_bytes()));
    for (index, (unit, most)) in (0..).zip(CLASSES) {
        let mut draw = Draw { rng: Pcg::new(index, 41), unit, most };
        for kinds in kinds() {
            let [a, b] = draw.pair(kinds);
            if let Some(found) = closest_points(&a, &b) {
                keep(found.on_a);
                keep(found.on_b);
                keep(Vec3::from_raw(found.normal.raw()));
                let parts = [found.part_a, found.part_b].map(i64::from);
                keep(Vec3::from_raw([found.distance.raw(), parts[0], parts[1]]));
            }
            if let Some(found) = cast(&a, draw.way(most), &b) {
                let parts = [found.part_a, found.part_b].map(i64::from);
                keep(Vec3::from_raw([found.time.raw().into(), parts[0], parts[1]]));
                if let Some(touch) = found.touch {
                    keep(touch.position);
                    keep(Vec3::from_raw(touch.normal.raw()));
                }
            }
        }
    }
    assert_eq!(Hash::of(&bytes).to_string(), "6a42f59dd88088e5d1bddcdb57798446");
}
