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
    let edges = [0, 1, 2].map(|i| W::difference(corners[(i + 1) % 3], corners[i]));
    // How far along each edge the point is, of how much: both times the length of the edge.
    let reach = [0, 1, 2].map(|i| W::dot(edges[i], W::difference(point, corners[i])));
    let whole = edges.map(|edge| W::dot(edge, edge));
    let zero = W::Dot::default();
    for (corner, before) in [(0, 2), (1, 0), (2, 1_usize)] {
        if reach[usize::from(corner)] <= zero && reach[before] >= whole[before] {
            return ClosestPoint::at_corner(corners, corner);
        }
    }
    let opposite = shares::<W>(edges, reach, whole);
    for (edge, feature) in (0..3).zip([0, 1, 2].map(Feature::Edge)) {
        let between = zero <= reach[edge] && reach[edge] <= whole[edge] && zero < whole[edge];
        if between && opposite[edge] <= W::Area::default() {
            let ends = [edge, (edge + 1) % 3];
            let [n, d] = [reach[edge], whole[edge]].map(W::widen);
            let (position, shares) = blend(ends.map(|end| corners[end]), [d.minus(n), n]);
            let mut weights = [Unit::ZERO; 3];
            (weights[ends[0]], weights[ends[1]]) = (shares[0], shares[1]);
            return ClosestPoint { position, feature, weights };
        }
    }
    let [c, a, b] = opposite;
    let (position, weights) = blend(*corners, [a, b, c]);
    ClosestPoint { position, feature: Feature::Face, weights }
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
    [0, 1, 2].map(|i| {
        let next = (i + 1) % 3;
        let turn = W::dot(edges[next], edges[i]);
        // q is e and then the way from the start of f.
        W::minor(whole[i], reach[next] + turn, reach[i], turn)
    })
}
