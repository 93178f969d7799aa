//! Floor 6: what is made of particles and constraints.

mod assembly;
mod cloth;
mod face;
mod plant;
mod rope;
mod tether;
mod wind;

pub use assembly::Assembly;
pub use cloth::Cloth;
pub use face::{Face, FaceId};
pub use plant::Plant;
pub use rope::Rope;
pub(crate) use wind::{Air, Gust};

/// The most faces a world may have: the pushes of all on one particle fit 62 bits.
pub const FACES_MAX: usize = 1 << 20;
