//! Which vertices and faces of a mesh touch.

use alloc::vec;
use alloc::vec::Vec;

use super::lists::Lists;
use super::mesh::TriangleMesh;

/// The edges of a mesh with their faces, and the neighbours of its vertices.
///
/// A corner that a face names twice gives no edge, but the side to its third corner remains one: a
/// face `[a, b, b]` is a line from a to b.
#[derive(Clone, Debug)]
pub struct Adjacency<'a> {
    mesh: &'a TriangleMesh,
    /// The ends of every edge, the lower vertex first, sorted.
    edges: Vec<[u32; 2]>,
    faces: Lists,
    neighbours: Lists,
}

/// Two vertices that a face joins, and all faces that do.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Edge<'a> {
    /// The lower vertex, then the higher one.
    pub ends: [u32; 2],
    /// In order. One at the boundary, two inside; more where sheets meet in one edge.
    pub faces: &'a [u32],
}

/// An inner edge about which its two faces can fold.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Hinge {
    /// The ends of the edge, the lower vertex first.
    pub ends: [u32; 2],
    /// The corners across from it, that of the lower face first.
    pub tips: [u32; 2],
}

impl<'a> Adjacency<'a> {
    /// The adjacency of a mesh. O(n log n) for n faces and vertices.
    #[must_use]
    pub fn new(mesh: &'a TriangleMesh) -> Self {
        let mut sides: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * mesh.faces().len());
        for (face, &[a, b, c]) in (0..).zip(mesh.faces()) {
            let joined = [[a, b], [b, c], [c, a]].into_iter().filter(|[from, to]| from != to);
            sides.extend(joined.map(|[from, to]| ([from.min(to), from.max(to)], face)));
        }
        sides.sort_unstable(); // equal ones are dropped
        sides.dedup();
        let mut edges = Vec::new();
        let mut faces = Lists::new();
        for sides in sides.chunk_by(|(a, _), (b, _)| a == b) {
            edges.push(sides[0].0);
            faces.push(sides.iter().map(|&(_, face)| face));
        }
        let neighbours = Lists::neighbours(edges.iter().copied(), mesh.vertices().len());
        Self { mesh, edges, faces, neighbours }
    }

    /// Every edge once, sorted by its ends.
    #[must_use]
    pub fn edges(&self) -> impl ExactSizeIterator<Item = Edge<'_>> {
        (0..self.edges.len()).map(|place| self.edge_at(place))
    }

    /// The edge between two vertices, if there is one. O(log n).
    #[must_use]
    pub fn edge(&self, a: u32, b: u32) -> Option<Edge<'_>> {
        let place = self.edges.binary_search(&[a.min(b), a.max(b)]).ok()?;
        Some(self.edge_at(place))
    }

    /// The edges of one face only, sorted.
    pub fn boundary(&self) -> impl Iterator<Item = [u32; 2]> {
        self.edges().filter(|edge| edge.faces.len() == 1).map(|edge| edge.ends)
    }

    /// The edges of exactly two faces that have different corners across from it, sorted.
    pub fn hinges(&self) -> impl Iterator<Item = Hinge> {
        self.edges().filter_map(|Edge { ends, faces }| {
            let &[first, second] = faces else { return None };
            let tips = [self.tip(first, ends)?, self.tip(second, ends)?];
            (tips[0] != tips[1]).then_some(Hinge { ends, tips })
        })
    }

    /// The vertices with an edge to this one, sorted; none for one that is not in the mesh. O(1).
    #[must_use]
    pub fn neighbours(&self, vertex: u32) -> &[u32] {
        self.neighbours.get(vertex as usize)
    }

    /// For every vertex the number of its component, the vertices that edges join it to.
    ///
    /// Components are numbered from 0 in the order of their lowest vertices; a vertex of no face is
    /// one by itself. O(vertices + edges).
    #[must_use]
    pub fn components(&self) -> Vec<u32> {
        const UNSEEN: u32 = u32::MAX; // there are at most 2^22 vertices
        let mut components = vec![UNSEEN; self.mesh.vertices().len()];
        let mut count = 0;
        let mut open = Vec::new();
        for (vertex, place) in (0..).zip(0..components.len()) {
            if components[place] != UNSEEN {
                continue;
            }
            components[place] = count;
            open.push(vertex);
            while let Some(vertex) = open.pop() {
                for &neighbour in self.neighbours(vertex) {
                    let component = &mut components[neighbour as usize];
                    if *component == UNSEEN {
                        *component = count;
                        open.push(neighbour);
                    }
                }
            }
            count += 1;
        }
        components
    }

    fn edge_at(&self, place: usize) -> Edge<'_> {
        Edge { ends: self.edges[place], faces: self.faces.get(place) }
    }

    /// The corner of a face that is no end of an edge of it; none if the face is a line.
    fn tip(&self, face: u32, ends: [u32; 2]) -> Option<u32> {
        let corners = self.mesh.faces()[face as usize];
        corners.into_iter().find(|corner| !ends.contains(corner))
    }
}
