//! Every movable particle stays on one side of a plane.

use alloc::vec::Vec;
use core::fmt;

use serde::{Deserialize, Serialize};

use crate::math::root::root_nearest;
use crate::math::wide::{
    add, dot_narrow, dot_wide, is_narrow, round_div, round_shift, round_shift_wide, sub, to_i32,
    to_i64,
};
use crate::math::{Factor, Unit, UnitVec3, Vec3};
use crate::particle::{
    DISPLACEMENT_LIMIT, RangeError, WORLD_LIMIT, check, check_in, check_within, clamp_longest,
};
use crate::store::{Handle, slot_index};

/// Names a half-space of a world.
#[derive(
    Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default, Serialize, Deserialize,
)]
pub struct HalfSpaceId(pub Handle);

/// A floor, a wall or a slope: particles behind the plane are put back on it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct HalfSpace {
    /// Any point of the plane, metres.
    pub point: Vec3,
    /// Points to where particles may be.
    pub normal: UnitVec3,
    /// Coulomb's coefficient, 0 to 16. Default 0.5.
    pub friction: Factor,
    /// Share of the approach speed that a bounce gives back, 0 to 1. Approaches slower than what
    /// the particle's acceleration makes in two ticks do not bounce. Default 0.
    pub restitution: Unit,
    /// A disabled half-space does nothing. Default `true`.
    pub enabled: bool,
    /// Whatever the game wants to keep here. Default 0.
    pub user: u64,
}

impl HalfSpace {
    /// The greatest coefficient of friction.
    pub const FRICTION_MAX: Factor = Factor::from_raw(16 << 16);

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { point, normal, friction, restitution, enabled: _, user: _ } = self;
        check_within(*point, WORLD_LIMIT, "point")?;
        check(normal.is_unit(), "normal")?;
        check_in(*friction, Factor::ZERO..=Self::FRICTION_MAX, "friction")?;
        check_in(*restitution, Unit::ZERO..=Unit::ONE, "restitution")
    }

    /// Depth of a point behind the plane in raw units, negative in front; rounded once.
    #[inline]
    fn depth(&self, position: [i64; 3]) -> i64 {
        let d = sub(self.point.raw(), position);
        let normal = self.normal.raw();
        if is_narrow(d) {
            round_shift(dot_narrow(normal, d), 30)
        } else {
            // |d| < 2^61.9 a component, so the depth is below 2^63.
            to_i64(round_shift_wide(dot_wide(normal, d), 30))
        }
    }

    /// `length` raw units along the normal, |length| <= 2^32.
    #[inline]
    fn along(&self, length: i64) -> [i64; 3] {
        self.normal.raw().map(|n| round_shift(n * length, 30))
    }
}

/// A particle that a surface pushed in this substep.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Touch {
    particle: u32,
    surface: u32,
    /// Motion along the normal before the push, raw units in this substep.
    approach: i64,
}

/// Puts every particle that `moves` back in front of the surfaces, with friction, and notes whom
/// they touched: each particle and surface once, with the fastest approach of the substep.
pub(crate) fn collide(
    surfaces: &[HalfSpace],
    moves: impl Fn(usize) -> bool,
    start: &[[i64; 3]],
    position: &mut [[i64; 3]],
    touches: &mut Vec<Touch>,
) {
    for (slot, (position, start)) in position.iter_mut().zip(start).enumerate() {
        if !moves(slot) {
            continue;
        }
        for (index, surface) in (0u32..).zip(surfaces) {
            let depth = surface.depth(*position);
            if depth > 0 {
                let particle = slot_index(slot);
                let motion = sub(*position, *start);
                let approach = if is_narrow(motion) {
                    round_shift(dot_narrow(surface.normal.raw(), motion), 30)
                } else {
                    0 // the displacement will be clamped: nothing to bounce with
                };
                touches.push(Touch { particle, surface: index, approach });
                push(surface, depth.min(DISPLACEMENT_LIMIT), *start, position);
            }
        }
    }
    touches.sort_unstable();
    touches.dedup_by_key(|touch| (touch.particle, touch.surface));
}

/// Moves a particle out by `depth`, and against its slip by at most `friction * depth`: Coulomb's
/// law in positions, where static friction comes for free (Macklin et al. 2014, section 6.1).
fn push(shape: &HalfSpace, depth: i64, start: [i64; 3], position: &mut [i64; 3]) {
    *position = add(*position, shape.along(depth));
    let motion = sub(*position, start);
    if !is_narrow(motion) {
        return; // moved beyond 64 m: the displacement clamp acts, friction does not
    }
    let normal_part = shape.along(round_shift(dot_narrow(shape.normal.raw(), motion), 30));
    let slip = sub(motion, normal_part);
    // |slip| <= |motion| + 2 ulp <= 1.74 * 2^30: the squares sum below 2^62.
    let slip_sq: i64 = slip.iter().map(|c| c * c).sum();
    // 20 + 30 bits; beyond 2^31 it stops any slip.
    let hold = round_shift(i64::from(shape.friction.raw()) * depth, 16).min(1 << 31);
    let stopped = if slip_sq <= hold * hold {
        slip
    } else {
        let length = root_nearest(slip_sq.cast_unsigned()).max(1).cast_signed();
        slip.map(|c| round_div(c * hold, length)) // hold <= length < 2^31
    };
    *position = sub(*position, stopped);
}

/// Gives the particles that touched a surface the velocity they leave with; positions stay.
///
/// A bounce returns its share of the approach, unless that is at most `bounce_min` of the particle
/// and the surface. Otherwise a push may stop the approach, but adds no speed: a particle that was
/// found behind the surface is put back without a pop.
pub(crate) fn settle(
    surfaces: &[HalfSpace],
    bounce_min: impl Fn(usize, &HalfSpace) -> i64,
    touches: &mut Vec<Touch>,
    displacement: &mut [[i32; 3]],
    displacement_max: i64,
    mut report_cut: impl FnMut(u32),
) {
    for touch in touches.drain(..) {
        let surface = &surfaces[touch.surface as usize];
        let slot = touch.particle as usize;
        let motion = displacement[slot].map(i64::from);
        let speed = round_shift(dot_narrow(surface.normal.raw(), motion), 30);
        let springs = surface.restitution > Unit::ZERO;
        let target = if springs && touch.approach < -bounce_min(slot, surface) {
            // 31 + 30 bits.
            round_shift(-touch.approach * i64::from(surface.restitution.raw()), 30)
        } else {
            speed.min(touch.approach.max(0))
        };
        // Each component is below 2^30 + 2^32.
        let settled = add(motion, surface.along(target - speed));
        let cut = clamp_longest(settled, displacement_max);
        if cut.is_some() {
            report_cut(touch.particle);
        }
        displacement[slot] = cut.unwrap_or(settled).map(to_i32);
    }
}

impl Default for HalfSpace {
    fn default() -> Self {
        Self {
            point: Vec3::ZERO,
            normal: UnitVec3::Y,
            friction: Factor::from_raw(1 << 15),
            restitution: Unit::ZERO,
            enabled: true,
            user: 0,
        }
    }
}

impl fmt::Display for HalfSpaceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "half-space {}", self.0)
    }
}
