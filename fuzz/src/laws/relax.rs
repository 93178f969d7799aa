//! Any constraints on a few particles, and nothing else.

use verlock::constraint::{Distance, DistanceForm, Volume};
use verlock::math::{Real, Vec3};
use verlock::particle::{Particle, ParticleId, ParticleSpec};
use verlock::store::Handle;
use verlock::world::{EventKind, World, WorldBuilder, WorldConfig};

use super::draw::Draw;
use super::world::is_sound;

/// No more particles, distances and volumes, and no more ticks.
const PARTICLES_MAX: usize = 6;
const DISTANCES_MAX: usize = 8;
const VOLUMES_MAX: usize = 3;
const TICKS_MAX: usize = 6;

/// One correction moves an end by less, raw units.
const CORRECTION_MAX: i128 = 1 << 33;

/// What a world is made of.
struct Net {
    config: WorldConfig,
    specs: Vec<ParticleSpec>,
    distances: Vec<Distance>,
    volumes: Vec<Volume>,
}

/// Nothing leaves its limits; constraints keep momentum, with equal masses to the bit; and a
/// particle on a loose rope changes nothing, however far away it is. True if anything is
/// constrained.
pub fn relax(bytes: &[u8]) -> bool {
    let net = Net::draw(&mut Draw::new(bytes));
    // 40 m are too far for 32 bits.
    let [Some(mut near), Some(mut far)] = [1, 40].map(|metres| net.build(metres)) else {
        return false;
    };
    let tail = id(net.specs.len());
    let places = [&near, &far].map(|world| world.position(tail));
    for _ in 0..TICKS_MAX {
        let (bound, before) = (net.bound(&near), momentum(&near));
        near.step(&[]);
        far.step(&[]);
        is_sound(&near);
        if [&near, &far].map(|world| world.position(tail)) != places {
            break; // the rope is no longer loose
        }
        let after = momentum(&near);
        if let Some(bound) = bound.filter(|_| !is_cut(&near)) {
            let off = |k: usize| (after[k] - before[k]).abs();
            assert!((0..3).all(|k| off(k) <= bound), "momentum: {before:?}, {after:?} +- {bound}");
        }
        for slot in 0..net.specs.len() {
            assert_eq!(near.position(id(slot)), far.position(id(slot)), "particle {slot}, far");
        }
    }
    near.distances().count() > 1 || near.volumes().count() > 0
}

/// The first particle of a slot.
fn id(slot: usize) -> ParticleId {
    ParticleId(Handle::new(u32::try_from(slot).expect("few slots"), 1))
}

/// Whether a limit took some of the momentum of this tick.
fn is_cut(world: &World) -> bool {
    let cut =
        |kind| matches!(kind, EventKind::DisplacementClamped { .. } | EventKind::WorldLimit { .. });
    world.events().iter().any(|event| cut(event.kind))
}

/// Total of mass times displacement, raw.
fn momentum(world: &World) -> [i128; 3] {
    let particles = world.particles();
    particles.ids().fold([0; 3], |sum, id| {
        let mass = particles.particle(id).map_or(0, |row| i128::from(row.mass.raw()));
        let moved = particles.displacement(id).unwrap_or_default().raw();
        [0, 1, 2].map(|k| sum[k] + mass * i128::from(moved[k]))
    })
}

impl Net {
    fn draw(draw: &mut Draw<'_>) -> Self {
        let config = WorldConfig {
            gravity: Vec3::ZERO,
            damping: Real::ZERO,
            wind: Vec3::ZERO,
            ..draw.config()
        };
        let count = 2 + draw.below(PARTICLES_MAX - 1);
        let mut specs: Vec<_> = (0..count).map(|_| draw.spec()).collect();
        if draw.below(4) == 0 {
            let mass = specs[0].particle.mass;
            specs.iter_mut().for_each(|spec| spec.particle.mass = mass);
        }
        let distances = (0..draw.below(DISTANCES_MAX)).map(|_| {
            let ends = [draw.below(count), draw.below(count)];
            draw.link(id(ends[0]), id(ends[1]))
        });
        let distances = distances.collect();
        let volumes = (0..draw.below(VOLUMES_MAX)).map(|_| {
            let corners = [(); 4].map(|()| id(draw.below(count)));
            draw.volume(corners)
        });
        let volumes = volumes.collect();
        Self { config, specs, distances, volumes }
    }

    /// The world, with a particle so far from the first one on a loose rope of 64 m; `None` if it
    /// is refused. Constraints that are refused are left out.
    fn build(&self, metres: i32) -> Option<World> {
        let mut builder = WorldBuilder::new(self.config).ok()?;
        for spec in &self.specs {
            builder.particle(spec).ok()?;
        }
        let place = self.specs[0].position + Vec3::from_ints(metres, 0, 0);
        let tail = builder.particle(&ParticleSpec::at(place).mass(Particle::MASS_MIN)).ok()?;
        for distance in &self.distances {
            let _ = builder.distance(distance);
        }
        let rope = Distance::rope(id(0), tail, Real::from_int(64));
        builder.distance(&rope.form(DistanceForm::DivisionFree)).ok()?;
        for volume in &self.volumes {
            let _ = builder.volume(volume);
        }
        Some(builder.build())
    }

    /// What a tick may change of the momentum. `None` where a particle takes none.
    ///
    /// An end of a distance is wrong by 1/2 for the product, by `arm / 2^31` for the share of the
    /// error and by `correction / 2^31` for that of the masses. A corner of a volume is wrong by
    /// 1/2 for the product and, its weight having 30 bits of that of the lightest, by `2^30 / 2^31`
    /// times its mass by that of the lightest; for shortened gradients by less than 1.
    fn bound(&self, world: &World) -> Option<i128> {
        let rows = self.specs.iter().map(|spec| spec.particle);
        if !rows.clone().all(|row| row.is_movable()) {
            return None;
        }
        let masses: Vec<_> = rows.map(|row| i128::from(row.mass.raw())).collect();
        let least = *masses.iter().min()?;
        if masses.iter().all(|mass| *mass == least) {
            // The tail has another mass, but its rope is loose.
            return Some(0);
        }
        let places = || world.particles().positions_raw().iter().flatten();
        let reach = places().max()?.abs_diff(*places().min()?);
        let WorldConfig { substeps, iterations, .. } = self.config;
        let rounds = i128::from(substeps * iterations);
        let projections = rounds * (self.distances.len() + self.volumes.len()) as i128;
        // Corrections and the coasting may lengthen arms meanwhile.
        let coasted = i128::from(substeps) << 31;
        let arm = i128::from(reach) + coasted + 2 * projections * CORRECTION_MAX;
        let mass = |id: ParticleId| masses.get(id.0.slot()).copied().unwrap_or(0);
        let links = self.distances.iter().map(|row| mass(row.a) + mass(row.b));
        let links = links.map(|masses| masses * (1 + ((arm + CORRECTION_MAX) >> 31)));
        let corners = self.volumes.iter().flat_map(|row| row.corners).map(mass);
        let corners = corners.map(|mass| mass * (2 + mass / least));
        Some(rounds * (links.sum::<i128>() + corners.sum::<i128>()))
    }
}
