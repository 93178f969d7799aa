//! Why a text is not a scene.

use alloc::format;
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
    /// The file of a mesh cannot be had.
    NoMesh {
        /// Which part names it.
        place: Place,
        /// Which file, and why not.
        why: String,
    },
    /// A field is set that objects of this list do not have, though similar ones do.
    NoField {
        /// Which part.
        place: Place,
        /// Its field.
        field: &'static str,
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

    /// The error of this part, whose fields the scene calls otherwise than the objects of which it
    /// is made.
    pub(super) fn refuses_as(
        self,
        why: impl Into<Refusal>,
        rename: fn(&'static str) -> &'static str,
    ) -> SceneError {
        let why = match why.into() {
            Refusal::OutOfRange(error) => {
                Refusal::OutOfRange(RangeError { field: rename(error.field), ..error })
            }
            why => why,
        };
        self.refuses(why)
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
        let message = match code {
            ron::Error::SuggestRawIdentifier(found) if found.starts_with(|c: char| !is_name(c)) => {
                format!("expected the name of a field, found `{found}`")
            }
            code => code.to_string(),
        };
        Self::Syntax { line, column, message }
    }
}

/// Whether the name of a field can begin with this.
fn is_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
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
            Self::NoMesh { place, why } => write!(f, "{place}.mesh: {why}"),
            Self::NoField { place, field } => {
                write!(f, "{place}.{field}: {} have no such field", place.section)
            }
            Self::Obj { file, why } => write!(f, "{file}: {why}"),
            Self::Mesh { place, why } => write!(f, "{place}.mesh: {why}"),
            Self::TooMany { kind, most } => write!(f, "scene makes more than {most} {kind}"),
        }
    }
}

impl core::error::Error for SceneError {}
