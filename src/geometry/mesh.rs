//! Triangles that share vertices.

use alloc::vec::Vec;
use core::fmt;

use crate::math::Vec3;

/// Vertices and the triangles between them. Immutable; the same lists give an equal mesh.
///
/// A face names its three corners by their places among the vertices, counted from 0. Vertices that
/// no face names, vertices in one place, faces without an area, and edges of any number of faces
/// are all allowed: a mesh is what its source says.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TriangleMesh {
    vertices: Vec<Vec3>,
    faces: Vec<[u32; 3]>,
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
    /// A coordinate is beyond [`TriangleMesh::COORDINATE_MAX`].
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
    /// A face spans more than [`TriangleMesh::SPAN_MAX`] along an axis.
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
    /// No coordinate is beyond +-2^36 m (raw: 2^60), as in a world.
    pub const COORDINATE_MAX: i64 = 1 << 60;
    /// No face spans more than this along an axis, raw: 131,072 m less a step. With that, exact
    /// predicates on triangles whose boxes meet fit 128 bits.
    pub const SPAN_MAX: i64 = (1 << 41) - 1;

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

    /// The positions of the corners of every face.
    #[must_use]
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = [Vec3; 3]> {
        self.faces.iter().map(|&corners| self.positions(corners))
    }

    /// The faces without an area, in order: a corner is named twice, or all lie on one line. Exact.
    pub fn degenerate_faces(&self) -> impl Iterator<Item = u32> {
        (0..).zip(self.triangles()).filter(|(_, triangle)| is_flat(triangle)).map(|(face, _)| face)
    }

    fn positions(&self, corners: [u32; 3]) -> [Vec3; 3] {
        corners.map(|vertex| self.vertices[vertex as usize])
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
        let range = -TriangleMesh::COORDINATE_MAX..=TriangleMesh::COORDINATE_MAX;
        if !position.raw().iter().all(|c| range.contains(c)) {
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
        if !cfg!(planted) && span(&triangle) > TriangleMesh::SPAN_MAX {
            return Err(MeshError::TooLong { face });
        }
        self.faces.push(corners);
        Ok(face)
    }

    /// The mesh. O(1).
    ///
    /// # Errors
    /// [`MeshError::NoFace`].
    pub fn build(self) -> Result<TriangleMesh, MeshError> {
        let Self { vertices, faces } = self;
        if faces.is_empty() { Err(MeshError::NoFace) } else { Ok(TriangleMesh { vertices, faces }) }
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

/// The length of the triangle along the axis where it is longest: at most 2^61 raw.
fn span(triangle: &[Vec3; 3]) -> i64 {
    let [a, b, c] = triangle.map(Vec3::raw);
    let along = |k: usize| a[k].max(b[k]).max(c[k]) - a[k].min(b[k]).min(c[k]);
    along(0).max(along(1)).max(along(2))
}

/// Whether the corners of a face lie on one line.
fn is_flat(triangle: &[Vec3; 3]) -> bool {
    let [a, b, c] = triangle.map(Vec3::raw);
    let minor = |j: usize, k: usize| {
        // Sides are below 2^41 along each axis: products are below 2^82.
        let side = |p: &[i64; 3], k: usize| i128::from(p[k] - a[k]);
        side(&b, j) * side(&c, k) == side(&b, k) * side(&c, j)
    };
    minor(0, 1) && minor(1, 2) && minor(2, 0)
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
