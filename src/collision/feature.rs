//! Names of the parts of a shape.

use core::fmt;

/// A vertex, edge or face of a shape, by its place in the shape's own lists: the same geometry has
/// the same name on the next tick, wherever it has moved.
///
/// | shape | vertices | edges | faces |
/// |---|---|---|---|
/// | half-space, sphere | | | 0: its surface |
/// | capsule | 0, 1: its ends | 0: between them | |
/// | box | 0..8: bit k is the end of edge k | 0..12 | 0..6: `2 k` against edge k, `2 k + 1` along |
/// | hull, mesh, height field | as listed there | as listed there | as listed there |
/// | triangle | 0..3 | 0..3: from corner k to the next | 0 |
///
/// Ordered by kind (vertices, edges, faces), then by place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(transparent)]
pub struct FeatureId(u32);

/// What a feature is.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum FeatureKind {
    /// A corner.
    Vertex,
    /// Between two vertices.
    Edge,
    /// Between edges.
    Face,
}

impl FeatureId {
    /// The highest place: 2^30 - 1.
    pub const INDEX_MAX: u32 = (1 << Self::INDEX_BITS) - 1;
    const INDEX_BITS: u32 = 30;

    /// Vertex `index`, at most [`INDEX_MAX`](Self::INDEX_MAX) as for all kinds: what is beyond is
    /// cut, which debug builds refuse.
    #[inline]
    #[must_use]
    pub const fn vertex(index: u32) -> Self {
        Self::new(FeatureKind::Vertex, index)
    }

    /// Edge `index`.
    #[inline]
    #[must_use]
    pub const fn edge(index: u32) -> Self {
        Self::new(FeatureKind::Edge, index)
    }

    /// Face `index`.
    #[inline]
    #[must_use]
    pub const fn face(index: u32) -> Self {
        Self::new(FeatureKind::Face, index)
    }

    const fn new(kind: FeatureKind, index: u32) -> Self {
        debug_assert!(index <= Self::INDEX_MAX, "FeatureId: index beyond 30 bits");
        Self((kind as u32) << Self::INDEX_BITS | index & Self::INDEX_MAX)
    }

    /// What it is.
    #[inline]
    #[must_use]
    pub const fn kind(self) -> FeatureKind {
        match self.0 >> Self::INDEX_BITS {
            0 => FeatureKind::Vertex,
            1 => FeatureKind::Edge,
            _ => FeatureKind::Face,
        }
    }

    /// Its place among the features of its kind.
    #[inline]
    #[must_use]
    pub const fn index(self) -> u32 {
        self.0 & Self::INDEX_MAX
    }

    /// Kind and place in one number: `kind << 30 | index`, kinds counted 0, 1, 2.
    #[inline]
    #[must_use]
    pub const fn bits(self) -> u32 {
        self.0
    }
}

impl fmt::Debug for FeatureId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}({})", self.kind(), self.index())
    }
}
