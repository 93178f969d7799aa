//! `verlock render`: pictures.
//!
//! No float is used on the way from a world to its pixels, so that the same picture comes out
//! everywhere: positions are projected and faces shaded in fixed point, shapes are sampled 16 times
//! a pixel and hidden by an integer depth.

mod band;
mod bounds;
mod camera;
mod canvas;
mod clip;
mod colour;
mod film;
mod font;
mod output;
mod painter;
mod palette;
mod picture;
mod plane;
mod reel;
mod sheet;
mod still;
mod view;

#[cfg(test)]
mod laws;

use std::io::{IsTerminal as _, Write, stdout};
use std::path::PathBuf;

use clap::builder::RangedU64ValueParser;
use serde_json::json;
use verlock::world::{Detail, DrawOptions};
use verlock::{Vec3, World};

use self::bounds::{Bounds, all_corners};
use self::camera::{Camera, Lens};
use self::colour::TEXT;
use self::output::{Format, Output, Written};
use self::painter::Style;
use self::reel::Reel;
pub(crate) use self::still::Still;
pub(crate) use self::view::{View, point};

use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::{Input, is_dash};
use crate::progress::Progress;

/// Paint a state, or many of them
///
/// A picture of one tick, a contact sheet or a film of several, or a folder with a picture for each
/// of them. Lines that are stretched by 5 % are red, squeezed ones blue; pinned particles are red.
/// The same worlds give the same pixels on every machine. Prints the ticks and the hash of the
/// pixels of every file, and says which is the first tick of a replay whose world is not the
/// recorded one.
#[derive(Debug, clap::Args)]
pub(crate) struct Render {
    /// Scene, replay or snapshot
    path: PathBuf,

    /// Tick to paint: by default a snapshot's only, a replay's last, a scene's first
    #[arg(long, value_name = "T", conflicts_with_all = ["from", "to", "every"])]
    tick: Option<u64>,

    /// First tick of several
    #[arg(long, value_name = "A")]
    from: Option<u64>,

    /// Last tick of several
    #[arg(long, value_name = "B")]
    to: Option<u64>,

    /// Ticks from one frame to the next [default: 1, in a GIF 3]
    #[arg(long, value_name = "N", value_parser = RangedU64ValueParser::<u64>::new().range(1..))]
    every: Option<u64>,

    /// A .png, a .gif or a folder
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    output: PathBuf,

    /// Put all frames on one picture, so many in a row
    #[arg(long, value_name = "COLUMNS", value_parser = clap::value_parser!(u32).range(1..=256))]
    sheet: Option<u32>,

    /// Pixels of a frame
    #[arg(long, value_name = "WxH", value_parser = view::size, default_value = "640x480")]
    size: [u32; 2],

    /// From where everything is looked at; the distance fits all that is shown
    #[arg(long, value_enum, default_value_t)]
    view: View,

    /// Where the camera stands instead, in metres
    #[arg(long, value_name = "X,Y,Z", value_parser = view::point, conflicts_with = "view")]
    #[arg(allow_hyphen_values = true)]
    camera: Option<Vec3>,

    /// What that camera looks at [default: the middle of all that is shown]
    #[arg(long, value_name = "X,Y,Z", value_parser = view::point, requires = "camera")]
    #[arg(allow_hyphen_values = true)]
    target: Option<Vec3>,

    /// Vertical angle of view in degrees, 5 to 120
    #[arg(long, value_name = "DEGREES", default_value_t = 32)]
    #[arg(value_parser = clap::value_parser!(u32).range(5..=120))]
    fov: u32,

    #[command(flatten)]
    parts: Parts,

    /// Overwrite files
    #[arg(long)]
    force: bool,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// What is painted besides faces, and what no face covers.
#[derive(Debug, clap::Args)]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of its own")]
struct Parts {
    /// Neither grids nor shadows
    #[arg(long)]
    no_grid: bool,

    /// Particles that are corners of faces too
    #[arg(long)]
    particles: bool,

    /// Constraints on corners of faces too, and those that are disabled
    #[arg(long)]
    constraints: bool,

    /// The number of every particle
    #[arg(long)]
    labels: bool,
}

impl Render {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let format = self.format()?;
        let input = Input::read(&self.path, limit)?;
        let reel = self.reel(&input, format)?;
        let ticks = reel.ticks();
        let mut output =
            Output::new(&self.output, format, self.sheet, ticks, self.size, self.force)?;

        let progress = Progress::new(input.name(), 2 * (ticks.to - ticks.from), "ticks");
        let mut bounds = Bounds::default();
        let options = self.options();
        let mut note = None;
        let last = reel.play(&progress, |world| {
            world.draw(&mut bounds, options);
            bounds.end_frame();
            note = note.take().or_else(|| reel.note(world));
            Ok(())
        })?;
        let note = note.or_else(|| reel.note(&last));
        let camera = self.camera(&bounds)?;
        let grid = !self.parts.no_grid;
        let style = Style { camera, size: self.size, bounds, grid };
        reel.play(&progress, |world: &World| {
            let caption = format!("tick {}", world.tick());
            let picture = style.paint(&[(&caption, TEXT)], &|sink| world.draw(sink, options));
            output.push(world, picture, out)
        })?;
        drop(progress);

        let written = output.finish(out)?;
        // What is said about a picture must not mix with it.
        let mut aside = anstream::stderr();
        let out = if is_dash(&self.output) { &mut aside } else { out };
        note.iter().for_each(tell);
        self.print(&written, note.as_deref(), out)?;
        Ok(Exit::Fine)
    }

    fn format(&self) -> Result<Format, Failure> {
        let format = Format::of(&self.output)?;
        if is_dash(&self.output) && stdout().is_terminal() {
            return Err(Failure::usage("a terminal shows no pictures: name a file with -o"));
        }
        if self.sheet.is_some() && format != Format::Png {
            return Err(Failure::usage("a contact sheet is one .png"));
        }
        let several = self.from.is_some() || self.to.is_some() || self.every.is_some();
        if several && self.sheet.is_none() && format == Format::Png {
            let what = "several ticks need a .gif, a folder or --sheet";
            return Err(Failure::usage(what));
        }
        Ok(format)
    }

    fn reel<'a>(&self, input: &'a Input, format: Format) -> Result<Reel<'a>, Failure> {
        if self.tick.is_some() || format == Format::Png && self.sheet.is_none() {
            return Reel::still(input, self.tick);
        }
        let every = self.every.unwrap_or(if format == Format::Gif { 3 } else { 1 });
        Reel::moving(input, self.from, self.to, every)
    }

    fn options(&self) -> DrawOptions {
        let detail = |all: bool| if all { Detail::All } else { Detail::Uncovered };
        let Parts { no_grid: _, particles, constraints, labels } = self.parts;
        DrawOptions { distances: detail(constraints), particles: detail(particles), labels }
    }

    fn camera(&self, bounds: &Bounds) -> Result<Camera, Failure> {
        let lens = Lens::new(self.size[0], self.size[1], self.fov);
        let Some(eye) = self.camera else {
            let corners = all_corners(bounds.grounded_corners());
            return Ok(Camera::fitted(self.view.direction(), &corners, lens));
        };
        let target = self.target.unwrap_or(Vec3::from_raw(bounds.middle()));
        let camera = Camera::looking(eye, target, lens);
        camera.ok_or_else(|| Failure::usage("the camera stands at what it looks at"))
    }

    fn print(
        &self,
        written: &[Written],
        note: Option<&str>,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        if self.json {
            let files: Vec<_> = written.iter().map(Written::json).collect();
            writeln!(out, "{:#}", json!({ "files": files, "note": note }))?;
        } else {
            written.iter().try_for_each(|file| writeln!(out, "{}", file.line()))?;
        }
        Ok(())
    }
}
