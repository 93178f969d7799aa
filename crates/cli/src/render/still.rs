//! One picture of what a command tells.

use std::io::Write;
use std::path::{Path, PathBuf};

use verlock::world::DrawSink;

use super::bounds::Bounds;
use super::camera::{Camera, Lens};
use super::output::Format;
use super::painter::Style;
use super::view::{View, size};
use crate::failure::Failure;
use crate::target::Target;

/// How a command paints what it tells.
#[derive(Debug, clap::Args)]
pub(crate) struct Still {
    /// Paint it too: a .png
    #[arg(long, value_name = "PNG")]
    render: Option<PathBuf>,

    /// Pixels of the picture
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "640x480")]
    size: [u32; 2],

    /// Where the camera stands
    #[arg(long, value_enum, default_value_t)]
    pub(crate) view: View,
}

impl Still {
    /// The file of the picture, if there is to be one; it must not overwrite what was read.
    pub(crate) fn target(&self, force: bool, read: &[&Path]) -> Result<Option<Target>, Failure> {
        let Some(path) = &self.render else { return Ok(None) };
        let target = Target::beside(path, force, read)?;
        if target.is_stdout() {
            return Err(Failure::usage("stdout is for text: name a file for the picture"));
        }
        if Format::of(path)? != Format::Png {
            return Err(Failure::usage(format!("{}: is no .png", path.display())));
        }
        Ok(Some(target))
    }

    /// Paints what is drawn, all of it in view.
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
        let camera = Camera::fitted(self.view.direction(), bounds.corners(), lens);
        let style = Style { camera, size: self.size, bounds, grid: false };
        target.write(&style.paint("", draw).to_png()?, out)
    }
}
