//! The relaxation's working copy of the constraints: a cache.

use alloc::collections::BTreeSet;
use alloc::vec::Vec;
use core::ops::Range;

use super::colour::{OVERFLOW, colour};
use super::component::Components;
use super::distance::{Distance, DistanceForm};
use super::link::Link;
use super::local::{Cloth, TooFar, block_of, push_max};
use crate::particle::Particle;
use crate::store::{Table, slot_index};

/// All active distance constraints.
///
/// A function of the constraints, of the particles' properties and of the substeps per second,
/// rebuilt when one of them changes. **The order of the relaxation**: links inside a block of slots
/// (`local.rs`) before links between blocks; among each by colour, then by slot.
///
/// Components of which every link suits are relaxed in 32 bits, the others one link at a time. No
/// link leads from the ones to the others, so their order does not matter, and which is which
/// changes no result.
#[derive(Clone, Debug, Default)]
pub(crate) struct Plan {
    /// The links that are relaxed one at a time.
    links: Vec<Link>,
    /// Where each colour ends in `links`, and whether no two of its links share a movable end.
    ends: Vec<(u32, bool)>,
    /// The others.
    cloth: Cloth,
    /// Components that would suit but for how far they reach, by their lowest slots.
    far: BTreeSet<u32>,
    /// How many of the constraints, active or not, have a carry.
    carried: usize,
    /// How many links are compliant.
    giving: usize,
}

/// A link, the block that it is in, and its colour.
type Placed = (Option<u32>, u8, Link);

impl Plan {
    pub(crate) fn new(
        distances: &Table<Distance>,
        particles: &Table<Particle>,
        per_second: u32,
    ) -> Self {
        Self::without(distances, particles, per_second, BTreeSet::new())
    }

    /// The same, with components that have grown too large relaxed one link at a time.
    pub(crate) fn with_far(
        &self,
        TooFar { mut anchors }: TooFar,
        distances: &Table<Distance>,
        particles: &Table<Particle>,
        per_second: u32,
    ) -> Self {
        anchors.extend(&self.far);
        Self::without(distances, particles, per_second, anchors)
    }

    fn without(
        distances: &Table<Distance>,
        particles: &Table<Particle>,
        per_second: u32,
        far: BTreeSet<u32>,
    ) -> Self {
        // Those that nothing moves have no link, but keep their place among the carries.
        let (mut carried, mut giving) = (0, 0);
        let numbered = |(_, distance): (_, &Distance)| {
            let carry = carried;
            carried += u32::from(distance.is_carried());
            let mut link = Link::of(distance, particles, per_second)?;
            if link.give > 0 {
                link.memory = giving;
                giving += 1;
            } else {
                link.memory = carry;
            }
            Some(link)
        };
        let links: Vec<Link> = distances.iter().filter_map(numbered).collect();
        let slots = slot_index(particles.rows().len());
        let (placed, colours) = place(&links, slots);
        let mut components = Components::new(slots);
        for link in &links {
            components.join(link.ends[0], link.ends[1]);
        }
        let push_max = push_max(colours);
        let suits = |(_, colour, link): &Placed| {
            *colour < OVERFLOW
                && link.form == DistanceForm::DivisionFree
                && link.shortest <= push_max
        };
        let unsuited = placed.iter().filter(|placed| !suits(placed));
        let mut alone: BTreeSet<u32> =
            unsuited.map(|(_, _, link)| components.root(link.ends[0])).collect();
        alone.extend(&far);
        let (single, cloth): (Vec<Placed>, Vec<Placed>) = placed
            .into_iter()
            .partition(|(_, _, link)| alone.contains(&components.root(link.ends[0])));
        let (links, ends) = by_colour(&single);
        let cloth = Cloth::new(&cloth, colours, slots, |slot| components.root(slot));
        Self { links, ends, cloth, far, carried: carried as usize, giving: giving as usize }
    }

    /// The links that are relaxed one at a time, colour by colour.
    pub(super) fn links(&self) -> &[Link] {
        &self.links
    }

    /// The colours in order: where their links are, and whether no two share a movable end.
    pub(super) fn colours(&self) -> impl Iterator<Item = (Range<usize>, bool)> {
        let mut start = 0;
        self.ends.iter().map(move |&(end, independent)| {
            let links = start..end as usize;
            start = links.end;
            (links, independent)
        })
    }

    /// The links that are relaxed in 32 bits.
    pub(crate) fn cloth(&self) -> &Cloth {
        &self.cloth
    }

    /// How many links are compliant.
    pub(crate) fn giving(&self) -> usize {
        self.giving
    }

    /// How many carries the state must hold.
    pub(crate) fn carried(&self) -> usize {
        self.carried
    }
}

/// Links with their blocks and colours, sorted by these, and the number of colours.
fn place(links: &[Link], slots: u32) -> (Vec<Placed>, u32) {
    let (inside, between): (Vec<_>, Vec<_>) =
        links.iter().map(|link| (block_of(link), *link)).partition(|(block, _)| block.is_some());
    let mut placed = Vec::with_capacity(links.len());
    let mut count = 0;
    for part in [inside, between] {
        let movable: Vec<_> = part.iter().map(|(_, link)| link.movable()).collect();
        let colours = colour(&movable, slots as usize);
        count += colours.iter().max().map_or(0, |&last| u32::from(last) + 1);
        let start = placed.len();
        placed.extend(part.into_iter().zip(colours).map(|((block, link), c)| (block, c, link)));
        // Stable, so that slots stay in order.
        placed[start..].sort_by_key(|(block, colour, _)| (*block, *colour));
    }
    (placed, count)
}

/// The links alone, those of all blocks together, and where each colour ends.
fn by_colour(placed: &[Placed]) -> (Vec<Link>, Vec<(u32, bool)>) {
    let key = |(block, colour, _): &Placed| (block.is_none(), *colour);
    let mut sorted = placed.to_vec();
    sorted.sort_by_key(key);
    let mut links = Vec::with_capacity(sorted.len());
    let mut ends = Vec::new();
    for colour in sorted.chunk_by(|a, b| key(a) == key(b)) {
        links.extend(colour.iter().map(|(_, _, link)| *link));
        ends.push((slot_index(links.len()), colour[0].1 < OVERFLOW));
    }
    (links, ends)
}

#[cfg(test)]
mod tests {
    use super::super::local::Locals;
    use super::super::relax::Memories;
    use super::*;
    use crate::math::wide::add;
    use crate::math::{Pcg, Real, Unit};
    use crate::particle::ParticleId;
    use crate::store::Handle;

    /// Particles in random slots and one net of rods and ropes on all of them.
    struct Net {
        particles: Table<Particle>,
        distances: Table<Distance>,
        position: Vec<[i64; 3]>,
    }

    impl Net {
        /// Nothing at these places.
        fn at(position: Vec<[i64; 3]>) -> Self {
            let mut particles = Table::default();
            for _ in &position {
                particles.insert(Particle::default());
            }
            Self { particles, distances: Table::default(), position }
        }

        /// Within `2^spread` of each other; rods of up to `rod` raw units.
        fn random(random: &mut Pcg, count: u32, spread: u32, rod: u32) -> Self {
            let mut within = |bits: u32| {
                [(); 3].map(|()| i64::from(random.next_u32() >> (32 - bits)) - (1 << (bits - 1)))
            };
            let base = within(32).map(|c| c << 27);
            let mut net = Self::at((0..count).map(|_| add(base, within(spread))).collect());
            let masses = [Particle::MASS_MIN, Real::ONE, Real::ONE, Particle::MASS_MAX];
            for slot in 0..count {
                let mass = masses[random.below(4) as usize];
                let row = Particle { mass, pinned: random.below(12) == 0, ..Particle::default() };
                net.particles.set(Handle::new(slot, 1), row);
            }
            // A tree, so that all hang together, whose branches lead anywhere; then ties nearby.
            for k in 1..count {
                let to = if k % 3 == 0 { random.below(k) } else { k - 1 };
                net.tie_any(random, [k, to], rod);
            }
            for _ in 0..2 * count {
                let a = random.below(count);
                let b = (a + 1 + random.below(40)) % count;
                net.tie_any(random, [a, b], rod);
            }
            net
        }

        /// Ties two particles by a random rod or rope.
        fn tie_any(&mut self, random: &mut Pcg, [a, b]: [u32; 2], rod: u32) {
            let length = |below: u32| Real::from_raw(i64::from((1 << 13) + below));
            let [a, b] = [a, b].map(|slot| ParticleId(Handle::new(slot, 1)));
            let rod = Distance::new(a, b, length(random.below(rod)));
            let rope = Distance::rope(a, b, length(random.below(1 << 29)));
            let stiffness = [Unit::ONE, Unit::ONE, Unit::from_raw(1 << 28)];
            let kind = [rod, rod, rope][random.below(3) as usize];
            if a != b {
                self.tie(kind.stiffness(stiffness[random.below(3) as usize]));
            }
        }

        fn tie(&mut self, distance: Distance) {
            self.distances.insert(distance.form(DistanceForm::DivisionFree));
        }

        /// The positions after some relaxations: in 32 bits, and one link at a time.
        fn relaxed(&self, passes: u32) -> [Vec<[i64; 3]>; 2] {
            let Self { particles, distances, position } = self;
            let plan = Plan::new(distances, particles, 240);
            assert!(plan.links().is_empty(), "all of it suits");
            let mut cloth = position.clone();
            let mut locals = Locals::default();
            let mut left = passes;
            while left > 0 {
                locals.gather(plan.cloth(), &cloth).expect("near its anchor");
                let run = left.min(plan.cloth().passes());
                (0..run).for_each(|_| locals.relax(plan.cloth()));
                locals.scatter(plan.cloth(), &mut cloth);
                left -= run;
            }
            let slots = slot_index(position.len());
            let far = Plan::without(distances, particles, 240, (0..slots).collect());
            assert!(!far.links().is_empty());
            let mut single = position.clone();
            for _ in 0..passes {
                let memories = Memories { carries: &mut [], taken: &mut [] };
                far.relax(position, &mut single, memories);
            }
            [cloth, single]
        }
    }

    /// Links that are relaxed together find what they read as it was: no other of them moves it.
    #[test]
    fn links_of_a_colour_are_independent() {
        let mut random = Pcg::new(10, 0);
        let net = Net::random(&mut random, 200, 24, 1 << 18);
        let plan = Plan::without(&net.distances, &net.particles, 240, (0..200).collect());
        let mut shared = 0;
        for (range, independent) in plan.colours() {
            let mut seen = BTreeSet::new();
            let ends = plan.links()[range].iter().flat_map(|link| link.ends);
            for end in ends.filter(|&end| !seen.insert(end)) {
                assert!(!independent || net.particles.rows()[end as usize].pinned, "slot {end}");
                shared += 1;
            }
        }
        assert!(shared > 0, "no pin has two links");
    }

    /// In 32 bits or one link at a time: the same bits, for nets that are slack, crumpled so that
    /// they explode, or as wide as they may be.
    #[test]
    fn cloth_is_what_its_links_are() {
        let (mut random, mut moved) = (Pcg::new(8, 0), 0);
        let cases = if cfg!(debug_assertions) { 60 } else { 4000 };
        for case in 0..cases {
            let spread = [10, 22, 26, 28][(case % 4) as usize];
            let count = 2 + random.below(60);
            let net = Net::random(&mut random, count, spread, 1 << 21);
            let [cloth, single] = net.relaxed(6);
            assert!(cloth == single, "case {case}");
            moved += u32::from(cloth != net.position);
        }
        assert!(2 * moved > cases, "only {moved} moved");
    }

    /// Ends 24 m from the anchor on either side are pushed farther apart than a single link would
    /// be projected alike, if the widest cloth were any wider; then a rope pulls them.
    #[test]
    fn the_widest_cloth_is_what_its_links_are() {
        let edge = (24 << 24) - 1;
        let near = edge - (1 << 10);
        let places = [0, edge, -edge, near, -near].map(|x| [x, 0, 0]);
        let mut net = Net::at(places.to_vec());
        let id = |slot| ParticleId(Handle::new(slot, 1));
        let metre = Real::ONE;
        net.tie(Distance::new(id(1), id(3), metre));
        net.tie(Distance::new(id(2), id(4), metre));
        for end in [1, 2] {
            net.tie(Distance::rope(id(0), id(end), metre * Real::from_int(64)));
        }
        net.tie(Distance::rope(id(1), id(2), metre));
        let [cloth, single] = net.relaxed(1);
        assert_eq!(cloth, single);
        assert!(single[1][0] < edge / 2, "the rope pulls");
    }

    /// The same for a net of several blocks, with links between them.
    #[test]
    fn blocks_change_nothing() {
        let mut random = Pcg::new(9, 0);
        for spread in [16, 27] {
            let net = Net::random(&mut random, 9000, spread, 1 << 18);
            let [cloth, single] = net.relaxed(3);
            assert!(cloth == single, "spread {spread}");
        }
    }
}
