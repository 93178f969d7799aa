//! `verlock overlap`: where two meshes intersect.

use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Value, json};
use verlock::Vec3;
use verlock::geometry::{
    Intersection, IntersectionPoint, TriangleMesh, intersection_triangle_triangle,
};
use verlock::partition::bvh::{Bvh, Precision};
use verlock::world::{DrawSink, Shade};

use crate::exit::Exit;
use crate::failure::Failure;
use crate::input::Input;
use crate::mesh::mesh;
use crate::render::Still;

/// List the faces of two meshes that intersect, and where
///
/// Exact: faces that touch in one point are listed, and such that are 60 nm apart are not. A line
/// for every pair: face of A, face of B, counted from 0 in the order of the files (a face of more
/// than 3 corners is a fan of several), then the corners of what they have in common, in metres: a
/// point, a segment, or the polygon of two faces in one plane. In JSON: "pairs" and, in the same
/// order, "segments", with coordinates as text. Returns 0 whether or not there are any.
#[derive(Debug, clap::Args)]
pub(crate) struct Overlap {
    /// Mesh A, an OBJ file
    a: PathBuf,

    /// Mesh B, an OBJ file
    b: PathBuf,

    /// Print JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    still: Still,

    /// Overwrite the picture
    #[arg(long)]
    force: bool,
}

impl Overlap {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let target = self.still.target(self.force, &[&self.a, &self.b])?;
        let inputs = Input::read_two(&self.a, &self.b, limit)?;
        let meshes = [mesh(&inputs[0])?, mesh(&inputs[1])?];
        let [tree_a, tree_b] = meshes.each_ref().map(|mesh| <Bvh>::new(Arc::clone(mesh)));
        let pairs = tree_a.pairs(&tree_b, Precision::Exact);
        // Where they are is found again whenever it is needed: small files can have many pairs.
        let places = || pairs.iter().filter_map(|&faces| common(&meshes, faces));
        if let Some(target) = target {
            let draw = |sink: &mut dyn DrawSink| draw(&meshes, places(), sink);
            self.still.paint(&target, &draw, out)?;
        }
        if self.json {
            write!(out, r#"{{"v":1,"pairs":"#)?;
            list(out, pairs.iter().map(|faces| json!(faces)))?;
            write!(out, r#","segments":"#)?;
            list(out, places().map(|intersection| decimals(&intersection)))?;
            writeln!(out, "}}")?;
        } else {
            for ([a, b], intersection) in pairs.iter().zip(places()) {
                write!(out, "{a} {b}")?;
                for IntersectionPoint { position: Vec3 { x, y, z }, .. } in intersection.points() {
                    write!(out, " ({x}, {y}, {z})")?;
                }
                writeln!(out)?;
            }
        }
        Ok(Exit::Fine)
    }
}

/// Writes a JSON array item by item.
fn list(out: &mut dyn Write, items: impl Iterator<Item = Value>) -> io::Result<()> {
    write!(out, "[")?;
    for (place, item) in items.enumerate() {
        let comma = if place == 0 { "" } else { "," };
        write!(out, "{comma}{item}")?;
    }
    write!(out, "]")
}

/// The corners of what is common, as exact decimals.
fn decimals(intersection: &Intersection) -> Value {
    let points = intersection.points().iter().map(|point| {
        let Vec3 { x, y, z } = point.position;
        [x, y, z].map(|c| c.to_string())
    });
    points.collect()
}

/// What a face of the first mesh and one of the second have in common.
fn common([a, b]: &[Arc<TriangleMesh>; 2], faces: [u32; 2]) -> Option<Intersection> {
    intersection_triangle_triangle(&a.triangle(faces[0]), &b.triangle(faces[1]))
}

fn draw(
    meshes: &[Arc<TriangleMesh>; 2],
    places: impl Iterator<Item = Intersection>,
    sink: &mut dyn DrawSink,
) {
    for (mesh, shade) in meshes.iter().zip([Shade::Face, Shade::Collider]) {
        mesh.triangles().for_each(|triangle| sink.triangle(*triangle.corners(), shade));
    }
    for intersection in places {
        let points = intersection.points();
        // A segment there and back, or around a polygon.
        let ends = points.iter().zip(points.iter().cycle().skip(1));
        ends.for_each(|(from, to)| sink.line([from.position, to.position], Shade::Contact));
        if let [point] = points {
            sink.point(point.position, Shade::Contact);
        }
    }
}
