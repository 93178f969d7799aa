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
//! # Rollback
//!
//! Keep the state before each of the last ticks; when a command for one of them arrives late, go
//! back and step again. `clone_from` reuses buffers and shares what did not change.
//!
//! ```
//! use verlock::particle::ParticleSpec;
//! use verlock::world::Action;
//! use verlock::{Command, Vec3, World, WorldBuilder, WorldConfig};
//!
//! let mut builder = WorldBuilder::new(WorldConfig::default())?;
//! let ball = builder.particle(&ParticleSpec::default())?;
//! let mut world = builder.build();
//!
//! let mut ring: [World; 8] = core::array::from_fn(|_| world.clone());
//! let mut commands: Vec<Vec<Command>> = vec![Vec::new(); 20]; // by tick, as far as they are known
//! for tick in 0..20 {
//!     ring[tick % 8].clone_from(&world);
//!     world.step(&commands[tick]);
//! }
//!
//! let action = Action::Impulse { particle: ball, impulse: Vec3::X };
//! commands[15].push(Command { player: 1, sequence: 0, action }); // late by five ticks
//! world.clone_from(&ring[15 % 8]);
//! for tick in 15..20 {
//!     ring[tick % 8].clone_from(&world);
//!     world.step(&commands[tick]);
//! }
//! assert_eq!(world.tick(), 20);
//! # Ok::<(), verlock::world::Refusal>(())
//! ```
//!
//! # Features
//!
//! - `std` (default): `scene`, and with it RON. Without it the crate is `no_std` with `alloc`.
//! - `parallel`: threads inside a colour of the relaxation. Changes speed only.
//!
//! # Floors
//!
//! A module names only its own floor or lower ones: [`math`] and [`store`] (0), [`geometry`] (1),
//! [`partition`] (2), [`particle`] (3), [`constraint`] (4), [`collision`] (5), [`world`] (7),
//! [`snapshot`] (8), `scene` (9), [`replay`] (10).
#![cfg_attr(not(feature = "std"), no_std)]

extern crate alloc;

// Indices of 32 bits are used as subscripts everywhere.
#[cfg(not(any(target_pointer_width = "32", target_pointer_width = "64")))]
compile_error!("verlock needs pointers of at least 32 bits");

pub mod body;
pub mod collision;
pub mod constraint;
pub mod geometry;
pub mod math;
pub mod particle;
pub mod partition;
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
