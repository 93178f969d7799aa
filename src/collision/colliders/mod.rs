//! A set of shapes that can be asked what is where.

mod collider;
mod first;
mod pairs;
mod query;

pub use collider::{Collider, ColliderError, ColliderId, Layers};
pub use query::Filter;

use alloc::vec::Vec;

use super::Shape;
use crate::geometry::Aabb;
use crate::math::Vec3;
use crate::partition::{DynamicTree, ID_MAX, Object, Partition, PartitionError};
use crate::store::Slots;

/// Shapes with ids, layers and user data, in a tree of their boxes.
///
/// Queries give the same answers, in the same order, whatever happened to the set before: they
/// depend on the colliders and their ids alone.
///
/// ```
/// use verlock::collision::{Collider, Colliders, Filter, Layers};
/// use verlock::geometry::{HalfSpace, Segment, Sphere};
/// use verlock::math::UnitVec3;
/// use verlock::{Vec3, real};
///
/// const GROUND: u32 = 1;
/// const GHOSTS: u32 = 2;
/// let mut colliders = Colliders::new();
/// let floor = HalfSpace::new(Vec3::ZERO, UnitVec3::Y)?;
/// let layers = Layers { on: GROUND, ..Layers::ALL };
/// let floor = colliders.insert(Collider { layers, ..floor.into() })?;
/// let ball = Sphere::new(Vec3::from_ints(0, 2, 0), real!("1"))?;
/// let layers = Layers { on: GHOSTS, ..Layers::ALL };
/// let ghost = colliders.insert(Collider { layers, ..ball.into() })?;
///
/// let down = Segment::new([Vec3::from_ints(0, 9, 0), Vec3::from_ints(0, -9, 0)])?;
/// let hits = colliders.cast_segment(&down, &Filter::ALL);
/// assert_eq!(hits.iter().map(|hit| hit.0).collect::<Vec<_>>(), [ghost, floor]);
/// let ground = Filter { layers: Layers { mask: GROUND, ..Layers::ALL }, ..Filter::ALL };
/// assert_eq!(colliders.cast_segment(&down, &ground)[0].0, floor);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Colliders {
    slots: Slots,
    /// By slot.
    tenants: Vec<Option<Collider>>,
    tree: DynamicTree,
    /// Slots of what has no box, sorted.
    endless: Vec<u32>,
}

impl Colliders {
    /// Without colliders.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes in a collider. O(sqrt n) on average for n colliders.
    ///
    /// # Errors
    /// [`ColliderError`] if it is out of range or there are too many. Then nothing has changed.
    pub fn insert(&mut self, collider: Collider) -> Result<ColliderId, ColliderError> {
        if !self.slots.has_room(ID_MAX as usize + 1) {
            return Err(ColliderError::Full);
        }
        let is_far = |bounds: Aabb| [bounds.min(), bounds.max()].into_iter().any(is_far);
        if collider.shape.bounds().is_some_and(is_far) {
            return Err(ColliderError::OutOfRange);
        }
        let id = self.slots.insert();
        // What is in range and new is taken.
        self.file(id.index, &collider.shape)?;
        self.tree.keep_up();
        if self.tenants.len() <= id.slot() {
            self.tenants.resize(id.slot() + 1, None);
        }
        self.tenants[id.slot()] = Some(collider);
        Ok(ColliderId(id))
    }

    /// Takes out a collider; `None` if there is none of this id. O(sqrt n) on average.
    pub fn remove(&mut self, id: ColliderId) -> Option<Collider> {
        if !self.slots.remove(id.0) {
            return None;
        }
        let collider = self.tenants[id.0.slot()].take();
        self.unfile(id.0.index);
        self.tree.keep_up();
        collider
    }

    /// Gives a collider another shape, or the same elsewhere. O(1) where it moves a little, else
    /// O(sqrt n) on average.
    ///
    /// # Errors
    /// [`ColliderError`] if the id is unknown or the shape out of range. Then nothing has changed.
    pub fn set_shape(
        &mut self,
        id: ColliderId,
        shape: impl Into<Shape>,
    ) -> Result<(), ColliderError> {
        let shape = shape.into();
        if !self.slots.contains(id.0) {
            return Err(ColliderError::UnknownId);
        }
        let slot = id.0.index;
        match (self.tree.object(slot), shape.bounds()) {
            (Some(_), Some(bounds)) => self.tree.update(slot, bounds.into())?,
            (None, Some(_)) => {
                self.file(slot, &shape)?;
                self.endless.retain(|&other| other != slot);
            }
            (_, None) => {
                self.unfile(slot);
                self.file(slot, &shape)?;
            }
        }
        self.tree.keep_up();
        self.tenant(id)?.shape = shape;
        Ok(())
    }

    /// Puts a collider on other layers. O(1).
    ///
    /// # Errors
    /// [`ColliderError::UnknownId`]. Then nothing has changed.
    pub fn set_layers(&mut self, id: ColliderId, layers: Layers) -> Result<(), ColliderError> {
        self.tenant(id)?.layers = layers;
        Ok(())
    }

    /// Gives a collider other user data. O(1).
    ///
    /// # Errors
    /// [`ColliderError::UnknownId`]. Then nothing has changed.
    pub fn set_user_data(&mut self, id: ColliderId, user_data: u64) -> Result<(), ColliderError> {
        self.tenant(id)?.user_data = user_data;
        Ok(())
    }

    /// A collider; `None` if there is none of this id. O(1).
    #[must_use]
    pub fn get(&self, id: ColliderId) -> Option<&Collider> {
        if self.slots.contains(id.0) { self.tenants[id.0.slot()].as_ref() } else { None }
    }

    /// All colliders, in the order of their slots.
    pub fn iter(&self) -> impl Iterator<Item = (ColliderId, &Collider)> {
        self.slots.iter().filter_map(|id| Some((ColliderId(id), self.get(ColliderId(id))?)))
    }

    /// How many there are. O(n).
    #[must_use]
    pub fn len(&self) -> usize {
        self.slots.live()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The collider of an id.
    fn tenant(&mut self, id: ColliderId) -> Result<&mut Collider, ColliderError> {
        if !self.slots.contains(id.0) {
            return Err(ColliderError::UnknownId);
        }
        self.tenants[id.0.slot()].as_mut().ok_or(ColliderError::UnknownId)
    }

    /// Files a slot by the box of its shape.
    fn file(&mut self, slot: u32, shape: &Shape) -> Result<(), ColliderError> {
        match shape.bounds() {
            Some(bounds) => self.tree.insert(slot, bounds.into())?,
            None => {
                if let Err(place) = self.endless.binary_search(&slot) {
                    self.endless.insert(place, slot);
                }
            }
        }
        Ok(())
    }

    /// Takes a slot out of wherever it is filed.
    fn unfile(&mut self, slot: u32) {
        if self.tree.remove(slot).is_err() {
            self.endless.retain(|&other| other != slot);
        }
    }
}

/// Whether a point is out of the range of the tree.
fn is_far(point: Vec3) -> bool {
    point.raw().into_iter().any(|c| c.unsigned_abs() > Object::COORDINATE_MAX.unsigned_abs())
}

impl From<PartitionError> for ColliderError {
    /// Ids are the set's own: only the range is left to be wrong.
    fn from(_: PartitionError) -> Self {
        Self::OutOfRange
    }
}
