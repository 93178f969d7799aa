//! Convex polyhedra.

mod distance;
mod facets;
mod quickhull;
mod round;
mod topology;

use alloc::sync::Arc;
use alloc::vec::Vec;

pub(super) use round::across;
pub use topology::{HullEdge, HullTopology};

use super::triangle::is_in_range;
use super::{Aabb, ShapeError, Triangle};
use crate::math::determinant::{cross, dot};
use crate::math::wide::sub;
use crate::math::{UnitVec3, Vec3};
use facets::Facets;

/// A convex polyhedron, closed: all that lies between its vertices.
///
/// What does not change where it moves is shared, see [`HullTopology`].
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct ConvexHull {
    topology: Arc<HullTopology>,
    vertices: Vec<Vec3>,
    normals: Vec<UnitVec3>,
    anchors: Vec<u32>,
    bounds: Aabb,
}

impl ConvexHull {
    /// No hull is made of more points, or has more vertices.
    pub const POINTS_MAX: usize = 1 << 22;

    /// The smallest convex polyhedron around some points, in metres. Exact: points in the plane of
    /// a face are part of it, and whatever is no corner of it is left out.
    ///
    /// Another order of the points only numbers the vertices otherwise. Expected O(n log n).
    ///
    /// # Errors
    /// [`ShapeError`] if a point is out of range, they span more than [`Triangle::SPAN_MAX`], there
    /// are more than [`POINTS_MAX`](Self::POINTS_MAX), or all lie in one plane.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Result<Self, ShapeError> {
        let points: Vec<Vec3> = points.into_iter().take(Self::POINTS_MAX + 1).collect();
        if points.len() > Self::POINTS_MAX {
            return Err(ShapeError::WrongCount("points"));
        }
        check(&points, "points")?;
        let raw: Vec<_> = points.iter().map(|p| p.raw()).collect();
        let Facets { corners, faces } = Facets::of(&raw).ok_or(ShapeError::Flat)?;
        let raw: Vec<_> = corners.iter().map(|&corner| raw[corner as usize]).collect();
        let topology = HullTopology::new(&raw, &faces).ok_or(ShapeError::Flat)?;
        Self::with_topology(Arc::new(topology), raw.into_iter().map(Vec3::from_raw).collect())
    }

    /// The hull of a topology, with its vertices in these places, see [`moved_to`](Self::moved_to).
    ///
    /// # Errors
    /// As for [`moved_to`](Self::moved_to).
    pub fn with_topology(
        topology: Arc<HullTopology>,
        vertices: Vec<Vec3>,
    ) -> Result<Self, ShapeError> {
        let bounds = check_moved(&topology, &vertices)?;
        let faces = topology.widest_corners().len();
        let (normals, anchors) = (Vec::with_capacity(faces), Vec::with_capacity(faces));
        let mut hull = Self { topology, vertices, normals, anchors, bounds };
        hull.raise_planes();
        Ok(hull)
    }

    /// Moves the vertices, all by one affine map: turned, sheared, stretched or shifted, each
    /// coordinate rounded. The topology stays as it is.
    ///
    /// That it is one map is not checked: of other places the result is some hull. O(corners).
    ///
    /// # Errors
    /// [`ShapeError`] if there are not as many places as vertices, one is out of range, they span
    /// more than [`Triangle::SPAN_MAX`], or the hull would be flat, or turned inside out. It stays
    /// where it was then.
    pub fn moved_to(&mut self, vertices: &[Vec3]) -> Result<(), ShapeError> {
        self.bounds = check_moved(&self.topology, vertices)?;
        self.vertices.copy_from_slice(vertices);
        self.raise_planes();
        Ok(())
    }

    /// What hulls share that differ in where they are only.
    #[inline]
    #[must_use]
    pub const fn topology(&self) -> &Arc<HullTopology> {
        &self.topology
    }

    /// The vertices, in metres; at least 4.
    #[inline]
    #[must_use]
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// The corners of every face, see [`HullTopology::faces`].
    #[must_use]
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.topology.faces()
    }

    /// The corners of a face, see [`HullTopology::face_corners`]. O(1).
    #[inline]
    #[must_use]
    pub fn face_corners(&self, face: u32) -> &[u32] {
        self.topology.face_corners(face)
    }

    /// The edges, see [`HullTopology::edges`].
    #[inline]
    #[must_use]
    pub fn edges(&self) -> &[HullEdge] {
        self.topology.edges()
    }

    /// The normal of every face, outwards: that of its
    /// [widest corners](HullTopology::widest_corners).
    #[inline]
    #[must_use]
    pub fn normals(&self) -> &[UnitVec3] {
        &self.normals
    }

    /// For every face the corner that is farthest along its normal, of several the first: none of
    /// its corners is in front of the plane through this one.
    #[inline]
    #[must_use]
    pub fn anchors(&self) -> &[u32] {
        &self.anchors
    }

    /// The smallest box along the axes around it. Exact.
    #[inline]
    #[must_use]
    pub const fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Whether a point, in metres, is inside or on the surface. Exact. O(faces).
    ///
    /// The planes of faces are parallel to those of their [widest
    /// corners](HullTopology::widest_corners), and go through the outermost corner: where a moved
    /// hull was rounded, all corners of a face are within it.
    #[must_use]
    pub fn contains(&self, point: Vec3) -> bool {
        // From inside the box differences are below 2^41.
        self.bounds.contains(&Aabb::of_point(point)) && {
            let mut faces = self.topology.widest_corners().iter().zip(self.faces());
            faces.all(|(&widest, corners)| {
                let normal = normal(&self.vertices, widest);
                let mut from = corners.iter().map(|&corner| self.vertices[corner as usize]);
                from.any(|corner| dot(&normal, sub(point.raw(), corner.raw())) <= 0)
            })
        }
    }

    /// Computes the normals, and where along them the faces are.
    fn raise_planes(&mut self) {
        let Self { topology, vertices, normals, anchors, bounds: _ } = self;
        normals.clear();
        anchors.clear();
        for (&widest, corners) in topology.widest_corners().iter().zip(topology.faces()) {
            // It has one: vertices have been checked.
            let normal = UnitVec3::normalize_wide(self::normal(vertices, widest));
            let normal = normal.unwrap_or(UnitVec3::Y);
            normals.push(normal);
            anchors.push(anchor(vertices, corners, normal));
        }
    }
}

/// The cross product that points out of a face with these corners, below 2^82.
#[inline]
fn normal(vertices: &[Vec3], corners: [u32; 3]) -> [i128; 3] {
    let [a, b, c] = corners.map(|corner| vertices[corner as usize].raw());
    cross(sub(b, a), sub(c, a))
}

/// See [`ConvexHull::anchors`].
fn anchor(vertices: &[Vec3], corners: &[u32], normal: UnitVec3) -> u32 {
    let Some((&first, rest)) = corners.split_first() else { return 0 };
    let [n, from] = [normal.raw(), vertices[first as usize].raw()];
    let mut best = (0, first);
    for &corner in rest {
        let [x, y, z] = sub(vertices[corner as usize].raw(), from);
        // Differences are below 2^41, components at most 2^30: below 3 * 2^71.
        let height = [(n[0], x), (n[1], y), (n[2], z)]
            .map(|(n, d)| i128::from(n) * i128::from(d))
            .into_iter()
            .sum::<i128>();
        if height > best.0 {
            best = (height, corner);
        }
    }
    best.1
}

/// Checks points of a hull; returns the box around them.
fn check(points: &[Vec3], field: &'static str) -> Result<Aabb, ShapeError> {
    if !points.iter().copied().all(is_in_range) {
        return Err(ShapeError::OutOfRange(field));
    }
    let bounds = Aabb::around(points.iter().copied()).ok_or(ShapeError::Flat)?;
    let is_short = bounds.span() <= Triangle::SPAN_MAX.unsigned_abs();
    if is_short { Ok(bounds) } else { Err(ShapeError::TooLong) }
}

/// Checks places for the vertices of a topology; returns the box around them.
fn check_moved(topology: &HullTopology, vertices: &[Vec3]) -> Result<Aabb, ShapeError> {
    if vertices.len() != topology.vertices_len() as usize {
        return Err(ShapeError::WrongCount("vertices"));
    }
    let bounds = check(vertices, "vertices")?;
    let [a, b, c, d] = topology.simplex();
    let way = sub(vertices[d as usize].raw(), vertices[a as usize].raw());
    // Negative where the fourth is behind the plane of the others. Below 2^125.
    match dot(&normal(vertices, [a, b, c]), way) {
        1.. => return Err(ShapeError::Mirrored),
        0 => return Err(ShapeError::Flat),
        ..0 => {}
    }
    let has_area = |&widest: &[u32; 3]| normal(vertices, widest) != [0; 3];
    let is_solid = topology.widest_corners().iter().all(has_area);
    if is_solid { Ok(bounds) } else { Err(ShapeError::Flat) }
}
