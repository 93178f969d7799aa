//! Frames side by side.

use super::colour::{BACKGROUND, GAP};
use super::picture::Picture;

/// Pixels between two frames.
const MARGIN: u32 = 2;

/// The most pixels of a sheet.
const PIXELS_MAX: u64 = 1 << 26;

/// A contact sheet: frames in rows, from the upper left.
#[derive(Debug)]
pub(super) struct Sheet {
    picture: Picture,
    columns: u32,
    frame: [u32; 2],
    /// Frames put so far.
    count: u32,
}

impl Sheet {
    /// Room for so many frames of a size; `None` if that makes more than 2^26 pixels.
    pub(super) fn new(columns: u32, frames: u64, frame: [u32; 2]) -> Option<Self> {
        let rows = u32::try_from(frames.div_ceil(columns.into())).ok()?;
        let length = |count: u32, each: u32| count.checked_mul(each + MARGIN);
        let width = length(columns, frame[0])? - MARGIN;
        let height = length(rows, frame[1])?.checked_sub(MARGIN)?;
        if u64::from(width) * u64::from(height) > PIXELS_MAX {
            return None;
        }
        let mut picture = Picture::new(width, height).filled(GAP);
        let empty = Picture::new(frame[0], frame[1]).filled(BACKGROUND);
        let mut sheet = Self { columns, frame, picture: Picture::new(0, 0), count: 0 };
        for index in 0..rows * columns {
            let [left, top] = sheet.place(index);
            picture.put(&empty, left, top);
        }
        sheet.picture = picture;
        Some(sheet)
    }

    /// Puts the next frame.
    pub(super) fn put(&mut self, frame: &Picture) {
        let [left, top] = self.place(self.count);
        self.picture.put(frame, left, top);
        self.count += 1;
    }

    pub(super) fn into_picture(self) -> Picture {
        self.picture
    }

    /// The upper left corner of a frame.
    fn place(&self, index: u32) -> [u32; 2] {
        let [column, row] = [index % self.columns, index / self.columns];
        [column * (self.frame[0] + MARGIN), row * (self.frame[1] + MARGIN)]
    }
}
