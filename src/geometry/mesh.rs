//! Triangles that share vertices.

use alloc::vec::Vec;
use core::fmt;

use super::Triangle;
use super::triangle::is_in_range;
use crate::math::Vec3;
use crate::store::{Hash, Hasher};

/// Vertices and the triangles between them. Immutable; the same lists give an equal mesh.
///
/// A face names its three corners by their places among the vertices, counted from 0. Vertices that
/// no face names, vertices in one place, faces without an area, and edges of any number of faces
/// are all allowed: a mesh is what its source says.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TriangleMesh {
    vertices: Vec<Vec3>,
    faces: Vec<[u32; 3]>,
    hash: Hash,
}

/// A mesh in the making, each part of it checked as it is added.
#[derive(Clone, Debug, Default)]
pub struct MeshBuilder {
    vertices: Vec<Vec3>,
    faces: Vec<[u32; 3]>,
}

/// Why something is not a mesh. Vertices and faces are counted from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum MeshError {
    /// There is no face.
    NoFace,
    /// There are more than [`TriangleMesh::VERTICES_MAX`] vertices.
    TooManyVertices,
    /// There are more than [`TriangleMesh::FACES_MAX`] faces.
    TooManyFaces,
    /// A coordinate is beyond [`Triangle::COORDINATE_MAX`].
    OutOfRange {
        /// The vertex that has it.
        vertex: u32,
    },
    /// A face names a vertex that is not there.
    NoSuchVertex {
        /// The face.
        face: u32,
        /// What it names.
        vertex: u32,
    },
    /// A face spans more than [`Triangle::SPAN_MAX`] along an axis.
    TooLong {
        /// The face.
        face: u32,
    },
    /// The tolerance of a weld is below 0.
    NegativeTolerance,
}

impl TriangleMesh {
    /// The most vertices: 2^22, as many as a world may have particles.
    pub const VERTICES_MAX: usize = 1 << 22;
    /// The most faces.
    pub const FACES_MAX: usize = 1 << 23;

    /// The mesh of these vertices and faces. O(vertices + faces).
    ///
    /// # Errors
    /// [`MeshError`] names the first vertex, or else the first face, that is not possible.
    pub fn new(
        vertices: impl IntoIterator<Item = Vec3>,
        faces: impl IntoIterator<Item = [u32; 3]>,
    ) -> Result<Self, MeshError> {
        let mut builder = MeshBuilder::default();
        vertices.into_iter().try_for_each(|position| builder.vertex(position).map(drop))?;
        faces.into_iter().try_for_each(|corners| builder.face(corners).map(drop))?;
        builder.build()
    }

    /// The vertices, in metres.
    #[must_use]
    pub fn vertices(&self) -> &[Vec3] {
        &self.vertices
    }

    /// The corners of every face, each a place in [`vertices`](Self::vertices).
    #[must_use]
    pub fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// The triangle of every face.
    #[must_use]
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = Triangle> {
        self.faces.iter().map(|&corners| self.between(corners))
    }

    /// The triangle of a face.
    ///
    /// # Panics
    /// If there is no such face.
    #[inline]
    #[must_use]
    pub fn triangle(&self, face: u32) -> Triangle {
        self.between(self.faces[face as usize])
    }

    /// The hash of the vertices and faces, which names the mesh: meshes are equal if, and but for a
    /// chance of 2^-128 only if, their hashes are. Of the number of vertices in 64 bits, then every
    /// coordinate in 64, then every corner in 32, all little-endian.
    #[must_use]
    pub const fn content_hash(&self) -> Hash {
        self.hash
    }

    /// The faces without an area, in order: a corner is named twice, or all lie on one line. Exact.
    pub fn degenerate_faces(&self) -> impl Iterator<Item = u32> {
        (0..)
            .zip(self.triangles())
            .filter(|(_, triangle)| triangle.is_degenerate())
            .map(|(face, _)| face)
    }

    #[inline]
    fn between(&self, corners: [u32; 3]) -> Triangle {
        Triangle::between(corners.map(|vertex| self.vertices[vertex as usize]))
    }
}

impl MeshBuilder {
    /// Adds a vertex, in metres; returns its place. O(1).
    ///
    /// # Errors
    /// [`MeshError::OutOfRange`] or [`MeshError::TooManyVertices`]; nothing is added then.
    pub fn vertex(&mut self, position: Vec3) -> Result<u32, MeshError> {
        if self.vertices.len() == TriangleMesh::VERTICES_MAX {
            return Err(MeshError::TooManyVertices);
        }
        let vertex = self.vertices_len();
        if !is_in_range(position) {
            return Err(MeshError::OutOfRange { vertex });
        }
        self.vertices.push(position);
        Ok(vertex)
    }

    /// Adds a face between vertices that have been added before; returns its place. O(1).
    ///
    /// # Errors
    /// [`MeshError::NoSuchVertex`], [`MeshError::TooLong`] or [`MeshError::TooManyFaces`]; nothing
    /// is added then.
    pub fn face(&mut self, corners: [u32; 3]) -> Result<u32, MeshError> {
        if self.faces.len() == TriangleMesh::FACES_MAX {
            return Err(MeshError::TooManyFaces);
        }
        let face = self.faces_len();
        let mut triangle = [Vec3::ZERO; 3];
        for (position, vertex) in triangle.iter_mut().zip(corners) {
            let found = self.vertices.get(vertex as usize);
            *position = *found.ok_or(MeshError::NoSuchVertex { face, vertex })?;
        }
        if !cfg!(planted) && !Triangle::between(triangle).is_short() {
            return Err(MeshError::TooLong { face });
        }
        self.faces.push(corners);
        Ok(face)
    }

    /// The mesh. O(vertices + faces).
    ///
    /// # Errors
    /// [`MeshError::NoFace`].
    pub fn build(self) -> Result<TriangleMesh, MeshError> {
        let Self { vertices, faces } = self;
        if faces.is_empty() {
            return Err(MeshError::NoFace);
        }
        let hash = content_hash(&vertices, &faces);
        Ok(TriangleMesh { vertices, faces, hash })
    }

    /// How many vertices there are so far: at most 2^22.
    #[expect(clippy::cast_possible_truncation, reason = "at most VERTICES_MAX")]
    pub(crate) fn vertices_len(&self) -> u32 {
        self.vertices.len() as u32
    }

    /// How many faces there are so far: at most 2^23.
    #[expect(clippy::cast_possible_truncation, reason = "at most FACES_MAX")]
    pub(crate) fn faces_len(&self) -> u32 {
        self.faces.len() as u32
    }
}

/// See [`TriangleMesh::content_hash`].
fn content_hash(vertices: &[Vec3], faces: &[[u32; 3]]) -> Hash {
    let mut hasher = Hasher::default();
    hasher.write(&(vertices.len() as u64).to_le_bytes());
    for position in vertices {
        position.raw().iter().for_each(|c| hasher.write(&c.to_le_bytes()));
    }
    for corner in faces.iter().flatten() {
        hasher.write(&corner.to_le_bytes());
    }
    hasher.finish()
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoFace => f.write_str("mesh has no face"),
            Self::TooManyVertices => {
                write!(f, "mesh has more than {} vertices", TriangleMesh::VERTICES_MAX)
            }
            Self::TooManyFaces => write!(f, "mesh has more than {} faces", TriangleMesh::FACES_MAX),
            Self::OutOfRange { vertex } => write!(f, "vertex {vertex} is out of range"),
            Self::NoSuchVertex { face, vertex } => {
                write!(f, "face {face} names vertex {vertex}, which is not there")
            }
            Self::TooLong { face } => write!(f, "face {face} spans 131072 m or more"),
            Self::NegativeTolerance => f.write_str("tolerance of the weld is below 0"),
        }
    }
}

impl core::error::Error for MeshError {}
