//! Changes of the frame of reference under which the laws do not change.

use verlock::WorldConfig;
use verlock::constraint::{HalfSpace, Volume};
use verlock::math::{Unit, UnitVec3, Vec3};
use verlock::particle::{Particle, ParticleSpec};
use verlock::world::{Action, Command};

use super::blueprint::Blueprint;

/// Permutes the axes, mirrors some of them, then shifts the origin. Exact.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Where each new axis comes from.
    axes: [usize; 3],
    /// 1 or -1 for each new axis.
    signs: [i64; 3],
    /// Added to positions, raw.
    shift: [i64; 3],
}

impl Frame {
    pub const IDENTITY: Self = Self { axes: [0, 1, 2], signs: [1; 3], shift: [0; 3] };

    pub fn shifted(shift: [i64; 3]) -> Self {
        Self { shift, ..Self::IDENTITY }
    }

    /// The mirror that turns one axis over.
    pub fn mirror(axis: usize) -> Self {
        let mut frame = Self::IDENTITY;
        frame.signs[axis] = -1;
        frame
    }

    /// A quarter turn about an axis.
    pub fn turn(axis: usize) -> Self {
        let mut frame = Self::IDENTITY;
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        frame.axes.swap(next, last);
        frame.signs[next] = -1;
        frame
    }

    pub fn raw(&self, v: [i64; 3]) -> [i64; 3] {
        [0, 1, 2].map(|k| v[self.axes[k]] * self.signs[k])
    }

    pub fn vector(&self, v: Vec3) -> Vec3 {
        Vec3::from_raw(self.raw(v.raw()))
    }

    pub fn point(&self, v: Vec3) -> Vec3 {
        self.vector(v) + Vec3::from_raw(self.shift)
    }

    fn normal(&self, v: UnitVec3) -> UnitVec3 {
        let UnitVec3 { x, y, z } = v;
        let raw = [x, y, z].map(Unit::raw);
        let sign = |k: usize| if self.signs[k] < 0 { -1 } else { 1 };
        UnitVec3::from_raw([0, 1, 2].map(|k| raw[self.axes[k]] * sign(k)))
    }

    fn config(&self, config: &WorldConfig) -> WorldConfig {
        let (gravity, wind) = (self.vector(config.gravity), self.vector(config.wind));
        WorldConfig { gravity, wind, ..*config }
    }

    fn particle(&self, spec: &ParticleSpec) -> ParticleSpec {
        let acceleration = self.vector(spec.particle.acceleration);
        ParticleSpec {
            position: self.point(spec.position),
            velocity: self.vector(spec.velocity),
            particle: Particle { acceleration, ..spec.particle },
        }
    }

    fn half_space(&self, shape: &HalfSpace) -> HalfSpace {
        let (point, normal) = (self.point(shape.point), self.normal(shape.normal));
        HalfSpace { point, normal, ..*shape }
    }

    /// A mirror turns a volume inside out: its sign is that of the frame.
    fn volume(&self, volume: &Volume) -> Volume {
        let images = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| self.vector(axis));
        let upright = images[0].cross(images[1]) == Some(images[2]);
        let rest_volume = if upright { volume.rest_volume } else { -volume.rest_volume };
        Volume { rest_volume, ..*volume }
    }

    fn action(&self, action: Action) -> Action {
        match action {
            Action::SpawnParticle { token, spec } => {
                Action::SpawnParticle { token, spec: self.particle(&spec) }
            }
            Action::SpawnHalfSpace { token, half_space } => {
                Action::SpawnHalfSpace { token, half_space: self.half_space(&half_space) }
            }
            Action::Force { particle, force } => {
                Action::Force { particle, force: self.vector(force) }
            }
            Action::Impulse { particle, impulse } => {
                Action::Impulse { particle, impulse: self.vector(impulse) }
            }
            Action::SetVelocity { particle, velocity } => {
                Action::SetVelocity { particle, velocity: self.vector(velocity) }
            }
            Action::SetAcceleration { particle, acceleration } => {
                Action::SetAcceleration { particle, acceleration: self.vector(acceleration) }
            }
            Action::MovePin { particle, target } => {
                Action::MovePin { particle, target: self.point(target) }
            }
            Action::Teleport { particle, position } => {
                Action::Teleport { particle, position: self.point(position) }
            }
            Action::SpawnVolume { token, volume } => {
                Action::SpawnVolume { token, volume: self.volume(&volume) }
            }
            Action::SetWind { wind } => Action::SetWind { wind: self.vector(wind) },
            Action::Configure { config } => Action::Configure { config: self.config(&config) },
            scalar => scalar,
        }
    }

    /// The same world as it looks in this frame.
    pub fn blueprint(&self, blueprint: &Blueprint) -> Blueprint {
        let Blueprint { config, particles, distances, half_spaces, volumes, faces, script } =
            blueprint;
        let seen = |(tick, command): &(u64, Command)| {
            (*tick, Command { action: self.action(command.action), ..*command })
        };
        Blueprint {
            config: self.config(config),
            particles: particles.iter().map(|spec| self.particle(spec)).collect(),
            distances: distances.clone(),
            half_spaces: half_spaces.iter().map(|shape| self.half_space(shape)).collect(),
            volumes: volumes.iter().map(|volume| self.volume(volume)).collect(),
            faces: faces.clone(),
            script: script.iter().map(seen).collect(),
        }
    }
}
