//! Floor 9: worlds and what happens in them, written as text.
//!
//! A scene is a RON file: one struct, in which `version: 1` is required and everything else has a
//! default. Numbers are decimals, plain or quoted, and become fixed point from their text: what is
//! written is what is simulated, to the nearest step.
//!
//! | field | holds |
//! |---|---|
//! | `config` | a [`WorldConfig`](crate::world::WorldConfig) |
//! | `seed` | of the world's random generator |
//! | `ticks` | how long the scene is meant to run; 600 |
//! | `origin` | is added, exactly, to every position in the file |
//! | `particles` | `position velocity mass gravity_scale acceleration pinned enabled user` |
//! | `ropes` | `from to particles mass pinned stiffness form` |
//! | `nets` | `corner edge_u edge_v columns rows mass pinned stiffness form diagonals` |
//! | `clouds` | `count min max speed mass seed` |
//! | `distances` | `a b rest_length stiffness form enabled user` |
//! | `half_spaces` | `point normal friction restitution enabled user` |
//! | `timeline` | `tick player action`: one command, an [`Action`](crate::world::Action) |
//! | `storm` | `from until player spawns removes links impulses min max speed mass` |
//!
//! Objects are created, and numbered from 0, in this order: particles, those of ropes, nets and
//! clouds; then distances, those of ropes and nets; then half-spaces. These numbers are how
//! distances and commands name them, `3` or `Particle(3)`. A number that the scene has not used
//! names what a command spawns into that slot, if nothing else ever was in it.
//!
//! A rope's `mass` may be a pair, from its first to its last particle; a cloud's and a storm's a
//! pair to draw between. A rest length that is left out, or 0, is the distance as placed.
//!
//! ```
//! use verlock::scene::Scene;
//!
//! let scene = Scene::parse(
//!     "(
//!         version: 1,
//!         ropes: [(from: (0, 2, 0), to: (1, 2, 0), particles: 5, pinned: [0])],
//!         half_spaces: [()],
//!         timeline: [(tick: 30, action: SetPinned(particle: 0, pinned: false))],
//!     )",
//! )?;
//! let mut world = scene.build()?;
//! for _ in 0..scene.ticks() {
//!     let commands = scene.commands(&world);
//!     world.step(&commands);
//! }
//! # Ok::<(), verlock::scene::SceneError>(())
//! ```

mod build;
mod cloud;
mod config;
mod distance;
mod error;
mod half_space;
mod list;
mod net;
mod number;
mod parse;
mod particle;
mod rope;
mod script;
mod shape;
mod storm;
mod timeline;

use alloc::vec::Vec;

pub use error::{Place, SceneError};
use parse::Description;

use crate::world::{Command, World};

/// A world and what happens in it, as a file describes them.
#[derive(Clone, Debug)]
pub struct Scene {
    description: Description,
}

impl Scene {
    /// The longest text that is read, in bytes.
    pub const TEXT_MAX: usize = 16 << 20;

    /// Reads a scene.
    ///
    /// O(text); nothing is generated yet, but whatever a scene generates is counted and found to
    /// fit a world.
    ///
    /// # Errors
    /// [`SceneError`] says where the text goes wrong. No text makes it panic.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        Description::parse(text).map(|description| Self { description })
    }

    /// The scene's world at tick 0. O(objects).
    ///
    /// # Errors
    /// Names the object and the field that the world refuses.
    pub fn build(&self) -> Result<World, SceneError> {
        build::build(&self.description)
    }

    /// What the scene's script does to this world in the coming tick: its timeline, then its storm.
    ///
    /// A function of the scene and the world alone. A game that records runs records what this
    /// returns, and needs no scene to play it back. O(commands), with a storm O(particles) more.
    #[must_use]
    pub fn commands(&self, world: &World) -> Vec<Command> {
        script::commands(&self.description, world)
    }

    /// For how many ticks the scene is meant to run.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.description.ticks
    }
}
