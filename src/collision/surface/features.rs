//! What of a mesh touches what else of it.

use alloc::vec;
use alloc::vec::Vec;

use crate::geometry::{Adjacency, Lists, TriangleMesh};

/// The edges of a mesh, and the faces at its edges and vertices. Immutable, as the mesh is.
#[derive(Debug)]
pub(super) struct Features {
    /// The ends of every edge, in the order of [`Adjacency::edges`].
    pub(super) ends: Vec<[u32; 2]>,
    /// The edges of every face.
    pub(super) sides: Vec<[u32; 3]>,
    at_edges: Lists,
    at_vertices: Lists,
    /// Whether there are edges, and each has two faces that go along it in opposite directions.
    pub(super) is_closed: bool,
    /// The lowest face of each part that hangs together, sorted.
    pub(super) shells: Vec<u32>,
}

impl Features {
    /// The features of a mesh. O(n log n) for n faces and vertices.
    pub(super) fn new(mesh: &TriangleMesh) -> Self {
        let adjacency = Adjacency::new(mesh);
        let ends: Vec<_> = adjacency.edges().map(|edge| edge.ends).collect();
        let mut sides = vec![[0; 3]; mesh.faces().len()];
        let mut is_closed = true;
        for (place, edge) in (0..).zip(adjacency.edges()) {
            let mut ways = 0;
            for &face in edge.faces {
                let [a, b, c] = mesh.faces()[face as usize];
                for (side, way) in sides[face as usize].iter_mut().zip([[a, b], [b, c], [c, a]]) {
                    let [low, high] = edge.ends;
                    if way == [low, high] || way == [high, low] {
                        *side = place;
                        ways += if way == [low, high] { 1 } else { -1 };
                    }
                }
            }
            is_closed &= edge.faces.len() == 2 && ways == 0;
        }
        let mut at_edges = Lists::new();
        adjacency.edges().for_each(|edge| at_edges.push(edge.faces.iter().copied()));
        let at_vertices = at_vertices(mesh);
        let is_closed = is_closed && !ends.is_empty();
        let shells = shells(mesh, &adjacency.components());
        Self { ends, sides, at_edges, at_vertices, is_closed, shells }
    }

    /// The faces at an edge, sorted.
    #[inline]
    pub(super) fn at_edge(&self, edge: u32) -> &[u32] {
        self.at_edges.get(edge as usize)
    }

    /// The faces at a vertex, sorted.
    #[inline]
    pub(super) fn at_vertex(&self, vertex: u32) -> &[u32] {
        self.at_vertices.get(vertex as usize)
    }
}

/// The lowest face of each component of vertices that has one.
fn shells(mesh: &TriangleMesh, components: &[u32]) -> Vec<u32> {
    let mut is_known = vec![false; components.len()];
    let mut is_new = |[first, ..]: &[u32; 3]| {
        // Components are numbered from 0, and there are no more of them than vertices.
        !core::mem::replace(&mut is_known[components[*first as usize] as usize], true)
    };
    (0..).zip(mesh.faces()).filter(|(_, face)| is_new(face)).map(|(number, _)| number).collect()
}

/// The faces at every vertex.
fn at_vertices(mesh: &TriangleMesh) -> Lists {
    let named = |(face, &corners): (u32, &[u32; 3])| corners.map(|vertex| (vertex, face));
    let mut pairs: Vec<_> = (0..).zip(mesh.faces()).flat_map(named).collect();
    pairs.sort_unstable(); // equal ones are dropped
    pairs.dedup();
    let mut lists = Lists::new();
    let mut pairs = pairs.into_iter().peekable();
    for (vertex, _) in (0..).zip(mesh.vertices()) {
        lists.push(
            core::iter::from_fn(|| pairs.next_if(|&(of, _)| of == vertex)).map(|(_, face)| face),
        );
    }
    lists
}
