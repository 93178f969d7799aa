//! Convex shapes as what they are made of.

use crate::collision::few::Few;
use crate::collision::patch::{Corner, Outline};
use crate::collision::width::Width;
use crate::collision::{FeatureId, Shape};
use crate::geometry::{Capsule, ConvexHull, Cuboid, Sphere, Triangle};
use crate::math::determinant::cross;
use crate::math::wide::{dot_wide, sub};
use crate::math::{UnitVec3, Vec3};

/// The core of a convex shape, from the origin of a pair: the shape is all that is within `radius`
/// of it.
pub(super) struct Solid<'a> {
    kind: Kind<'a>,
    pub(super) corners: Few<Vec3, 8>,
    /// Of its faces, outwards.
    pub(super) normals: Few<UnitVec3, 6>,
    /// Raw.
    pub(super) radius: i64,
}

#[derive(Clone, Copy)]
enum Kind<'a> {
    Point,
    Segment,
    Triangle,
    Cuboid { is_mirrored: bool },
    Hull(&'a ConvexHull),
}

/// An edge of a core. It runs along the cross product of its normals.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    pub(super) from: [i64; 3],
    pub(super) way: [i64; 3],
    /// Of the faces at both sides; none at a segment.
    pub(super) normals: Option<[UnitVec3; 2]>,
    /// Its faces.
    pub(super) faces: [u32; 2],
}

/// The corners of a box's face along an axis, counter-clockwise, by the ends of the next axes.
const SQUARE: [[u32; 2]; 4] = [[0, 0], [1, 0], [1, 1], [0, 1]];

impl<'a> Solid<'a> {
    /// None of what is no convex shape with an end.
    pub(super) fn new(shape: &'a Shape, origin: [i64; 3]) -> Option<Self> {
        let local = |point: Vec3| Vec3::from_raw(sub(point.raw(), origin));
        Some(match shape {
            Shape::Sphere(sphere) => Self::of_sphere(sphere, local),
            Shape::Capsule(capsule) => Self::of_capsule(capsule, local),
            Shape::Cuboid(cuboid) => Self::of_cuboid(cuboid, local),
            Shape::ConvexHull(hull) => Self::of_hull(hull, local),
            Shape::Triangle(triangle) => Self::of_triangle(triangle, local),
            Shape::HalfSpace(_) | Shape::MeshShape(_) | Shape::HeightField(_) => return None,
        })
    }

    fn of_sphere(sphere: &Sphere, local: impl Fn(Vec3) -> Vec3) -> Self {
        let corners = [local(sphere.center())].into_iter().collect();
        Self { kind: Kind::Point, corners, normals: Few::new(), radius: sphere.radius().raw() }
    }

    fn of_capsule(capsule: &Capsule, local: impl Fn(Vec3) -> Vec3) -> Self {
        let corners = capsule.ends().map(local).into_iter().collect();
        Self { kind: Kind::Segment, corners, normals: Few::new(), radius: capsule.radius().raw() }
    }

    fn of_triangle(triangle: &Triangle, local: impl Fn(Vec3) -> Vec3) -> Self {
        let [a, b, c] = triangle.corners().map(local);
        let cross = cross(sub(b.raw(), a.raw()), sub(c.raw(), a.raw()));
        // A triangle without an area has no faces.
        let normal = UnitVec3::normalize_wide(cross);
        let normals = normal.into_iter().flat_map(|normal| [normal, -normal]).collect();
        Self { kind: Kind::Triangle, corners: [a, b, c].into_iter().collect(), normals, radius: 0 }
    }

    fn of_cuboid(cuboid: &Cuboid, local: impl Fn(Vec3) -> Vec3) -> Self {
        let kind = Kind::Cuboid { is_mirrored: cuboid.is_mirrored() };
        let corners = cuboid.corners().into_iter().map(local).collect();
        let normals = cuboid.normals().into_iter().flat_map(|normal| [-normal, normal]).collect();
        Self { kind, corners, normals, radius: 0 }
    }

    fn of_hull(hull: &'a ConvexHull, local: impl Fn(Vec3) -> Vec3) -> Self {
        let corners = hull.vertices().iter().map(|&vertex| local(vertex)).collect();
        let normals = hull.normals().iter().copied().collect();
        Self { kind: Kind::Hull(hull), corners, normals, radius: 0 }
    }

    /// The corners of a face, by their places.
    fn face_corners(&self, face: u32) -> Few<u32, 4> {
        match self.kind {
            Kind::Point => Few::new(),
            Kind::Segment => [0, 1].into_iter().collect(),
            Kind::Triangle if face == 0 => [0, 1, 2].into_iter().collect(),
            Kind::Triangle => [0, 2, 1].into_iter().collect(),
            Kind::Cuboid { is_mirrored } => {
                let (axis, is_along) = (face / 2, face % 2 == 1);
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let (u, v) = if is_along == is_mirrored { (v, u) } else { (u, v) };
                let end = u32::from(is_along) << axis;
                SQUARE.iter().map(|[along_u, along_v]| end | along_u << u | along_v << v).collect()
            }
            Kind::Hull(hull) => hull.face_corners(face).iter().copied().collect(),
        }
    }

    /// The edge between two corners of a face.
    fn edge_between(&self, from: u32, to: u32) -> u32 {
        match self.kind {
            Kind::Point | Kind::Segment => 0,
            // From each corner to the next one.
            Kind::Triangle => {
                if (from + 1) % 3 == to {
                    from
                } else {
                    to
                }
            }
            Kind::Cuboid { .. } => {
                let axis = (from ^ to).trailing_zeros();
                box_edge(from, axis)
            }
            Kind::Hull(hull) => {
                let ends = [from.min(to), from.max(to)];
                let place = hull.edges().binary_search_by_key(&ends, |edge| edge.ends);
                // Fewer than 2^30.
                place.map_or(0, |place| place as u32)
            }
        }
    }

    /// The name of a corner.
    pub(super) fn corner_name(&self, corner: u32) -> FeatureId {
        match self.kind {
            Kind::Point => FeatureId::face(0),
            _ => FeatureId::vertex(corner),
        }
    }

    /// What is clipped of it where something touches it in this direction: its face, or all of it
    /// where it has none.
    pub(super) fn outline(&self, face: Option<u32>, direction: UnitVec3) -> Outline {
        let face_corners = match face {
            Some(face) => self.face_corners(face),
            None => (0..self.corners.len() as u32).collect(),
        };
        let corner = |(i, &vertex): (usize, &u32)| Corner {
            at: self.corners[vertex as usize].raw(),
            name: self.corner_name(vertex),
            edge: self.edge_between(vertex, face_corners[(i + 1) % face_corners.len()]),
        };
        Outline {
            // A triangle has two faces of one name.
            face: FeatureId::face(match self.kind {
                Kind::Triangle => 0,
                _ => face.unwrap_or(0),
            }),
            normal: face.map_or(direction, |face| self.normals[face as usize]),
            corners: face_corners.iter().enumerate().map(corner).collect(),
        }
    }

    /// What is clipped of it in a direction.
    pub(super) fn outline_at<W: Width>(&self, direction: UnitVec3) -> Outline {
        self.outline(self.facing::<W>(direction), direction)
    }

    /// The name of a point of it, with the outline there: what is flat is named by its face.
    pub(super) fn name(&self, point: Vec3, outline: &Outline) -> FeatureId {
        match self.kind {
            Kind::Segment => {
                let end = (0..).zip(self.corners.iter()).find(|&(_, &end)| end == point);
                end.map_or(FeatureId::edge(0), |(end, _)| FeatureId::vertex(end))
            }
            _ => outline.face,
        }
    }

    /// Whether the core has no volume.
    pub(super) const fn is_flat(&self) -> bool {
        matches!(self.kind, Kind::Point | Kind::Segment | Kind::Triangle)
    }

    /// The ends of a segment.
    pub(super) fn segment(&self) -> Option<[[i64; 3]; 2]> {
        match self.kind {
            Kind::Segment => Some([self.corners[0].raw(), self.corners[1].raw()]),
            _ => None,
        }
    }

    /// How far a face reaches along its normal.
    #[inline]
    pub(super) fn face_reach<W: Width>(&self, face: u32) -> W::Reach {
        let along = |&corner: &u32| {
            W::along(self.normals[face as usize], self.corners[corner as usize].raw())
        };
        if let Kind::Hull(hull) = self.kind {
            return along(&hull.anchors()[face as usize]);
        }
        self.face_corners(face).iter().map(along).reduce(Ord::max).unwrap_or_default()
    }

    /// The corner that is farthest along a direction, of several the first, and how far it is.
    #[inline]
    pub(super) fn farthest<W: Width>(&self, direction: UnitVec3) -> (u32, W::Reach) {
        let mut best = (0, W::along(direction, self.corners[0].raw()));
        for (corner, at) in (1..).zip(&self.corners[1..]) {
            let reach = W::along(direction, at.raw());
            if reach > best.1 {
                best = (corner, reach);
            }
        }
        best
    }

    /// Of the faces at its farthest corner along a direction the one that looks that way most; the
    /// first of several. None if it has no faces.
    pub(super) fn facing<W: Width>(&self, direction: UnitVec3) -> Option<u32> {
        let (corner, _) = self.farthest::<W>(direction);
        let mut best: Option<(i128, u32)> = None;
        for (face, normal) in (0..).zip(self.normals.iter()) {
            let cosine = dot_wide(normal.raw(), direction.raw());
            let is_better = best.is_none_or(|(most, _)| cosine > most);
            if is_better && self.face_corners(face).contains(&corner) {
                best = Some((cosine, face));
            }
        }
        best.map(|(_, face)| face)
    }

    /// All edges.
    pub(super) fn edges(&self) -> Few<Edge, 12> {
        let edge = |ends: [u32; 2], faces: Option<[u32; 2]>| {
            let [from, to] = ends.map(|end| self.corners[end as usize].raw());
            let normals = faces.map(|faces| faces.map(|face| self.normals[face as usize]));
            Edge { from, way: sub(to, from), normals, faces: faces.unwrap_or_default() }
        };
        match self.kind {
            Kind::Point => Few::new(),
            Kind::Segment => [edge([0, 1], None)].into_iter().collect(),
            Kind::Triangle => {
                let faces = (!self.normals.is_empty()).then_some([0, 1]);
                [[0, 1], [1, 2], [2, 0]].map(|ends| edge(ends, faces)).into_iter().collect()
            }
            Kind::Cuboid { is_mirrored } => (0..12)
                .map(|place| {
                    let (axis, at_u, at_v) = (place / 4, place & 1, place >> 1 & 1);
                    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                    let from = at_u << u | at_v << v;
                    let faces = [2 * u + at_u, 2 * v + at_v];
                    // From end to end the edge runs along the cross product of both normals.
                    let is_turned = (at_u == at_v) == is_mirrored;
                    let faces = if is_turned { [faces[1], faces[0]] } else { faces };
                    edge([from, from | 1 << axis], Some(faces))
                })
                .collect(),
            Kind::Hull(hull) => hull.edges().iter().map(|e| edge(e.ends, Some(e.faces))).collect(),
        }
    }
}

/// The edge of a box along an axis at a corner, as [`FeatureId`] numbers them.
pub(super) fn box_edge(corner: u32, axis: u32) -> u32 {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    4 * axis + (corner >> u & 1) + 2 * (corner >> v & 1)
}
