//! Convex pieces of faces.

use alloc::vec::Vec;
use core::cmp::Ordering;

use crate::geometry::{Aabb, Feature, Triangle, closest_point_triangle};
use crate::math::determinant::cross;
use crate::math::root::{isqrt_wide, isqrt_wide_up};
use crate::math::wide::{add, round_div_wide, round_shift_wide, sub, to_i64};
use crate::math::{UnitVec3, Vec3};
use crate::partition::bvh::Bvh;
use crate::partition::bvh::nearest::Nearest;
use crate::partition::bvh::volume::Volume;

/// A corner of a piece, and how far from the other surface it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    position: Vec3,
    /// Raw, rounded down: what of the surface it stands for is no nearer.
    pub(super) at_least: u64,
    /// Raw, rounded up.
    at_most: u64,
    /// The place of the face that is nearest.
    pub(super) place: u32,
    /// How often it was rounded, and what it lies between: each time by less than a raw unit.
    roundings: u64,
}

/// A convex polygon, part of a face, with what bounds its distance from the other surface.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    corners: Vec<Corner>,
    /// No point of it is farther away, raw.
    pub(super) at_most: u64,
    /// The place of the face that says so, and the corner that is farthest from it.
    pub(super) face: u32,
    worst: usize,
}

/// Where a polygon is cut: between two of its edges, or corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    pub(super) ends: [End; 2],
}

/// A point of the edge that begins at a corner, `share` of 2^30 along.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    corner: usize,
    share: i64,
}

const SHARE_BITS: u32 = 30;

/// Pieces of so many corners are cut across, after which they have fewer: what is done to a piece
/// costs as much as the square of that.
const CORNERS_MAX: usize = 16;

impl Corner {
    pub(super) fn new(position: Vec3, nearest: &Nearest, roundings: u64) -> Self {
        let [at_least, at_most] = distance(nearest.distance_sq, nearest.point.feature);
        let at_least = at_least.saturating_sub(roundings);
        Self { position, at_least, at_most, place: nearest.place, roundings }
    }
}

impl Piece {
    /// The triangle of three corners; nothing is known of it.
    pub(super) fn new(corners: Vec<Corner>) -> Self {
        Self { corners, at_most: u64::MAX, face: 0, worst: 0 }
    }

    /// Finds a bound; a small one need not be the best. Whether cutting can lower it.
    pub(super) fn bound<V: Volume>(&mut self, to: &Bvh<V>, limit: u64) -> bool {
        // From a corner, no point is farther away than another corner.
        let nearest = self.corners.iter().map(|corner| corner.at_most).min().unwrap_or(0);
        let roundings = self.corners.iter().map(|corner| corner.roundings).max().unwrap_or(0);
        let diameter = self.diameter();
        self.at_most = nearest + diameter + roundings;
        if self.at_most <= limit || diameter <= roundings {
            return false;
        }
        // Corners are often as near to several faces, of which few are near to the rest.
        let mut places: Vec<u32> = self.corners.iter().map(|corner| corner.place).collect();
        let middle = self.middle();
        places.push(to.nearest_or(to.nearest_on(places[0], middle), middle).place);
        places.sort_unstable();
        places.dedup();
        let mut least = u64::MAX;
        for place in places {
            let triangle = &to.triangles[place as usize];
            let distances = self.corners.iter().map(|corner| {
                let nearest = closest_point_triangle(corner.position, triangle);
                let distance_sq = (corner.position - nearest.position).length_sq_wide();
                distance(distance_sq, nearest.feature)[1]
            });
            if let Some((at_most, worst)) = distances.zip(0..).max()
                && at_most < least
            {
                (least, self.face, self.worst) = (at_most, place, worst);
            }
        }
        // At most 2^62, like all distances.
        self.at_most = self.at_most.min(least + roundings);
        self.at_most > limit
    }

    /// Where to cut: along an edge of the face that bounds it, so that on one side the bound is the
    /// distance from its plane; or across, if it is much larger than the face, or nothing is
    /// gained.
    pub(super) fn cut<V: Volume>(&self, to: &Bvh<V>) -> Cut {
        let triangle = &to.triangles[self.face as usize];
        if self.corners.len() < CORNERS_MAX && self.span() >> 1 <= triangle.bounds().span() {
            let nearest = closest_point_triangle(self.corners[self.worst].position, triangle);
            let edges = match nearest.feature {
                Feature::Vertex(corner) => [(corner + 2) % 3, corner],
                Feature::Edge(edge) => [edge; 2],
                Feature::Face => return self.across(),
            };
            let cuts = edges.map(|edge| self.along(triangle, edge.into()));
            if let Some(cut) = cuts[0].or(cuts[1]) {
                return cut;
            }
        }
        self.across()
    }

    /// The cut by the plane that stands upright on an edge of a face, if there is enough of the
    /// piece on either side of it: more than what the plane and the place of a cut are wrong by, so
    /// that no cut is repeated.
    fn along(&self, triangle: &Triangle, edge: usize) -> Option<Cut> {
        let corners = triangle.corners().map(Vec3::raw);
        let start = corners[edge];
        let (side, other) =
            (sub(corners[(edge + 1) % 3], start), sub(corners[(edge + 2) % 3], start));
        // Sides are below 2^41, and the normal below 2^83.
        let upright = cross(side, other);
        let minor = |j: usize, k: usize| {
            i128::from(side[j]) * upright[k] - i128::from(side[k]) * upright[j]
        };
        let outward = UnitVec3::normalize_wide([minor(1, 2), minor(2, 0), minor(0, 1)])?.raw();
        let beyond = |corner: &Corner| -> i128 {
            // Below 2^30 * 2^62 * 3.
            let way = sub(corner.position.raw(), start).into_iter().zip(outward);
            way.map(|(d, n)| i128::from(d) * i128::from(n)).sum()
        };
        let beyond: Vec<i128> = self.corners.iter().map(beyond).collect();
        // Ends of cuts are rounded, by less than 2 raw units. Components of the normal, and shares,
        // are wrong by the 2^-30th part at most: along three axes, 2^-28 of the longest way.
        let ways = self.corners.iter().flat_map(|c| sub(c.position.raw(), start));
        let longest = ways.map(|c| i128::from(c.unsigned_abs())).max().unwrap_or(0);
        let enough = (2 << 30) + 4 * longest;
        if !(beyond.iter().any(|&s| s > enough) && beyond.iter().any(|&s| s < -enough)) {
            return None;
        }
        let crosses = |k: &usize| (beyond[*k] > 0) != (beyond[(*k + 1) % beyond.len()] > 0);
        let mut ends = (0..beyond.len()).filter(crosses).map(|corner| {
            let (from, to) = (beyond[corner].abs(), beyond[(corner + 1) % beyond.len()].abs());
            // Below 2^94 * 2^30.
            let share = round_div_wide(from << SHARE_BITS, (from + to).max(1));
            End { corner, share: to_i64(share) }
        });
        // A convex polygon is left once for every time it is entered.
        Some(Cut { ends: [ends.next()?, ends.next()?] })
    }

    /// The cut from the middle of the longest edge to the corner or edge opposite.
    fn across(&self) -> Cut {
        let len = self.corners.len();
        let length = |k: usize| {
            let (a, b) = (self.corners[k].position, self.corners[(k + 1) % len].position);
            (b - a).length_sq_wide()
        };
        let longest = (0..len).rev().max_by_key(|&k| length(k)).unwrap_or(0);
        let opposite = End { corner: (longest + len.div_ceil(2)) % len, share: 0 };
        let middle = End { corner: longest, share: 1 << (SHARE_BITS - 1) };
        let mut ends = [middle, opposite];
        ends.sort_unstable_by_key(|end| end.corner);
        Cut { ends }
    }

    /// The corner at which a cut ends, if there is one; else where it is to be, how often it is
    /// rounded then, and which faces are near.
    pub(super) fn end(&self, end: End) -> Result<Corner, (Vec3, u64, [u32; 2])> {
        let [from, to] = [end.corner, (end.corner + 1) % self.corners.len()];
        let [from, to] = [self.corners[from], self.corners[to]];
        if end.share == 0 {
            return Ok(from);
        }
        let (start, way) = (from.position.raw(), sub(to.position.raw(), from.position.raw()));
        // Below 2^41 * 2^30.
        let part = way
            .map(|c| to_i64(round_shift_wide(i128::from(c) * i128::from(end.share), SHARE_BITS)));
        Err((
            Vec3::from_raw(add(start, part)),
            from.roundings.max(to.roundings) + 1,
            [from.place, to.place],
        ))
    }

    /// Both parts, given the corners at the ends of the cut.
    pub(super) fn halves(&self, cut: &Cut, corners: [Corner; 2]) -> [Self; 2] {
        let len = self.corners.len();
        [0, 1].map(|half| {
            let (from, to) = (cut.ends[half], cut.ends[1 - half]);
            let mut part = alloc::vec![corners[half]];
            // The corners behind one end, up to the other one.
            let count = (to.corner + len - from.corner - 1) % len + 1;
            part.extend((1..=count).map(|k| self.corners[(from.corner + k) % len]));
            if to.share == 0 {
                part.pop();
            }
            part.push(corners[1 - half]);
            Self::new(part)
        })
    }

    /// The mean of the corners, rounded down.
    fn middle(&self) -> Vec3 {
        let start = self.corners[0].position.raw();
        let (mut sum, mut count) = ([0; 3], 0);
        for corner in &self.corners {
            // Differences are below 2^42.
            sum = add(sum, sub(corner.position.raw(), start));
            count += 1;
        }
        Vec3::from_raw(add(start, sum.map(|c| c.div_euclid(count))))
    }

    /// No two corners are farther apart.
    fn diameter(&self) -> u64 {
        let corners = self.corners.iter().map(|corner| corner.position);
        let pairs = corners.clone().flat_map(|a| corners.clone().map(move |b| b - a));
        roots(pairs.map(Vec3::length_sq_wide).max().unwrap_or(0))[1]
    }

    fn span(&self) -> u64 {
        let bounds = Aabb::around(self.corners.iter().map(|corner| corner.position));
        bounds.map_or(0, |bounds| bounds.span())
    }
}

/// The distance from a place that was rounded, from below and above: it is off by 0.87 raw units at
/// most, and not at all at a corner.
fn distance(square: u128, feature: Feature) -> [u64; 2] {
    let slack = u64::from(!matches!(feature, Feature::Vertex(_)));
    let [floor, ceiling] = roots(square);
    [floor.saturating_sub(slack), ceiling + slack]
}

/// The square root of the square of a distance, rounded down and up.
fn roots(square: u128) -> [u64; 2] {
    // Squares are below 3 * 2^124: roots fit.
    [isqrt_wide(square), isqrt_wide_up(square)]
        .map(|root| to_i64(root.cast_signed()).unsigned_abs())
}

/// The one with the greatest bound is greatest; how they are ordered else decides nothing but which
/// is cut first.
impl Ord for Piece {
    fn cmp(&self, other: &Self) -> Ordering {
        let key = |piece: &Self| (piece.at_most, piece.corners[0].position);
        key(self).cmp(&key(other))
    }
}

impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Piece {}
