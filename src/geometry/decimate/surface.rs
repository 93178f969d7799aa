//! The faces that are left, and which edges may collapse.

use alloc::vec;
use alloc::vec::Vec;

use crate::geometry::{Triangle, TriangleMesh};
use crate::math::determinant::cross;
use crate::math::wide::{dot_narrow, sub};
use crate::math::{UnitVec3, Vec3};

/// Faces may turn by no more than this at once: by 75 degrees, whose cosine is 1/4 (times 2^60).
const TURN_COSINE: i64 = 1 << 58;

/// Vertices, the faces between them, and which faces are around a vertex.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    positions: Vec<Vec3>,
    faces: Vec<[u32; 3]>,
    /// The faces around every vertex, in no particular order. Faces that are gone are in none.
    stars: Vec<Vec<u32>>,
    roles: Vec<Role>,
    /// How many faces are left.
    len: usize,
    /// For every vertex the last walk that came by.
    seen: Vec<u32>,
    walk: u32,
}

/// What the faces around a vertex look like.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Role {
    /// They close around it.
    Inner,
    /// A fan that begins and ends at the boundary.
    Rim,
    /// Anything else: several fans, or edges of three faces and more. It stays.
    Fixed,
}

impl Surface {
    /// The surface of a mesh. Faces that name a vertex twice are left out.
    pub(super) fn new(mesh: &TriangleMesh) -> Self {
        let is_face = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
        let faces: Vec<_> = mesh.faces().iter().copied().filter(is_face).collect();
        let vertices = mesh.vertices().len();
        let mut stars = vec![Vec::new(); vertices];
        for (face, corners) in (0..).zip(&faces) {
            for &corner in corners {
                stars[corner as usize].push(face);
            }
        }
        let mut surface = Self {
            positions: mesh.vertices().to_vec(),
            len: faces.len(),
            faces,
            stars,
            roles: vec![Role::Fixed; vertices],
            seen: vec![0; vertices],
            walk: 0,
        };
        surface.roles = (0..).take(vertices).map(|vertex| surface.find_role(vertex)).collect();
        surface
    }

    /// How many faces are left.
    pub(super) const fn len(&self) -> usize {
        self.len
    }

    /// The corners of all faces that are left, in order.
    pub(super) fn faces(&self) -> impl Iterator<Item = [u32; 3]> {
        let is_left = |face: u32, corner: u32| self.stars[corner as usize].contains(&face);
        let faces = (0..).zip(&self.faces);
        faces.filter(move |(face, corners)| is_left(*face, corners[0])).map(|(_, &corners)| corners)
    }

    pub(super) fn position(&self, vertex: u32) -> Vec3 {
        self.positions[vertex as usize]
    }

    pub(super) fn role(&self, vertex: u32) -> Role {
        self.roles[vertex as usize]
    }

    /// The corners of the faces around a vertex.
    fn around(&self, vertex: u32) -> impl Iterator<Item = [u32; 3]> {
        self.stars[vertex as usize].iter().map(|&face| self.faces[face as usize])
    }

    /// Adds the vertices that share a face with one to a list, each once.
    pub(super) fn neighbours(&mut self, vertex: u32, into: &mut Vec<u32>) {
        self.walk += 1; // once or twice a collapse and candidate: far below 2^32
        let Self { faces, stars, seen, walk, .. } = self;
        for &face in &stars[vertex as usize] {
            for corner in faces[face as usize] {
                if corner != vertex && seen[corner as usize] != *walk {
                    seen[corner as usize] = *walk;
                    into.push(corner);
                }
            }
        }
    }

    /// How many faces are around a vertex.
    pub(super) fn degree(&self, vertex: u32) -> usize {
        self.stars[vertex as usize].len()
    }

    /// The corners across from an edge, one for each of its faces: none of two, of `len` in all.
    fn tips(&self, mut ends: [u32; 2]) -> Tips {
        // The fewer faces are looked at.
        ends.sort_unstable_by_key(|&end| self.degree(end));
        let [a, b] = ends;
        let mut tips = Tips { corners: [a; 2], len: 0 };
        for corners in self.around(a).filter(|corners| corners.contains(&b)) {
            let tip = corners.into_iter().find(|corner| *corner != a && *corner != b);
            if let (Some(place), Some(tip)) = (tips.corners.get_mut(tips.len), tip) {
                *place = tip;
            }
            tips.len += 1;
        }
        tips
    }

    /// Whether an edge can become the vertex `ends[0]` at `position` so that what is there remains
    /// a surface of the same kind, no face turns over, and none becomes too long.
    pub(super) fn can_collapse(&mut self, ends: [u32; 2], position: Vec3) -> bool {
        self.keeps_shape(ends) && self.keeps_sides(ends, position)
    }

    /// The condition of Dey, Edelsbrunner, Guha and Nekhayev (*Topology Preserving Edge
    /// Contraction*, 1999): what is next to both ends is next to the edge. A boundary counts as a
    /// vertex that its edges are joined to.
    fn keeps_shape(&mut self, ends: [u32; 2]) -> bool {
        let tips = self.tips(ends);
        let [tip, other] = tips.corners;
        let is_rim = tips.len == 1;
        let is_possible = match ends.map(|end| self.role(end)) {
            [Role::Fixed, Role::Fixed] => false,
            [Role::Inner, _] | [_, Role::Inner] => tips.len == 2 && tip != other,
            // Between two points of the boundary only along it, and no last triangle.
            _ => is_rim && !ends.iter().all(|&end| self.tips([end, tip]).len == 1),
        };
        if !is_possible {
            return false;
        }
        let joins_tips = |end| {
            self.around(end).any(|corners| corners.contains(&tip) && corners.contains(&other))
        };
        if !is_rim && ends.into_iter().all(joins_tips) {
            return false;
        }
        let mut next = Vec::new();
        self.neighbours(ends[1], &mut next);
        self.neighbours(ends[0], &mut Vec::new());
        let common = next.iter().filter(|&&vertex| self.seen[vertex as usize] == self.walk);
        common.count() == tips.len
    }

    fn keeps_sides(&self, ends: [u32; 2], position: Vec3) -> bool {
        let is_end = |corner: &u32| ends.contains(corner);
        let of_both = ends.into_iter().flat_map(|end| self.around(end));
        // Those with both ends disappear.
        of_both.filter(|corners| corners.iter().filter(|c| is_end(c)).count() == 1).all(|corners| {
            let before = corners.map(|corner| self.position(corner));
            let after = corners.map(|c| if is_end(&c) { position } else { self.position(c) });
            Triangle::new(after).is_ok() && !turns(before, after)
        })
    }

    /// Makes an edge the vertex `ends[0]` at `position`.
    pub(super) fn collapse(&mut self, [kept, gone]: [u32; 2], position: Vec3) {
        self.positions[kept as usize] = position;
        self.roles[kept as usize] = match [self.role(kept), self.role(gone)] {
            [Role::Fixed, _] | [_, Role::Fixed] => Role::Fixed,
            [Role::Rim, _] | [_, Role::Rim] => Role::Rim,
            [Role::Inner, Role::Inner] => Role::Inner,
        };
        for face in core::mem::take(&mut self.stars[gone as usize]) {
            let corners = self.faces[face as usize];
            if corners.contains(&kept) {
                self.len -= 1;
                for corner in corners.into_iter().filter(|&corner| corner != gone) {
                    let star = &mut self.stars[corner as usize];
                    if let Some(place) = star.iter().position(|&other| other == face) {
                        star.swap_remove(place);
                    }
                }
            } else {
                self.faces[face as usize] = corners.map(|c| if c == gone { kept } else { c });
                self.stars[kept as usize].push(face);
            }
        }
    }

    /// O(k log k) for k faces around it.
    fn find_role(&self, vertex: u32) -> Role {
        // The other corners of all faces around, each with the place of the face.
        let star = (0..).zip(self.around(vertex));
        let of_face = |(place, corners): (usize, [u32; 3])| {
            corners.into_iter().filter(|&c| c != vertex).map(move |c| (c, place))
        };
        let mut spokes: Vec<(u32, usize)> = star.flat_map(of_face).collect();
        spokes.sort_unstable();
        // By the faces at an edge from one to the next; where there are more than two, not all.
        let mut next = vec![[None; 2]; self.degree(vertex)];
        let (mut rims, mut crossings) = (0, 0);
        for edge in spokes.chunk_by(|a, b| a.0 == b.0) {
            match *edge {
                [_] => rims += 1,
                [(_, a), (_, b)] => {
                    for (from, to) in [(a, b), (b, a)] {
                        let slot = usize::from(next[from][0].is_some());
                        next[from][slot] = Some(to);
                    }
                }
                _ => crossings += 1,
            }
        }
        let is_one_fan = || reached(&next) == next.len();
        match (rims, crossings) {
            (0, 0) if !next.is_empty() && is_one_fan() => Role::Inner,
            (2, 0) if is_one_fan() => Role::Rim,
            _ => Role::Fixed,
        }
    }
}

/// To how many places, of which there is one, steps lead from the first.
fn reached(next: &[[Option<usize>; 2]]) -> usize {
    let mut is_reached = vec![false; next.len()];
    let (mut open, mut count) = (vec![0], 0);
    while let Some(place) = open.pop() {
        if !core::mem::replace(&mut is_reached[place], true) {
            count += 1;
            open.extend(next[place].into_iter().flatten());
        }
    }
    count
}

/// The corners across from an edge.
#[derive(Clone, Copy, Debug)]
struct Tips {
    corners: [u32; 2],
    len: usize,
}

/// Whether a face turns over, or loses its area.
fn turns(before: [Vec3; 3], after: [Vec3; 3]) -> bool {
    let (Some(before), after) = (normal(before), normal(after)) else { return false };
    after.is_none_or(|after| dot_narrow(before.raw(), after.raw()) < TURN_COSINE)
}

/// The direction that a face looks in; none without an area.
pub(super) fn normal([a, b, c]: [Vec3; 3]) -> Option<UnitVec3> {
    let [a, b, c] = [a, b, c].map(Vec3::raw);
    // Sides are below 2^41.
    UnitVec3::normalize_wide(cross(sub(b, a), sub(c, a)))
}
