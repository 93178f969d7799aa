//! Hulls that stand for round shapes.

use alloc::sync::Arc;
use alloc::vec::Vec;

use super::ConvexHull;
use crate::geometry::ShapeError;
use crate::geometry::segment::check_ends;
use crate::geometry::sphere::check_radius;
use crate::math::determinant::cross;
use crate::math::trig::cos_sin;
use crate::math::wide::{dot_narrow, round_shift_wide, sub, to_i64};
use crate::math::{Real, Unit, UnitVec3, Vec3};

impl ConvexHull {
    /// The most sides of what stands for something round.
    pub const SIDES_MAX: u32 = 256;

    /// The prism inside a cylinder, with its corners on the circles about both `ends`, in metres.
    ///
    /// Corners are numbered around the first end, then around the other, counter-clockwise as seen
    /// from the other side of the second end. The first is off in the direction of the cross
    /// product of the coordinate axis that the cylinder is farthest from lying along, of several
    /// the first, and the way from the first end to the second. None is farther from its circle
    /// than 2^-26 of the radius and a raw unit.
    ///
    /// # Errors
    /// [`ShapeError`] if an end is out of range, both are one point, the prism is too long, the
    /// radius is outside 0..=[`RADIUS_MAX`](crate::geometry::Sphere::RADIUS_MAX), the sides are not
    /// 3..=[`SIDES_MAX`](Self::SIDES_MAX), or their square is greater than the radius, raw: then
    /// they would not bulge. [`ShapeError::Flat`] also if it is so flat that rounding dents it.
    pub fn cylinder(ends: [Vec3; 2], radius: Real, sides: u32) -> Result<Self, ShapeError> {
        let ring = ring(ends, radius, sides)?;
        let corners = ends.iter().flat_map(|&end| ring.iter().map(move |&way| end + way));
        let ideal = ideal_ring(sides, 0).chain(ideal_ring(sides, 1));
        Self::around(ideal)?.placed_at(corners.collect())
    }

    /// The pyramid inside a cone, with its corners on the circle about the middle of its `base`,
    /// and at the `apex`, in metres. Corners are numbered as for a [`cylinder`](Self::cylinder)
    /// from the base to the apex, which comes last.
    ///
    /// # Errors
    /// As for a [`cylinder`](Self::cylinder).
    pub fn cone(base: Vec3, apex: Vec3, radius: Real, sides: u32) -> Result<Self, ShapeError> {
        let ring = ring([base, apex], radius, sides)?;
        let mut corners: Vec<Vec3> = ring.into_iter().map(|way| base + way).collect();
        corners.push(apex);
        Self::around(ideal_ring(sides, 0).chain([Vec3::Z * Real::from_int(64)]))?.placed_at(corners)
    }

    /// The same topology elsewhere.
    fn placed_at(self, corners: Vec<Vec3>) -> Result<Self, ShapeError> {
        let hull = Self::with_topology(Arc::clone(&self.topology), corners)?;
        let is_convex = hull.vertices().iter().all(|&corner| hull.contains(corner));
        if is_convex { Ok(hull) } else { Err(ShapeError::Flat) }
    }
}

/// A ring of corners about the z axis, 64 m wide to each side so that what rounding does to it is
/// nothing, `height` times as high.
fn ideal_ring(sides: u32, height: i32) -> impl Iterator<Item = Vec3> {
    (0..sides).map(move |side| {
        let [cos, sin] = cos_sin(side, sides);
        let at = |c: Unit| Real::from_raw(c.raw().into());
        Vec3::new(at(cos), at(sin), Real::from_int(64 * height))
    })
}

/// From either end to its corners. Rounded once, both alike: sides are flat parallelograms.
fn ring(ends: [Vec3; 2], radius: Real, sides: u32) -> Result<Vec<Vec3>, ShapeError> {
    check_ends(ends)?;
    check_radius(radius)?;
    // A corner is before its neighbours by 4.9 radius / sides^2: farther than rounding moves them.
    let bulges = || i64::from(sides).pow(2) <= radius.raw();
    if !((3..=ConvexHull::SIDES_MAX).contains(&sides) && bulges()) {
        return Err(ShapeError::WrongCount("sides"));
    }
    let [u, v] = across(sub(ends[1].raw(), ends[0].raw())).ok_or(ShapeError::Flat)?;
    let corner = |side| {
        let turn = cos_sin(side, sides).map(|c| i64::from(c.raw()));
        let along = |k: usize| {
            // At most 2^61, times 2^39.
            let share = dot_narrow([u.raw()[k], v.raw()[k], 0], [turn[0], turn[1], 0]);
            let product = i128::from(share) * i128::from(radius.raw());
            to_i64(round_shift_wide(product, 2 * Unit::FRACTION_BITS))
        };
        Vec3::from_raw([0, 1, 2].map(along))
    };
    Ok((0..sides).map(corner).collect())
}

/// Two directions that with the way make a right-handed frame; `None` for no way.
pub(in crate::geometry) fn across(way: [i64; 3]) -> Option<[UnitVec3; 2]> {
    let least = (0..3).min_by_key(|&k| way[k].unsigned_abs())?;
    let mut axis = [0; 3];
    axis[least] = 1;
    let u = UnitVec3::normalize_wide(cross(axis, way))?;
    let way = UnitVec3::normalize(Vec3::from_raw(way))?;
    let v = UnitVec3::normalize_wide(cross(way.raw(), u.raw()))?;
    Some([u, v])
}
