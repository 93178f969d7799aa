//! From the world to the picture.
//!
//! A position becomes a *view*: its differences from the eye along right, up and ahead, exact sums
//! rounded once, in units of which 2^24 to 2^25 lie between the eye and what it looks at. What is
//! farther than 2^16 times that is not seen. A view becomes a [`Spot`] by one division.

use verlock::Vec3;
use verlock::math::UnitVec3;
use verlock::math::wide::{round_div, round_div_wide, round_shift, round_shift_wide};

use super::canvas::{PIXEL, Spot};
use super::clip::Frustum;
use super::colour::WHOLE;

/// Bits of the distance between the eye and what it looks at.
const FOCUS_BITS: u32 = 25;

/// No component of a view is greater.
const VIEW_MAX: i64 = 1 << 40;

/// What is nearer to the eye is cut off: between a 64th and a 128th of the way to the focus.
const NEAR: i64 = 1 << 18;

/// Bits of the nearness of what is one unit away: at [`NEAR`], 2^31.
const NEARNESS_BITS: u32 = 49;

/// The share of the picture that a fitted box fills: 13 of 16.
const FIT: [i128; 2] = [13, 16];

/// A perspective view.
#[derive(Clone, Debug)]
pub(super) struct Camera {
    /// Raw. In 128 bits, since it may have to stand far outside of a large world.
    eye: [i128; 3],
    /// Right, up and ahead, 30 fractional bits.
    axes: [[i64; 3]; 3],
    /// By how many bits a sum of products is shortened to become a view.
    shift: u32,
    /// The distance to what is looked at.
    focus: i64,
    lens: Lens,
}

/// What a camera maps to the picture: its size and angle of view.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lens {
    /// The middle of the picture, screen units, at most 2^17.
    half: [i64; 2],
    /// Screen units for a unit across at a unit ahead, below 2^22.
    focal: i64,
}

impl Lens {
    /// A picture of so many pixels, at most 4,096 each, with a vertical angle of view in degrees,
    /// 5 to 120.
    pub(super) fn new(width: u32, height: u32, angle: u32) -> Self {
        let half = [width, height].map(|pixels| i64::from(pixels) * PIXEL / 2);
        let (sine, cosine) = sine_and_cosine(angle);
        // 2^17 * 2^30; sine >= 2^25.4.
        Self { half, focal: round_div(half[1] * cosine, sine) }
    }

    /// The screen's half extents.
    pub(super) fn half(self) -> [i64; 2] {
        self.half
    }

    pub(super) fn focal(self) -> i64 {
        self.focal
    }
}

impl Camera {
    /// At one point, looking at another; `None` if they are the same.
    pub(super) fn looking(eye: Vec3, target: Vec3, lens: Lens) -> Option<Self> {
        let back = eye.checked_sub(target)?;
        let axes = axes(UnitVec3::normalize(back)?);
        Some(Self::new(eye.raw().map(i128::from), axes, back.length().raw().into(), lens))
    }

    /// Looking from a direction, as near as points allow that are to be seen, at least one of them,
    /// with all of them in the middle of the picture. O(points).
    ///
    /// All `|x - ex| focal <= half (ez - z)` hold, with x along right and z backwards, if and only
    /// if `ex focal + half ez >= max(x focal + half z)` and the same with -x. The nearest eye makes
    /// both equal; the axis that needs it farther away decides. From there the other one fills less
    /// than its half of the picture: both are equal for the half that it does fill.
    pub(super) fn fitted(from: UnitVec3, points: &[[i64; 3]], lens: Lens) -> Self {
        let axes = axes(from);
        let middle = [0, 1, 2].map(|axis| {
            let places = points.iter().map(|point| point[axis]);
            let ends = places.clone().min().zip(places.max());
            ends.map_or(0, |(low, high)| (low + high) >> 1)
        });
        let focal = i128::from(lens.focal);
        let half = lens.half.map(|half| i128::from(half) * FIT[0] / FIT[1]);
        let views = points.iter().map(|point| {
            let offset = [0, 1, 2].map(|axis| i128::from(point[axis] - middle[axis]));
            axes.map(|axis| along(axis, offset, 30))
        });
        let views: Vec<_> = views.collect();
        // 22 + 63 bits.
        let reach = |axis: usize, half: i128| {
            [focal, -focal].map(|focal| {
                let reaches = views.iter().map(|view| view[axis] * focal - half * view[2]);
                reaches.fold(i128::MIN, i128::max)
            })
        };
        let away = |axis: usize, half: i128| reach(axis, half).iter().sum::<i128>() / (2 * half);
        let distance = away(0, half[0]).max(away(1, half[1])).max(1);
        let centre = |axis: usize| {
            // The less is to be filled, the farther away the eye.
            let [mut low, mut high] = [1, half[axis]];
            while low < high {
                let half = i128::midpoint(low, high);
                if away(axis, half) <= distance { high = half } else { low = half + 1 }
            }
            let [right, left] = reach(axis, high);
            (right - left) / (2 * focal)
        };
        let way = [centre(0), centre(1), -distance];
        let eye = [0, 1, 2].map(|axis| {
            let way = way.into_iter().zip(axes).map(|(w, a)| w * i128::from(a[axis]));
            i128::from(middle[axis]) + round_shift_wide(way.sum(), 30)
        });
        Self::new(eye, axes, distance, lens)
    }

    fn new(eye: [i128; 3], axes: [[i64; 3]; 3], distance: i128, lens: Lens) -> Self {
        // The distance gets FOCUS_BITS bits; the axes have 30 behind the point.
        let bits = i128::BITS - distance.leading_zeros();
        let mut camera = Self { eye, axes, shift: bits + 30 - FOCUS_BITS, focus: 0, lens };
        camera.focus = round_shift_wide(distance << 30, camera.shift).try_into().unwrap_or(NEAR);
        camera
    }

    /// What the camera sees of the space of views.
    pub(super) fn frustum(&self) -> Frustum {
        Frustum::new(self.lens, NEAR)
    }

    /// A position as the camera sees it; `None` if it is too far away to be seen.
    pub(super) fn view(&self, position: [i64; 3]) -> Option<[i64; 3]> {
        // At most 2^66.
        let offset = [0, 1, 2].map(|axis| i128::from(position[axis]) - self.eye[axis]);
        let view = self.axes.map(|axis| along(axis, offset, self.shift));
        let bound = i128::from(VIEW_MAX);
        if view.iter().any(|c| c.abs() > bound) {
            return None;
        }
        Some(view.map(|c| i64::try_from(c).unwrap_or_default()))
    }

    /// Where a view inside the [frustum](Self::frustum) is on the screen, `lift` 4,096ths, at most
    /// 128, nearer than it is.
    pub(super) fn spot(&self, view: [i64; 3], lift: i64) -> Spot {
        let [x, y, ahead] = view;
        // 22 + 40 bits; inside the frustum the quotient is at most twice the picture's half.
        let across = |c: i64| round_div(c * self.lens.focal, ahead);
        let near = (1 << NEARNESS_BITS) / ahead;
        Spot {
            x: self.lens.half[0] + across(x),
            y: self.lens.half[1] - across(y),
            near: near + near * lift / 4096,
        }
    }

    /// How long something is on the screen that is `length` long at the focus.
    pub(super) fn scaled(&self, length: i64, view: [i64; 3]) -> i64 {
        // 20 + 25 bits.
        round_div(length * self.focus, view[2])
    }

    /// Raw units that are as long as something on the screen, below 2^20, at the focus.
    pub(super) fn raw_at_focus(&self, length: i64) -> i64 {
        // 20 + 25 + 71 bits.
        let raw = ((i128::from(length) * i128::from(self.focus)) << self.shift) >> 30;
        i64::try_from(raw / i128::from(self.lens.focal)).unwrap_or(i64::MAX)
    }

    /// How deep in a ball of some raw diameter around the focus a position is, as a share of
    /// [`WHOLE`]: none in front of it, all behind it.
    pub(super) fn depth(&self, position: [i64; 3], diameter: i64) -> u32 {
        let Some([_, _, ahead]) = self.view(position) else { return WHOLE };
        // 2^30 * 2^62; more than 0.
        let diameter = round_shift_wide(i128::from(diameter) << 30, self.shift).max(1);
        let depth = (i128::from(ahead - self.focus) * 256 / diameter + 128).clamp(0, 256);
        u32::try_from(depth).unwrap_or_default()
    }

    /// Whether a face is seen from its front, and its share of light; `None` for one without area.
    pub(super) fn light(&self, corners: [Vec3; 3]) -> Option<(bool, u32)> {
        let [a, b, c] = corners.map(|corner| corner.raw().map(i128::from));
        let [u, v] = [b, c].map(|end| [0, 1, 2].map(|axis| end[axis] - a[axis]));
        // 62 + 62 + 1 bits.
        let minor = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let normal = UnitVec3::normalize_wide([minor(1, 2), minor(2, 0), minor(0, 1)])?;
        let front = self.is_before(corners[0].raw(), normal);
        let normal = if front { normal } else { -normal };
        // From the left, above and behind the eye, 8 fractional bits: a vector of length 1.
        let toward = [-141, 166, -133].into_iter().zip(self.axes);
        let share: i128 = toward.map(|(part, axis)| part * along(axis, wide(normal), 30)).sum();
        // The light wraps round the edge a little, and some comes from everywhere.
        let light = ((share >> 30) + 90) * 3 / 5 + 40;
        Some((front, u32::try_from(light.clamp(40, WHOLE.into())).unwrap_or_default()))
    }

    /// Whether the eye is in front of a plane.
    pub(super) fn is_before(&self, point: [i64; 3], normal: UnitVec3) -> bool {
        let offset = [0, 1, 2].map(|axis| self.eye[axis] - i128::from(point[axis]));
        along(normal.raw(), offset, 1) > 0
    }
}

fn wide(normal: UnitVec3) -> [i128; 3] {
    normal.raw().map(i128::from)
}

/// The part of a vector along an axis, shortened by some bits. Below 2^66 * 2^30 * 3.
fn along(axis: [i64; 3], vector: [i128; 3], shift: u32) -> i128 {
    let sum: i128 = axis.into_iter().zip(vector).map(|(a, v)| i128::from(a) * v).sum();
    round_shift_wide(sum, shift)
}

/// Right, up and ahead, with up as near to the world's as can be, for what looks against `back`.
fn axes(back: UnitVec3) -> [[i64; 3]; 3] {
    let [x, _, z] = back.raw();
    // The cross product of the world's up and back.
    let right = UnitVec3::normalize(Vec3::from_raw([z, 0, -x])).unwrap_or(UnitVec3::X).raw();
    let back = back.raw();
    let minor = |i: usize, j: usize| round_shift(back[i] * right[j] - back[j] * right[i], 30);
    [right, [minor(1, 2), minor(2, 0), minor(0, 1)], back.map(|c| -c)]
}

/// Sine and cosine of half an angle in degrees, at most 180, with 30 fractional bits and an error
/// below 2^-26, by their series.
fn sine_and_cosine(angle: u32) -> (i64, i64) {
    /// Pi, 30 fractional bits.
    const PI: i64 = 3_373_259_426;
    let angle = round_div(i64::from(angle) * PI, 360);
    let (mut sine, mut cosine, mut term) = (0, 0, 1 << 30);
    for n in 0..16 {
        match n % 4 {
            0 => cosine += term,
            1 => sine += term,
            2 => cosine -= term,
            _ => sine -= term,
        }
        // 31 + 31 bits: the angle is at most 1.6, its powers by factorials likewise.
        term = round_div(round_shift(term * angle, 30), n + 1);
    }
    (sine, cosine)
}

/// The point of the way from `a` to `b` that is `part` of `whole` along. 41 + 63 bits.
pub(super) fn between(a: [i64; 3], b: [i64; 3], part: i64, whole: i64) -> [i64; 3] {
    [0, 1, 2].map(|axis| {
        let way = i128::from(b[axis] - a[axis]) * i128::from(part);
        let step = round_div_wide(way, whole.into());
        a[axis] + i64::try_from(step).unwrap_or_default()
    })
}
