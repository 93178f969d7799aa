//! What internal constraints must not change.

use verlock::World;

/// Total of mass times displacement, raw: exact.
pub fn momentum(world: &World) -> [i128; 3] {
    let particles = world.particles();
    let mut sum = [0; 3];
    for id in particles.ids() {
        let mass = particles.particle(id).map_or(0, |row| i128::from(row.mass.raw()));
        let moved = particles.displacement(id).unwrap_or_default().raw();
        for (sum, moved) in sum.iter_mut().zip(moved) {
            *sum += mass * i128::from(moved);
        }
    }
    sum
}
