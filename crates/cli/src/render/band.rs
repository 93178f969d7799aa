//! Some rows of a picture, sample by sample.

use verlock::math::root::isqrt;

use super::canvas::{PIXEL, Spot};
use super::colour::{BACKGROUND, Rgb, WHOLE};

/// Samples of a pixel along each axis.
const SAMPLES: usize = 4;

/// Screen units from one sample to the next.
const STEP: i64 = PIXEL / 4;

/// Bits behind the point of a nearness that is stepped along a row.
const NEAR_BITS: u32 = 16;

/// Rows of pixels whose samples fit the caches of a processor.
pub(super) const BAND_ROWS: usize = 16;

/// Rows of samples in a band.
const BAND_SAMPLES: i64 = 64;

const _: () = assert!(BAND_SAMPLES.cast_unsigned() == (SAMPLES * BAND_ROWS) as u64);

/// The samples of [`BAND_ROWS`] rows: the nearest colour found so far, and how near it is.
#[derive(Debug)]
pub(super) struct Band {
    /// Samples in a row, below 2^31.
    width: usize,
    /// The first row of samples, counted from the top of the picture.
    top: i64,
    near: Vec<u32>,
    colour: Vec<Rgb>,
}

/// Where a row crosses an edge: screen units, and the nearness there.
#[derive(Clone, Copy)]
struct Crossing {
    x: i64,
    /// What is left of the x by rounding down.
    rest: bool,
    near: i64,
}

impl Band {
    /// Room for the samples of so many columns of pixels.
    pub(super) fn new(columns: u32) -> Self {
        let width = SAMPLES * columns as usize;
        let samples = width * SAMPLES * BAND_ROWS;
        Self { width, top: 0, near: vec![0; samples], colour: vec![BACKGROUND; samples] }
    }

    /// Begins anew at a row of pixels.
    pub(super) fn clear(&mut self, row: u32) {
        self.top = i64::from(row) * (PIXEL / STEP);
        self.near.fill(0);
        self.colour.fill(BACKGROUND);
    }

    /// Fills the samples inside a convex polygon. Polygons that share an edge leave no gap and
    /// share no sample: rows and columns belong to a polygon from its upper left border, included,
    /// to its lower right one, excluded.
    pub(super) fn polygon(&mut self, corners: &[Spot], colour: Rgb) {
        let ys = || corners.iter().map(|corner| corner.y);
        let (Some(low), Some(high)) = (ys().min(), ys().max()) else { return };
        for row in self.rows(low, high) {
            let Some([left, right]) = crossings(corners, centre(row)) else { continue };
            let first = first_sample(left);
            let (first, end) = self.columns(first, first_sample(right));
            if first >= end {
                continue;
            }
            // Both ends have been crossed: right.x > left.x, and what is added to the nearness
            // of one end is never more than what leads to the other.
            let slope = ((right.near - left.near) << NEAR_BITS) / (right.x - left.x).max(1);
            let start = (left.near << NEAR_BITS) + slope * (centre(first) - left.x);
            let run = self.run(row, first, end);
            for (index, (near, sample)) in (0..).zip(run) {
                let found = clamp_near((start + slope * STEP * index) >> NEAR_BITS);
                if found >= *near {
                    (*near, *sample) = (found, colour);
                }
            }
        }
    }

    /// Fills the samples of a ball, lit from the upper left.
    pub(super) fn ball(&mut self, centre_spot: Spot, radius: i64, colour: Rgb) {
        let Spot { x, y, near } = centre_spot;
        let found = clamp_near(near);
        let radius_sq = radius * radius;
        // The light falls on a point a third of the radius up and to the left: no point of the
        // ball is farther from it than 1.48 radii, 2.19 in the square.
        let glint = radius / 3;
        let fall = (i64::from(WHOLE) << 40) / (radius_sq * 9 / 4).max(1);
        for row in self.rows(y - radius, y + radius) {
            let dy = centre(row) - y;
            let half = isqrt((radius_sq - dy * dy).max(0).unsigned_abs()).cast_signed();
            let (first, end) = self.columns(first_at(x - half), first_at(x + half));
            let shine_y = (dy + glint) * (dy + glint);
            for (column, (near, sample)) in (first..).zip(self.run(row, first, end)) {
                if found >= *near {
                    let shine_x = centre(column) - x + glint;
                    let dark = ((shine_x * shine_x + shine_y) * fall) >> 40;
                    let light = WHOLE - u32::try_from(dark).unwrap_or(WHOLE).min(WHOLE);
                    (*near, *sample) = (found, colour.lit(WHOLE / 4 + light * 3 / 5));
                }
            }
        }
    }

    /// Writes the mean of each pixel's samples.
    pub(super) fn resolve(&self, rows: &mut [u8]) {
        let row_bytes = self.width / SAMPLES * 3;
        let lines = self.colour.chunks_exact(self.width * SAMPLES);
        for (pixels, samples) in rows.chunks_exact_mut(row_bytes).zip(lines) {
            for (column, pixel) in pixels.chunks_exact_mut(3).enumerate() {
                let mut sums = [0u16; 3];
                for line in samples.chunks_exact(self.width) {
                    for Rgb(sample) in &line[column * SAMPLES..(column + 1) * SAMPLES] {
                        sums.iter_mut().zip(sample).for_each(|(sum, c)| *sum += u16::from(*c));
                    }
                }
                // A mean of bytes: the upper byte of the result is 0.
                let mean = |sum: u16| ((sum + 8) / 16).to_le_bytes()[0];
                pixel.iter_mut().zip(sums).for_each(|(channel, sum)| *channel = mean(sum));
            }
        }
    }

    /// The rows of samples from one height to another, lower one excluded, that are in the band.
    fn rows(&self, low: i64, high: i64) -> std::ops::Range<i64> {
        let bottom = self.top + BAND_SAMPLES;
        first_at(low).max(self.top)..first_at(high).min(bottom)
    }

    /// What is in the picture of some columns: none between equal ends.
    fn columns(&self, first: i64, end: i64) -> (i64, i64) {
        let width = i64::try_from(self.width).unwrap_or_default();
        (first.clamp(0, width), end.clamp(0, width))
    }

    /// The samples of a row from one column to another.
    fn run(
        &mut self,
        row: i64,
        first: i64,
        end: i64,
    ) -> impl Iterator<Item = (&mut u32, &mut Rgb)> {
        let at = |column: i64| index(row - self.top) * self.width + index(column);
        let run = at(first)..at(end);
        self.near[run.clone()].iter_mut().zip(&mut self.colour[run])
    }
}

/// Where the sample of a row or a column is.
fn centre(sample: i64) -> i64 {
    sample * STEP + STEP / 2
}

/// The first sample at or after a coordinate.
fn first_at(coordinate: i64) -> i64 {
    (coordinate + STEP / 2 - 1).div_euclid(STEP)
}

fn first_sample(crossing: Crossing) -> i64 {
    first_at(crossing.x + i64::from(crossing.rest))
}

/// Where a row crosses the border of a convex polygon, from left to right.
fn crossings(corners: &[Spot], y: i64) -> Option<[Crossing; 2]> {
    let mut found: Option<[Crossing; 2]> = None;
    for (index, &b) in corners.iter().enumerate() {
        let a = corners[if index == 0 { corners.len() - 1 } else { index - 1 }];
        let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
        if !(a.y <= y && y < b.y) {
            continue;
        }
        // 21 bits each; the nearness has 32.
        let (height, way) = (b.y - a.y, y - a.y);
        let x = (b.x - a.x) * way;
        let crossing = Crossing {
            x: a.x + x.div_euclid(height),
            rest: x.rem_euclid(height) > 0,
            near: a.near + (b.near - a.near) * way / height,
        };
        found = Some(match found {
            None => [crossing; 2],
            Some([left, right]) => [
                if (crossing.x, crossing.rest) < (left.x, left.rest) { crossing } else { left },
                if (crossing.x, crossing.rest) > (right.x, right.rest) { crossing } else { right },
            ],
        });
    }
    found
}

/// Nearness as it is kept.
fn clamp_near(near: i64) -> u32 {
    u32::try_from(near.max(0)).unwrap_or(u32::MAX)
}

/// A row or a column that is known to be in the band.
fn index(sample: i64) -> usize {
    usize::try_from(sample).unwrap_or_default()
}
