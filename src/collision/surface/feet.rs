//! Where a surface is nearest to a point: all places, not only the first.

use alloc::vec::Vec;

use super::near::Near;
use super::side::{Side, side};
use crate::collision::{FeatureId, FeatureKind};
use crate::geometry::{
    Aabb, Feature, Surface, Triangle, closest_point_triangle, normal_point_triangle,
};
use crate::math::{Real, UnitVec3, Vec3};

/// A place of a surface to which a point is nearer than to all others around.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    /// What it lies on.
    pub(super) feature: FeatureId,
    pub(super) position: Vec3,
    /// From the point to the place; negative where the point is inside.
    pub(super) separation: Real,
    /// From the point into the surface.
    pub(super) normal: UnitVec3,
}

/// The nearest place of one face.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    feature: FeatureId,
    distance: Real,
    position: Vec3,
    triangle: Triangle,
    on: Feature,
}

/// Distances are to rounded places: those of two that are equally far differ by no more than this.
const ROUNDED: Real = Real::from_raw(2);

/// Lists that are used again.
#[derive(Debug, Default)]
pub(super) struct Feet {
    candidates: Vec<Candidate>,
    found: Vec<Foot>,
}

impl Feet {
    /// The places within `reach` of a point, sorted by feature; if the point is inside, only the
    /// nearest one.
    ///
    /// `faces` are all faces within reach, each once. A place is one of a vertex or an edge if it
    /// is the nearest place of **every** face there: so the region of each feature is told by exact
    /// signs, inner edges and vertices of flat or hollow parts have none, and a point has no foot
    /// twice. The nearest place of all counts in any case: where faces without an area hide which
    /// edges are one, it would be missed.
    pub(super) fn of<'a, S: Surface>(
        &mut self,
        surface: &S,
        point: Vec3,
        faces: impl Iterator<Item = &'a Near>,
        reach: Real,
    ) -> &[Foot] {
        self.found.clear();
        self.gather(surface, point, faces, reach);
        let Some(nearest) = self.nearest(surface) else { return &self.found };
        if side(surface, point, nearest.feature) == Side::Inside {
            self.found.push(nearest.foot(surface, point, Side::Inside));
        } else {
            self.collect(surface, point, nearest, Side::Outside);
        }
        &self.found
    }

    /// The places within `reach` of a point behind which it is, from near to far, however many
    /// others are nearer; of equally near ones the lower feature first. `faces` are as for
    /// [`of`](Self::of).
    pub(super) fn of_inside<'a, S: Surface>(
        &mut self,
        surface: &S,
        point: Vec3,
        faces: impl Iterator<Item = &'a Near>,
        reach: Real,
    ) -> &[Foot] {
        self.found.clear();
        self.gather(surface, point, faces, reach);
        let Some(nearest) = self.nearest(surface) else { return &self.found };
        self.collect(surface, point, nearest, Side::Inside);
        self.found.sort_unstable_by_key(|foot| (-foot.separation, foot.feature));
        &self.found
    }

    /// Adds all places from which the point is seen on a side, sorted by feature.
    fn collect<S: Surface>(&mut self, surface: &S, point: Vec3, nearest: Candidate, on: Side) {
        for (candidate, is_whole) in groups(&self.candidates, surface) {
            let is_foot = is_whole || candidate.feature == nearest.feature;
            if is_foot && side(surface, point, candidate.feature) == on {
                self.found.push(candidate.foot(surface, point, on));
            }
        }
    }

    /// The nearest place of all, but of those that are as near one that is whole.
    fn nearest<S: Surface>(&self, surface: &S) -> Option<Candidate> {
        let groups = || groups(&self.candidates, surface);
        let rank = |c: &Candidate| (c.distance, c.feature);
        let (nearest, _) = groups().min_by_key(|(c, _)| rank(c))?;
        let whole = groups().filter(|(_, is_whole)| *is_whole).map(|(c, _)| c).min_by_key(rank);
        Some(match whole {
            Some(whole) if whole.distance <= nearest.distance + ROUNDED => whole,
            _ => nearest,
        })
    }

    /// The candidates, sorted by feature.
    fn gather<'a, S: Surface>(
        &mut self,
        surface: &S,
        point: Vec3,
        faces: impl Iterator<Item = &'a Near>,
        reach: Real,
    ) {
        self.candidates.clear();
        let bounds = Aabb::of_point(point);
        for near in faces.filter(|near| near.is_near(&bounds, reach)) {
            let foot = closest_point_triangle(point, &near.triangle);
            let distance = point.distance(foot.position);
            if distance > reach {
                continue;
            }
            let feature = match foot.feature {
                Feature::Vertex(k) => FeatureId::vertex(surface.corners(near.face)[usize::from(k)]),
                Feature::Edge(k) => FeatureId::edge(surface.sides(near.face)[usize::from(k)]),
                Feature::Face => FeatureId::face(near.face),
            };
            let (position, on) = (foot.position, foot.feature);
            let triangle = near.triangle;
            self.candidates.push(Candidate { feature, distance, position, triangle, on });
        }
        self.candidates.sort_unstable_by_key(|c| c.feature);
    }
}

impl Candidate {
    fn foot<S: Surface>(&self, surface: &S, point: Vec3, side: Side) -> Foot {
        let Self { feature, distance, position, triangle, on } = *self;
        let is_inside = side == Side::Inside;
        let normal = match normal_point_triangle(point, &triangle, on) {
            Some(normal) if is_inside => -normal,
            Some(normal) => normal,
            None => inward(surface, feature),
        };
        let separation = if is_inside { -distance } else { distance };
        Foot { feature, position, separation, normal }
    }
}

/// One candidate of each feature, and whether it is whole: the nearest place of every face there.
fn groups<S: Surface>(all: &[Candidate], surface: &S) -> impl Iterator<Item = (Candidate, bool)> {
    let same = all.chunk_by(|a, b| a.feature == b.feature);
    same.map(|same| (same[0], same.len() == faces_at(surface, same[0].feature)))
}

/// How many faces there are at a feature.
fn faces_at<S: Surface>(surface: &S, feature: FeatureId) -> usize {
    match feature.kind() {
        FeatureKind::Face => 1,
        FeatureKind::Edge => surface.faces_at_edge(feature.index()).count(),
        FeatureKind::Vertex => surface.faces_at_vertex(feature.index()).count(),
    }
}

/// Into the surface at a feature: against the normals of its faces, together or, where these cancel
/// out, of the lowest one that has any; down if none has.
pub(super) fn inward<S: Surface>(surface: &S, feature: FeatureId) -> UnitVec3 {
    let normals: Vec<_> = match feature.kind() {
        FeatureKind::Face => normal_of(surface, feature.index()).into_iter().collect(),
        FeatureKind::Edge => {
            surface.faces_at_edge(feature.index()).filter_map(|f| normal_of(surface, f)).collect()
        }
        FeatureKind::Vertex => {
            surface.faces_at_vertex(feature.index()).filter_map(|f| normal_of(surface, f)).collect()
        }
    };
    // At most 2^23 unit vectors.
    let sum = normals.iter().fold([0; 3], |sum, normal| crate::math::wide::add(sum, normal.raw()));
    let together = UnitVec3::normalize(Vec3::from_raw(sum));
    -together.or(normals.first().copied()).unwrap_or(UnitVec3::Y)
}

/// The outer normal of a face, if it has an area.
pub(super) fn normal_of<S: Surface>(surface: &S, face: u32) -> Option<UnitVec3> {
    let [a, b, c] = surface.triangle(face).corners().map(Vec3::raw);
    let [u, v] = [b, c].map(|end| crate::math::wide::sub(end, a));
    UnitVec3::normalize_wide(crate::math::determinant::cross(u, v))
}
