//! Floor 4: rules over particles, and the loop that relaxes them.
//!
//! A constraint is *projected*: the particles are moved, in inverse proportion to their masses,
//! until its rule holds. Projecting all of them once is a relaxation; each disturbs its neighbours,
//! so relaxation is iterated, and what is left over is finished in the next ticks (Jakobsen 2003).
//!
//! | kind | rule | moves |
//! |---|---|---|
//! | [`Distance`] | two particles keep a distance | both, by their masses |
//! | [`Volume`] | four particles keep the volume between them | all, by their masses |
//! | [`HalfSpace`] | every movable particle stays in front of a plane | the particle |
//!
//! Order: distances colour by colour, volumes and then half-spaces in slot order; then the next
//! iteration.

mod colour;
mod component;
mod correction;
mod curve;
mod distance;
mod half_space;
mod lanes;
mod link;
mod local;
mod plan;
mod relax;
mod tear;
mod tetrahedron;
mod volume;

pub(crate) use correction::{CARRY_MAX, Carry};
pub use distance::{Distance, DistanceForm, DistanceId};
pub use half_space::{HalfSpace, HalfSpaceId};
pub(crate) use half_space::{Touch, collide, settle};
pub(crate) use local::Locals;
pub(crate) use plan::Plan;
pub(crate) use relax::Memories;
pub(crate) use tear::{Tear, Tearable};
pub(crate) use tetrahedron::Tetrahedron;
pub use volume::{Volume, VolumeId};

/// The most distance constraints a world may have.
///
/// With at most 64 iterations and 2^32.4 raw units a correction, relaxation moves a particle by
/// less than 2^59.4 raw units, so positions stay below 2^60.9 and differences of positions below
/// 2^61.9: every sum and dot product of the relaxation fits its type.
pub const DISTANCES_MAX: usize = 1 << 21;

/// The most volume constraints a world may have.
///
/// With at most 64 iterations and 2^31.6 raw units a correction they move a particle by less than
/// 2^57.6 raw units, so that positions stay below 2^60.9 and their differences below 2^61.9.
pub const VOLUMES_MAX: usize = 1 << 20;

/// The most half-spaces a world may have.
pub const HALF_SPACES_MAX: usize = 64;

/// The most relaxations in a substep.
pub const ITERATIONS_MAX: u32 = 64;
