//! `verlock overlap`: where two meshes intersect.

use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Value, json};
use verlock::Vec3;
use verlock::geometry::{
    Intersection, IntersectionPoint, TriangleMesh, intersection_triangle_triangle,
};
use verlock::partition::bvh::{Bvh, Precision};
use verlock::world::{DrawSink, Shade};

use crate::count::counted;
use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::Input;
use crate::render::{self, View, size};
use crate::target::Target;

/// List the faces of two meshes that intersect, and where
///
/// Exact: faces that touch in one point are listed, and such that are 60 nm apart are not. A line
/// for every pair: face of A, face of B, counted from 0 in the order of the files (a face of more
/// than 3 corners is a fan of several), then the corners of what they have in common, in metres: a
/// point, a segment, or the polygon of two faces in one plane. In JSON: "pairs" and, in the same
/// order, "segments". Returns 0 whether or not there are any.
#[derive(Debug, clap::Args)]
pub(crate) struct Overlap {
    /// Mesh A, an OBJ file
    a: PathBuf,

    /// Mesh B, an OBJ file
    b: PathBuf,

    /// Print JSON
    #[arg(long)]
    json: bool,

    /// Paint both meshes and where they intersect: a .png
    #[arg(long, value_name = "PNG")]
    render: Option<PathBuf>,

    /// Pixels of the picture
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "640x480")]
    size: [u32; 2],

    /// Where the camera stands
    #[arg(long, value_enum, default_value_t)]
    view: View,

    /// Overwrite the picture
    #[arg(long)]
    force: bool,
}

/// Two faces that intersect, and where.
struct Pair {
    faces: [u32; 2],
    intersection: Intersection,
}

impl Overlap {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let target = self.render.map(|path| Target::new(path, self.force)).transpose()?;
        if target.as_ref().is_some_and(Target::is_stdout) {
            return Err(Failure::usage("stdout is for the pairs: name a file for the picture"));
        }
        let inputs = Input::read_two(&self.a, &self.b, limit)?;
        let [a, b] = [mesh(&inputs[0])?, mesh(&inputs[1])?];
        let pairs = pairs(&a, &b);
        if let Some(target) = target {
            let draw = |sink: &mut dyn DrawSink| draw([&a, &b], &pairs, sink);
            target.write(&render::still(self.size, self.view, &draw)?, out)?;
        }
        if self.json {
            let faces: Vec<_> = pairs.iter().map(|pair| pair.faces).collect();
            let segments: Vec<_> = pairs.iter().map(Pair::json).collect();
            writeln!(out, "{}", json!({ "v": 1, "pairs": faces, "segments": segments }))?;
        } else {
            for Pair { faces: [a, b], intersection } in &pairs {
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

impl Pair {
    /// The corners of what is common, as exact decimals.
    fn json(&self) -> Value {
        let points = self.intersection.points().iter().map(|point| {
            let Vec3 { x, y, z } = point.position;
            [x, y, z].map(|c| c.to_string())
        });
        points.collect()
    }
}

/// The mesh of a file. Faces without an area are legal, but seldom meant.
fn mesh(input: &Input) -> Result<Arc<TriangleMesh>, Failure> {
    let mesh = input.mesh()?;
    let degenerate: Vec<_> = mesh.degenerate_faces().collect();
    if let Some(first) = degenerate.first() {
        let count = counted(degenerate.len() as u64, "face");
        tell(format_args!("{}: {count} without an area, the first is {first}", input.name()));
    }
    Ok(Arc::new(mesh))
}

fn pairs(a: &Arc<TriangleMesh>, b: &Arc<TriangleMesh>) -> Vec<Pair> {
    let [tree_a, tree_b] = [a, b].map(|mesh| <Bvh>::new(Arc::clone(mesh)));
    let pairs = tree_a.pairs(&tree_b, Precision::Exact).into_iter();
    pairs
        .filter_map(|faces| {
            let [of_a, of_b] = [a.triangle(faces[0]), b.triangle(faces[1])];
            let intersection = intersection_triangle_triangle(&of_a, &of_b)?;
            Some(Pair { faces, intersection })
        })
        .collect()
}

fn draw(meshes: [&TriangleMesh; 2], pairs: &[Pair], sink: &mut dyn DrawSink) {
    for (mesh, shade) in meshes.into_iter().zip([Shade::Face, Shade::Collider]) {
        mesh.triangles().for_each(|triangle| sink.triangle(*triangle.corners(), shade));
    }
    for Pair { intersection, .. } in pairs {
        let points = intersection.points();
        // A segment there and back, or around a polygon.
        let ends = points.iter().zip(points.iter().cycle().skip(1));
        ends.for_each(|(from, to)| sink.line([from.position, to.position], Shade::Contact));
        if let [point] = points {
            sink.point(point.position, Shade::Contact);
        }
    }
}
