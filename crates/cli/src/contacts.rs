//! `verlock contacts`: where two meshes touch.

use std::io::Write;
use std::path::PathBuf;

use serde_json::{Value, json};
use verlock::collision::{Contact, MARGIN_MAX, Manifold, MeshShape, manifolds_mesh_mesh};
use verlock::geometry::Surface;
use verlock::math::UnitVec3;
use verlock::world::{DrawSink, Shade};
use verlock::{Real, Vec3};

use crate::exit::Exit;
use crate::failure::Failure;
use crate::input::Input;
use crate::mesh::{check_pairs, feature_name, mesh};
use crate::number::length;
use crate::render::Still;

/// List where two meshes touch, and which way they part
///
/// Manifolds: up to four contacts that share a normal, from A to B. A line for every contact: what
/// of A touches what of B (vertices, edges and faces are counted from 0), how far they are
/// apart along the normal in metres (negative where they overlap), the normal, the point on A and
/// that on B. In JSON: "manifolds", with coordinates as text. Returns 0 whether or not there are
/// any.
#[derive(Debug, clap::Args)]
pub(crate) struct Contacts {
    /// Mesh A, an OBJ file
    a: PathBuf,

    /// Mesh B, an OBJ file
    b: PathBuf,

    /// What is farther apart than this does not touch, metres
    #[arg(long, value_name = "M", value_parser = length, default_value = "0.005")]
    margin: Real,

    /// Take faces for sheets without an inside
    #[arg(long)]
    two_sided: bool,

    /// Print JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    still: Still,

    /// Overwrite the picture
    #[arg(long)]
    force: bool,
}

/// No more pairs of faces are looked at.
const PAIRS_MAX: usize = 10_000_000;

impl Contacts {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let target = self.still.target(self.force, &[&self.a, &self.b])?;
        let inputs = Input::read_two(&self.a, &self.b, limit)?;
        let shape = |input: &Input| -> Result<MeshShape, Failure> {
            let shape = MeshShape::new(mesh(input)?);
            Ok(if self.two_sided { shape.two_sided() } else { shape })
        };
        let shapes = [shape(&inputs[0])?, shape(&inputs[1])?];
        check_pairs(&shapes, "--margin", self.margin.min(MARGIN_MAX), PAIRS_MAX)?;
        let mut manifolds = Vec::new();
        manifolds_mesh_mesh(&shapes[0], &shapes[1], self.margin, &mut manifolds);
        if let Some(target) = target {
            let draw = |sink: &mut dyn DrawSink| draw(&shapes, &manifolds, sink);
            self.still.paint(&target, &draw, out)?;
        }
        if self.json {
            let all: Vec<_> = manifolds.iter().map(told).collect();
            writeln!(out, "{:#}", json!({ "v": 1, "manifolds": all }))?;
            return Ok(Exit::Fine);
        }
        for manifold in &manifolds {
            for Contact { features: [a, b], on_a, on_b, separation } in manifold.contacts() {
                let [normal, on_a, on_b] =
                    [direction(manifold.normal), place(*on_a), place(*on_b)].map(|p| p.join(", "));
                let [a, b] = [*a, *b].map(feature_name);
                writeln!(out, "{a}, {b}: {separation} ({normal}) ({on_a}) ({on_b})")?;
            }
        }
        Ok(Exit::Fine)
    }
}

fn direction(UnitVec3 { x, y, z }: UnitVec3) -> [String; 3] {
    [x, y, z].map(|c| c.to_string())
}

fn place(Vec3 { x, y, z }: Vec3) -> [String; 3] {
    [x, y, z].map(|c| c.to_string())
}

fn told(manifold: &Manifold) -> Value {
    let contact = |contact: &Contact| {
        let Contact { features, on_a, on_b, separation } = *contact;
        json!({
            "features": features.map(feature_name),
            "separation": separation.to_string(),
            "on_a": place(on_a),
            "on_b": place(on_b),
        })
    };
    let contacts: Vec<_> = manifold.contacts().iter().map(contact).collect();
    json!({ "normal": direction(manifold.normal), "contacts": contacts })
}

/// Both meshes, the points on B, and from there arrows along the normals, a twelfth of the scene
/// long.
fn draw(shapes: &[MeshShape; 2], manifolds: &[Manifold], sink: &mut dyn DrawSink) {
    for (shape, shade) in shapes.iter().zip([Shade::Face, Shade::Collider]) {
        let faces = 0..u32::try_from(shape.mesh().faces().len()).unwrap_or(u32::MAX);
        faces.for_each(|face| sink.triangle(*shape.triangle(face).corners(), shade));
    }
    let [a, b] = shapes.each_ref().map(Surface::bounds);
    // Below 2^62.
    let length = Real::from_raw(i64::try_from(a.union(b).span() / 12).unwrap_or(0));
    for manifold in manifolds {
        for contact in manifold.contacts() {
            // From 30 fraction bits to 24.
            let normal = Vec3::from_raw(manifold.normal.raw().map(|c| c >> 6));
            arrow(contact.on_b, normal, length, sink);
        }
    }
}

/// A point, a line from it, and a tip at the end of that.
fn arrow(from: Vec3, normal: Vec3, length: Real, sink: &mut dyn DrawSink) {
    let end = from + normal * length;
    sink.point(from, Shade::Contact);
    sink.line([from, end], Shade::Contact);
    // Across the normal: from the axis that it is farthest from lying along.
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let least = (0..3).min_by_key(|&axis| normal.raw()[axis].abs()).unwrap_or(0);
    let across = normal.cross(axes[least]).unwrap_or(Vec3::ZERO);
    let upright = normal.cross(across).unwrap_or(Vec3::ZERO);
    let part = |thirtieths: i64| Real::from_raw(length.raw() / 30 * thirtieths);
    for side in [across, upright, -across, -upright] {
        sink.line([end, end - normal * part(8) + side * part(3)], Shade::Contact);
    }
}
