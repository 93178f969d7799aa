//! Ten shapes, made with integers: the same vertices on every machine.

mod circle;
mod hard;
mod noise;
mod patches;
mod round;
mod scene;

use verlock::geometry::TriangleMesh;

/// Makes a mesh. The number of faces grows with the square of the detail, from 1 on.
pub type Shape = fn(u32) -> TriangleMesh;

/// Every shape with its name. Faces are counter-clockwise seen from outside.
pub const SHAPES: [(&str, Shape); 10] = [
    ("torus", round::torus),
    ("knot", round::knot),
    ("spring", round::spring),
    ("vase", round::vase),
    ("rock", round::rock),
    ("terrain", scene::terrain),
    ("tree", scene::tree),
    ("room", scene::room),
    ("gear", hard::gear),
    ("stairs", hard::stairs),
];

/// What meshes with the gear, without being one of the ten: it stands beside it.
#[allow(dead_code, reason = "not every program writes it")]
pub const PINION: (&str, Shape) = ("pinion", hard::pinion);

/// The shape of this name.
#[allow(dead_code, reason = "not every program asks by name")]
pub fn shape(name: &str, detail: u32) -> TriangleMesh {
    let (_, shape) = SHAPES.into_iter().find(|(known, _)| *known == name).expect("a known name");
    shape(detail)
}
