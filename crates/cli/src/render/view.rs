//! Where the camera stands.

use clap::ValueEnum;
use verlock::Vec3;
use verlock::math::UnitVec3;

use crate::number::number;

/// From where everything shown is looked at.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, ValueEnum)]
pub(crate) enum View {
    /// Against z; x to the right, y up
    Front,
    /// Against x; z to the left, y up
    Side,
    /// Against y; x to the right, z down
    Top,
    /// From the front, right and above
    #[default]
    Iso,
}

impl View {
    /// The direction from what is looked at to the eye.
    pub(super) fn direction(self) -> UnitVec3 {
        match self {
            Self::Front => UnitVec3::Z,
            Self::Side => UnitVec3::X,
            Self::Top => UnitVec3::Y,
            Self::Iso => UnitVec3::normalize(Vec3::from_ints(4, 3, 5)).unwrap_or(UnitVec3::Z),
        }
    }
}

/// Pixels of a picture, `WxH`.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    let sides = sides.ok_or("two numbers with an x between them are expected: 640x480")?;
    if sides.iter().all(|side| (16..=4096).contains(side)) {
        Ok(sides)
    } else {
        Err("a picture is 16 to 4096 pixels wide and high".into())
    }
}

/// A point of the world in metres, `X,Y,Z`.
pub(crate) fn point(text: &str) -> Result<Vec3, String> {
    const EXPECTED: &str = "three numbers with commas between them are expected: 1,2.5,-3";
    if text.split(',').count() != 3 {
        return Err(EXPECTED.into());
    }
    let mut numbers = text.split(',').map(number);
    let mut next = || numbers.next().ok_or(EXPECTED)?;
    let point = Vec3::new(next()?, next()?, next()?);
    let limit = verlock::particle::WORLD_LIMIT.unsigned_abs();
    if point.raw().iter().any(|c| c.unsigned_abs() > limit) {
        return Err("outside of the world, 2^36 m either way".into());
    }
    Ok(point)
}
