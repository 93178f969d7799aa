//! Floor 2: which boxes touch. Ids and boxes; no shapes, no mass, no motion.
//!
//! A [`Partition`] keeps objects, each with an id of the caller's choosing and a *tight* box, and
//! lists the *pairs* of ids whose tight boxes have a point in common. Boxes are closed: touching
//! counts. How a partition divides space is its own matter and never reaches a result:
//!
//! | | divides space by | made for |
//! |---|---|---|
//! | [`DynamicTree`] | a tree of boxes around boxes | the default |
//! | [`Orthtree`] | cells that halve along each axis: quadtree, octree | objects of like size |
//! | [`Bsp`] | planes | rooms with walls |
//! | [`BruteForce`] | nothing | a dozen objects, and as the oracle of the others |
//!
//! Faces of two meshes, which do not come and go, are found by the hierarchies in [`bvh`].
//!
//! # Order
//!
//! A pair is `[lower id, higher id]`, and pairs are sorted. The list is a function of the ids and
//! tight boxes alone, whichever partition made it, whatever happened to it before.
//!
//! # Ids
//!
//! An id is a place in a table, so that memory is in proportion to the highest one, some 150 bytes
//! an id in a dynamic tree and 75 elsewhere: number objects from 0 and use numbers again, as the
//! slots of a store do.
//!
//! ```
//! use verlock::Vec3;
//! use verlock::geometry::Aabb;
//! use verlock::partition::{DynamicTree, Partition};
//!
//! // Two crates side by side, touching, and one that hangs in the air above.
//! let cube = |x, y| Aabb::new(Vec3::from_ints(x, y, 0), Vec3::from_ints(x + 1, y + 1, 1));
//! let mut tree = DynamicTree::new();
//! tree.insert(0, cube(0, 0).into())?;
//! tree.insert(1, cube(1, 0).into())?;
//! tree.insert(2, cube(0, 9).into())?;
//! assert_eq!(tree.pairs(), [[0, 1]]);
//!
//! tree.update(2, cube(0, 1).into())?;
//! assert_eq!(tree.pairs(), [[0, 1], [0, 2], [1, 2]]);
//! # Ok::<(), verlock::partition::PartitionError>(())
//! ```

mod brute_force;
mod bsp;
pub mod bvh;
mod dynamic_tree;
mod error;
mod object;
mod orthtree;
mod roster;

pub use brute_force::BruteForce;
pub use bsp::Bsp;
pub use dynamic_tree::DynamicTree;
pub use error::PartitionError;
pub use object::Object;
pub use orthtree::Orthtree;

use alloc::vec::Vec;

use crate::geometry::Aabb;

/// Two objects whose tight boxes touch: the lower id, then the higher one.
pub type Pair = [u32; 2];

/// The highest id of an object: 2^20 - 1. A higher one would only take more memory.
pub const ID_MAX: u32 = (1 << 20) - 1;

/// Objects with boxes, and which of them touch.
///
/// Changes are cheap to tell and may be left undone until [`pairs`](Self::pairs) asks; everything
/// else is right at any time.
pub trait Partition {
    /// Takes in an object.
    ///
    /// # Errors
    /// [`PartitionError`] if the id is too large or taken, or the object out of range. Then nothing
    /// has changed.
    fn insert(&mut self, id: u32, object: Object) -> Result<(), PartitionError>;

    /// Gives an object another box and centre.
    ///
    /// # Errors
    /// [`PartitionError`] if the id is unknown or the object out of range. Then nothing has
    /// changed.
    fn update(&mut self, id: u32, object: Object) -> Result<(), PartitionError>;

    /// Takes out an object; its id is free again.
    ///
    /// # Errors
    /// [`PartitionError::UnknownId`]. Then nothing has changed.
    fn remove(&mut self, id: u32) -> Result<(), PartitionError>;

    /// An object as it was last told; `None` if there is none of this id. O(1).
    fn object(&self, id: u32) -> Option<Object>;

    /// The number of objects. O(1).
    fn len(&self) -> u32;

    /// Whether there are no objects. O(1).
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// All pairs of objects whose tight boxes touch, sorted.
    fn pairs(&mut self) -> &[Pair];

    /// Replaces `ids` with those of all objects whose tight boxes touch `region`, sorted. The
    /// region may be any box.
    ///
    /// Objects that changed since [`pairs`](Self::pairs) was last asked are looked at one by one.
    fn query(&self, region: &Aabb, ids: &mut Vec<u32>);

    /// Checks everything that the partition takes for granted. O(n log n) or worse: for tests.
    ///
    /// # Errors
    /// What does not hold: a defect of this crate.
    fn validate(&self) -> Result<(), &'static str>;
}
