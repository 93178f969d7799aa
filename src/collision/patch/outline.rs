//! What is clipped.

use crate::collision::FeatureId;
use crate::collision::few::Few;
use crate::collision::width::Width;
use crate::math::UnitVec3;
use crate::math::wide::{dot_wide, sub};

/// A face as it is clipped; or an edge, of two corners, or a point.
#[derive(Debug)]
pub(in crate::collision) struct Outline {
    /// Its name in its shape.
    pub(in crate::collision) face: FeatureId,
    /// Points out of the shape. Means nothing for an edge or a point.
    pub(in crate::collision) normal: UnitVec3,
    /// At least one; counter-clockwise, seen from outside.
    pub(in crate::collision) corners: Few<Corner, 4>,
}

/// A corner of a face, and the side that begins there.
#[derive(Clone, Copy, Debug)]
pub(in crate::collision) struct Corner {
    /// Where it is, from the origin of the pair, raw.
    pub(in crate::collision) at: [i64; 3],
    pub(in crate::collision) name: FeatureId,
    /// From here to the next corner.
    pub(in crate::collision) edge: u32,
}

impl Outline {
    /// How far it reaches.
    #[inline]
    pub(super) fn reach<W: Width>(&self, direction: UnitVec3) -> W::Reach {
        -self.lowest::<W>(-direction).1
    }

    /// The corner that reaches least far, of several the first, and how far.
    #[inline]
    pub(super) fn lowest<W: Width>(&self, direction: UnitVec3) -> (Corner, W::Reach) {
        let mut lowest = (self.corners[0], W::along(direction, self.corners[0].at));
        for &corner in &self.corners[1..] {
            let reach = W::along(direction, corner.at);
            if reach < lowest.1 {
                lowest = (corner, reach);
            }
        }
        lowest
    }
}

/// How many sides so many corners have: an edge has one.
#[inline]
pub(super) const fn sides(corners: usize) -> usize {
    if corners > 2 { corners } else { corners - 1 }
}

/// The corner after another one.
#[inline]
pub(super) const fn after(corner: usize, corners: usize) -> usize {
    if corner + 1 < corners { corner + 1 } else { 0 }
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
    /// None of what is no face, or does not look up.
    #[inline]
    pub(super) fn new(outline: &Outline, up: UnitVec3) -> Option<Self> {
        let normal = outline.normal;
        // Close to 2^30 at most.
        let cosine = (dot_wide(normal.raw(), up.raw()) >> 30) as i64;
        (outline.corners.len() > 2 && cosine > 0).then(|| {
            let cosine = (normal != up).then_some(cosine);
            Self { normal, offset: outline.reach::<W>(normal), cosine }
        })
    }

    /// Whether it is at right angles to the direction.
    #[inline]
    pub(super) const fn is_level(&self) -> bool {
        self.cosine.is_none()
    }

    /// How far above it a point is, upwards, raw.
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
    /// Corner after corner its volumes with all sides: positive inside, in no particular unit.
    volumes: Few<i128, 16>,
    sides: usize,
}

impl Table {
    /// Seen from where `up` points to.
    #[inline]
    pub(super) fn new<W: Width>(outline: &[Corner], up: UnitVec3, others: &[Corner]) -> Self {
        let sides = sides(outline.len());
        let side = |i: usize| {
            let (start, end) = (outline[i].at, outline[after(i, outline.len())].at);
            (start, W::cross(up.raw(), sub(end, start)))
        };
        let volume = |&(start, inwards): &_, at| W::volume(inwards, sub(at, start));
        let mut volumes = Few::new();
        if let [a, b, c, d] = outline
            && sub(b.at, a.at) == sub(c.at, d.at)
        {
            // Opposite sides are parallel: the volumes with both add up to that between them.
            let halves = [0, 1].map(side);
            let between = halves.map(|half| volume(&half, d.at));
            for corner in others {
                let [first, second] = halves.map(|half| volume(&half, corner.at));
                volumes.extend([first, second, between[0] - first, between[1] - second]);
            }
        } else {
            let all: Few<_, 4> = (0..sides).map(side).collect();
            for corner in others {
                volumes.extend(all.iter().map(|side| volume(side, corner.at)));
            }
        }
        Self { volumes, sides }
    }

    /// The volumes of a corner.
    #[inline]
    pub(super) fn row(&self, corner: usize) -> &[i128] {
        &self.volumes[corner * self.sides..][..self.sides]
    }
}
