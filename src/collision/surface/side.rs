//! Inside or outside, told at the nearest point of a surface: exactly.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::feet::normal_of;
use super::near::{fold, tip};
use crate::collision::{FeatureId, FeatureKind};
use crate::geometry::{Surface, orient3d};
use crate::math::Vec3;
use crate::math::determinant::cross;
use crate::math::wide::sub;

/// Where a point is, seen from the part of the surface that is nearest to it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Side {
    /// In front of the surface, or on it.
    Outside,
    /// Behind it.
    Inside,
}

/// The side of a point to which this feature is nearest, of all that touch it at least.
///
/// At an open border it is outside too where the way to it leads away from the faces, though they
/// are seen from behind: what is beside a sheet is not in it. That is as exact as a unit vector.
pub(super) fn side<S: Surface>(surface: &S, point: Vec3, feature: FeatureId) -> Side {
    if surface.is_two_sided() {
        return Side::Outside;
    }
    match feature.kind() {
        FeatureKind::Face => of_sign(height(surface, feature.index(), point)),
        FeatureKind::Edge => at_edge(surface, point, feature.index()),
        FeatureKind::Vertex => at_vertex(surface, point, feature.index()),
    }
}

/// On which side of a face's plane a point is.
fn height<S: Surface>(surface: &S, face: u32, point: Vec3) -> Ordering {
    let [a, b, c] = *surface.triangle(face).corners();
    orient3d(a, b, c, point)
}

fn of_sign(height: Ordering) -> Side {
    if height == Ordering::Less { Side::Inside } else { Side::Outside }
}

/// At a ridge it is outside, in a valley inside: from elsewhere the edge is not nearest.
fn at_edge<S: Surface>(surface: &S, point: Vec3, edge: u32) -> Side {
    let mut faces = surface.faces_at_edge(edge);
    match [faces.next(), faces.next(), faces.next()] {
        [Some(face), None, _] => at_border(surface, point, [face], [edge]),
        [Some(face), Some(other), None] => match fold(surface, edge, [face, other]) {
            Ordering::Less => Side::Outside,
            Ordering::Greater => Side::Inside,
            // One of them may have no area, and thus no side.
            Ordering::Equal => {
                let heights = [face, other].map(|face| height(surface, face, point));
                if heights == [Ordering::Less, Ordering::Greater] {
                    return Side::Outside; // folded on itself
                }
                of_sign(heights[0].then(heights[1]))
            }
        },
        // Several sheets meet.
        _ => Side::Outside,
    }
}

/// At a border with these faces and edges: outside if some face is not seen from behind, or if the
/// way from some edge leads away from its face. Else it is right behind.
fn at_border<S: Surface>(
    surface: &S,
    point: Vec3,
    faces: impl IntoIterator<Item = u32>,
    edges: impl IntoIterator<Item = u32>,
) -> Side {
    let mut heights = faces.into_iter().map(|face| height(surface, face, point));
    if heights.any(|height| height != Ordering::Less)
        || edges.into_iter().any(|edge| is_beside(surface, point, edge))
    {
        return Side::Outside;
    }
    Side::Inside
}

/// Whether a point is beyond an edge that has one face: on the other side of it than the face.
///
/// Widths: sides and ways are below 2^42, a unit vector has 30 bits: products are below 2^117.
fn is_beside<S: Surface>(surface: &S, point: Vec3, edge: u32) -> bool {
    let mut faces = surface.faces_at_edge(edge);
    let (Some(face), None) = (faces.next(), faces.next()) else { return false };
    let Some(normal) = normal_of(surface, face) else { return true };
    let [from, to] = surface.ends(edge).map(|end| surface.position(end).raw());
    let across = cross(sub(to, from), normal.raw());
    let side = |to: Vec3| dot(across, sub(to.raw(), from)).signum();
    side(point) * side(tip(surface, edge, face)) < 0
}

/// The two sides of a face that leave a vertex, in the order of its corners, and their normal.
struct Wedge {
    sides: [[i64; 3]; 2],
    normal: [i128; 3],
}

/// By the parity of a cone: the way from the point to a face crosses other faces, and each crossing
/// changes the side.
///
/// Both are taken as directions from the vertex, whose faces reach to infinity then. No face lies
/// in the direction of the point, or it would be nearer.
///
/// Widths: the point is within [`REACH_MAX`](super::REACH_MAX) = 2^40 along each axis, sides are
/// below 2^41, and their sum below 2^42: determinants are below 6 * 2^(40 + 42 + 41).
fn at_vertex<S: Surface>(surface: &S, point: Vec3, vertex: u32) -> Side {
    let faces = || surface.faces_at_vertex(vertex);
    if !is_closed(surface, vertex) {
        let at_vertex = |edge: &u32| surface.ends(*edge).contains(&vertex);
        let edges = faces().flat_map(|face| surface.sides(face)).filter(at_vertex);
        return at_border(surface, point, faces(), edges);
    }
    let origin = surface.position(vertex).raw();
    let to_point = sub(point.raw(), origin);
    let wedges: Vec<_> = faces().filter_map(|face| Wedge::new(surface, face, vertex)).collect();
    for (first, own) in wedges.iter().enumerate() {
        let height = dot(own.normal, to_point);
        if height == 0 {
            continue;
        }
        let [u, v] = own.sides;
        let to_face = [u[0] + v[0], u[1] + v[1], u[2] + v[2]];
        let others = wedges.iter().enumerate().filter(|(other, _)| *other != first);
        let crossings = others.map(|(_, wedge)| wedge.crossing(to_point, to_face));
        let crossings = crossings.sum::<Option<i32>>();
        if let Some(crossings) = crossings {
            let is_inside = (height < 0) != (crossings % 2 == 1);
            return if is_inside { Side::Inside } else { Side::Outside };
        }
    }
    // The point is in the plane of every face: take the side of all together.
    let sum = wedges.iter().map(|wedge| dot(wedge.normal, to_point).signum()).sum::<i128>();
    of_sign(sum.cmp(&0))
}

/// Whether every edge at a vertex has two faces. A side from a corner to itself is no edge.
fn is_closed<S: Surface>(surface: &S, vertex: u32) -> bool {
    surface.faces_at_vertex(vertex).all(|face| {
        let (corners, sides) = (surface.corners(face), surface.sides(face));
        let ends = [0, 1, 2].map(|k| [corners[k], corners[(k + 1) % 3]]);
        let is_edge = |[from, to]: [u32; 2]| from != to && [from, to].contains(&vertex);
        let mut edges = ends.into_iter().zip(sides).filter(|&(ends, _)| is_edge(ends));
        edges.all(|(_, edge)| surface.faces_at_edge(edge).count() == 2)
    })
}

impl Wedge {
    /// `None` for a face without an area.
    fn new<S: Surface>(surface: &S, face: u32, vertex: u32) -> Option<Self> {
        let corners = surface.corners(face);
        let own = corners.iter().position(|&corner| corner == vertex)?;
        let side = |k: usize| {
            let end = surface.position(corners[(own + k) % 3]);
            sub(end.raw(), surface.position(vertex).raw())
        };
        let sides = [side(1), side(2)];
        let normal = cross(sides[0], sides[1]);
        (normal != [0; 3]).then_some(Self { sides, normal })
    }

    /// How often the segment between two directions crosses the wedge: 0 or 1, `None` if it only
    /// touches the wedge's sides. The first direction is not in the wedge.
    ///
    /// A point `a w1 + b w2` of the segment from r to g has `a N.(g - r) = -det(r, g, w2)` and
    /// `b N.(g - r) = det(r, g, w1)`: it is in the wedge if neither is negative.
    fn crossing(&self, from: [i64; 3], to: [i64; 3]) -> Option<i32> {
        let heights = [dot(self.normal, from), dot(self.normal, to)];
        // In the plane of the wedge but not in the wedge: no crossing there.
        match heights.map(i128::signum) {
            [0, 0] => return None,
            [0, _] | [_, 0] | [1, 1] | [-1, -1] => return Some(0),
            _ => {}
        }
        let across = cross(from, to);
        let ends = self.sides.map(|side| dot(across, side));
        let up = (heights[1] - heights[0]).signum();
        match [ends[0].signum() * up, -ends[1].signum() * up] {
            [-1, _] | [_, -1] => Some(0),
            [1, 1] => Some(1),
            _ => None,
        }
    }
}

fn dot(a: [i128; 3], b: [i64; 3]) -> i128 {
    crate::math::determinant::dot(&a, b)
}
