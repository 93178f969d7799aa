//! Floor 9: worlds and what happens in them, written as text.
//!
//! A scene is a RON file: one struct, in which `version: 1` is required and everything else has a
//! default. Numbers are decimals, plain or quoted, with a digit first and without exponent, and
//! become fixed point from their text: what is written is what is simulated, to the nearest step.
//!
//! Objects are created, and numbered from 0, in this order: particles, those of ropes, nets and
//! clouds, all of cloths and plants; then distances, those of ropes and nets; then half-spaces,
//! volumes and faces. These numbers are how distances and commands name them, `3` or
//! `Particle(3)`. A number that the scene has not used names what a command spawns into that slot,
//! if nothing else ever was in it.
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
//!
//! Meshes come from OBJ files, their numbers likewise from the text: [`Obj`].
//!
//! # Fields
//!
#![doc = include_str!("fields.md")]

mod build;
mod cloth;
mod cloud;
mod config;
mod distance;
mod error;
mod face;
mod half_space;
mod list;
mod net;
mod number;
mod obj;
mod parse;
mod particle;
mod rope;
mod script;
mod shape;
mod storm;
mod timeline;
mod volume;

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use cloth::Meshes;
pub use error::{Place, SceneError};
pub use obj::{Obj, ObjError, ObjFault, ObjPart};
use parse::Description;

use crate::world::{Command, World};

/// A world and what happens in it, as a file describes them.
#[derive(Clone, Debug)]
pub struct Scene {
    description: Description,
    meshes: Meshes,
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
        Self::parse_with(text, |name| Err(format!("{name}: only `parse_with` reads files")))
    }

    /// Reads a scene whose meshes are in files: `load` gives the text of an OBJ file by its name,
    /// or says which file is wanted and why there is none.
    ///
    /// # Errors
    /// [`SceneError`] says where the text, or that of a mesh, goes wrong, or which is missing.
    pub fn parse_with(
        text: &str,
        mut load: impl FnMut(&str) -> Result<String, String>,
    ) -> Result<Self, SceneError> {
        let description = Description::parse(text)?;
        let mut meshes = Meshes::new();
        let lists = [("cloths", &description.cloths), ("plants", &description.plants)];
        for (section, list) in lists {
            for (index, sheet) in (0u32..).zip(list) {
                let Some(name) = sheet.file() else { continue };
                if meshes.contains_key(name) {
                    continue;
                }
                let place = Place::at(section, index);
                let text = load(name).map_err(|why| SceneError::NoMesh { place, why })?;
                let obj = Obj::parse(&text);
                let obj = obj.map_err(|why| SceneError::Obj { file: name.into(), why })?;
                meshes.insert(name.into(), obj.into_mesh());
            }
        }
        Ok(Self { description, meshes })
    }

    /// The scene's world at tick 0. O(objects).
    ///
    /// # Errors
    /// Names the object and the field that the world refuses.
    pub fn build(&self) -> Result<World, SceneError> {
        build::build(&self.description, &self.meshes)
    }

    /// What the scene's script does to this world in the coming tick: its timeline, then its storm.
    ///
    /// A function of the scene and the world alone. A game that records runs records what this
    /// returns, and needs no scene to play it back. O(commands), with a storm O(particles) more.
    #[must_use]
    pub fn commands(&self, world: &World) -> Vec<Command> {
        script::commands(&self.description, world)
    }

    /// The entries of the timeline and their ticks, in the order in which they are given. Those of
    /// one tick are the first of its [`commands`](Self::commands), numbered from 0.
    pub fn timeline(&self) -> impl Iterator<Item = (Place, u64)> {
        let timeline = self.description.timeline.iter();
        timeline.map(|entry| (Place::at("timeline", entry.index), entry.tick))
    }

    /// For how many ticks the scene is meant to run.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.description.ticks
    }
}
