//! When a shape that moves first touches another.
//!
//! Conservative advancement (Mirtich, *Impulse-based Dynamic Simulation of Rigid Body Systems*,
//! 1996) for shapes that do not turn:
//!
//! ```text
//! time = 0
//! repeat
//!     the direction between their nearest points at this time gives two planes, between which
//!     there is nothing; they meet later: time = when they do; never: no touch
//! until the time is not later: they touch, as far as can be told
//! ```
//! The planes are exact for the direction as it was rounded, and so is the time at which they meet,
//! rounded down: whatever was rounded on the way, no touch is missed and none is told too late.

use alloc::vec::Vec;

use super::Shape;
use super::distance::{self, Core, Skin, View, along, grown, height};
use crate::geometry::{Aabb, HalfSpace, Segment};
use crate::math::wide::{round_shift_wide, to_i64};
use crate::math::{Real, Unit, UnitVec3, Vec3};

/// That a moving shape touches another.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Cast {
    /// They do not touch before, as a fraction of the way in 0..=1. By then they are so near that
    /// 2^-30 of the way, or a few units of the last place, more would do.
    pub time: Unit,
    /// Where, and in which direction; `None` if they overlap from the start.
    pub touch: Option<Touch>,
    /// Which part of A touches: the face of a mesh or height field, 0 of other shapes.
    pub part_a: u32,
    /// Which part of B.
    pub part_b: u32,
}

/// Where a moving shape touches another.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Touch {
    /// The point where they touch, metres, in the place where B is.
    pub position: Vec3,
    /// From what moves into what is touched, from A to B: where a surface is hit, its own normal is
    /// the opposite.
    pub normal: UnitVec3,
}

/// After so many planes a cast ends with the time it knows. It takes fewer than ten, but for what
/// slips past with nothing between.
const STEPS_MAX: u32 = 64;

/// A way along a surface is looked at in so many parts.
const PARTS_MAX: u32 = 64;

/// When A, moving by `motion` in metres without turning, first touches B, which rests; `None` if it
/// does not. O(n) for each of a few steps.
///
/// No touch is missed or told too late. What passes by at a few units of the last place, or at
/// 2^-30 of the way, may be taken for a touch. Times are told to 2^-30 of the way, and so is where
/// A is then: at the end of a way of 1,000 km it may be 1 mm short of the touch. Components of the
/// motion beyond 2^37 m, twice what a world reaches, are taken for that.
///
/// ```
/// use verlock::collision::cast;
/// use verlock::geometry::{Sphere, Triangle};
/// use verlock::{Vec3, math::Unit, real};
///
/// let ball = Sphere::new(Vec3::from_ints(0, 5, 0), real!("1"))?.into();
/// let floor = [Vec3::from_ints(-9, 0, -9), Vec3::from_ints(0, 0, 9), Vec3::from_ints(9, 0, -9)];
/// let floor = Triangle::new(floor)?.into();
/// let hit = cast(&ball, Vec3::from_ints(0, -8, 0), &floor).expect("a hit");
/// assert_eq!(hit.time.raw(), Unit::ONE.raw() / 2 - 1);
/// assert_eq!(hit.touch.map(|touch| touch.position), Some(Vec3::ZERO));
/// assert_eq!(cast(&ball, Vec3::from_ints(0, -3, 0), &floor), None);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[must_use]
pub fn cast(a: &Shape, motion: Vec3, b: &Shape) -> Option<Cast> {
    cast_until(a, motion, b, Unit::ONE)
}

/// As [`cast`], or `None` if not until then.
pub(super) fn cast_until(a: &Shape, motion: Vec3, b: &Shape, until: Unit) -> Option<Cast> {
    between(&a.view(), motion, &b.view(), until)
}

/// Where a segment, from its first end to its second, first touches a shape; `None` if it does not.
/// As [`cast`] of a point: the normal points on into the shape, so that the surface's own normal is
/// its opposite.
#[must_use]
pub fn cast_segment(segment: &Segment, shape: &Shape) -> Option<Cast> {
    cast_segment_until(segment, shape, Unit::ONE)
}

/// As [`cast_segment`], or `None` if not until then.
pub(super) fn cast_segment_until(segment: &Segment, shape: &Shape, until: Unit) -> Option<Cast> {
    let [from, to] = segment.ends();
    between(&View::Convex(Core::point(from)), to - from, &shape.view(), until)
}

fn between(a: &View, motion: Vec3, b: &View, until: Unit) -> Option<Cast> {
    const MOST: i64 = 1 << 61;
    let motion = Vec3::from_raw(motion.raw().map(|c| c.clamp(-MOST, MOST)));
    let found = match (a, b) {
        (View::Convex(a), View::Convex(b)) => of_convex(a, motion, b, until),
        (View::Convex(a), View::HalfSpace(b)) => onto_half_space(a, motion, b),
        (View::Convex(a), View::Skin(b)) => onto_skin(a, motion, *b, until),
        (View::HalfSpace(a), View::HalfSpace(b)) => of_half_spaces(a, motion, b),
        (View::Skin(a), View::HalfSpace(_) | View::Skin(_)) => {
            a.faces().into_iter().fold(None, |best, face| {
                let until = best.map_or(until, |best: Cast| best.time);
                let triangle = a.triangle(face).into();
                let next = match b {
                    View::Skin(b) => onto_skin(&triangle, motion, *b, until),
                    _ => between(&View::Convex(triangle), motion, b, until),
                };
                earlier(best, next.map(|next| Cast { part_a: face, ..next }))
            })
        }
        // As if the other moved towards it.
        (View::HalfSpace(_) | View::Skin(_), _) => {
            between(b, -motion, a, until).map(|cast| cast.turned(motion))
        }
    };
    found.filter(|cast| cast.time <= until)
}

/// The first of both; of two at a time one that overlaps from the start, then the one with lower
/// numbers.
fn earlier(best: Option<Cast>, next: Option<Cast>) -> Option<Cast> {
    let (Some(first), Some(second)) = (best, next) else { return best.or(next) };
    let rank = |cast: Cast| (cast.time, cast.touch.is_some(), cast.part_a, cast.part_b);
    if rank(second) < rank(first) { next } else { best }
}

/// Shapes are no farther apart than that along any axis when a cast ends that touches. It ends
/// early by what the rounded length of a normal makes of their extents, 2^-30 of less than 2^43
/// raw, by about 2^-30 of the way, and by a few units.
pub(super) fn early_max(motion: Vec3) -> Real {
    Real::from_raw((1 << 16) + (longest(motion) >> 28).cast_signed())
}

fn longest(motion: Vec3) -> u64 {
    motion.raw().map(i64::unsigned_abs).into_iter().max().unwrap_or(0)
}

/// As `of_convex`, with every face of a surface that rests: those near a part of the way after
/// those near the parts before, until one is touched.
///
/// A limit changes nothing that is found before it: it ends the search only where it is before a
/// part begins, and what is touched by then, if [early](early_max), is near the parts before.
fn onto_skin(a: &Core, motion: Vec3, b: Skin, until: Unit) -> Option<Cast> {
    let bounds = a.bounds();
    let longest = longest(motion);
    // Parts are about as long as the shape, or as a small part of the surface.
    let length = bounds.span().max(b.bounds().span() / u64::from(PARTS_MAX)).max(1);
    let parts = (longest / length).clamp(1, PARTS_MAX.into()) as u32; // at most PARTS_MAX
    // Rounded down, and the last one is the end.
    let time = |part: u32| {
        Unit::from_raw((i64::from(Unit::ONE.raw()) * i64::from(part) / i64::from(parts)) as i32)
    };
    let place = |time: Unit| {
        let way = part_of(motion, time);
        Aabb::new(bounds.min() + way, bounds.max() + way)
    };
    let early = early_max(motion);
    let mut faces = Vec::new();
    let mut best: Option<Cast> = None;
    for part in (0..parts).take_while(|&part| time(part) <= until) {
        let end = time(part + 1);
        let swept = place(time(part)).union(place(end));
        b.faces_near(&grown(&swept, early), &mut faces);
        for &face in &faces {
            let until = best.map_or(until, |best| best.time);
            let next = of_convex(a, motion, &b.triangle(face).into(), until);
            best = earlier(best, next.map(|next| Cast { part_b: face, ..next }));
        }
        if best.is_some_and(|best| best.time <= end) {
            break;
        }
    }
    best
}

/// As [`cast`], or `None` if not until then.
fn of_convex(a: &Core, motion: Vec3, b: &Core, until: Unit) -> Option<Cast> {
    if b.is_passed_by(a, motion) {
        return None;
    }
    let mut cast = Cast::OVERLAP;
    for _ in 0..STEPS_MAX {
        let now = cast.time;
        let place = part_of(motion, now);
        let apart = distance::of_convex(a, b, place).or_else(|| {
            // There is a gap, but the place was rounded into it: two units back it is not.
            let back = along(cast.touch?.normal, Real::from_raw(2));
            distance::of_convex(a, b, place - back)
        });
        let Some(apart) = apart else { break };
        let normal = apart.normal;
        let time = meeting(gap(a, b, normal), height(normal, motion), now)?;
        if time > until {
            return None;
        }
        cast = Cast::new(time, Touch { position: apart.on_b, normal });
        if time == now {
            break;
        }
    }
    Some(cast)
}

/// The gap between the planes across `normal` that touch both from within, in units of 2^-54.
fn gap(a: &Core, b: &Core, normal: UnitVec3) -> i128 {
    let from = a.points()[0];
    let high = a.points().iter().map(|&p| height(normal, p - from)).max().unwrap_or(0);
    let low = b.points().iter().map(|&p| height(normal, p - from)).min().unwrap_or(0);
    // Round shapes reach as far as the normal is long, which is less than 2^30 + 2.
    let radii = i128::from((a.radius + b.radius).raw()) * ((1 << 30) + 2);
    low - high - radii
}

/// When a gap is closed that shrinks by `rate` in all, rounded down; `None` if it is open at `now`
/// and until the end. Both are in units of 2^-54, below 2^95.
fn meeting(gap: i128, rate: i128, now: Unit) -> Option<Unit> {
    let one = i128::from(Unit::ONE.raw());
    if gap * one <= rate * i128::from(now.raw()) {
        return Some(now);
    }
    if rate <= 0 || gap > rate {
        return None;
    }
    // Above 0 and at most one.
    Some(Unit::from_raw((gap * one / rate) as i32))
}

/// When A touches a half-space that rests.
fn onto_half_space(a: &Core, motion: Vec3, b: &HalfSpace) -> Option<Cast> {
    let normal = b.normal();
    let heights = a.points().iter().map(|&point| (height(normal, point - b.point()), point));
    let (lowest, point) = heights.min_by_key(|&(height, _)| height)?;
    let gap = lowest - (i128::from(a.radius.raw()) << 30);
    if gap <= 0 {
        return Some(Cast::OVERLAP);
    }
    let time = meeting(gap, -height(normal, motion), Unit::ZERO)?;
    let at = point + part_of(motion, time);
    let above = round_shift_wide(height(normal, at - b.point()), 30);
    let position = at - along(normal, Real::from_raw(to_i64(above)));
    Some(Cast::new(time, Touch { position, normal: -normal }))
}

/// When half-spaces touch that face each other.
fn of_half_spaces(a: &HalfSpace, motion: Vec3, b: &HalfSpace) -> Option<Cast> {
    let Some(apart) = distance::of_half_spaces(a, b) else { return Some(Cast::OVERLAP) };
    let gap = height(apart.normal, b.point() - a.point());
    let time = meeting(gap, height(apart.normal, motion), Unit::ZERO)?;
    Some(Cast::new(time, Touch { position: b.point(), normal: apart.normal }))
}

/// How far the way is by then, rounded.
fn part_of(motion: Vec3, time: Unit) -> Vec3 {
    // At most 2^61 * 2^30.
    let part = |c: i64| to_i64(round_shift_wide(i128::from(c) * i128::from(time.raw()), 30));
    Vec3::from_raw(motion.raw().map(part))
}

impl Cast {
    /// Of what overlaps from the start.
    const OVERLAP: Self = Self { time: Unit::ZERO, touch: None, part_a: 0, part_b: 0 };

    /// The same where the other one moves, by `motion`.
    fn turned(self, motion: Vec3) -> Self {
        let turn = |Touch { position, normal }| Touch {
            position: position + part_of(motion, self.time),
            normal: -normal,
        };
        let Self { time, touch, part_a, part_b } = self;
        Self { time, touch: touch.map(turn), part_a: part_b, part_b: part_a }
    }

    const fn new(time: Unit, touch: Touch) -> Self {
        Self { time, touch: Some(touch), part_a: 0, part_b: 0 }
    }
}
