//! Where two surfaces touch: corners over faces, edges across edges.

use alloc::vec::Vec;

use super::DEPTH_MAX;
use super::feet::Feet;
use super::near::Near;
use super::proximity::Proximity;
use super::ridges::{Ridge, crossing};
use crate::collision::margin::counted;
use crate::collision::{Contact, FeatureId};
use crate::geometry::Surface;
use crate::math::Real;

/// Two surfaces, their faces that are near one another, and which are near which.
pub(super) struct NearSurfaces<'a, A, B> {
    a: &'a A,
    b: &'a B,
    faces_a: Vec<Near>,
    faces_b: Vec<Near>,
    /// Places in both lists, sorted.
    pairs: Vec<[u32; 2]>,
    margin: Real,
}

impl<'a, A: Surface, B: Surface> NearSurfaces<'a, A, B> {
    /// Of the pairs of faces whose boxes, grown by `margin`, meet, each once. Sorts them.
    pub(super) fn new(a: &'a A, b: &'a B, pairs: &mut [[u32; 2]], margin: Real) -> Self {
        pairs.sort_unstable();
        let (mut faces_a, mut found) = (Vec::new(), Vec::with_capacity(pairs.len()));
        for same in pairs.chunk_by(|one, other| one[0] == other[0]) {
            let place = place(&faces_a);
            faces_a.push(Near::of(a, same[0][0]));
            found.extend(same.iter().map(|pair| [place, pair[1]]));
        }
        let mut names: Vec<_> = pairs.iter().map(|pair| pair[1]).collect();
        names.sort_unstable();
        names.dedup();
        for pair in &mut found {
            // Every name is there.
            pair[1] = names.partition_point(|&name| name < pair[1]) as u32;
        }
        let faces_b = names.iter().map(|&face| Near::of(b, face)).collect();
        Self { a, b, faces_a, faces_b, pairs: found, margin: counted(margin) }
    }

    /// All contacts, sorted by their features.
    pub(super) fn proximities(&self) -> Vec<Proximity> {
        let mut found = Vec::new();
        self.corners_of_a(&mut found);
        self.corners_of_b(&mut found);
        self.edges(&mut found);
        found.sort_unstable_by_key(Proximity::key);
        // Corners of both that are nearest to one another have been found twice.
        found.dedup_by_key(|proximity| proximity.contact.features);
        found
    }

    fn corners_of_a(&self, found: &mut Vec<Proximity>) {
        corners(
            (self.a, &self.faces_a),
            (self.b, &self.faces_b),
            &self.pairs,
            self.margin,
            |proximity| {
                found.push(proximity);
            },
        );
    }

    fn corners_of_b(&self, found: &mut Vec<Proximity>) {
        let mut pairs: Vec<_> = self.pairs.iter().map(|&[a, b]| [b, a]).collect();
        pairs.sort_unstable();
        corners(
            (self.b, &self.faces_b),
            (self.a, &self.faces_a),
            &pairs,
            self.margin,
            |proximity| {
                found.push(proximity.flipped());
            },
        );
    }

    fn edges(&self, found: &mut Vec<Proximity>) {
        let ridges_a: Vec<_> = self.faces_a.iter().map(|near| ridges(self.a, near)).collect();
        let ridges_b: Vec<_> = self.faces_b.iter().map(|near| ridges(self.b, near)).collect();
        for &[a, b] in &self.pairs {
            for a in ridges_a[a as usize].iter().flatten() {
                for b in ridges_b[b as usize].iter().flatten() {
                    let range = [DEPTH_MAX, self.margin];
                    found.extend(crossing((Some(self.a), a), (Some(self.b), b), range));
                }
            }
        }
    }
}

/// The sides that a face speaks for.
fn ridges<S: Surface>(surface: &S, near: &Near) -> [Option<Ridge>; 3] {
    let mut ridges = [None; 3];
    near.sides().for_each(|side| ridges[side] = Some(Ridge::of(surface, near, side)));
    ridges
}

/// The feet of all corners of one surface on another one, as contacts from the first to the second.
fn corners<A: Surface, B: Surface>(
    (a, faces_a): (&A, &[Near]),
    (b, faces_b): (&B, &[Near]),
    pairs: &[[u32; 2]],
    margin: Real,
    mut tell: impl FnMut(Proximity),
) {
    let mut feet = Feet::default();
    for same in pairs.chunk_by(|one, other| one[0] == other[0]) {
        let own = &faces_a[same[0][0] as usize];
        for corner in own.corners() {
            let vertex = a.corners(own.face)[corner];
            let point = own.triangle.corners()[corner];
            let others = same.iter().map(|pair| &faces_b[pair[1] as usize]);
            for foot in feet.of(b, point, others, margin.max(DEPTH_MAX)) {
                if (-DEPTH_MAX..=margin).contains(&foot.separation) {
                    let features = [FeatureId::vertex(vertex), foot.feature];
                    let (on_b, separation) = (foot.position, foot.separation);
                    let contact = Contact { features, on_a: point, on_b, separation };
                    tell(Proximity { normal: foot.normal, contact });
                }
            }
        }
    }
}

/// The next place of a list of faces.
fn place(faces: &[Near]) -> u32 {
    faces.len() as u32 // at most FACES_MAX
}
