//! From one convex hull to another.
//!
//! Gilbert, Johnson and Keerthi, *A Fast Procedure for Computing the Distance Between Complex
//! Objects in Three-Dimensional Space*, 1988, in exact integers:
//!
//! ```text
//! D = { b - a : a in A, b in B }      the point of D that is nearest to 0 is the way from A to B
//! simplex = { any corner of D }
//! repeat
//!     keep of the simplex the corners of the part that is nearest to 0; it is 0: they meet
//!     take the corner of D that is farthest from that part, back towards 0
//!     no farther than the part itself: done; else add it to the simplex
//! ```
//! Every corner taken is strictly nearer, along the exact direction to the part, than the part is,
//! so that the distance falls strictly and the end is reached; no tolerance stops it before. For
//! the same reason no simplex is ever flat.

use super::blend::blend;
use super::normal::{to_line, to_plane, to_point};
use super::point_segment::Place;
use super::point_triangle::{Part, ends_of};
use super::width::{Area, Narrow, Wide, Width, is_narrow_by_half};
use crate::math::int256::Int256;
use crate::math::{Real, UnitVec3, Vec3};

/// The nearest points of two hulls that are apart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct ClosestConvex {
    /// The point of A: of several one of them.
    pub(crate) on_a: Vec3,
    /// The point of B that is nearest to it.
    pub(crate) on_b: Vec3,
    /// From A to B.
    pub(crate) normal: UnitVec3,
}

/// The nearest points of the convex hulls of `a`, moved by `offset`, and `b`; `None` if they are
/// not farther from each other than `radius`, which is exact. O(n) for each of a few steps.
///
/// Each has at least one point, and spans no more than a triangle; coordinates are those of a
/// world, moved or not. The radius is at most 2^40 raw.
pub(crate) fn closest_convex(
    a: &[Vec3],
    b: &[Vec3],
    offset: Vec3,
    radius: Real,
) -> Option<ClosestConvex> {
    let moved = a.iter().map(|&p| p + offset);
    if is_narrow_by_half(moved.chain(b.iter().copied())) {
        closest::<Narrow>(a, b, offset, radius)
    } else {
        closest::<Wide>(a, b, offset, radius)
    }
}

/// A corner of the difference, or a point within it.
#[derive(Clone, Copy)]
struct Corner {
    a: Vec3,
    b: Vec3,
    /// From A, where it has been moved to, to B.
    way: Vec3,
}

/// The part of a simplex that is nearest to 0.
struct Nearest<A> {
    /// Its corners, the last one repeated.
    corners: [Corner; 3],
    /// In what shares they make up the nearest point: 0 for what is repeated.
    shares: [A; 3],
    /// How many corners it has.
    len: usize,
    /// From 0 to it, at right angles to it, times something.
    direction: [A; 3],
}

fn closest<W: Width>(a: &[Vec3], b: &[Vec3], offset: Vec3, radius: Real) -> Option<ClosestConvex> {
    let corner = |a: Vec3, b: Vec3| Corner { a, b, way: b - a - offset };
    let mut nearest = Nearest::of_corner::<W>(corner(*a.first()?, *b.first()?));
    loop {
        let direction = &nearest.direction;
        if direction.iter().all(|c| *c == W::Area::default()) {
            return None;
        }
        let next = corner(farthest(a, direction, true), farthest(b, direction, false));
        let gain = height(next.way - nearest.corners[0].way, direction);
        if gain >= W::Area::default() {
            break;
        }
        nearest = nearest.with::<W>(next)?;
    }
    if radius > Real::ZERO && nearest.is_within(radius) {
        return None;
    }
    let on = |point: fn(&Corner) -> Vec3| {
        let corners = nearest.corners.each_ref().map(point);
        blend(corners, nearest.shares).0
    };
    let normal = W::Area::direction(nearest.direction)?;
    Some(ClosestConvex {
        on_a: on(|corner| corner.a) + offset,
        on_b: on(|corner| corner.b),
        normal,
    })
}

/// How far along a direction.
#[inline]
fn height<A: Area>(way: Vec3, direction: &[A; 3]) -> A {
    let [x, y, z] = way.raw();
    direction[0].times(x).plus(direction[1].times(y)).plus(direction[2].times(z))
}

/// The point that is farthest along a direction, or back; the first of several.
fn farthest<A: Area>(points: &[Vec3], direction: &[A; 3], ahead: bool) -> Vec3 {
    let mut best = (A::default(), points[0]);
    for &point in &points[1..] {
        let way = if ahead { point - points[0] } else { points[0] - point };
        let height = height(way, direction);
        if height > best.0 {
            best = (height, point);
        }
    }
    best.1
}

impl<A: Area> Nearest<A> {
    fn of_corner<W: Width<Area = A>>(corner: Corner) -> Self {
        let direction = to_point::<W>(Vec3::ZERO, corner.way);
        let one = A::default().successor();
        Self { corners: [corner; 3], shares: [one, A::default(), A::default()], len: 1, direction }
    }

    fn of_edge<W: Width<Area = A>>(ends: [Corner; 2]) -> Self {
        let ways = ends.map(|end| end.way);
        match Place::nearest::<W>(Vec3::ZERO, ways) {
            Place::Start => Self::of_corner::<W>(ends[0]),
            Place::End => Self::of_corner::<W>(ends[1]),
            Place::Between(n, d) => Self::on_edge::<W>(ends, [d.minus(n), n]),
        }
    }

    fn on_edge<W: Width<Area = A>>([from, to]: [Corner; 2], shares: [A; 2]) -> Self {
        let direction = to_line::<W>(Vec3::ZERO, [from.way, to.way]);
        let shares = [shares[0], shares[1], A::default()];
        Self { corners: [from, to, to], shares, len: 2, direction }
    }

    fn of_face<W: Width<Area = A>>(corners: [Corner; 3]) -> Self {
        let ways = corners.map(|corner| corner.way);
        match Part::nearest::<W>(Vec3::ZERO, &ways) {
            Part::Corner(corner) => Self::of_corner::<W>(corners[usize::from(corner)]),
            Part::Edge(edge, shares) => {
                Self::on_edge::<W>(ends_of(edge).map(|end| corners[end]), shares)
            }
            Part::Face(shares) => {
                Self { corners, shares, len: 3, direction: to_plane::<W>(Vec3::ZERO, &ways) }
            }
        }
    }

    /// The nearest part of the simplex that this part and another corner make; `None` if 0 is in
    /// it.
    fn with<W: Width<Area = A>>(&self, next: Corner) -> Option<Self> {
        let [p, q, r] = self.corners;
        match self.len {
            1 => Some(Self::of_edge::<W>([p, next])),
            2 => Some(Self::of_face::<W>([p, q, next])),
            _ => [[p, q, r], [q, r, p], [r, p, q]].into_iter().find_map(|[from, to, other]| {
                // It is nearest of all where nothing lies between its plane and 0; no plane of the
                // other corners does, since this one is nearer.
                let face = Self::of_face::<W>([from, to, next]);
                let beyond = height(other.way - face.corners[0].way, &face.direction);
                (beyond >= A::default()).then_some(face)
            }),
        }
    }

    /// Whether 0 is within `radius`, at most 2^40. Exact.
    ///
    /// Corners are less than 2^42 apart along each axis: if one is 2^43 away, all are beyond 2^42.
    /// Products of two are below 2^87 otherwise, and a normal below 2^85.
    fn is_within(&self, radius: Real) -> bool {
        let [p, q, r] = self.corners.map(|corner| corner.way);
        if p.raw().into_iter().any(|c| c.unsigned_abs() >= 1 << 43) {
            return false;
        }
        let wide = |v: Vec3| v.raw().map(i128::from);
        let cross = |a: [i128; 3], b: [i128; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let dot = |a: [i128; 3], b: [i128; 3]| {
            [0, 1, 2]
                .into_iter()
                .fold(Int256::default(), |sum, k| sum + Int256::product(a[k], b[k]))
        };
        let (way, edge) = (wide(p), wide(q - p));
        // The square of the distance is the first over the second.
        let [square, whole] = match self.len {
            1 => [dot(way, way), Int256::from(1)],
            2 => {
                let turn = cross(way, edge);
                [dot(turn, turn), dot(edge, edge)]
            }
            _ => {
                let normal = cross(edge, wide(r - p));
                let height = dot(normal, way);
                // A normal is at most 2^86 long: this is farther than 2^40.
                if height.bits() > 126 {
                    return false;
                }
                let height = height.shifted(0);
                [Int256::product(height, height), dot(normal, normal)]
            }
        };
        // Below 2^176 * 2^80.
        square <= whole.times(radius.raw()).times(radius.raw())
    }
}
