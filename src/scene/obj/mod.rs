//! Meshes from Wavefront OBJ files.

mod error;
mod read;
mod statement;

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;
use core::ops::Range;

pub use error::{ObjError, ObjFault};
use read::Reader;
use statement::Statements;

use crate::geometry::TriangleMesh;

/// What an OBJ file says: a mesh, and which of its faces belong together by name.
///
/// | statement | is read as |
/// |---|---|
/// | `v x y z` | a vertex in metres; a weight or colours behind it are ignored |
/// | `f a b c ...` | a face; of more than 3 corners, the fan `(a b c) (a c d) ...` |
/// | `o name`, `g name` | the name of the faces that follow |
/// | `l p s vt vn vp usemtl mtllib` and the like | nothing |
///
/// A corner is `v`, `v/vt`, `v//vn` or `v/vt/vn`, of which only `v` matters: 1 is the first vertex
/// of the file, -1 the last one so far, and none may be farther down. Coordinates are read by
/// [`Real::parse_scientific`](crate::math::Real::parse_scientific), so to nearest from their text.
/// `#` begins a comment, and a line that ends in `\` goes on in the next one. Whatever else a line
/// begins with is refused.
///
/// `Display` writes what reads back as an equal value.
///
/// ```
/// use verlock::scene::Obj;
///
/// let obj = Obj::parse("v 0 0 0\nv 1 0 0\nv 1 1e-1 0\nv 0 .1 0\nf 1 2 3 4\n")?;
/// assert_eq!(obj.mesh().faces(), [[0, 1, 2], [0, 2, 3]]);
///
/// let error = Obj::parse("v 0 0 0\nv 1 0 nan\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2: z: unexpected byte 'n' at offset 0");
/// # Ok::<(), verlock::scene::ObjError>(())
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Obj {
    mesh: TriangleMesh,
    parts: Vec<ObjPart>,
}

/// Faces that follow one another and have a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ObjPart {
    /// As in the file, with single blanks; may be empty, or the same for several parts.
    pub name: String,
    /// Where they are among the faces of the mesh; at least one.
    pub faces: Range<u32>,
}

impl Obj {
    /// Reads an OBJ file. O(text); beyond the limits of a mesh nothing more is stored.
    ///
    /// # Errors
    /// [`ObjError`] names the line. No text makes it panic.
    pub fn parse(text: &str) -> Result<Self, ObjError> {
        let mut reader = Reader::default();
        let mut line = 1;
        for statement in Statements::of(text) {
            line = statement.line;
            reader.read(&statement).map_err(|why| ObjError { line, why })?;
        }
        reader.finish().map_err(|why| ObjError { line, why })
    }

    /// The mesh: vertices as in the file, faces in its order.
    #[must_use]
    pub fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    /// The mesh alone.
    #[must_use]
    pub fn into_mesh(self) -> TriangleMesh {
        self.mesh
    }

    /// The named parts with faces, in order. Together they hold every face from the first name on.
    #[must_use]
    pub fn parts(&self) -> &[ObjPart] {
        &self.parts
    }
}

impl From<TriangleMesh> for Obj {
    /// A mesh without names.
    fn from(mesh: TriangleMesh) -> Self {
        Self { mesh, parts: Vec::new() }
    }
}

impl fmt::Display for Obj {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mesh, parts } = self;
        for position in mesh.vertices() {
            writeln!(f, "v {} {} {}", position.x, position.y, position.z)?;
        }
        let mut parts = parts.iter().peekable();
        for (face, corners) in (0..).zip(mesh.faces()) {
            if let Some(part) = parts.next_if(|part| part.faces.start == face) {
                writeln!(f, "o {}", part.name)?;
            }
            let [a, b, c] = corners.map(|vertex| vertex + 1); // at most 2^22
            writeln!(f, "f {a} {b} {c}")?;
        }
        Ok(())
    }
}
