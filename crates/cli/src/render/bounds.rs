//! The box around everything that is shown.

use verlock::Vec3;
use verlock::math::UnitVec3;
use verlock::world::{DrawSink, Shade};

use super::plane::Plane;

/// A box around all points drawn, and how many things there were in one frame at most.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bounds {
    corners: Option<[[i64; 3]; 2]>,
    things: u64,
    things_max: u64,
    /// The first plane that things can lie on.
    ground: Option<Plane>,
}

/// What is drawn where there is nothing to see: a metre around the origin.
const EMPTY: [[i64; 3]; 2] = [[-(1 << 24); 3], [1 << 24; 3]];

impl Bounds {
    /// A frame is complete.
    pub(super) fn end_frame(&mut self) {
        self.things_max = self.things_max.max(self.things);
        self.things = 0;
    }

    /// The most points and triangles of a frame.
    pub(super) fn things_max(&self) -> u64 {
        self.things_max
    }

    /// The middle, raw.
    pub(super) fn middle(&self) -> [i64; 3] {
        let [low, high] = self.corners();
        // Within the world: 2^60 and 2^60.
        [0, 1, 2].map(|axis| (low[axis] + high[axis]) >> 1)
    }

    /// The longest edge, raw; more than 0.
    pub(super) fn extent(&self) -> i64 {
        longest(self.corners())
    }

    /// The two opposite corners, raw. A box without extent is grown by a metre.
    pub(super) fn corners(&self) -> [[i64; 3]; 2] {
        match self.corners {
            None => EMPTY,
            Some([low, high]) if low == high => {
                [0, 1].map(|side| [0, 1, 2].map(|axis| low[axis] + EMPTY[side][axis]))
            }
            Some(corners) => corners,
        }
    }

    /// The same, with the ground under it if that is near.
    pub(super) fn grounded_corners(&self) -> [[i64; 3]; 2] {
        let [mut low, high] = self.corners();
        let ground = self.ground().under(self.middle()).map_or(low[1], |ground| ground[1]);
        if ground < low[1] && low[1] - ground < self.extent() {
            low[1] = ground;
        }
        [low, high]
    }

    /// The ground of the world, or else one that could be.
    pub(super) fn ground(&self) -> Plane {
        self.ground.unwrap_or_else(|| Plane::default_ground(self.corners()))
    }

    fn add(&mut self, points: &[Vec3]) {
        for point in points {
            let point = point.raw();
            let [low, high] = self.corners.get_or_insert([point; 2]);
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
    }
}

/// All eight corners of a box.
pub(super) fn all_corners(box_corners: [[i64; 3]; 2]) -> [[i64; 3]; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7]
        .map(|corner: usize| [0, 1, 2].map(|axis| box_corners[(corner >> axis) & 1][axis]))
}

/// All points drawn.
#[derive(Debug, Default)]
pub(super) struct Points(pub(super) Vec<[i64; 3]>);

impl DrawSink for Points {
    fn triangle(&mut self, corners: [Vec3; 3], _: Shade) {
        self.0.extend(corners.map(Vec3::raw));
    }

    fn line(&mut self, ends: [Vec3; 2], _: Shade) {
        self.0.extend(ends.map(Vec3::raw));
    }

    fn point(&mut self, at: Vec3, _: Shade) {
        self.0.push(at.raw());
    }
}

/// The longest edge of a box.
pub(super) fn longest([low, high]: [[i64; 3]; 2]) -> i64 {
    [0, 1, 2].map(|axis| high[axis] - low[axis]).into_iter().fold(0, i64::max)
}

impl DrawSink for Bounds {
    fn plane(&mut self, point: Vec3, normal: UnitVec3, shade: Shade) {
        let plane = Plane { point: point.raw(), normal };
        if self.ground.is_none() && shade != Shade::Disabled && plane.is_ground() {
            self.ground = Some(plane);
        }
    }

    fn triangle(&mut self, corners: [Vec3; 3], _: Shade) {
        self.things += 1;
        self.add(&corners);
    }

    fn line(&mut self, ends: [Vec3; 2], _: Shade) {
        self.add(&ends);
    }

    fn point(&mut self, at: Vec3, _: Shade) {
        self.things += 1;
        self.add(&[at]);
    }
}
