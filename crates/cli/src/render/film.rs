//! Frames one after another.

use std::borrow::Cow;
use std::io;

use gif::{DisposalMethod, Encoder, Frame, Repeat};

use super::colour::Rgb;
use super::palette::{COLOURS_MAX, Palette};
use super::picture::Picture;

/// The shortest time a frame is shown, in hundredths of a second: viewers slow shorter ones down.
const DELAY_MIN: u64 = 2;

/// A film without an end. Of each frame, what changed is written.
pub(super) struct Film {
    encoder: Encoder<Vec<u8>>,
    size: [u32; 2],
    shown: Option<Picture>,
}

/// The rows and columns in which two pictures differ.
#[derive(Clone, Copy)]
struct Window {
    left: usize,
    top: usize,
    right: usize,
    bottom: usize,
}

impl Film {
    /// A film in frames of a size below 2^16.
    pub(super) fn new(size: [u32; 2]) -> io::Result<Self> {
        let [width, height] = size.map(|side| short(side as usize));
        let mut encoder = Encoder::new(Vec::new(), width, height, &[]).map_err(io::Error::other)?;
        encoder.set_repeat(Repeat::Infinite).map_err(io::Error::other)?;
        Ok(Self { encoder, size, shown: None })
    }

    pub(super) fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Adds a frame that is shown for so many hundredths of a second.
    pub(super) fn push(&mut self, picture: Picture, delay: u64) -> io::Result<()> {
        let window = Window::new(self.shown.as_ref(), &picture);
        let pixels = window.pixels(&picture);
        let shown = self.shown.as_ref().map(|shown| window.pixels(shown));
        let changed = |index: usize| shown.as_ref().is_none_or(|old| old[index] != pixels[index]);
        let fresh = pixels.iter().enumerate().filter(|&(index, _)| changed(index));
        let palette = Palette::new(fresh.map(|(_, &pixel)| pixel).collect());
        let unchanged = u8::try_from(palette.colours.len().min(COLOURS_MAX)).unwrap_or(u8::MAX);
        let indices = pixels
            .iter()
            .enumerate()
            .map(|(index, &pixel)| if changed(index) { palette.index(pixel) } else { unchanged });
        let frame = Frame {
            delay: u16::try_from(delay.max(DELAY_MIN)).unwrap_or(u16::MAX),
            dispose: DisposalMethod::Keep,
            transparent: Some(unchanged),
            left: short(window.left),
            top: short(window.top),
            width: short(window.right - window.left),
            height: short(window.bottom - window.top),
            palette: Some(palette.colours.iter().flat_map(|Rgb(c)| *c).chain([0; 3]).collect()),
            buffer: Cow::Owned(indices.collect()),
            ..Frame::default()
        };
        self.encoder.write_frame(&frame).map_err(io::Error::other)?;
        self.shown = Some(picture);
        Ok(())
    }

    /// The file.
    pub(super) fn finish(self) -> io::Result<Vec<u8>> {
        self.encoder.into_inner().map_err(io::Error::other)
    }
}

impl Window {
    /// Everything at first, then what differs, at least one pixel.
    fn new(shown: Option<&Picture>, picture: &Picture) -> Self {
        let (width, height) = (picture.width as usize, picture.height as usize);
        let Some(shown) = shown else {
            return Self { left: 0, top: 0, right: width, bottom: height };
        };
        let mut window = Self { left: width, top: height, right: 0, bottom: 0 };
        let bytes = picture.row_bytes();
        let rows = picture.pixels.chunks_exact(bytes).zip(shown.pixels.chunks_exact(bytes));
        for (row, (new, old)) in rows.enumerate() {
            let mut differing = (0..bytes).filter(|&byte| new[byte] != old[byte]);
            if let Some(first) = differing.next() {
                let last = differing.next_back().unwrap_or(first);
                window.left = window.left.min(first / 3);
                window.right = window.right.max(last / 3 + 1);
                window.top = window.top.min(row);
                window.bottom = row + 1;
            }
        }
        if window.bottom == 0 { Self { left: 0, top: 0, right: 1, bottom: 1 } } else { window }
    }

    fn pixels(self, picture: &Picture) -> Vec<Rgb> {
        let rows = picture.pixels.chunks_exact(picture.row_bytes());
        let rows = rows.skip(self.top).take(self.bottom - self.top);
        let pixels = rows.flat_map(|row| row[3 * self.left..3 * self.right].chunks_exact(3));
        pixels.map(|pixel| Rgb([pixel[0], pixel[1], pixel[2]])).collect()
    }
}

/// A side of a picture, or a place in it.
fn short(length: usize) -> u16 {
    u16::try_from(length).unwrap_or(u16::MAX)
}
