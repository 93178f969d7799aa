//! Meshes in motion.

use alloc::vec::Vec;

use super::TimeOfImpact;
use crate::collision::{FeatureId, MeshShape};
use crate::geometry::sweep::{Impact, Motion, Sweep, back_off};
use crate::geometry::{Surface, Triangle, overlap_triangle_triangle};
use crate::math::{Real, Unit, Vec3};
use crate::partition::bvh::{RefitError, SweptBvh};

/// A mesh whose vertices move evenly, each along a straight line, from where they are to their
/// places in the end.
#[derive(Clone, Debug)]
pub struct MeshMotion<'a> {
    shape: &'a MeshShape,
    end: &'a [Vec3],
    tree: SweptBvh,
}

impl<'a> MeshMotion<'a> {
    /// The motion to these positions, in metres, one for every vertex. O(n).
    ///
    /// # Errors
    /// [`RefitError`] names the first vertex, or else the first face, that is not possible.
    pub fn new(shape: &'a MeshShape, end: &'a [Vec3]) -> Result<Self, RefitError> {
        Ok(Self { shape, end, tree: SweptBvh::new(shape.tree(), end)? })
    }

    /// Where the vertices are at a time in 0..=1, rounded as [`Motion::at`] does.
    #[must_use]
    pub fn at(&self, time: Unit) -> Vec<Vec3> {
        (0..).zip(self.end).map(|(vertex, _)| self.vertex(vertex).at(time)).collect()
    }

    /// When two meshes touch, and with what; `None` proves that they do not. The gap is one between
    /// bare faces: [`MeshShape::thickness`] does not count.
    ///
    /// They touch at once where faces meet already; otherwise first where a vertex meets a face, or
    /// an edge an edge. Exact. Faces are looked at in the order of the times at which the boxes
    /// around them meet, and no more of them once that is later than a contact: O(n + k log k) for
    /// n faces and k nodes and pairs whose boxes meet before the first contact or then. What lands
    /// flat, in one plane with what it lands on, costs up to [`Sweep::work_max`] for most of these
    /// pairs, unless the plane is one of the axes'; and the larger the gap is, the more they are.
    #[must_use]
    pub fn time_of_impact(&self, other: &Self, sweep: &Sweep) -> Option<TimeOfImpact> {
        let mut found = TimeOfImpact::none();
        self.tree.visit_pairs(&other.tree, sweep.gap, Unit::ONE, |[a, b], first| {
            if first == Unit::ZERO
                && overlap_triangle_triangle(&self.face(a).start, &other.face(b).start)
            {
                found.add(Some(Impact::AT_ONCE), [FeatureId::face(a), FeatureId::face(b)]);
            }
            self.touch(other, sweep, [a, b], &mut found);
            found.time
        });
        found.found()
    }

    /// Until when both meshes can move such that, rounded as [`at`](Self::at) does, no face of one
    /// meets one of the other: 1 if they never touch, otherwise strictly before they do, or 0.
    /// Costs as much as [`time_of_impact`](Self::time_of_impact).
    ///
    /// With a gap of 2 raw units or more, which no rounding bridges, they never trade sides either.
    #[must_use]
    pub fn advance(&self, other: &Self, sweep: &Sweep) -> Unit {
        let Some(impact) = self.time_of_impact(other, sweep) else { return Unit::ONE };
        // Either is moved by half a raw unit at most.
        let near = self.tree.pairs(&other.tree, Real::from_raw(1), impact.time);
        back_off(impact.time, |time| {
            let meet = |&[a, b]: &[u32; 2]| {
                overlap_triangle_triangle(&self.face(a).at(time), &other.face(b).at(time))
            };
            !near.iter().any(meet)
        })
    }

    /// Looks at all that belongs to two faces. Everything belongs to the lowest face that has it:
    /// where two features come near, so do these faces.
    fn touch(&self, other: &Self, sweep: &Sweep, [a, b]: [u32; 2], found: &mut TimeOfImpact) {
        for vertex in self.own_vertices(a) {
            let features = [FeatureId::vertex(vertex), FeatureId::face(b)];
            let (vertex, face) = (self.vertex(vertex), other.face(b).corners());
            found.add(sweep.vertex_face_until(found.time, vertex, face), features);
        }
        for vertex in other.own_vertices(b) {
            let features = [FeatureId::face(a), FeatureId::vertex(vertex)];
            let (vertex, face) = (other.vertex(vertex), self.face(a).corners());
            found.add(sweep.vertex_face_until(found.time, vertex, face), features);
        }
        for edge_a in self.own_edges(a) {
            for edge_b in other.own_edges(b) {
                let features = [FeatureId::edge(edge_a), FeatureId::edge(edge_b)];
                let (edge_a, edge_b) = (self.edge(edge_a), other.edge(edge_b));
                found.add(sweep.edge_edge_until(found.time, edge_a, edge_b), features);
            }
        }
    }

    fn own_vertices(&self, face: u32) -> impl Iterator<Item = u32> {
        let lowest = |vertex| self.shape.faces_at_vertex(vertex).next();
        self.shape.corners(face).into_iter().filter(move |&vertex| lowest(vertex) == Some(face))
    }

    fn own_edges(&self, face: u32) -> impl Iterator<Item = u32> + Clone {
        let lowest = |edge| self.shape.faces_at_edge(edge).next();
        self.shape.sides(face).into_iter().filter(move |&edge| lowest(edge) == Some(face))
    }

    #[inline]
    fn vertex(&self, vertex: u32) -> Motion<Vec3> {
        Motion::new(self.shape.position(vertex), self.end[vertex as usize])
    }

    #[inline]
    fn edge(&self, edge: u32) -> [Motion<Vec3>; 2] {
        self.shape.ends(edge).map(|vertex| self.vertex(vertex))
    }

    #[inline]
    fn face(&self, face: u32) -> Motion<Triangle> {
        let corners = self.shape.corners(face).map(|vertex| self.vertex(vertex));
        let [start, end] = [corners.map(|c| c.start), corners.map(|c| c.end)];
        Motion::new(Triangle::between(start), Triangle::between(end))
    }
}
