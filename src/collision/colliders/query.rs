//! What is where.

use alloc::vec::Vec;

use super::{Collider, ColliderId, Colliders, Layers};
use crate::collision::distance::grown;
use crate::collision::{Cast, Closest, Shape, cast, cast_segment, closest_points, overlap};
use crate::geometry::{Aabb, Segment, Sphere};
use crate::math::{Real, Vec3};
use crate::partition::Partition;

/// Which colliders count.
#[derive(Clone, Copy)]
pub struct Filter<'a> {
    /// What may meet the query, and what it may meet.
    pub layers: Layers,
    /// Has the last word. It must depend on its arguments, and on what peers agree on, alone.
    pub predicate: &'a dyn Fn(ColliderId, &Collider) -> bool,
}

impl Filter<'_> {
    /// Everything.
    pub const ALL: Filter<'static> = Filter { layers: Layers::ALL, predicate: &|_, _| true };

    fn lets_pass(&self, id: ColliderId, collider: &Collider) -> bool {
        self.layers.may_meet(collider.layers) && (self.predicate)(id, collider)
    }
}

impl Colliders {
    /// What a shape touches on its way, moving by `motion` in metres without turning, in the order
    /// in which it does: by time, then by id. See [`cast`], and
    /// [`cast_first`](Self::cast_first) if the first one is enough.
    #[must_use]
    pub fn cast(&self, shape: &Shape, motion: Vec3, filter: &Filter) -> Vec<(ColliderId, Cast)> {
        let way = |bounds: Aabb| bounds.union(shifted(&bounds, motion));
        let region = shape.bounds().map(way);
        self.casts(region, filter, |other| cast(shape, motion, other))
    }

    /// What a segment goes through, from its first end to its second, in order: by time, then by
    /// id. Normals point into what is hit. See [`cast_segment`], and
    /// [`cast_segment_first`](Self::cast_segment_first) if the first one is enough.
    #[must_use]
    pub fn cast_segment(&self, segment: &Segment, filter: &Filter) -> Vec<(ColliderId, Cast)> {
        let region = Some(segment.bounds());
        self.casts(region, filter, |shape| cast_segment(segment, shape))
    }

    fn casts(
        &self,
        region: Option<Aabb>,
        filter: &Filter,
        cast: impl Fn(&Shape) -> Option<Cast>,
    ) -> Vec<(ColliderId, Cast)> {
        let hit = |(id, collider): (_, &Collider)| Some((id, cast(&collider.shape)?));
        let mut hits: Vec<_> = self.near(region, filter).filter_map(hit).collect();
        hits.sort_by_key(|&(id, cast)| (cast.time, id));
        hits
    }

    /// What overlaps a shape, by id; touching counts. See [`overlap`]: meshes are hollow.
    #[must_use]
    pub fn overlaps(&self, shape: &Shape, filter: &Filter) -> Vec<ColliderId> {
        let near = self.near(shape.bounds(), filter);
        near.filter(|(_, other)| overlap(shape, &other.shape)).map(|(id, _)| id).collect()
    }

    /// What is not farther from a shape than `reach`, in metres, the nearest first: by distance,
    /// then by id. What overlaps comes with nothing and before all others. See [`closest_points`].
    #[must_use]
    pub fn closest(
        &self,
        shape: &Shape,
        reach: Real,
        filter: &Filter,
    ) -> Vec<(ColliderId, Option<Closest>)> {
        let region = shape.bounds().map(|bounds| grown(&bounds, reach));
        let distance = |closest: &Option<Closest>| closest.map_or(Real::ZERO, |c| c.distance);
        let mut all: Vec<_> = self
            .near(region, filter)
            .map(|(id, other)| (id, closest_points(shape, &other.shape)))
            .filter(|(_, closest)| distance(closest) <= reach)
            .collect();
        all.sort_by_key(|(id, closest)| (distance(closest), *id));
        all
    }

    /// What a point, in metres, is in, by id; the surface counts. See [`Shape::contains`]: meshes
    /// and height fields are hollow, and a point out of the range of shapes is in nothing.
    #[must_use]
    pub fn at_point(&self, point: Vec3, filter: &Filter) -> Vec<ColliderId> {
        Sphere::new(point, Real::ZERO)
            .map_or_else(|_| Vec::new(), |point| self.overlaps(&point.into(), filter))
    }

    /// The colliders whose boxes touch a region, and those without a box, by id; all of them where
    /// the region has no end.
    pub(super) fn near<'a>(
        &'a self,
        region: Option<Aabb>,
        filter: &'a Filter,
    ) -> impl Iterator<Item = (ColliderId, &'a Collider)> {
        let mut slots = Vec::new();
        if let Some(region) = region {
            self.tree.query(&region, &mut slots);
            slots.extend(&self.endless);
            slots.sort_unstable();
        } else {
            slots.extend(self.slots.iter().map(|id| id.index));
        }
        slots.into_iter().filter_map(|slot| {
            let id = ColliderId(self.slots.tenant(slot)?);
            let collider = self.get(id)?;
            filter.lets_pass(id, collider).then_some((id, collider))
        })
    }
}

/// A box elsewhere, or as far as there are numbers.
pub(super) fn shifted(bounds: &Aabb, by: Vec3) -> Aabb {
    let shift = |corner: Vec3| {
        let (corner, by) = (corner.raw(), by.raw());
        Vec3::from_raw([0, 1, 2].map(|k| corner[k].saturating_add(by[k])))
    };
    Aabb::new(shift(bounds.min()), shift(bounds.max()))
}
