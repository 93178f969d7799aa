//! Where edges of two surfaces are nearest, both between their ends.

use super::feet::normal_of;
use super::near::{Near, is_near, tip};
use super::proximity::{Proximity, along};
use crate::collision::{Contact, FeatureId};
use crate::geometry::{Aabb, Feature, Segment, Surface, closest_segment_segment};
use crate::math::determinant::{Full, Middle, Width, cross};
use crate::math::wide::{NARROW_MAX, dot_wide, sub};
use crate::math::{Real, UnitVec3, Vec3};

/// An edge of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ridge {
    pub(super) edge: u32,
    pub(super) segment: Segment,
    pub(super) bounds: Aabb,
}

impl Ridge {
    /// A side of a face.
    pub(super) fn of<S: Surface>(surface: &S, near: &Near, side: usize) -> Self {
        let corners = near.triangle.corners();
        let segment = Segment::between([corners[side], corners[(side + 1) % 3]]);
        Self { edge: surface.sides(near.face)[side], segment, bounds: segment.bounds() }
    }
}

/// Which of a direction and its opposite lead away from all faces at an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cone {
    along: bool,
    against: bool,
    /// Whether the edge parts an inside from an outside.
    is_solid: bool,
}

impl Cone {
    /// Of a direction at right angles to an edge; of a wire, which is at no surface, any.
    ///
    /// A wire is solid: what it has passed through is told by the other edge alone.
    fn of<W: Width, S: Surface>((surface, ridge): Rim<'_, S>, direction: &[W::Minor; 3]) -> Self {
        let free = Self { along: true, against: true, is_solid: true };
        let Some(surface) = surface else { return free };
        let origin = ridge.segment.ends()[0].raw();
        let (mut cone, mut count) = (free, 0);
        for face in surface.faces_at_edge(ridge.edge) {
            let to_tip = sub(tip(surface, ridge.edge, face).raw(), origin);
            let height = W::sign(direction, to_tip);
            cone.along &= height <= 0;
            cone.against &= height >= 0;
            count += 1;
        }
        Self { is_solid: count == 2 && !surface.is_two_sided(), ..cone }
    }
}

/// An edge with its surface, or a wire without one.
pub(super) type Rim<'a, S> = (Option<&'a S>, &'a Ridge);

/// Where an edge of A is nearest to an edge of B, if that is between the ends of both and leads out
/// of all faces there, and they are at most `margin` apart or `depth` into one another.
pub(super) fn crossing<A: Surface, B: Surface>(
    a: Rim<'_, A>,
    b: Rim<'_, B>,
    [depth, margin]: [Real; 2],
) -> Option<Proximity> {
    let (ridge_a, ridge_b) = (a.1, b.1);
    if !is_near(&ridge_a.bounds, &ridge_b.bounds, margin.max(depth)) {
        return None;
    }
    let [[a0, a1], [b0, b1]] = [ridge_a, ridge_b].map(|r| r.segment.ends().map(Vec3::raw));
    let (u, v, way) = (sub(a1, a0), sub(b1, b0), sub(b0, a0));
    // Ways to tips and to one another are below 2^42 in any case.
    let span = ridge_a.bounds.span().max(ridge_b.bounds.span());
    let is_forward = if span <= NARROW_MAX.unsigned_abs() {
        orientation::<Middle, A, B>(a, b, &Middle::cross(u, v), way)
    } else {
        orientation::<Full, A, B>(a, b, &Full::cross(u, v), way)
    }?;
    let [on_a, on_b] = closest_segment_segment(&ridge_a.segment, &ridge_b.segment);
    if [on_a.feature, on_b.feature] != [Feature::Edge(0); 2] {
        return None;
    }
    let direction = UnitVec3::normalize_wide(cross(u, v))?;
    let normal = if is_forward { direction } else { -direction };
    let separation = along(normal, way);
    let is_deep = separation < Real::ZERO;
    if separation > margin
        || separation < -depth
        || is_deep && !(dives(a, -normal) && dives(b, normal))
    {
        return None;
    }
    let features = [ridge_a.edge, ridge_b.edge].map(FeatureId::edge);
    let (on_a, on_b) = (on_a.position, on_b.position);
    Some(Proximity { normal, contact: Contact { features, on_a, on_b, separation } })
}

/// Whether a direction leads into what an edge is part of, and not only along a face.
fn dives<S: Surface>((surface, ridge): Rim<'_, S>, direction: UnitVec3) -> bool {
    /// A sine of 1 / 64.
    const LEAST: i128 = 1 << 54;
    let Some(surface) = surface else { return true };
    let mut normals = surface.faces_at_edge(ridge.edge).filter_map(|face| normal_of(surface, face));
    normals.all(|normal| dot_wide(normal.raw(), direction.raw()) < -LEAST)
}

/// Whether the normal is along the direction or, `Some(false)`, against it; none if it is neither.
///
/// It leads away from the faces of A, and the opposite away from those of B. Where that leaves both
/// ways, or where there is no inside, it is the way from A to B.
fn orientation<W: Width, A: Surface, B: Surface>(
    a: Rim<'_, A>,
    b: Rim<'_, B>,
    direction: &[W::Minor; 3],
    way: [i64; 3],
) -> Option<bool> {
    let (a, b) = (Cone::of::<W, A>(a, direction), Cone::of::<W, B>(b, direction));
    let way = W::sign(direction, way);
    let is_solid = a.is_solid && b.is_solid;
    match (a.along && b.against, a.against && b.along) {
        (false, false) => None,
        (true, true) => Some(way >= 0),
        (true, false) => (way >= 0 || is_solid).then_some(true),
        (false, true) => (way <= 0 || is_solid).then_some(false),
    }
}
