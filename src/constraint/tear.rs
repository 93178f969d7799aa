//! Distances that take damage.

use super::distance::{Distance, DistanceId};
use crate::math::root::root_nearest_wide;
use crate::math::wide::{dot_wide, round_div_wide, round_shift_wide, sub, to_i32, to_i64};
use crate::math::{Factor, Real};
use crate::particle::{Particle, ParticleId};
use crate::store::Table;

/// A distance that can tear, with what decides at a glance whether it does. A cache.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tearable {
    pub(crate) id: DistanceId,
    ends: [u32; 2],
    /// The square of the greatest length that does no damage, less than 2^102.
    harmless_sq: i128,
}

/// What the damage of a tick did.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Tear {
    /// It has this damage now and holds.
    Worn(Factor),
    /// It broke, with this damage.
    Broken(Factor),
}

impl Tearable {
    /// All of a world that are enabled, and their ends too.
    pub(crate) fn all(
        distances: &Table<Distance>,
        particles: &Table<Particle>,
    ) -> impl Iterator<Item = Self> {
        let enabled = |id: ParticleId| particles.get(id.0).is_some_and(|end| end.enabled);
        let tears = move |(_, distance): &(_, &Distance)| {
            let Distance { a, b, enabled: itself, tear_strain, .. } = **distance;
            itself && tear_strain > Factor::ZERO && enabled(a) && enabled(b)
        };
        distances.iter().filter(tears).map(|(handle, distance)| {
            let Distance { a, b, rest_length, tear_strain, .. } = *distance;
            let one_and_strain = i128::from(Factor::ONE.raw()) + i128::from(tear_strain.raw());
            // 34 + 32 bits, 16 of them gone.
            let harmless = round_shift_wide(i128::from(rest_length.raw()) * one_and_strain, 16);
            let ends = [a.0.index, b.0.index];
            Self { id: DistanceId(handle), ends, harmless_sq: harmless * harmless }
        })
    }

    /// The damage of a tick that ends with these positions, if any.
    #[inline]
    pub(crate) fn tear(&self, distance: &Distance, position: &[[i64; 3]]) -> Option<Tear> {
        let [a, b] = self.ends.map(|end| position[end as usize]);
        let length_sq = dot_wide(sub(b, a), sub(b, a));
        (length_sq > self.harmless_sq).then(|| wear(distance, length_sq))
    }
}

/// Adds the strain above what does no damage to the damage, at least the least step, so that a
/// toughness of 0 breaks at once. Damage ends at the greatest number.
#[cold]
fn wear(distance: &Distance, length_sq: i128) -> Tear {
    let rest = i128::from(distance.rest_length.raw());
    let length = root_nearest_wide(length_sq.cast_unsigned()).cast_signed(); // below 2^63
    let strain = round_div_wide((length - rest) << 16, rest);
    let excess = (strain - i128::from(distance.tear_strain.raw())).max(1);
    let damage = i128::from(distance.damage.raw()) + excess;
    let damage = Factor::from_raw(to_i32(to_i64(damage.min(i128::from(i32::MAX)))));
    if damage > distance.toughness { Tear::Broken(damage) } else { Tear::Worn(damage) }
}

/// Nothing is longer, so that squares fit: `1,024 m * 32,768` is 2^49 raw units.
const _: () = assert!(Distance::REST_LENGTH_MAX.raw() <= Real::ONE.raw() << 10);

#[cfg(test)]
mod tests {
    use super::*;

    /// A strain that rounds to the threshold does the least damage all the same.
    #[test]
    fn the_least_excess_is_damage() {
        let ids = [ParticleId::default(); 2];
        let tear_strain = Factor::from_raw(Factor::ONE.raw() / 2);
        let rod = Distance::new(ids[0], ids[1], Real::ONE).tear_strain(tear_strain);
        let least = Factor::from_raw(1);
        let length = i128::from(Real::ONE.raw()) * 3 / 2 + 1;
        assert_eq!(wear(&rod, length * length), Tear::Broken(least));
        let tough = Distance { toughness: least, ..rod };
        assert_eq!(wear(&tough, length * length), Tear::Worn(least));
    }
}
