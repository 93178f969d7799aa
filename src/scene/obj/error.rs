//! Why a text is not a mesh.

use core::fmt;

use crate::geometry::MeshError;
use crate::math::DecimalError;

/// Why a text is not an OBJ file that makes a mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ObjError {
    /// Where the statement begins, counted from 1; the last one, if only the end of the text shows
    /// what is missing.
    pub line: u32,
    /// What is wrong there.
    pub why: ObjFault,
}

/// What is wrong with a line of an OBJ file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ObjFault {
    /// The line begins with a word that OBJ files do not have, or that makes curved surfaces.
    UnknownStatement,
    /// A vertex ends too early.
    Missing {
        /// The first coordinate that is not there.
        coordinate: &'static str,
    },
    /// A coordinate is not a number, or not one that fits.
    Number {
        /// Which one.
        coordinate: &'static str,
        /// Where it goes wrong.
        why: DecimalError,
    },
    /// A face has fewer than 3 corners.
    FewCorners,
    /// A corner is not made of indices.
    Corner {
        /// Which one, counted from 1.
        corner: u32,
    },
    /// A corner names a vertex that is not there, or not yet.
    NoSuchVertex {
        /// Which one, counted from 1.
        corner: u32,
        /// How many vertices stand above.
        vertices: u32,
    },
    /// No mesh can have this vertex or face, or have no face.
    Mesh(MeshError),
}

impl From<MeshError> for ObjFault {
    fn from(error: MeshError) -> Self {
        Self::Mesh(error)
    }
}

impl fmt::Display for ObjFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownStatement => f.write_str("unknown statement"),
            Self::Missing { coordinate } => write!(f, "{coordinate} is missing"),
            Self::Number { coordinate, why } => write!(f, "{coordinate}: {why}"),
            Self::FewCorners => f.write_str("face has fewer than 3 corners"),
            Self::Corner { corner } => {
                write!(f, "corner {corner} is not v, v/vt, v//vn or v/vt/vn")
            }
            Self::NoSuchVertex { corner, vertices } => {
                write!(f, "corner {corner} names none of the {vertices} vertices above")
            }
            Self::Mesh(error) => error.fmt(f),
        }
    }
}

impl fmt::Display for ObjError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, why } = self;
        write!(f, "line {line}: {why}")
    }
}

impl core::error::Error for ObjError {}
