//! What is to be painted, in the coordinates of the picture.

use verlock::math::root::isqrt;
use verlock::math::wide::round_div;

use super::band::Band;
use super::colour::Rgb;
use super::picture::Picture;

/// Screen units of a pixel: its quarters are sampled, and corners lie on sixteenths of those.
pub(super) const PIXEL: i64 = 64;

/// Nearness of what lies over everything.
pub(super) const TOP: i64 = (1 << 32) - 1;

/// A point of the picture: screen units from the upper left corner, below 2^20 either way, and the
/// nearness, between 0 and [`TOP`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Spot {
    pub(super) x: i64,
    pub(super) y: i64,
    /// The reciprocal of the distance along the view, which is linear on the screen.
    pub(super) near: i64,
}

/// A shape in one colour, or a ball.
#[derive(Clone, Copy, Debug)]
pub(super) enum Shape {
    /// A convex polygon: where its corners begin in the list of them, and how many there are.
    Polygon { first: usize, corners: usize, colour: Rgb },
    /// A disc that looks like a ball; the radius is below 2^20 screen units.
    Ball { centre: Spot, radius: i64, colour: Rgb },
}

/// Shapes in the order in which they were added. Where two are equally near, the later is seen.
#[derive(Debug)]
pub(super) struct Canvas {
    width: u32,
    height: u32,
    corners: Vec<Spot>,
    shapes: Vec<Shape>,
}

impl Canvas {
    /// Nothing, on so many pixels.
    pub(super) fn new(width: u32, height: u32) -> Self {
        Self { width, height, corners: Vec::new(), shapes: Vec::new() }
    }

    /// Adds a convex polygon.
    pub(super) fn polygon(&mut self, corners: &[Spot], colour: Rgb) {
        let first = self.corners.len();
        self.corners.extend_from_slice(corners);
        self.shapes.push(Shape::Polygon { first, corners: corners.len(), colour });
    }

    /// Adds a line, `width` screen units wide, with square ends.
    pub(super) fn line(&mut self, a: Spot, b: Spot, width: i64, colour: Rgb) {
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        // At most 2 * 2^42.
        let length = isqrt((dx * dx + dy * dy).unsigned_abs()).cast_signed();
        let along = |d: i64| if length == 0 { 0 } else { round_div(d * width, 2 * length) };
        let (ex, ey) = if length == 0 { (width / 2, 0) } else { (along(dx), along(dy)) };
        let corner = |spot: Spot, end: i64, side: i64| Spot {
            x: spot.x + end * ex - side * ey,
            y: spot.y + end * ey + side * ex,
            near: spot.near,
        };
        let corners = [corner(a, -1, -1), corner(b, 1, -1), corner(b, 1, 1), corner(a, -1, 1)];
        self.polygon(&corners, colour);
    }

    /// Adds a ball.
    pub(super) fn ball(&mut self, centre: Spot, radius: i64, colour: Rgb) {
        self.shapes.push(Shape::Ball { centre, radius, colour });
    }

    /// Paints all shapes, band by band. O(pixels + shapes * bands).
    pub(super) fn paint(&self) -> Picture {
        let mut picture = Picture::new(self.width, self.height);
        let mut band = Band::new(self.width);
        for (first, rows) in picture.bands() {
            band.clear(first);
            for shape in &self.shapes {
                match *shape {
                    Shape::Polygon { first, corners, colour } => {
                        band.polygon(&self.corners[first..first + corners], colour);
                    }
                    Shape::Ball { centre, radius, colour } => band.ball(centre, radius, colour),
                }
            }
            band.resolve(rows);
        }
        picture
    }
}
