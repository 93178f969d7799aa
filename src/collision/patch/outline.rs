//! What is clipped.

use crate::collision::FeatureId;
use crate::collision::few::Few;
use crate::collision::width::Width;
use crate::math::UnitVec3;
use crate::math::wide::{dot_wide, sub};

/// A face as it is clipped; or an edge, of two corners, or a point.
#[derive(Clone, Debug)]
pub(in crate::collision) struct Outline {
    /// Its name in its shape.
    pub(in crate::collision) face: FeatureId,
    /// Points out of the shape. Means nothing for an edge or a point.
    pub(in crate::collision) normal: UnitVec3,
    /// At least one; counter-clockwise, seen from outside.
    pub(in crate::collision) corners: Few<Corner, 4>,
}

/// A corner of a face, and the side that begins there.
#[derive(Clone, Copy, Default, Debug)]
pub(in crate::collision) struct Corner {
    /// Where it is, from the origin of the pair, raw.
    pub(in crate::collision) at: [i64; 3],
    pub(in crate::collision) vertex: u32,
    /// From here to the next corner.
    pub(in crate::collision) edge: u32,
}

impl Outline {
    /// Whether it has an inside.
    #[inline]
    pub(super) fn is_face(&self) -> bool {
        self.corners.len() > 2
    }

    /// The sides, by the places of their corners.
    #[inline]
    pub(super) fn sides(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        let corners = self.corners.len();
        // An edge has one.
        let sides = if corners > 2 { corners } else { corners - 1 };
        (0..sides).map(move |i| [i, if i + 1 < corners { i + 1 } else { 0 }])
    }

    /// How far it reaches.
    #[inline]
    pub(super) fn reach<W: Width>(&self, direction: UnitVec3) -> W::Reach {
        let along = |corner: &Corner| W::along(direction, corner.at);
        let first = along(&self.corners[0]);
        self.corners[1..].iter().map(along).fold(first, Ord::max)
    }
}

/// The plane of a face, for heights along one direction.
pub(super) struct Plane<W: Width> {
    normal: UnitVec3,
    /// None of the corners is in front of it.
    offset: W::Reach,
    /// Between the normal and the direction, times 2^30; none if they are equal.
    cosine: Option<i64>,
}

impl<W: Width> Plane<W> {
    /// None if the direction does not point out of the face.
    #[inline]
    pub(super) fn new(face: &Outline, up: UnitVec3) -> Option<Self> {
        let normal = face.normal;
        let offset = face.reach::<W>(normal);
        if normal == up {
            return Some(Self { normal, offset, cosine: None });
        }
        // Close to 2^30 at most.
        let cosine = (dot_wide(normal.raw(), up.raw()) >> 30) as i64;
        (face.is_face() && cosine > 0).then_some(Self { normal, offset, cosine: Some(cosine) })
    }

    /// How far above it a point is, along the direction, raw.
    #[inline]
    pub(super) fn height(&self, point: [i64; 3]) -> i64 {
        let reach = W::along(self.normal, point) - self.offset;
        match self.cosine {
            None => W::round(reach),
            Some(cosine) => W::slant(reach, cosine),
        }
    }
}

/// On which sides of the sides of one outline the corners of another are.
pub(super) struct Table {
    /// Side after side the volumes of all corners: positive inside, in no particular unit.
    volumes: Few<i128, 16>,
    corners: usize,
}

impl Table {
    /// Seen from where `up` points to.
    #[inline]
    pub(super) fn new<W: Width>(outline: &Outline, up: UnitVec3, other: &Outline) -> Self {
        let mut volumes = Few::new();
        for [i, next] in outline.sides() {
            let start = outline.corners[i].at;
            let inwards = W::cross(up.raw(), sub(outline.corners[next].at, start));
            for corner in other.corners.iter() {
                volumes.push(W::volume(inwards, sub(corner.at, start)));
            }
        }
        Self { volumes, corners: other.corners.len() }
    }

    #[inline]
    pub(super) fn of(&self, side: usize, corner: usize) -> i128 {
        self.volumes[side * self.corners + corner]
    }

    /// The least of a corner's.
    #[inline]
    pub(super) fn least(&self, corner: usize) -> i128 {
        let volumes = self.volumes.iter().skip(corner).step_by(self.corners);
        volumes.fold(i128::MAX, |least, &volume| least.min(volume))
    }
}
