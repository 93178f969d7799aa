//! Where two faces touch: one clipped by the other, along a direction.
//!
//! Seen along the normal, both faces are convex polygons. What they have in common is a polygon
//! too, and each of its corners is one of three things: a corner of one face that lies over the
//! other, or a point where two sides cross. All are found from the corners of the faces by exact
//! signs, none from another: so each has a name, and none has the rounding errors of another.
//!
//! A corner exactly over a side counts as inside if it is B's, outside if it is A's: where faces
//! share corners and sides, what they have in common has each corner once.

mod clip;
mod outline;
mod reduce;

pub(super) use outline::{Corner, Outline};

use super::few::Few;
use super::width::Width;
use super::{Contact, FeatureId};
use crate::math::wide::{add, sub};
use crate::math::{Real, UnitVec3, Vec3};
use clip::common;
pub(super) use reduce::reduce;

/// Lengths that differ by less count as one where a choice depends on it, raw: 31 um. So the noise
/// of a stack at rest does not turn one manifold into another.
pub(super) const TIE: i64 = 1 << 9;

/// A contact, from the origin of the pair, raw.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch {
    pub(super) features: [FeatureId; 2],
    /// The points on A and on B.
    pub(super) on: [[i64; 3]; 2],
    pub(super) separation: i64,
}

impl Default for Touch {
    fn default() -> Self {
        Self { features: [FeatureId::face(0); 2], on: [[0; 3]; 2], separation: 0 }
    }
}

impl Touch {
    /// The same in the world. Places are below 2^60 there, and moved by less than 2^43.
    #[inline]
    pub(super) fn contact(self, origin: [i64; 3]) -> Contact {
        let Self { features, on, separation } = self;
        let [on_a, on_b] = on.map(|point| Vec3::from_raw(add(origin, point)));
        Contact { features, on_a, on_b, separation: Real::from_raw(separation) }
    }

    /// With A and B exchanged.
    #[inline]
    pub(super) fn flipped(self) -> Self {
        let Self { features: [a, b], on: [on_a, on_b], separation } = self;
        Self { features: [b, a], on: [on_b, on_a], separation }
    }
}

/// Up to four points in which two outlines touch, at most `margin` apart along `normal`, which
/// points from the first to the second. There is always one: where they are deepest.
pub(super) fn patch<W: Width>(
    normal: UnitVec3,
    outlines: [&Outline; 2],
    margin: i64,
) -> Few<Touch, 4> {
    let mut touches = common::<W>(normal, outlines, margin);
    let deepest = deepest::<W>(normal, outlines);
    let least = touches.iter().map(|touch| touch.separation).min();
    if least.is_none_or(|least| least > deepest.separation + TIE) {
        // The corner that is deepest has slipped past a side.
        touches = touches.iter().copied().filter(|t| t.features != deepest.features).collect();
        touches.push(deepest);
    }
    reduce(normal, &touches)
}

/// The corner of B that is deepest below A, whether it is over the face or not.
fn deepest<W: Width>(normal: UnitVec3, [a, b]: [&Outline; 2]) -> Touch {
    let (mut deepest, mut least) = (b.corners[0], W::along(normal, b.corners[0].at));
    for &corner in &b.corners[1..] {
        let reach = W::along(normal, corner.at);
        if reach < least {
            (deepest, least) = (corner, reach);
        }
    }
    let separation = W::round(least - a.reach::<W>(normal));
    let on_a = sub(deepest.at, W::step(normal, separation));
    let features = [a.face, FeatureId::vertex(deepest.vertex)];
    Touch { features, on: [on_a, deepest.at], separation }
}
