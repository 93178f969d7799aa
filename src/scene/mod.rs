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
//! | `cloths` | `mesh at pinned mass stiffness bending form attachments`, |
//! | | `tear_strain toughness drag`: a [`Cloth`](crate::body::Cloth) |
//! | `plants` | the same and `compliance spread`: a [`Plant`](crate::body::Plant) |
//! | `distances` | `a b rest_length slack stiffness compliance form`, |
//! | | `tear_strain toughness damage enabled user` |
//! | `volumes` | `corners rest_volume stiffness enabled user` |
//! | `faces` | `corners drag enabled user` |
//! | `half_spaces` | `point normal friction restitution enabled user` |
//! | `timeline` | `tick player action`: one command, an [`Action`](crate::world::Action) |
//! | `storm` | `from until player spawns removes links impulses min max speed mass` |
//!
//! Objects are created, and numbered from 0, in this order: particles, those of ropes, nets and
//! clouds, all of cloths and plants; then distances, those of ropes and nets; then half-spaces,
//! volumes and faces. These numbers are how distances and commands name them, `3` or
//! `Particle(3)`. A number that the scene has not used names what a command spawns into that slot,
//! if nothing else ever was in it.
//!
//! A `mesh` is `File("curtain.obj")`, beside the scene, or `Grid(edge_u: (1, 0, 0), edge_v: (0, -1,
//! 0), columns: 20, rows: 20)`; `pinned` is `Top`, `Bottom`, `Places([0, 19])` or `None`.
//!
//! A rope's `mass` may be a pair, from its first to its last particle; a cloud's and a storm's a
//! pair to draw between. A rest length or volume that is left out, or 0, is the one as placed.
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
        Self::parse_with(text, |_| None)
    }

    /// Reads a scene whose meshes are in files: `load` gives the text of an OBJ file by its name.
    ///
    /// # Errors
    /// [`SceneError`] says where the text, or that of a mesh, goes wrong, or which is missing.
    pub fn parse_with(
        text: &str,
        mut load: impl FnMut(&str) -> Option<String>,
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
                let missing = SceneError::NoMesh { place: Place::at(section, index) };
                let text = load(name).ok_or(missing)?;
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

    /// For how many ticks the scene is meant to run.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.description.ticks
    }
}
