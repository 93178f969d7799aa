//! The files that are written.

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use verlock::{Hash, World};

use super::film::Film;
use super::picture::Picture;
use super::reel::Ticks;
use super::sheet::Sheet;
use crate::count::counted;
use crate::failure::Failure;
use crate::input::is_dash;
use crate::target::Target;

/// What a path stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Format {
    Png,
    Gif,
    /// A PNG for each frame.
    Folder,
}

/// Takes frames and makes files of them.
pub(super) struct Output {
    path: PathBuf,
    force: bool,
    ticks: Ticks,
    /// The one file, unless it is a folder.
    target: Option<Target>,
    medium: Medium,
    written: Vec<Written>,
}

enum Medium {
    Single,
    Sheet(Sheet),
    Film {
        film: Film,
        /// Ticks times 100 that were not shown yet, less than the tick rate.
        rest: u64,
        /// The hashes of all frames.
        hashes: Vec<u8>,
    },
}

/// What a file came to hold.
pub(super) struct Written {
    path: String,
    ticks: Ticks,
    size: [u32; 2],
    pixels: Hash,
}

impl Format {
    /// Files are known by their extension; `-` is a PNG; what has none is a folder.
    pub(crate) fn of(path: &Path) -> Result<Self, Failure> {
        let extension = path.extension().map(OsStr::to_ascii_lowercase);
        match extension.as_deref().and_then(|extension| extension.to_str()) {
            _ if is_dash(path) => Ok(Self::Png),
            _ if path.is_dir() => Ok(Self::Folder),
            Some("png") => Ok(Self::Png),
            Some("gif") => Ok(Self::Gif),
            None => Ok(Self::Folder),
            Some(_) => {
                let name = path.display();
                Err(Failure::usage(format!("{name}: neither .png nor .gif nor a folder")))
            }
        }
    }
}

impl Output {
    /// Refuses files that are there, so that nothing is painted in vain.
    pub(super) fn new(
        path: &Path,
        format: Format,
        columns: Option<u32>,
        ticks: Ticks,
        size: [u32; 2],
        force: bool,
    ) -> Result<Self, Failure> {
        let mut target = None;
        if format == Format::Folder {
            fs::create_dir_all(path).map_err(|error| Failure::io(path.display(), &error))?;
            for tick in ticks.iter() {
                Target::new(path.join(frame_name(tick)), force)?;
            }
        } else {
            target = Some(Target::new(path.into(), force)?);
        }
        let medium = match (format, columns) {
            (Format::Gif, _) => {
                let film = Film::new(size).map_err(|error| Failure::io(path.display(), &error))?;
                Medium::Film { film, rest: 0, hashes: Vec::new() }
            }
            (Format::Png, Some(columns)) => {
                let sheet = Sheet::new(columns, ticks.count(), size);
                Medium::Sheet(sheet.ok_or_else(|| {
                    let frames = counted(ticks.count(), "frame");
                    let hint = "too large a sheet: take a smaller --size or a larger --every";
                    Failure::usage(format!("{frames}: {hint}"))
                })?)
            }
            _ => Medium::Single,
        };
        Ok(Self { path: path.into(), force, ticks, target, medium, written: Vec::new() })
    }

    /// Takes the next frame.
    pub(super) fn push(
        &mut self,
        world: &World,
        picture: Picture,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        match &mut self.medium {
            Medium::Single => self.write_frame(world.tick(), &picture, out),
            Medium::Sheet(sheet) => {
                sheet.put(&picture);
                Ok(())
            }
            Medium::Film { film, rest, hashes } => {
                hashes.extend(picture.hash().to_bytes());
                let rate = u64::from(world.config().tick_rate);
                let gone = *rest + self.ticks.every.saturating_mul(100);
                *rest = gone % rate;
                let pushed = film.push(picture, gone / rate);
                pushed.map_err(|error| Failure::io(self.path.display(), &error))
            }
        }
    }

    /// Writes what is not written yet; returns all that was.
    pub(super) fn finish(mut self, out: &mut dyn Write) -> Result<Vec<Written>, Failure> {
        let failed = |error| Failure::io(self.path.display(), &error);
        let (bytes, size, pixels) = match self.medium {
            Medium::Single => return Ok(self.written),
            Medium::Sheet(sheet) => {
                let picture = sheet.into_picture();
                let size = [picture.width, picture.height];
                (picture.to_png().map_err(failed)?, size, picture.hash())
            }
            Medium::Film { film, rest: _, hashes } => {
                let size = film.size();
                (film.finish().map_err(failed)?, size, Hash::of(&hashes))
            }
        };
        if let Some(target) = &self.target {
            target.write(&bytes, out)?;
        }
        let path = self.path.display().to_string();
        self.written.push(Written { path, ticks: self.ticks, size, pixels });
        Ok(self.written)
    }

    /// Writes a picture of its own: the only one, or one in the folder.
    fn write_frame(
        &mut self,
        tick: u64,
        picture: &Picture,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let in_folder = self.path.join(frame_name(tick));
        let path = if self.target.is_some() { &self.path } else { &in_folder };
        let png = picture.to_png().map_err(|error| Failure::io(path.display(), &error))?;
        match &self.target {
            Some(target) => target.write(&png, out)?,
            None => Target::new(in_folder.clone(), self.force)?.write(&png, out)?,
        }
        self.written.push(Written {
            path: path.display().to_string(),
            ticks: Ticks { from: tick, to: tick, every: 1 },
            size: [picture.width, picture.height],
            pixels: picture.hash(),
        });
        Ok(())
    }
}

impl Written {
    pub(super) fn line(&self) -> String {
        let Self { path, ticks, size: [width, height], pixels } = self;
        let Ticks { from, to, every } = ticks;
        let ticks = match ticks.count() {
            1 => format!("tick {from}"),
            _ if *every == 1 => format!("ticks {from} to {to}"),
            _ => format!("every {every} ticks from {from} to {to}"),
        };
        format!("{path}: {ticks}, {width}x{height}, pixels {pixels}")
    }

    pub(super) fn json(&self) -> Value {
        let Self { path, ticks, size: [width, height], pixels } = self;
        json!({
            "path": path, "ticks": ticks.iter().collect::<Vec<_>>(),
            "width": width, "height": height, "pixels": pixels.to_string(),
        })
    }
}

/// The name of a frame in a folder: in order of ticks up to a million of them.
fn frame_name(tick: u64) -> String {
    format!("{tick:06}.png")
}
