//! What of a surface hangs together, and whether it is free where it is moved to.

use alloc::vec;
use alloc::vec::Vec;

use crate::geometry::{Aabb, Surface, Triangle, overlap_triangle_triangle};
use crate::math::wide::add;
use crate::math::{Real, Vec3};

/// Faces that are joined by vertices, and their vertices, both without order.
#[derive(Debug, Default)]
pub(super) struct Shell {
    pub(super) faces: Vec<u32>,
    pub(super) vertices: Vec<(u32, Vec3)>,
}

impl Shell {
    /// All that hangs together with some faces. O(n) for n faces, and the highest number of any.
    pub(super) fn of<S: Surface>(surface: &S, faces: &[u32]) -> Self {
        let (mut seen_faces, mut seen_vertices) = (Seen::default(), Seen::default());
        let mut shell = Self::default();
        shell.faces.extend(faces.iter().filter(|&&face| seen_faces.is_new(face)));
        let mut next = 0;
        while let Some(&face) = shell.faces.get(next) {
            next += 1;
            for vertex in surface.corners(face) {
                if seen_vertices.is_new(vertex) {
                    shell.vertices.push((vertex, surface.position(vertex)));
                    let around = surface.faces_at_vertex(vertex);
                    shell.faces.extend(around.filter(|&face| seen_faces.is_new(face)));
                }
            }
        }
        shell
    }
}

/// Which numbers have been seen.
#[derive(Default)]
struct Seen(Vec<bool>);

impl Seen {
    fn is_new(&mut self, number: u32) -> bool {
        let place = number as usize;
        if place >= self.0.len() {
            self.0.resize(2 * place + 1, false);
        }
        !core::mem::replace(&mut self.0[place], true)
    }
}

/// Whether some faces of a surface, moved by a way, meet no face of another one: exactly.
///
/// O((k + m) log(k + m)) for k faces and m of the other surface near the box around them, and a
/// little for each pair that is near one another along x.
pub(super) fn is_free<S: Surface, T: Surface>(
    (surface, faces): (&S, &[u32]),
    way: [i64; 3],
    other: &T,
) -> bool {
    let moved = |corner: &Vec3| Vec3::from_raw(add(corner.raw(), way));
    // Faces are within 2^60 and move by less than 2^62: what overlaps the box around a face of the
    // other surface is within 2^61, and only that is asked whether it meets one.
    let own = faces.iter().map(|&face| surface.triangle(face).corners().each_ref().map(moved));
    let own = sorted(own.map(Triangle::between));
    let Some(bounds) = own.iter().map(|face| face.0).reduce(Aabb::union) else { return true };
    let mut near = vec![];
    other.faces_near(&bounds, &mut near);
    let others = sorted(near.into_iter().map(|face| other.triangle(face)));
    let start = |face: &Boxed| face.0.min().x.raw();
    // Each pair at that of the two which begins first, or at our own.
    let behind = |face: &Boxed| others.partition_point(|other| start(other) < start(face));
    let after = |face: &Boxed| own.partition_point(|other| start(other) <= start(face));
    own.iter().all(|face| misses(face, &others[behind(face)..]))
        && others.iter().all(|face| misses(face, &own[after(face)..]))
}

/// A face and its box.
type Boxed = (Aabb, Triangle);

/// By where they begin along x.
fn sorted(faces: impl Iterator<Item = Triangle>) -> Vec<Boxed> {
    let mut boxed: Vec<_> = faces.map(|face| (face.bounds(), face)).collect();
    boxed.sort_unstable_by_key(|(bounds, _)| bounds.min().x);
    boxed
}

/// Whether a face meets none of those that begin in it or behind it.
fn misses((bounds, face): &Boxed, others: &[Boxed]) -> bool {
    let end: Real = bounds.max().x;
    let mut near = others.iter().take_while(|(other, _)| other.min().x <= end);
    near.all(|(other, triangle)| {
        !bounds.overlaps(other) || !overlap_triangle_triangle(face, triangle)
    })
}
