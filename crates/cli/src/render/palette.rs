//! At most 255 colours for many.

use super::colour::Rgb;

/// The most colours of a palette; one more stands for what does not change.
pub(super) const COLOURS_MAX: usize = 255;

/// Colours, and which of them stands for each one that was seen.
#[derive(Debug)]
pub(super) struct Palette {
    pub(super) colours: Vec<Rgb>,
    /// Sorted.
    seen: Vec<(Rgb, u8)>,
}

/// A colour and how often it was seen.
type Count = (Rgb, u64);

impl Palette {
    /// The best palette for these pixels: a box around all colours is cut in two at its median
    /// pixel, then the box with the greatest spread, until there are enough of them; the mean of
    /// each is a colour (Heckbert 1982). Few colours stay as they are.
    pub(super) fn new(mut pixels: Vec<Rgb>) -> Self {
        pixels.sort_unstable();
        let counts = pixels.chunk_by(|a, b| a == b).map(|same| (same[0], same.len() as u64));
        let mut boxes: Vec<Vec<Count>> = vec![counts.collect()];
        boxes.retain(|counts| !counts.is_empty());
        while boxes.len() < COLOURS_MAX {
            let spreads = boxes.iter().enumerate().map(|(index, colours)| (spread(colours), index));
            let Some(((worth, channel), index)) = spreads.max() else { break };
            if worth == 0 {
                break;
            }
            let upper = cut(&mut boxes[index], channel);
            boxes.push(upper);
        }
        let mut seen = Vec::new();
        for (index, colours) in (0..=u8::MAX).zip(&boxes) {
            seen.extend(colours.iter().map(|&(colour, _)| (colour, index)));
        }
        seen.sort_unstable();
        Self { colours: boxes.iter().map(|colours| mean(colours)).collect(), seen }
    }

    /// The number of the colour that stands for one that was seen.
    pub(super) fn index(&self, colour: Rgb) -> u8 {
        let found = self.seen.binary_search_by_key(&colour, |&(seen, _)| seen);
        found.map_or(0, |place| self.seen[place].1)
    }
}

/// How much is gained by cutting a box, and along which channel.
fn spread(colours: &[Count]) -> (u64, usize) {
    let pixels: u64 = colours.iter().map(|&(_, count)| count).sum();
    let width = |channel: usize| {
        let values = || colours.iter().map(|(Rgb(colour), _)| u64::from(colour[channel]));
        values().max().unwrap_or_default() - values().min().unwrap_or_default()
    };
    let [red, green, blue] = [0, 1, 2].map(width);
    let channel = if green >= red && green >= blue { 1 } else { 2 * usize::from(blue > red) };
    // Rare colours matter less than common ones, but an eye sees the width first.
    (red.max(green).max(blue).pow(2) * pixels.isqrt(), channel)
}

/// Keeps the colours below the median pixel; returns the others. Neither part is empty.
fn cut(colours: &mut Vec<Count>, channel: usize) -> Vec<Count> {
    colours.sort_unstable_by_key(|&(Rgb(colour), _)| (colour[channel], colour));
    let pixels: u64 = colours.iter().map(|&(_, count)| count).sum();
    let mut below = 0;
    let middle = colours.iter().take_while(|&&(_, count)| {
        below += count;
        2 * below <= pixels
    });
    let middle = middle.count().clamp(1, colours.len() - 1);
    colours.split_off(middle)
}

fn mean(colours: &[Count]) -> Rgb {
    let pixels: u64 = colours.iter().map(|&(_, count)| count).sum();
    Rgb([0, 1, 2].map(|channel| {
        let sum: u64 = colours.iter().map(|&(Rgb(c), count)| u64::from(c[channel]) * count).sum();
        // A mean of bytes.
        ((sum + pixels / 2) / pixels).to_le_bytes()[0]
    }))
}
