//! Floor 10: recordings that prove themselves.
//!
//! A replay holds a start, the inputs of every tick, a hash of the state after every tick, and
//! keyframes for seeking. Whoever has it can step again and [`verify`] that every tick comes out
//! the same. `FORMAT.md` describes every byte.
//!
//! Anything that is a [`Simulation`] can be recorded: a [`World`](crate::world::World) alone, or a
//! game that owns one and turns its own inputs into commands.

mod error;
mod format;
mod recorder;
mod simulation;
mod verify;

pub use error::{Divergence, DivergenceKind, VerifyError};
pub use format::Replay;
pub use recorder::Recorder;
pub use simulation::Simulation;
pub use verify::{seek, verify};
