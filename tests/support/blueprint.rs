//! A world as a list of parts, which can be looked at and transformed before it is built.

use verlock::body::Face;
use verlock::constraint::{Distance, HalfSpace, Volume};
use verlock::particle::{ParticleId, ParticleSpec};
use verlock::store::Handle;
use verlock::world::{Action, Command, EventKind};
use verlock::{World, WorldBuilder, WorldConfig};

/// The parts of a world, in order of creation, and what is done to it.
#[derive(Clone, Debug, Default)]
pub struct Blueprint {
    pub config: WorldConfig,
    pub particles: Vec<ParticleSpec>,
    pub distances: Vec<Distance>,
    pub half_spaces: Vec<HalfSpace>,
    pub volumes: Vec<Volume>,
    pub faces: Vec<Face>,
    /// Commands and the ticks they are for.
    pub script: Vec<(u64, Command)>,
}

impl Blueprint {
    pub fn new(config: WorldConfig, particles: &[ParticleSpec]) -> Self {
        Self { config, particles: particles.to_vec(), ..Self::default() }
    }

    pub fn build(&self) -> World {
        let Self { config, particles, distances, half_spaces, volumes, faces, script: _ } = self;
        let mut builder = WorldBuilder::new(*config).expect("the configuration is valid");
        for particle in particles {
            builder.particle(particle).expect("the particle is valid");
        }
        for distance in distances {
            builder.distance(distance).expect("the constraint is valid");
        }
        for half_space in half_spaces {
            builder.half_space(half_space).expect("the half-space is valid");
        }
        for volume in volumes {
            builder.volume(volume).expect("the volume is valid");
        }
        for face in faces {
            builder.face(face).expect("the face is valid");
        }
        builder.build()
    }

    /// What the script does in a tick.
    pub fn commands(&self, tick: u64) -> Vec<Command> {
        let due = self.script.iter().filter(|(at, _)| *at == tick);
        due.map(|(_, command)| *command).collect()
    }
}

/// The first particle that lived in a slot.
pub fn first(index: u32) -> ParticleId {
    ParticleId(Handle::new(index, 1))
}

pub fn run(world: &mut World, ticks: u32) {
    for _ in 0..ticks {
        world.step(&[]);
    }
}

/// Steps once with these actions, by one player in this order, and returns what happened.
pub fn act(world: &mut World, actions: &[Action]) -> Vec<EventKind> {
    let commands: Vec<_> = (0..)
        .zip(actions)
        .map(|(sequence, &action)| Command { player: 0, sequence, action })
        .collect();
    world.step(&commands).iter().map(|event| event.kind).collect()
}
