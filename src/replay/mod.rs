//! Floor 10: recordings that prove themselves.
//!
//! A replay holds a start, the inputs of every tick, a hash of the state after every tick, and
//! keyframes for seeking. Whoever has it can step again and [`verify`] that every tick comes out
//! the same. `FORMAT.md` describes every byte.
//!
//! ```
//! use verlock::replay::{Recorder, Replay, seek, verify};
//! use verlock::{World, WorldBuilder, WorldConfig};
//!
//! let world = WorldBuilder::new(WorldConfig::default())?.build();
//! let mut recorder = Recorder::new(world, 60);
//! for _ in 0..100 {
//!     recorder.step(&[]); // confirmed ticks only: roll back in another world
//! }
//! let bytes = recorder.replay();
//! let replay = Replay::parse(&bytes)?;
//! verify::<World>(&replay, |_| ())?;
//! let world: World = seek(&replay, 90)?;
//! assert_eq!(Some(world.hash()), replay.hash_after(89));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! When two machines have parted, [`bisect_replays`] finds the first tick in which they did, and
//! [`Heavy`] the bug behind it if it is one of saving, hashing or caching.
//!
//! Anything that is a [`Simulation`] can be recorded: a [`World`](crate::world::World) alone, or a
//! game that owns one and turns its own inputs into commands.

mod bisect;
mod error;
mod format;
mod hash_log;
mod heavy;
mod recorder;
mod simulation;
mod verify;

pub use bisect::{Bisection, Cause, Parting, bisect, bisect_replays};
pub use error::{Divergence, DivergenceKind, VerifyError};
pub use format::Replay;
pub use hash_log::{HashLog, HashLogError, HashLogReason};
pub use heavy::{Heavy, HeavyError, Mismatch, Way};
pub use recorder::Recorder;
pub use simulation::Simulation;
pub use verify::{seek, verify};
