//! The lines in which two surfaces intersect.

use alloc::vec::Vec;

use crate::collision::FeatureId;
use crate::collision::surface::feet::normal_of;
use crate::geometry::{
    Feature, Intersection, IntersectionPoint, Surface, intersection_triangle_triangle,
};
use crate::math::determinant::cross;
use crate::math::wide::sub;
use crate::math::{UnitVec3, Vec3};

/// Where a line goes from one pair of faces to the next: as a rule where an edge pierces a face.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Knot {
    /// Of A and of B. Unique.
    pub(super) features: [FeatureId; 2],
    pub(super) position: Vec3,
    /// A pair of faces that meet there.
    pub(super) faces: [u32; 2],
}

/// What two faces have in common, from knot to knot, along the product of their normals.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub(super) knots: [u32; 2],
    /// Of A and of B.
    pub(super) faces: [u32; 2],
}

/// All lines in which two surfaces intersect.
#[derive(Debug, Default)]
pub(super) struct Contour {
    /// Sorted by features.
    pub(super) knots: Vec<Knot>,
    pub(super) links: Vec<Link>,
    /// Whether faces meet elsewhere than where an edge of one pierces the inside of another.
    pub(super) is_degenerate: bool,
}

impl Contour {
    /// Of pairs of faces, of which some may intersect. Faces that only touch in a point, or lie in
    /// one plane, add no line.
    pub(super) fn new<A: Surface, B: Surface>(a: &A, b: &B, pairs: &[[u32; 2]]) -> Self {
        let mut ends: Vec<([Knot; 2], [u32; 2])> = Vec::new();
        let mut is_degenerate = false;
        for &faces in pairs {
            let triangles = (a.triangle(faces[0]), b.triangle(faces[1]));
            let found = intersection_triangle_triangle(&triangles.0, &triangles.1);
            let points = found.as_ref().map_or(&[][..], Intersection::points);
            is_degenerate |= !points.iter().all(is_piercing);
            let [from, to] = points else { continue };
            let knots = [from, to].map(|point| {
                let features = [name(a, faces[0], point.on_a), name(b, faces[1], point.on_b)];
                Knot { features, position: point.position, faces }
            });
            let is_forward = leads_along(a, b, &knots);
            ends.push((if is_forward { knots } else { [knots[1], knots[0]] }, faces));
        }
        let mut knots: Vec<_> = ends.iter().flat_map(|(ends, _)| *ends).collect();
        knots.sort_unstable();
        knots.dedup_by_key(|knot| knot.features);
        let mut contour = Self { knots, links: Vec::new(), is_degenerate };
        let link = |(ends, faces): &([Knot; 2], _)| {
            let knots = ends.each_ref().map(|knot| contour.place(knot));
            Link { knots, faces: *faces }
        };
        contour.links = ends.iter().map(link).collect();
        contour
    }

    /// The faces of A and of B that its lines go through, sorted.
    pub(super) fn rims(&self) -> [Vec<u32>; 2] {
        [0, 1].map(|k| {
            let mut rim: Vec<_> = self.links.iter().map(|link| link.faces[k]).collect();
            rim.sort_unstable();
            rim.dedup();
            rim
        })
    }

    /// The number of a knot of it.
    pub(super) fn place(&self, knot: &Knot) -> u32 {
        // At most two for each of less than 2^31 pairs; every knot is there.
        self.knots.partition_point(|other| other.features < knot.features) as u32
    }

    /// Twice the area of what a closed line of these links spans, as a vector, from an origin near
    /// to them: terms are below 2^85, of less than 2^31.
    pub(super) fn area(&self, link: Link, origin: Vec3) -> [i128; 3] {
        let [from, to] =
            link.knots.map(|knot| sub(self.knots[knot as usize].position.raw(), origin.raw()));
        cross(from, to)
    }
}

/// Whether an edge goes through the inside of a face there.
const fn is_piercing(point: &IntersectionPoint) -> bool {
    matches!(
        (point.on_a, point.on_b),
        (Feature::Edge(_), Feature::Face) | (Feature::Face, Feature::Edge(_))
    )
}

/// The feature of a surface that a feature of one of its faces is.
fn name<S: Surface>(surface: &S, face: u32, feature: Feature) -> FeatureId {
    match feature {
        Feature::Vertex(k) => FeatureId::vertex(surface.corners(face)[usize::from(k)]),
        Feature::Edge(k) => FeatureId::edge(surface.sides(face)[usize::from(k)]),
        Feature::Face => FeatureId::face(face),
    }
}

/// Whether a link goes along the product of the normals of its faces. Which way one goes that is
/// shorter than rounding does not matter.
fn leads_along<A: Surface, B: Surface>(a: &A, b: &B, [from, to]: &[Knot; 2]) -> bool {
    let normals = [normal_of(a, from.faces[0]), normal_of(b, from.faces[1])];
    let [Some(u), Some(v)] = normals.map(|n| n.map(UnitVec3::raw)) else { return true };
    let way = sub(to.position.raw(), from.position.raw());
    let product = cross(u, v);
    // Below 3 * 2^61 * 2^42.
    (0..3).map(|k| product[k] * i128::from(way[k])).sum::<i128>() >= 0
}
