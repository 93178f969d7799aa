//! Laws that hold for any input, one for each fuzz target.
//!
//! A law panics when it is broken. It returns whether the input was accepted, so that the test that
//! replays the corpus can tell when the corpus no longer gets past the decoder.

mod broad_phase;
mod bvh;
mod commands;
pub mod container;
mod draw;
mod hull;
mod manifold;
mod obj;
pub mod oracle;
pub mod planes;
mod relax;
mod replay;
mod scene;
mod snapshot;
mod toi;
mod triangle_triangle;
mod world;

pub use broad_phase::broad_phase;
pub use bvh::bvh;
pub use commands::commands;
pub use hull::hull;
pub use manifold::manifold;
pub use obj::obj;
pub use relax::relax;
pub use replay::replay;
pub use scene::scene;
pub use snapshot::snapshot;
pub use toi::toi;
pub use triangle_triangle::triangle_triangle;
