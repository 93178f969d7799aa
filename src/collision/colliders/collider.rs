//! What is in the set.

use core::fmt;

use crate::collision::Shape;
use crate::store::Handle;

/// The name of a collider.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ColliderId(pub Handle);

/// A shape, and what it has to do with.
#[derive(Clone, Debug)]
pub struct Collider {
    /// The shape, where it is.
    pub shape: Shape,
    /// What may meet it, and what it may meet.
    pub layers: Layers,
    /// Whatever the owner of the set likes; it never reaches a result.
    pub user_data: u64,
}

/// A bit for each layer that something is on, and one for each that it may meet.
///
/// Two things may meet if each is on a layer that the other may meet.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Layers {
    /// The layers that it is on.
    pub on: u32,
    /// The layers that it may meet.
    pub mask: u32,
}

/// Why a collider is not taken in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ColliderError {
    /// There is no collider of this id.
    UnknownId,
    /// It reaches beyond [`COORDINATE_MAX`](crate::partition::Object::COORDINATE_MAX).
    OutOfRange,
    /// There are 2^20 colliders.
    Full,
}

impl Layers {
    /// On every layer, and may meet every layer.
    pub const ALL: Self = Self { on: u32::MAX, mask: u32::MAX };

    /// Whether both may meet.
    #[inline]
    #[must_use]
    pub const fn may_meet(self, other: Self) -> bool {
        self.mask & other.on != 0 && other.mask & self.on != 0
    }
}

impl Default for Layers {
    /// [`ALL`](Self::ALL).
    fn default() -> Self {
        Self::ALL
    }
}

impl<S: Into<Shape>> From<S> for Collider {
    /// On all layers, without user data.
    fn from(shape: S) -> Self {
        Self { shape: shape.into(), layers: Layers::ALL, user_data: 0 }
    }
}

impl fmt::Display for ColliderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::UnknownId => "no collider has this id",
            Self::OutOfRange => "collider is out of range",
            Self::Full => "there are 1048576 colliders",
        })
    }
}

impl core::error::Error for ColliderError {}
