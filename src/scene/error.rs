//! Why a text is not a scene.

use alloc::string::{String, ToString};
use core::fmt;

use ron::error::SpannedError;

use super::ObjError;
use crate::geometry::MeshError;
use crate::particle::RangeError;
use crate::world::Refusal;

/// Why a text is not a scene, or a scene not a world.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum SceneError {
    /// The text is longer than [`Scene::TEXT_MAX`](super::Scene::TEXT_MAX).
    TooLong,
    /// The text is not a scene of this version: wrong RON, an unknown field, not a decimal.
    Syntax {
        /// Counted from 1.
        line: u32,
        /// In characters, counted from 1: where reading stopped, behind a value that is wrong.
        column: u32,
        /// What is wrong there.
        message: String,
    },
    /// A part of the scene is not possible.
    Refused {
        /// Which part.
        place: Place,
        /// Its field, and why.
        why: Refusal,
    },
    /// The file of a mesh was not given, or not found.
    NoMesh {
        /// Which part names it.
        place: Place,
    },
    /// The file of a mesh is not one.
    Obj {
        /// The name of the file.
        file: String,
        /// Where it goes wrong.
        why: ObjError,
    },
    /// A mesh is not possible where it is put.
    Mesh {
        /// Which part.
        place: Place,
        /// Why.
        why: MeshError,
    },
    /// The scene would make more objects of a kind than a world can have.
    TooMany {
        /// The kind, in the plural.
        kind: &'static str,
        /// As many as there can be.
        most: usize,
    },
}

/// A part of a scene file, such as `particles[3]` or `config`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Place {
    /// The field of the scene.
    pub section: &'static str,
    /// The element, counted from 0, if the field is a list.
    pub index: Option<u32>,
}

impl Place {
    /// A field of the scene.
    pub(super) const fn of(section: &'static str) -> Self {
        Self { section, index: None }
    }

    /// An element of a list; in 16 MiB of text no list has 2^32 of them.
    pub(super) const fn at(section: &'static str, index: u32) -> Self {
        Self { section, index: Some(index) }
    }

    /// The error of this part.
    pub(super) fn refuses(self, why: impl Into<Refusal>) -> SceneError {
        SceneError::Refused { place: self, why: why.into() }
    }
}

/// Applies `check` to every element; the error names the first that fails.
pub(super) fn try_each<'a, T: 'a>(
    section: &'static str,
    elements: impl IntoIterator<Item = T>,
    mut check: impl FnMut(T) -> Result<(), RangeError>,
) -> Result<(), SceneError> {
    (0u32..).zip(elements).try_for_each(|(index, element)| {
        check(element).map_err(|why| Place::at(section, index).refuses(why))
    })
}

impl From<SpannedError> for SceneError {
    fn from(error: SpannedError) -> Self {
        let at = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
        let SpannedError { code, span } = error;
        let (line, column) = (at(span.start.line), at(span.start.col));
        Self::Syntax { line, column, message: code.to_string() }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { section, index } = self;
        match index {
            Some(index) => write!(f, "{section}[{index}]"),
            None => f.write_str(section),
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLong => f.write_str("scene is longer than 16 MiB"),
            Self::Syntax { line, column, message } => {
                write!(f, "line {line}, column {column}: {message}")
            }
            Self::Refused { place, why } => match why {
                // These two begin with the field.
                Refusal::OutOfRange(_) | Refusal::Stale { .. } => write!(f, "{place}.{why}"),
                _ => write!(f, "{place}: {why}"),
            },
            Self::NoMesh { place } => write!(f, "{place}.mesh: no such file"),
            Self::Obj { file, why } => write!(f, "{file}: {why}"),
            Self::Mesh { place, why } => write!(f, "{place}.mesh: {why}"),
            Self::TooMany { kind, most } => write!(f, "scene makes more than {most} {kind}"),
        }
    }
}

impl core::error::Error for SceneError {}
