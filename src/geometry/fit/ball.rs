//! The smallest ball around points.

use super::frame::{FINE_BITS, meet};
use crate::math::determinant::{Middle, Width};
use crate::math::root::isqrt_wide;
use crate::math::wide::to_i64;

/// A ball, in fine units.
#[derive(Clone, Copy)]
pub(super) struct Ball {
    pub(super) center: [i64; 3],
    pub(super) radius: i64,
}

/// A point that is outside by no more, in fine units, counts as inside: a center is rounded by up
/// to 0.87 of one, and so is the distance of a point on the surface.
const SLACK: i64 = 2;

/// More rounds are not needed: each replaces the ball by a larger one.
const ROUNDS_MAX: usize = 100;

/// The smallest ball around at least one point, but for rounding; lengths are below 2^22.
///
/// The ball of a few points grows until no point is outside: the farthest one joins, and those stay
/// that the smallest ball around all of them goes through (Gärtner, *Fast and Robust Smallest
/// Enclosing Balls*, 1999). O(n) a round, of which there are few.
pub(super) fn smallest_ball(points: &[[i64; 3]]) -> Ball {
    let mut support = Support::new(points[0]);
    let mut ball = Ball { center: points[0].map(|c| c << FINE_BITS), radius: 0 };
    for _ in 0..ROUNDS_MAX {
        let farthest = points.iter().copied().rev().max_by_key(|&p| ball.distance_sq(p));
        let Some(outside) = farthest.filter(|&p| !ball.contains(p)) else { break };
        match support.joined_by(outside) {
            Some((larger, through)) if larger.radius > ball.radius => {
                (ball, support) = (larger, through);
            }
            _ => break, // nothing but rounding is left
        }
    }
    ball
}

impl Ball {
    /// The smallest ball with two to four points on its surface; `None` if there is none, or it is
    /// far larger than what the points come from.
    fn through(points: &[[i64; 3]]) -> Option<Self> {
        let (&origin, others) = points.split_first()?;
        let way = |p: &[i64; 3]| [0, 1, 2].map(|k| p[k] - origin[k]);
        // Ways are below 2^23 and their squares below 2^46. With x the center from the origin,
        // way . x = way^2 / 2. In a plane, x is in it.
        let value = |way: [i64; 3]| i128::from(square(way)) << (FINE_BITS - 1);
        let x = match others {
            [b] => way(b).map(|c| i128::from(c) << (FINE_BITS - 1)),
            [b, c] => {
                let (b, c) = (way(b), way(c));
                meet([b, c, Middle::cross(b, c)], [value(b), value(c), 0])?
            }
            [b, c, d] => {
                let ways = [b, c, d].map(way);
                meet(ways, ways.map(value))?
            }
            _ => return None,
        };
        if x.iter().any(|c| c.abs() >= 1 << 31) {
            return None;
        }
        // Below 2^31.
        let center = [0, 1, 2].map(|k| (origin[k] << FINE_BITS) + to_i64(x[k]));
        let mut ball = Self { center, radius: 0 };
        let farthest_sq = points.iter().map(|&p| ball.distance_sq(p)).max()?;
        ball.radius = to_i64(isqrt_wide(farthest_sq).cast_signed()) + 1;
        Some(ball)
    }

    /// The square of the distance of a point from the center: below 3 * 2^66.
    fn distance_sq(&self, p: [i64; 3]) -> u128 {
        let along = |k: usize| u128::from((p[k] << FINE_BITS).abs_diff(self.center[k]));
        (0..3).map(|k| along(k).pow(2)).sum()
    }

    fn contains(&self, p: [i64; 3]) -> bool {
        self.distance_sq(p) <= u128::from((self.radius + SLACK).unsigned_abs()).pow(2)
    }
}

/// One to four points that a ball goes through.
#[derive(Clone, Copy)]
struct Support {
    points: [[i64; 3]; 4],
    len: usize,
}

impl Support {
    fn new(point: [i64; 3]) -> Self {
        Self { points: [point; 4], len: 1 }
    }

    /// The smallest ball around these points and one that is outside of theirs, which it therefore
    /// goes through; and what it goes through.
    fn joined_by(&self, point: [i64; 3]) -> Option<(Ball, Self)> {
        let own = &self.points[..self.len];
        let parts = (1_u32..1 << self.len).filter(|part| part.count_ones() <= 3);
        let balls = parts.filter_map(|part| {
            let mut through = Self::new(point);
            for (k, &p) in own.iter().enumerate().filter(|(k, _)| part >> k & 1 == 1) {
                debug_assert!(k < 4, "Support: more than four points");
                through.points[through.len] = p;
                through.len += 1;
            }
            let ball = Ball::through(&through.points[..through.len])?;
            own.iter().all(|&p| ball.contains(p)).then_some((ball, through))
        });
        balls.min_by_key(|(ball, _)| ball.radius)
    }
}

/// Below 2^46 for vectors below 2^23.
fn square(v: [i64; 3]) -> i64 {
    v.iter().map(|c| c * c).sum()
}
