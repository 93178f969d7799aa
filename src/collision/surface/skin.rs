//! Convex polyhedra as surfaces.

use alloc::vec::Vec;

use crate::collision::{FeatureId, FeatureKind};
use crate::geometry::{Aabb, ConvexHull, Cuboid, Lists, Surface};
use crate::math::Vec3;
use crate::math::determinant::{cross, dot};

/// The faces of a box or a hull, cut into triangles. Few: all lists are made anew for each pair.
#[derive(Debug)]
pub(super) struct Skin {
    vertices: Vec<Vec3>,
    bounds: Aabb,
    triangles: Vec<[u32; 3]>,
    sides: Vec<[u32; 3]>,
    /// The ends of every edge, sorted, those inside a face included.
    ends: Vec<[u32; 2]>,
    /// The two triangles at every edge.
    at_edges: Vec<[u32; 2]>,
    at_vertices: Lists,
    /// The face that a triangle is part of.
    faces: Vec<u32>,
    /// What an edge is called: the face that it cuts, if it is none.
    edges: Vec<FeatureId>,
}

/// The axis after another.
const NEXT: [usize; 3] = [1, 2, 0];

impl Skin {
    pub(super) fn of_hull(hull: &ConvexHull) -> Self {
        let edges = hull.edges();
        let name = |ends: [u32; 2]| edges.binary_search_by_key(&ends, |edge| edge.ends).ok();
        let polygons = hull.faces().map(<[u32]>::to_vec);
        // At most 3 * 2^22 edges.
        Self::new(hull.vertices().to_vec(), polygons, |ends| name(ends).map(|edge| edge as u32))
    }

    pub(super) fn of_cuboid(cuboid: &Cuboid) -> Self {
        let edges = cuboid.half_edges().map(Vec3::raw);
        let is_mirrored = dot(&cross(edges[0], edges[1]), edges[2]) < 0;
        let polygons = (0..6).map(|face| {
            let (axis, end) = (face / 2, face % 2);
            let (u, v) = (NEXT[axis], NEXT[NEXT[axis]]);
            let corner = |[i, j]: [u32; 2]| (end as u32) << axis | i << u | j << v;
            let mut corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(corner);
            if is_mirrored == (end == 1) {
                corners.reverse();
            }
            corners.to_vec()
        });
        let name = |[low, high]: [u32; 2]| {
            let way = low ^ high;
            way.is_power_of_two().then(|| {
                let axis = way.trailing_zeros();
                let (u, v) = (NEXT[axis as usize], NEXT[NEXT[axis as usize]]);
                4 * axis + (low >> u & 1) + 2 * (low >> v & 1)
            })
        };
        Self::new(cuboid.corners().to_vec(), polygons, name)
    }

    /// The skin of faces, given their corners counter-clockwise as seen from outside; `name` tells
    /// what the edge between two vertices is called, and that there is one.
    fn new(
        vertices: Vec<Vec3>,
        polygons: impl Iterator<Item = Vec<u32>>,
        name: impl Fn([u32; 2]) -> Option<u32>,
    ) -> Self {
        let (mut triangles, mut faces) = (Vec::new(), Vec::new());
        for (face, corners) in (0..).zip(polygons) {
            for pair in corners.get(1..).unwrap_or_default().windows(2) {
                triangles.push([corners[0], pair[0], pair[1]]);
                faces.push(face);
            }
        }
        let mut around: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
        for (place, &[a, b, c]) in (0..).zip(&triangles) {
            around.extend([[a, b], [b, c], [c, a]].map(|[p, q]| ([p.min(q), p.max(q)], place)));
        }
        around.sort_unstable();
        let (mut ends, mut at_edges, mut edges) = (Vec::new(), Vec::new(), Vec::new());
        for pair in around.chunks_exact(2) {
            ends.push(pair[0].0);
            at_edges.push([pair[0].1, pair[1].1]);
            let face = FeatureId::face(faces[pair[0].1 as usize]);
            edges.push(name(pair[0].0).map_or(face, FeatureId::edge));
        }
        let place = |[p, q]: [u32; 2]| {
            // Every side of a triangle is there.
            ends.partition_point(|&other| other < [p.min(q), p.max(q)]) as u32
        };
        let sides =
            triangles.iter().map(|&[a, b, c]| [[a, b], [b, c], [c, a]].map(place)).collect();
        let mut at_vertices = Lists::new();
        let mut corners: Vec<(u32, u32)> = (0..)
            .zip(&triangles)
            .flat_map(|(place, corners)| corners.map(|vertex| (vertex, place)))
            .collect();
        corners.sort_unstable();
        for same in corners.chunk_by(|one, other| one.0 == other.0) {
            at_vertices.push(same.iter().map(|&(_, place)| place));
        }
        let first = vertices.first().copied().unwrap_or(Vec3::ZERO);
        let bounds = vertices.iter().fold(Aabb::of_point(first), |bounds, &p| bounds.with(p));
        Self { vertices, bounds, triangles, sides, ends, at_edges, at_vertices, faces, edges }
    }

    /// What the shape calls a feature of its skin.
    pub(super) fn name(&self, feature: FeatureId) -> FeatureId {
        let index = feature.index() as usize;
        match feature.kind() {
            FeatureKind::Vertex => feature,
            FeatureKind::Edge => self.edges[index],
            FeatureKind::Face => FeatureId::face(self.faces[index]),
        }
    }
}

impl Surface for Skin {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn faces_near(&self, bounds: &Aabb, faces: &mut Vec<u32>) {
        faces.clear();
        let is_near = |face: &u32| self.triangle(*face).bounds().overlaps(bounds);
        faces.extend((0..).take(self.triangles.len()).filter(is_near));
    }

    fn corners(&self, face: u32) -> [u32; 3] {
        self.triangles[face as usize]
    }

    fn sides(&self, face: u32) -> [u32; 3] {
        self.sides[face as usize]
    }

    fn ends(&self, edge: u32) -> [u32; 2] {
        self.ends[edge as usize]
    }

    fn position(&self, vertex: u32) -> Vec3 {
        self.vertices[vertex as usize]
    }

    fn faces_at_edge(&self, edge: u32) -> impl Iterator<Item = u32> {
        self.at_edges[edge as usize].into_iter()
    }

    fn faces_at_vertex(&self, vertex: u32) -> impl Iterator<Item = u32> {
        self.at_vertices.get(vertex as usize).iter().copied()
    }

    fn is_two_sided(&self) -> bool {
        false
    }

    fn is_closed(&self) -> bool {
        true
    }
}
