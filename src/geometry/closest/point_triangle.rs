//! From a point to a triangle.

use super::ClosestPoint;
use super::blend::blend;
use super::width::{Area, Narrow, Wide, Width, is_narrow};
use crate::geometry::{Feature, Triangle};
use crate::math::{Unit, Vec3};

/// The point of a triangle that is nearest to `point`, which may be any. O(1).
///
/// ```
/// use verlock::geometry::{Feature, Triangle, closest_point_triangle};
/// use verlock::{Vec3, real};
///
/// let triangle = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::Y])?;
/// let quarter = real!("0.25");
/// let above = Vec3::new(quarter, quarter, real!("9"));
/// let foot = closest_point_triangle(above, &triangle);
/// assert_eq!(foot.position, Vec3::new(quarter, quarter, real!("0")));
/// assert_eq!(foot.feature, Feature::Face);
/// assert_eq!(closest_point_triangle(Vec3::ONE, &triangle).feature, Feature::Edge(1));
/// # Ok::<(), verlock::geometry::TriangleError>(())
/// ```
#[inline]
#[must_use]
pub fn closest_point_triangle(point: Vec3, triangle: &Triangle) -> ClosestPoint<3> {
    let corners = triangle.corners();
    let [a, b, c] = *corners;
    if is_narrow([point, a, b, c]) {
        closest::<Narrow>(point, corners)
    } else {
        closest::<Wide>(point, corners)
    }
}

fn closest<W: Width>(point: Vec3, corners: &[Vec3; 3]) -> ClosestPoint<3> {
    let part = Part::nearest::<W>(point, corners);
    let feature = part.feature();
    match part {
        Part::Corner(corner) => ClosestPoint::at_corner(corners, corner),
        Part::Edge(edge, on_edge) => {
            let ends = ends_of(edge);
            let (position, on_edge) = blend([corners[ends[0]], corners[ends[1]]], on_edge);
            let mut weights = [Unit::ZERO; 3];
            (weights[ends[0]], weights[ends[1]]) = (on_edge[0], on_edge[1]);
            ClosestPoint { position, feature, weights }
        }
        Part::Face(shares) => {
            let (position, weights) = blend(*corners, shares);
            ClosestPoint { position, feature, weights }
        }
    }
}

/// The part of a triangle that is nearest to a point, and in what shares its corners make up the
/// foot.
pub(super) enum Part<A> {
    Corner(u8),
    Edge(u8, [A; 2]),
    Face([A; 3]),
}

/// The corners at the ends of an edge.
#[inline]
pub(super) fn ends_of(edge: u8) -> [usize; 2] {
    let from = usize::from(edge);
    [from, (from + 1) % 3]
}

impl<A: Area> Part<A> {
    fn feature(&self) -> Feature {
        match *self {
            Self::Corner(corner) => Feature::Vertex(corner),
            Self::Edge(edge, _) => Feature::Edge(edge),
            Self::Face(_) => Feature::Face,
        }
    }

    pub(super) fn nearest<W: Width<Area = A>>(point: Vec3, corners: &[Vec3; 3]) -> Self {
        let edge = |i: usize| W::difference(corners[(i + 1) % 3], corners[i]);
        let edges = [edge(0), edge(1), edge(2)];
        // How far along each edge the point is, of how much: both times the length of the edge.
        let reach = |i: usize| W::dot(edges[i], W::difference(point, corners[i]));
        let reach = [reach(0), reach(1), reach(2)];
        let whole = |i: usize| W::dot(edges[i], edges[i]);
        let whole = [whole(0), whole(1), whole(2)];
        let zero = W::Dot::default();
        for (corner, before) in [(0, 2), (1, 0), (2, 1_usize)] {
            if reach[usize::from(corner)] <= zero && reach[before] >= whole[before] {
                return Self::Corner(corner);
            }
        }
        let opposite = shares::<W>(edges, reach, whole);
        for edge in [0, 1, 2_u8] {
            let i = usize::from(edge);
            let between = zero <= reach[i] && reach[i] <= whole[i] && zero < whole[i];
            if between && opposite[i] <= A::default() {
                let (n, d) = (W::widen(reach[i]), W::widen(whole[i]));
                return Self::Edge(edge, [d.minus(n), n]);
            }
        }
        let [c, a, b] = opposite;
        Self::Face([a, b, c])
    }
}

/// The barycentric coordinates of a point's shadow on the plane, by the edge that is opposite to
/// the corner: positive where the shadow is on the inner side of the edge. Their sum is the square
/// of the normal.
///
/// With edges e and f, one after the other, and q from the start of e to the point, that is
/// `(e x f) . (e x q) = (e . e) (f . q) - (e . q) (f . e)`.
#[inline]
fn shares<W: Width>(
    edges: [[W::Side; 3]; 3],
    reach: [W::Dot; 3],
    whole: [W::Dot; 3],
) -> [W::Area; 3] {
    let share = |i: usize| {
        let next = (i + 1) % 3;
        let turn = W::dot(edges[next], edges[i]);
        // q is e and then the way from the start of f.
        W::minor(whole[i], reach[next] + turn, reach[i], turn)
    };
    [share(0), share(1), share(2)]
}
