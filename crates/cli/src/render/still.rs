//! One picture of what a command tells.

use std::io::Write;
use std::path::{Path, PathBuf};

use verlock::world::{DrawSink, Shade};

use super::bounds::{Bounds, Points};
use super::camera::{Camera, Lens};
use super::colour::of_face;
use super::output::Format;
use super::painter::Style;
use super::view::{View, size};
use crate::failure::Failure;
use crate::input::is_dash;
use crate::target::Target;

/// How a command paints what it tells.
#[derive(Debug, clap::Args)]
pub(crate) struct Still {
    /// Paint it too: a .png
    #[arg(long, value_name = "PNG")]
    render: Option<PathBuf>,

    /// Pixels of the picture
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "640x480")]
    #[arg(requires = "render")]
    size: [u32; 2],

    /// Where the camera stands
    #[arg(long, value_enum, default_value_t, requires = "render")]
    pub(crate) view: View,
}

impl Still {
    /// The file of the picture, if there is to be one; it must not overwrite what was read.
    pub(crate) fn target(&self, force: bool, read: &[&Path]) -> Result<Option<Target>, Failure> {
        let Some(path) = &self.render else { return Ok(None) };
        if is_dash(path) {
            return Err(Failure::usage("stdout is for text: name a file for the picture"));
        }
        if !matches!(Format::of(path), Ok(Format::Png)) {
            return Err(Failure::usage(format!("{}: is no .png", path.display())));
        }
        Target::beside(path, force, read).map(Some)
    }

    /// Paints what is drawn, all of it in view, and which colours mesh A and mesh B have.
    pub(crate) fn paint(
        &self,
        target: &Target,
        draw: &dyn Fn(&mut dyn DrawSink),
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let mut bounds = Bounds::default();
        draw(&mut bounds);
        bounds.end_frame();
        let lens = Lens::new(self.size[0], self.size[1], 32);
        // Of two meshes far apart a box would be mostly empty.
        let mut points = Points::default();
        draw(&mut points);
        let camera = Camera::fitted(self.view.direction(), &points.0, lens);
        let legend = [("A ", Shade::Face), ("B", Shade::Collider)];
        let legend = legend.map(|(name, shade)| (name, of_face(shade, true)));
        let style = Style { camera, size: self.size, bounds, grid: false };
        target.write(&style.paint(&legend, draw).to_png()?, out)
    }
}
