//! A deterministic lockstep physics core: Verlet particles and relaxation in fixed-point integers.
//!
//! The same snapshot and the same commands give the same bytes after every tick, on every platform,
//! in every build, with any number of threads. The README states the promise in full and what it
//! does not cover; `ARCHITECTURE.md` shows how it is kept.
//!
//! # One tick
//!
//! ```text
//! commands -> caches -> substeps { integrate -> relax -> close -> settle velocities } -> events
//! ```
//!
//! [`World::step`](world::World::step) is that list of calls.
//!
//! # Conventions
//!
//! Right-handed, y up. Metres, seconds, kilograms, newtons. Numbers are [`Real`]: 64
//! bits, 24 of them a fraction (60 nm). A tick is a fixed time step; tick `n` is the step from
//! [`World::tick`](world::World::tick)` == n` to `n + 1`.
//!
//! # Floors
//!
//! A module names only its own floor or lower ones: [`math`] and [`store`] (0), [`geometry`] (1),
//! [`particle`] (3), [`constraint`] (4), [`world`] (7), [`snapshot`] (8), `scene` (9), [`replay`]
//! (10).
#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

// Indices of 32 bits are used as subscripts everywhere.
#[cfg(not(any(target_pointer_width = "32", target_pointer_width = "64")))]
compile_error!("verlock needs pointers of at least 32 bits");

pub mod body;
pub mod constraint;
pub mod geometry;
pub mod math;
pub mod particle;
pub mod replay;
#[cfg(feature = "std")]
pub mod scene;
pub mod snapshot;
pub mod store;
pub mod world;

pub use math::{Real, Vec3};
pub use snapshot::{Hash, SIM_VERSION};
pub use world::{Command, Event, World, WorldBuilder, WorldConfig};

/// The README's example, run as a test.
#[cfg(all(doctest, feature = "std"))]
#[doc = include_str!("../README.md")]
struct Readme;
