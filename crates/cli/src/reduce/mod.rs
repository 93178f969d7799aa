//! `verlock reduce`: what stands in for a mesh.

mod look;
mod proxy;

use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Value, json};
use verlock::geometry::{Aabb, TriangleMesh};
use verlock::partition::bvh::{Bvh, Farthest};
use verlock::scene::Obj;
use verlock::world::{DrawSink, Shade};
use verlock::{Real, Vec3};

use self::look::Look;
use self::proxy::{Proxy, Wanted, text};
use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::{Input, is_dash};
use crate::mesh::mesh;
use crate::render::{Still, View};
use crate::report::Report;
use crate::target::Target;

/// Make something simpler that stands in for a mesh, and tell how far off it is
///
/// Prints what it is, and its deviation: no point of either surface is farther from the other one,
/// in metres, and some point is `deviation_at_least` as far. Then both directions apart, within
/// `at_least` and `at_most`, with a point of the surface that is so far away: `of_mesh` from the
/// mesh to what stands in, `of_proxy` from that to the mesh. Hulls, spheres, capsules and boxes
/// contain the mesh; `beyond_hull` says how far they reach beyond its convex hull. Such as are
/// round are measured as 64 sides, within 1/256 of the radius. In a picture A is the mesh and B
/// what stands in. With `-o -` all this goes to stderr.
#[derive(Debug, clap::Args)]
pub(crate) struct Reduce {
    /// An OBJ file
    mesh: PathBuf,

    #[command(flatten)]
    wanted: Wanted,

    /// Write what stands in as a mesh: an .obj, or `-`
    #[arg(short, long, value_name = "OBJ")]
    output: Option<PathBuf>,

    #[command(flatten)]
    still: Still,

    /// Overwrite files
    #[arg(long)]
    force: bool,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Reduce {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let picture = self.still.target(self.force, &[&self.mesh])?;
        let file = self.file()?;
        let input = Input::read(&self.mesh, limit)?;
        let original = mesh(&input)?;
        let proxy = self.wanted.of(&original, &input)?;
        let report = report(&original, &proxy);
        if let Some(picture) = picture {
            let draw = |sink: &mut dyn DrawSink| {
                draw(&original, &proxy.look.mesh, self.still.view, sink);
            };
            self.still.paint(&picture, &draw, out)?;
        }
        if let Some(file) = file {
            let text = Obj::from(TriangleMesh::clone(&proxy.look.mesh)).to_string();
            file.write(text.as_bytes(), out)?;
            if file.is_stdout() {
                // What is told of a mesh must not mix with it.
                report.print(self.json, &mut anstream::stderr())?;
                return Ok(Exit::Fine);
            }
        }
        report.print(self.json, out)?;
        Ok(Exit::Fine)
    }

    fn file(&self) -> Result<Option<Target>, Failure> {
        let Some(path) = &self.output else { return Ok(None) };
        let is_obj =
            path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj"));
        if !is_obj && !is_dash(path) {
            return Err(Failure::usage(format!("{}: is no .obj", path.display())));
        }
        Target::beside(path, self.force, &[&self.mesh]).map(Some)
    }
}

/// What there was, what there is, and how far apart they are.
fn report(original: &Arc<TriangleMesh>, proxy: &Proxy) -> Report {
    let Proxy { kind, look: Look { mesh, rough }, around } = proxy;
    let [tree, of_proxy] = [original, mesh].map(|mesh| <Bvh>::new(Arc::clone(mesh)));
    let deviation = tree.deviation(&of_proxy);
    let mut report = Report::default();
    report.add("v", 1);
    report.add("proxy", *kind);
    report.add("mesh_faces", original.faces().len());
    report.add("mesh_vertices", original.vertices().len());
    if let Some((beyond_hull, shape)) = around {
        report.add("shape", shape.clone());
        report.add("beyond_hull", beyond_hull.to_string());
    } else {
        report.add("faces", mesh.faces().len());
        report.add("vertices", mesh.vertices().len());
    }
    let at_most = deviation.at_most() + *rough;
    let both = [deviation.of_original, deviation.of_proxy].map(|side| side.at_least);
    let at_least = (both[0].max(both[1]) - *rough).max(Real::ZERO);
    report.add("deviation", at_most.to_string());
    report.add("deviation_at_least", at_least.to_string());
    // Neither of what is as good as exact, nor of hairs.
    let bounds = Aabb::around(original.vertices().iter().copied());
    let hair = bounds.map_or(0, |bounds| bounds.span() >> 12);
    let slack = at_most - at_least;
    if slack.raw().unsigned_abs() > hair && slack.raw() > at_most.raw() / 4 {
        tell(format_args!("deviation {at_most} is not tight: it may be as small as {at_least}"));
    }
    report.add("of_mesh", farthest(&deviation.of_original, *rough));
    report.add("of_proxy", farthest(&deviation.of_proxy, *rough));
    report
}

/// The bounds of a distance that is measured to within `rough`.
fn farthest(&Farthest { point, at_least, at_most }: &Farthest, rough: Real) -> Value {
    let at_least = (at_least - rough).max(Real::ZERO);
    let [at_least, at_most] = [at_least, at_most + rough].map(|length| length.to_string());
    json!({ "at_least": at_least, "at_most": at_most, "point": text(point) })
}

/// Paints a mesh and, to the right of it, another.
fn draw(original: &TriangleMesh, proxy: &TriangleMesh, view: View, sink: &mut dyn DrawSink) {
    let corners = original.vertices().iter().chain(proxy.vertices());
    let Some(bounds) = Aabb::around(corners.copied()) else { return };
    let extent = bounds.max() - bounds.min();
    let zero = Real::ZERO;
    let part = |length: Real, tenths: i64| Real::from_raw(length.raw() / 10 * tenths);
    // To the right as it is seen, with a gap between them.
    let right = match view {
        View::Front | View::Top => Vec3::new(part(extent.x, 11), zero, zero),
        View::Side => Vec3::new(zero, zero, part(extent.z, -11)),
        View::Iso => {
            let wide = extent.x.max(extent.z);
            Vec3::new(part(wide, 10), zero, part(wide, -8))
        }
    };
    for (mesh, way, shade) in [(original, Vec3::ZERO, Shade::Face), (proxy, right, Shade::Collider)]
    {
        for triangle in mesh.triangles() {
            sink.triangle(triangle.corners().map(|corner| corner + way), shade);
        }
    }
}
