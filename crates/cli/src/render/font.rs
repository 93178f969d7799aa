//! A few characters, as strokes.

use super::canvas::{Canvas, PIXEL, Spot, TOP};
use super::colour::Rgb;

/// Characters are this high, in units of their own.
const HEIGHT: i64 = 10;

/// Units between two characters.
const SPACE: i64 = 3;

/// Strokes, parted by blanks: a digit for each x and each y from the upper left corner, `A` for 10.
fn strokes(character: char) -> &'static str {
    match character {
        '0' => "204062684A2A080220",
        '1' => "02303A 0A6A",
        '2' => "02204062640A6A",
        '3' => "022040626345254567684A2A08",
        '4' => "5A500767",
        '5' => "6010044466684A2A08",
        '6' => "502205082A4A6866442406",
        '7' => "00602A",
        '8' => "250302204062634525 07082A4A6867452507",
        '9' => "1A4865624020020426 4664",
        't' => "21284A5A 0454",
        'i' => "141A 1112",
        'c' => "5544240608 2A4A59 082A",
        'k' => "000A 5408 265A",
        'A' => "0A306A 1757",
        'B' => "0A004062634505 4567684A0A",
        _ => "",
    }
}

/// How far the next character stands.
fn advance(character: char) -> i64 {
    match character {
        'i' => 2 + SPACE,
        ' ' => 2 * SPACE,
        _ => 6 + SPACE,
    }
}

/// Writes a text over everything, from its lower left corner, `height` screen units high; returns
/// where the next one begins.
pub(super) fn write(
    canvas: &mut Canvas,
    text: &str,
    [left, bottom]: [i64; 2],
    height: i64,
    colour: Rgb,
) -> i64 {
    let mut start = 0;
    for character in text.chars() {
        for stroke in strokes(character).split(' ') {
            let place = |pair: &[u8]| {
                let [x, y] = [pair[0], pair[1]].map(|digit| i64::from(digit.min(b':') - b'0'));
                Spot {
                    x: left + (start + x) * height / HEIGHT,
                    y: bottom - (HEIGHT - y) * height / HEIGHT,
                    near: TOP,
                }
            };
            let spots: Vec<_> = stroke.as_bytes().chunks_exact(2).map(place).collect();
            let width = (height / 8).max(PIXEL);
            spots.windows(2).for_each(|ends| canvas.line(ends[0], ends[1], width, colour));
        }
        start += advance(character);
    }
    left + start * height / HEIGHT
}
