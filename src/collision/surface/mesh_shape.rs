//! Meshes that can be collided with.

use alloc::sync::Arc;
use alloc::vec::Vec;

use super::features::Features;
use crate::geometry::{Aabb, ShapeError, Sphere, Surface, TriangleMesh};
use crate::math::{Real, Vec3};
use crate::partition::bvh::{Bvh, RefitError};

/// A triangle mesh whose vertices stand in the world, and may be moved.
///
/// What does not move, its edges and which faces share them, is made once and shared by clones. A
/// mesh is one-sided unless it is told otherwise: behind its faces is inside.
#[derive(Clone, Debug)]
pub struct MeshShape {
    features: Arc<Features>,
    tree: Bvh,
    vertices: Vec<Vec3>,
    bounds: Aabb,
    thickness: Real,
    is_two_sided: bool,
}

impl MeshShape {
    /// A one-sided mesh without a thickness, its vertices where the mesh has them. O(n log n).
    #[must_use]
    pub fn new(mesh: Arc<TriangleMesh>) -> Self {
        let features = Arc::new(Features::new(&mesh));
        let vertices = mesh.vertices().to_vec();
        let bounds = bounds(&features, &vertices);
        let thickness = Real::ZERO;
        Self { features, tree: Bvh::new(mesh), vertices, bounds, thickness, is_two_sided: false }
    }

    /// The same mesh, touched from both sides: for cloth, and for whatever is open.
    #[must_use]
    pub fn two_sided(self) -> Self {
        Self { is_two_sided: true, ..self }
    }

    /// The same mesh with a number that is kept for whoever solves its contacts: how far it is to
    /// stay from others, in metres, half of what two sheets of it are to keep.
    ///
    /// It is no geometry, and nothing here reads it: queries, contacts and separations are those of
    /// the bare faces. Add what both of a pair have to the margin, and take it off separations.
    ///
    /// # Errors
    /// [`ShapeError::Negative`], or [`ShapeError::TooLarge`] above [`Sphere::RADIUS_MAX`].
    pub fn with_thickness(self, thickness: Real) -> Result<Self, ShapeError> {
        if thickness < Real::ZERO {
            return Err(ShapeError::Negative("thickness"));
        }
        if thickness > Sphere::RADIUS_MAX {
            return Err(ShapeError::TooLarge("thickness"));
        }
        Ok(Self { thickness, ..self })
    }

    /// Moves every vertex to its place, in metres. O(n).
    ///
    /// # Errors
    /// [`RefitError`] names the first vertex, or else the first face, that is not possible; nothing
    /// has moved then.
    pub fn move_to(&mut self, positions: &[Vec3]) -> Result<(), RefitError> {
        self.tree.refit(positions)?;
        self.vertices.copy_from_slice(positions);
        self.bounds = bounds(&self.features, positions);
        Ok(())
    }

    /// The mesh, its vertices where they were when the shape was made.
    #[must_use]
    pub fn mesh(&self) -> &Arc<TriangleMesh> {
        self.tree.mesh()
    }

    /// Where the vertices are now, in metres.
    #[must_use]
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// The tree over the faces, where they are now.
    #[must_use]
    pub const fn tree(&self) -> &Bvh {
        &self.tree
    }

    /// How far it is to stay from others, in metres; see [`with_thickness`](Self::with_thickness).
    #[must_use]
    pub const fn thickness(&self) -> Real {
        self.thickness
    }

    /// How many edges there are.
    #[must_use]
    pub fn edges_len(&self) -> usize {
        self.features.ends.len()
    }

    /// Whether there are edges, and each has two faces that go along it in opposite directions: the
    /// mesh has no hole, and an inside unless it is turned inside out.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.features.is_closed
    }
}

/// The box around all vertices of faces; a mesh has some.
fn bounds(features: &Features, vertices: &[Vec3]) -> Aabb {
    let of_faces =
        (0..).zip(vertices).filter(|&(vertex, _)| !features.at_vertex(vertex).is_empty());
    Aabb::around(of_faces.map(|(_, &point)| point)).unwrap_or(Aabb::of_point(Vec3::ZERO))
}

impl Surface for MeshShape {
    /// The box around all faces. O(1).
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// O(k log k) for k nodes and faces near the box.
    fn faces_near(&self, bounds: &Aabb, faces: &mut Vec<u32>) {
        faces.clear();
        faces.extend(self.tree.faces_near(bounds));
    }

    #[inline]
    fn corners(&self, face: u32) -> [u32; 3] {
        self.mesh().faces()[face as usize]
    }

    #[inline]
    fn sides(&self, face: u32) -> [u32; 3] {
        self.features.sides[face as usize]
    }

    #[inline]
    fn ends(&self, edge: u32) -> [u32; 2] {
        self.features.ends[edge as usize]
    }

    #[inline]
    fn position(&self, vertex: u32) -> Vec3 {
        self.vertices[vertex as usize]
    }

    #[inline]
    fn faces_at_edge(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.features.at_edge(edge).iter().copied()
    }

    #[inline]
    fn faces_at_vertex(&self, vertex: u32) -> impl Iterator<Item = u32> {
        self.features.at_vertex(vertex).iter().copied()
    }

    #[inline]
    fn is_two_sided(&self) -> bool {
        self.is_two_sided
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.features.is_closed
    }

    #[inline]
    fn shells(&self) -> &[u32] {
        &self.features.shells
    }
}
