//! Half-spaces and the ground, as grids.
//!
//! Each plane is a height over the two axes that it is least steep along, and its lines stand over
//! the multiples of one spacing, so that the grids of several planes meet. They fade away from the
//! middle of what is shown, and stop behind other planes.

use verlock::Vec3;
use verlock::math::UnitVec3;
use verlock::math::root::isqrt_wide;
use verlock::math::wide::round_div_wide;
use verlock::world::{DrawSink, Shade};

use super::bounds::{Bounds, longest};
use super::colour::WHOLE;
use super::painter::Draw;

/// Lines of a grid from the middle of what is shown to where they fade out, at most.
const LINES: i64 = 14;

/// Raw units of a metre.
const METRE: i128 = 1 << 24;

/// The boundary of a half-space.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Plane {
    pub(super) point: [i64; 3],
    pub(super) normal: UnitVec3,
}

/// Where grids stand and how far they reach.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    middle: [i64; 3],
    /// Raw.
    radius: i64,
    /// Metres between two lines, as a fraction.
    spacing: [i128; 2],
}

/// A short piece of a line, and its share of colour of [`WHOLE`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) ends: [Vec3; 2],
    pub(super) share: u32,
}

/// The planes that are drawn, but for those that take no part; one of them at least is ground.
pub(super) fn planes(draw: &Draw<'_>, bounds: &Bounds) -> Vec<Plane> {
    let mut planes = Planes(Vec::new());
    draw(&mut planes);
    if !planes.0.iter().any(|plane| plane.is_ground()) {
        planes.0.push(bounds.ground());
    }
    planes.0
}

/// A sink for planes alone.
struct Planes(Vec<Plane>);

impl DrawSink for Planes {
    fn plane(&mut self, point: Vec3, normal: UnitVec3, shade: Shade) {
        if shade != Shade::Disabled {
            self.0.push(Plane { point: point.raw(), normal });
        }
    }
}

impl Plane {
    /// The axis along which the plane is steepest.
    fn steep(self) -> usize {
        let [x, y, z] = self.normal.raw().map(i64::abs);
        if y >= x && y >= z {
            1
        } else if x >= z {
            0
        } else {
            2
        }
    }

    /// Whether things can lie on it.
    pub(super) fn is_ground(self) -> bool {
        self.steep() == 1 && self.normal.raw()[1] > 0
    }

    /// The ground of a world that has none: the plane through the origin, unless it is far from
    /// what is shown; then the lower end of the box.
    pub(super) fn default_ground(corners: [[i64; 3]; 2]) -> Self {
        let [low, high] = corners.map(|corner| corner[1]);
        let far = low > longest(corners) || high < 0;
        Self { point: [0, if far { low } else { 0 }, 0], normal: UnitVec3::Y }
    }

    /// Moves a point along an axis onto the plane; `None` where that is outside of the world.
    fn drop_along(self, axis: usize, mut point: [i64; 3]) -> Option<[i64; 3]> {
        let normal = self.normal.raw().map(i128::from);
        // 30 + 62 bits twice; the part of the normal along the axis has 29.
        let aside = (0..3).filter(|&other| other != axis);
        let sum: i128 = aside.map(|a| normal[a] * i128::from(point[a] - self.point[a])).sum();
        let along = normal[axis];
        let fall = round_div_wide(sum * along.signum(), along.abs().max(1));
        point[axis] = i64::try_from(i128::from(self.point[axis]) - fall).ok()?;
        (point[axis].unsigned_abs() <= 1 << 61).then_some(point)
    }

    /// The point of the plane below or above a point.
    pub(super) fn under(self, point: [i64; 3]) -> Option<[i64; 3]> {
        self.drop_along(1, point)
    }

    /// How far in front of the plane a point is, raw; negative behind it.
    pub(super) fn height(self, point: [i64; 3]) -> i128 {
        let normal = self.normal.raw();
        let offset = [0, 1, 2].map(|axis| i128::from(point[axis] - self.point[axis]));
        [0, 1, 2].map(|axis| i128::from(normal[axis]) * offset[axis]).iter().sum::<i128>() >> 30
    }
}

impl Grid {
    /// A grid around everything shown.
    pub(super) fn new(bounds: &Bounds) -> Self {
        let radius = bounds.extent() + bounds.extent() / 4;
        let mut spacing = [1, 1_000_000];
        // 1, 2, 5, 10, 20 and so on, micrometres at first.
        for factor in [[2, 1], [5, 2], [2, 1]].into_iter().cycle() {
            if spacing[0] * METRE * i128::from(LINES) >= spacing[1] * i128::from(radius) {
                break;
            }
            spacing[0] = spacing[0] * factor[0] / factor[1];
        }
        Self { middle: bounds.middle(), radius, spacing }
    }

    /// The lines of one plane as far as they are in front of the others.
    pub(super) fn pieces(&self, plane: Plane, others: &[Plane]) -> Vec<Piece> {
        let steep = plane.steep();
        let [u, v] = [(steep + 1) % 3, (steep + 2) % 3];
        let mut pieces = Vec::new();
        for [across, along] in [[u, v], [v, u]] {
            for line in self.lines(across) {
                let knots = self.lines(along);
                for (from, to) in knots.clone().zip(knots.skip(1)) {
                    let knot = |at: i64| {
                        let mut point = self.middle;
                        (point[across], point[along]) = (self.place(line), self.place(at));
                        plane.drop_along(steep, point)
                    };
                    if let (Some(a), Some(b)) = (knot(from), knot(to)) {
                        pieces.extend(self.piece(a, b, [u, v], plane, others));
                    }
                }
            }
        }
        pieces
    }

    /// Whether a point of a plane is behind another one.
    pub(super) fn is_hidden(&self, point: [i64; 3], plane: Plane, others: &[Plane]) -> bool {
        let slack = i128::from(self.radius / 1000);
        others.iter().any(|other| *other != plane && other.height(point) < -slack)
    }

    fn piece(
        &self,
        a: [i64; 3],
        b: [i64; 3],
        flat: [usize; 2],
        plane: Plane,
        others: &[Plane],
    ) -> Option<Piece> {
        let centre = [0, 1, 2].map(|axis| (a[axis] + b[axis]) >> 1);
        if self.is_hidden(centre, plane, others) {
            return None;
        }
        let aside = flat.map(|axis| i128::from(centre[axis] - self.middle[axis]));
        // 2 * 2^124.
        let away = isqrt_wide((aside[0] * aside[0] + aside[1] * aside[1]).unsigned_abs());
        let whole = u128::from(WHOLE);
        let share = whole.checked_sub(away * whole / u128::from(self.radius.unsigned_abs()))?;
        let share = u32::try_from(share).ok().filter(|&share| share > 0)?;
        Some(Piece { ends: [a, b].map(Vec3::from_raw), share })
    }

    /// The numbers of the lines across an axis.
    fn lines(&self, axis: usize) -> impl Iterator<Item = i64> + Clone {
        let number = |place: i64| {
            let number = i128::from(place) * self.spacing[1] / (self.spacing[0] * METRE);
            i64::try_from(number).unwrap_or_default()
        };
        let middle = self.middle[axis];
        number(middle - self.radius) - 1..=number(middle + self.radius) + 1
    }

    /// Where a line is, raw.
    fn place(&self, line: i64) -> i64 {
        let place = round_div_wide(i128::from(line) * self.spacing[0] * METRE, self.spacing[1]);
        i64::try_from(place).unwrap_or_default()
    }
}
