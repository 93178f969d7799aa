//! The sink that paints a world.

use std::fmt;

use verlock::Vec3;
use verlock::world::{DrawSink, Shade};

use super::bounds::Bounds;
use super::camera::Camera;
use super::canvas::{Canvas, PIXEL, Spot};
use super::clip::Frustum;
use super::colour::{self, BACKGROUND, GRID, Rgb, SHADOW, TEXT, WHOLE};
use super::font;
use super::picture::Picture;
use super::plane::{Grid, Plane, planes};

/// By how many 4,096ths of its distance a thing is moved towards the eye, so that faces do not hide
/// their edges, nor lines their ends, nor the ground what lies on it. Contacts are seen through all
/// but what is four times as near.
const EDGE_LIFT: i64 = 8;
const LINE_LIFT: i64 = 16;
const POINT_LIFT: i64 = 32;
const CONTACT_LIFT: i64 = 3072;
const GRID_LIFT: i64 = -64;
const SHADOW_LIFT: i64 = -68;

const LINE_WIDTH: i64 = PIXEL * 5 / 4;
const CONTACT_WIDTH: i64 = PIXEL * 9 / 4;
const EDGE_WIDTH: i64 = PIXEL * 3 / 4;
const GRID_WIDTH: i64 = PIXEL;

/// A point's radius lies between these, wherever it is.
const RADIUS_FAR: i64 = PIXEL * 3 / 4;
const RADIUS_NEAR: i64 = PIXEL * 64;

/// The share of the background in the colour of what is farthest behind.
const HAZE: u32 = WHOLE / 4;

/// The corners of the shadow of a point, 8 bits behind the binary point.
const OCTAGON: [[i64; 2]; 8] =
    [[256, 0], [181, 181], [0, 256], [-181, 181], [-256, 0], [-181, -181], [0, -256], [181, -181]];

/// Tells a sink what there is.
pub(super) type Draw<'a> = dyn Fn(&mut dyn DrawSink) + 'a;

/// How frames are painted: the same for all of them.
#[derive(Debug)]
pub(super) struct Style {
    pub(super) camera: Camera,
    /// Pixels across and down.
    pub(super) size: [u32; 2],
    /// Of what is shown in any frame.
    pub(super) bounds: Bounds,
    /// Whether there are grids and shadows.
    pub(super) grid: bool,
}

/// Paints one frame.
#[derive(Debug)]
pub(super) struct Painter<'a> {
    style: &'a Style,
    frustum: Frustum,
    canvas: Canvas,
    grid: Grid,
    /// What is drawn as a grid: none without.
    planes: Vec<Plane>,
    /// Of a point at the focus.
    radius: i64,
}

impl Style {
    /// Paints what is told to a sink, and texts in the lower left corner.
    pub(super) fn paint(&self, captions: &[(&str, Rgb)], draw: &Draw<'_>) -> Picture {
        let mut painter = Painter::new(self, draw);
        painter.grids();
        draw(&mut painter);
        painter.caption(captions);
        painter.finish()
    }

    /// The radius of a point at the focus: the more there is, the smaller; 1.25 to 4.5 pixels on a
    /// picture of 480 rows.
    fn radius(&self) -> i64 {
        let area = u64::from(self.size[0]) * u64::from(self.size[1]);
        let room = (area / self.bounds.things_max().max(1)).isqrt().cast_signed();
        let height = i64::from(self.size[1]) * PIXEL;
        (room * PIXEL / 16).clamp(height / 384, height / 106)
    }
}

impl<'a> Painter<'a> {
    /// An empty canvas for what is to be drawn.
    pub(super) fn new(style: &'a Style, draw: &Draw<'_>) -> Self {
        let [width, height] = style.size;
        Self {
            style,
            frustum: style.camera.frustum(),
            canvas: Canvas::new(width, height),
            grid: Grid::new(&style.bounds),
            planes: if style.grid { planes(draw, &style.bounds) } else { Vec::new() },
            radius: style.radius(),
        }
    }

    /// What was painted.
    pub(super) fn finish(self) -> Picture {
        self.canvas.paint()
    }

    /// Paints the planes that are seen from the front.
    fn grids(&mut self) {
        let planes = self.planes.clone();
        for &plane in &planes {
            if self.style.camera.is_before(plane.point, plane.normal) {
                for piece in self.grid.pieces(plane, &planes) {
                    let colour = BACKGROUND.mix(
                        GRID,
                        if plane.is_ground() { piece.share } else { piece.share * 2 / 3 },
                    );
                    self.stroke(piece.ends, GRID_WIDTH, GRID_LIFT, colour);
                }
            }
        }
    }

    /// Texts beside each other in the lower left corner.
    fn caption(&mut self, texts: &[(&str, Rgb)]) {
        let rows = i64::from(self.style.size[1]) * PIXEL;
        let height = (rows / 40).max(12 * PIXEL).min(rows / 24);
        let bottom = i64::from(self.style.size[1]) * PIXEL - height;
        let mut left = height;
        for &(text, colour) in texts {
            left = font::write(&mut self.canvas, text, [left, bottom], height, colour);
        }
    }

    fn view(&self, at: Vec3) -> Option<[i64; 3]> {
        self.style.camera.view(at.raw())
    }

    fn stroke(&mut self, ends: [Vec3; 2], width: i64, lift: i64, colour: Rgb) {
        let [Some(a), Some(b)] = ends.map(|end| self.view(end)) else { return };
        if let Some(ends) = self.frustum.clip_line([a, b]) {
            let [a, b] = ends.map(|end| self.style.camera.spot(end, lift));
            self.canvas.line(a, b, width, colour);
        }
    }

    fn fill(&mut self, corners: [Vec3; 3], lift: i64, colour: Rgb) {
        let [Some(a), Some(b), Some(c)] = corners.map(|corner| self.view(corner)) else { return };
        let polygon = self.frustum.clip_triangle([a, b, c]);
        let spots = polygon.into_iter().map(|corner| self.style.camera.spot(corner, lift));
        self.canvas.polygon(&spots.collect::<Vec<_>>(), colour);
    }

    /// What shadows fall on.
    fn ground(&self) -> Option<Plane> {
        self.planes.iter().copied().find(|plane| plane.is_ground())
    }

    /// Where the shadow of a point falls, if it is above the ground and that is not hidden.
    fn shadow(&self, at: Vec3) -> Option<Vec3> {
        let ground = self.ground().filter(|ground| ground.height(at.raw()) > 0)?;
        let shadow = ground.under(at.raw())?;
        let hidden = self.grid.is_hidden(shadow, ground, &self.planes);
        (!hidden).then(|| Vec3::from_raw(shadow))
    }

    fn shadow_of_point(&mut self, at: Vec3) {
        let (Some(middle), Some(ground)) = (self.shadow(at), self.ground()) else { return };
        let radius = self.style.camera.raw_at_focus(self.radius);
        let spots = OCTAGON.map(|[x, z]| {
            let mut corner = middle.raw();
            // 62 bits and 8.
            corner[0] = corner[0].saturating_add(radius.saturating_mul(x) >> 8);
            corner[2] = corner[2].saturating_add(radius.saturating_mul(z) >> 8);
            let view = self.style.camera.view(ground.under(corner)?)?;
            self.frustum.contains(view).then(|| self.style.camera.spot(view, SHADOW_LIFT))
        });
        if let Some(spots) = spots.into_iter().collect::<Option<Vec<_>>>() {
            self.canvas.polygon(&spots, SHADOW);
        }
    }

    /// A colour as it is seen through the air between: what is behind fades a little.
    fn hazed(&self, colour: Rgb, at: Vec3) -> Rgb {
        let depth = self.style.camera.depth(at.raw(), self.style.bounds.extent());
        colour.mix(BACKGROUND, HAZE * depth / WHOLE)
    }

    /// A point of the picture, if it is inside of it.
    fn spot(&self, at: Vec3, lift: i64) -> Option<(Spot, [i64; 3])> {
        let view = self.view(at).filter(|&view| self.frustum.contains(view))?;
        Some((self.style.camera.spot(view, lift), view))
    }
}

/// The lift of a thing, unless it is a contact.
fn lifted(shade: Shade, lift: i64) -> i64 {
    if shade == Shade::Contact { CONTACT_LIFT } else { lift }
}

impl DrawSink for Painter<'_> {
    fn triangle(&mut self, corners: [Vec3; 3], shade: Shade) {
        if let [Some(a), Some(b), Some(c)] = corners.map(|corner| self.shadow(corner)) {
            self.fill([a, b, c], SHADOW_LIFT, SHADOW);
        }
        let Some((front, light)) = self.style.camera.light(corners) else { return };
        let colour = colour::of_face(shade, front).lit(light);
        self.fill(corners, 0, colour);
        for index in 0..3 {
            let edge = [corners[index], corners[(index + 1) % 3]];
            self.stroke(edge, EDGE_WIDTH, EDGE_LIFT, colour.lit(WHOLE * 7 / 16));
        }
    }

    fn line(&mut self, ends: [Vec3; 2], shade: Shade) {
        if let [Some(a), Some(b)] = ends.map(|end| self.shadow(end)) {
            self.stroke([a, b], LINE_WIDTH, SHADOW_LIFT, SHADOW);
        }
        let colour = self.hazed(colour::of(shade), ends[0]);
        let width = if shade == Shade::Contact { CONTACT_WIDTH } else { LINE_WIDTH };
        self.stroke(ends, width, lifted(shade, LINE_LIFT), colour);
    }

    fn point(&mut self, at: Vec3, shade: Shade) {
        self.shadow_of_point(at);
        let lift = lifted(shade, POINT_LIFT);
        let Some((spot, view)) = self.spot(at, lift) else { return };
        let radius = match shade {
            Shade::Pinned => self.radius * 3 / 2,
            // However much there is around it.
            Shade::Contact => self.radius.max(i64::from(self.style.size[1]) * PIXEL / 140),
            _ => self.radius,
        };
        let radius = self.style.camera.scaled(radius, view).clamp(RADIUS_FAR, RADIUS_NEAR);
        self.canvas.ball(spot, radius, self.hazed(colour::of(shade), at));
    }

    fn label(&mut self, at: Vec3, text: fmt::Arguments<'_>) {
        if let Some((spot, _)) = self.spot(at, POINT_LIFT) {
            let height = i64::from(self.style.size[1]) * PIXEL / 64;
            let (left, bottom) = (spot.x + height / 2, spot.y - height / 2);
            let (text, height) = (text.to_string(), height.max(6 * PIXEL));
            font::write(&mut self.canvas, &text, [left, bottom], height, TEXT);
        }
    }
}
