//! A picture, pixel by pixel.

use std::io;

use verlock::Hash;

use super::band::BAND_ROWS;
use super::colour::Rgb;

/// Pixels in rows from the top, red, green and blue.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Picture {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) pixels: Vec<u8>,
}

impl Picture {
    /// A black picture.
    pub(super) fn new(width: u32, height: u32) -> Self {
        let bytes = 3 * width as usize * height as usize;
        Self { width, height, pixels: vec![0; bytes] }
    }

    /// The same with every pixel in one colour.
    pub(super) fn filled(mut self, Rgb(colour): Rgb) -> Self {
        self.pixels.chunks_exact_mut(3).for_each(|pixel| pixel.copy_from_slice(&colour));
        self
    }

    /// Bands of rows, each with the number of its first one.
    pub(super) fn bands(&mut self) -> impl Iterator<Item = (u32, &mut [u8])> {
        let bytes = self.row_bytes() * BAND_ROWS;
        (0..).step_by(BAND_ROWS).zip(self.pixels.chunks_mut(bytes))
    }

    /// Copies another picture to a place where it fits.
    pub(super) fn put(&mut self, other: &Self, left: u32, top: u32) {
        let row_bytes = self.row_bytes();
        let rows = self.pixels.chunks_exact_mut(row_bytes).skip(top as usize);
        for (row, from) in rows.zip(other.pixels.chunks_exact(other.row_bytes())) {
            row[3 * left as usize..][..from.len()].copy_from_slice(from);
        }
    }

    /// The hash of the pixels.
    pub(super) fn hash(&self) -> Hash {
        Hash::of(&self.pixels)
    }

    /// The picture as a PNG file.
    pub(super) fn to_png(&self) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(png::Filter::NoFilter);
        encoder.write_header()?.write_image_data(&self.pixels)?;
        Ok(bytes)
    }

    pub(super) fn row_bytes(&self) -> usize {
        3 * self.width as usize
    }
}
