//! Volumes from below, when a tree is made and when its vertices move.

use alloc::vec;
use core::fmt;

use super::Bvh;
use super::build::LANES;
use super::cell_box::CellBox;
use super::cells::Cells;
use super::volume::{Enclose, Volume};
use crate::geometry::{Aabb, Triangle, TriangleError, is_in_range};
use crate::math::Vec3;

/// Why vertices cannot be where they are said to be. Vertices and faces are counted from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum RefitError {
    /// There is not one position for every vertex of the mesh.
    WrongLength,
    /// A coordinate is beyond [`Triangle::COORDINATE_MAX`].
    OutOfRange {
        /// The vertex that has it.
        vertex: u32,
    },
    /// A face spans more than [`Triangle::SPAN_MAX`] along an axis.
    TooLong {
        /// The face.
        face: u32,
    },
}

impl<V: Volume> Bvh<V> {
    /// Moves the vertices of the mesh to these positions, in metres, one for each in order; the
    /// shape of the tree remains. O(n).
    ///
    /// # Errors
    /// [`RefitError`] names the first vertex, or else the first face, that is not possible; nothing
    /// has moved then.
    pub fn refit(&mut self, positions: &[Vec3]) -> Result<(), RefitError> {
        self.place(positions)?;
        self.cells = Cells::around(positions);
        self.refit_volumes();
        Ok(())
    }

    /// Moves the faces only, and not the volumes.
    pub(super) fn place(&mut self, positions: &[Vec3]) -> Result<(), RefitError> {
        self.check(positions)?;
        let faces = self.mesh.faces();
        for (triangle, &face) in self.triangles.iter_mut().zip(&self.shape.faces) {
            let corners = faces[face as usize];
            *triangle = Triangle::between(corners.map(|vertex| positions[vertex as usize]));
        }
        Ok(())
    }

    fn check(&self, positions: &[Vec3]) -> Result<(), RefitError> {
        if positions.len() != self.mesh.vertices().len() {
            return Err(RefitError::WrongLength);
        }
        let mut far = (0..).zip(positions).filter(|(_, position)| !is_in_range(**position));
        if let Some((vertex, _)) = far.next() {
            return Err(RefitError::OutOfRange { vertex });
        }
        let span = Aabb::around(positions.iter().copied()).map_or(0, |bounds| bounds.span());
        if span <= Triangle::SPAN_MAX.unsigned_abs() {
            return Ok(()); // no face can be longer than all together
        }
        for (face, corners) in (0..).zip(self.mesh.faces()) {
            let corners = corners.map(|vertex| positions[vertex as usize]);
            if Triangle::new(corners) == Err(TriangleError::TooLong) {
                return Err(RefitError::TooLong { face });
            }
        }
        Ok(())
    }

    /// Makes the volumes anew from the triangles. Children stand behind their node, so that
    /// backwards is from below. O(n).
    pub(super) fn refit_volumes(&mut self) {
        let Self { shape, triangles, cells, volumes, mesh: _ } = self;
        let point = CellBox::new([0; 3], [0; 3]);
        let anything = V::around(&[point]);
        volumes.resize(shape.links.len(), [anything; LANES]);
        // What every node is enclosed in, and the box around it.
        let mut nodes = vec![(anything, point); shape.links.len()];
        for node in (0..shape.links.len()).rev() {
            let link = shape.links[node];
            let used = usize::from(link.len);
            let mut boxes = [point; LANES];
            for (lane, place) in link.below().enumerate() {
                (volumes[node][lane], boxes[lane]) = if link.is_leaf {
                    let corners = triangles[place].corners().map(|corner| cells.of_point(corner));
                    (V::around(&corners), CellBox::around(&corners))
                } else {
                    nodes[place]
                };
            }
            let first = volumes[node][0];
            volumes[node][used..].fill(first);
            let bounds = CellBox::around(&boxes[..used]);
            nodes[node] = (V::around(&boxes[..used]), bounds);
            shape.links[node].size = bits(&bounds);
        }
    }
}

/// The bits of the longest edge.
#[expect(clippy::cast_possible_truncation, reason = "at most 64")]
fn bits(bounds: &CellBox) -> u8 {
    let [x, y, z] = bounds.extents();
    (i64::BITS - (x | y | z).leading_zeros()) as u8
}

impl fmt::Display for RefitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::WrongLength => f.write_str("mesh has another number of vertices"),
            Self::OutOfRange { vertex } => write!(f, "vertex {vertex} is out of range"),
            Self::TooLong { face } => write!(f, "face {face} spans 131072 m or more"),
        }
    }
}

impl core::error::Error for RefitError {}
