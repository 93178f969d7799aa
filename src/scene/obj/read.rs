//! Statements to a mesh.

use alloc::string::String;
use alloc::vec::Vec;
use core::num::{IntErrorKind, ParseIntError};

use super::error::ObjFault;
use super::statement::Statement;
use super::{Obj, ObjPart};
use crate::geometry::MeshBuilder;
use crate::math::{Real, Vec3};

/// Statements that say nothing about a mesh of triangles.
const IGNORED: &[&str] = &[
    "vt",
    "vn",
    "vp",
    "l",
    "p",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "bevel",
    "lod",
    "c_interp",
    "d_interp",
    "shadow_obj",
    "trace_obj",
];

/// The part of a file that has been read.
#[derive(Default)]
pub(super) struct Reader {
    mesh: MeshBuilder,
    /// The last may still be empty.
    parts: Vec<ObjPart>,
}

impl Reader {
    pub(super) fn read(&mut self, statement: &Statement<'_>) -> Result<(), ObjFault> {
        let mut words = statement.words();
        match words.next() {
            Some("v") => self.vertex(words),
            Some("f") => self.face(words),
            Some("o" | "g") => {
                self.part(words);
                Ok(())
            }
            Some(word) if !IGNORED.contains(&word) => Err(ObjFault::UnknownStatement),
            _ => Ok(()),
        }
    }

    pub(super) fn finish(mut self) -> Result<Obj, ObjFault> {
        self.drop_empty();
        Ok(Obj { mesh: self.mesh.build()?, parts: self.parts })
    }

    fn vertex<'a>(&mut self, mut words: impl Iterator<Item = &'a str>) -> Result<(), ObjFault> {
        let mut number = |coordinate| {
            let word = words.next().ok_or(ObjFault::Missing { coordinate })?;
            Real::parse_scientific(word).map_err(|why| ObjFault::Number { coordinate, why })
        };
        let position = Vec3::new(number("x")?, number("y")?, number("z")?);
        self.mesh.vertex(position)?;
        Ok(())
    }

    /// A fan about the first corner.
    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), ObjFault> {
        let vertices = self.mesh.vertices_len();
        // Counting cannot overflow: a mesh has far fewer faces.
        let mut corners = (1..).zip(words).map(|(corner, word)| vertex(corner, word, vertices));
        let mut required = || corners.next().unwrap_or(Err(ObjFault::FewCorners));
        let (first, second, mut last) = (required()?, required()?, required()?);
        self.mesh.face([first, second, last])?;
        for corner in corners {
            let next = corner?;
            self.mesh.face([first, last, next])?;
            last = next;
        }
        if let Some(part) = self.parts.last_mut() {
            part.faces.end = self.mesh.faces_len();
        }
        Ok(())
    }

    /// What follows belongs to a part of this name.
    fn part<'a>(&mut self, words: impl Iterator<Item = &'a str>) {
        self.drop_empty();
        let mut name = String::new();
        for word in words {
            if !name.is_empty() {
                name.push(' ');
            }
            name.push_str(word);
        }
        let start = self.mesh.faces_len();
        self.parts.push(ObjPart { name, faces: start..start });
    }

    fn drop_empty(&mut self) {
        self.parts.pop_if(|part| part.faces.is_empty());
    }
}

/// The place of the vertex that a corner names, when there are `vertices` so far.
fn vertex(corner: u32, word: &str, vertices: u32) -> Result<u32, ObjFault> {
    let mut indices = word.split('/');
    let named = indices.next().and_then(index);
    let usual = indices.clone().count() <= 2;
    let usual = usual && indices.all(|other| other.is_empty() || index(other).is_some());
    let place = match named.filter(|_| usual).ok_or(ObjFault::Corner { corner })? {
        named @ 1.. => named - 1,
        0 => -1,
        named => named + i64::from(vertices),
    };
    let place = u32::try_from(place).ok().filter(|&place| place < vertices);
    place.ok_or(ObjFault::NoSuchVertex { corner, vertices })
}

/// A whole number; one that 64 bits do not hold counts as the last that they do.
fn index(word: &str) -> Option<i64> {
    word.parse().map_or_else(
        |error: ParseIntError| match error.kind() {
            IntErrorKind::PosOverflow => Some(i64::MAX),
            IntErrorKind::NegOverflow => Some(i64::MIN),
            _ => None,
        },
        Some,
    )
}
