//! Two boxes: separating axes, then clipping.

use super::pair::Pair;
use super::separate::product_max;
use super::solid::box_edge;
use crate::collision::patch::{Corner, Outline, patch, to_beat};
use crate::collision::width::{Narrow, Wide, Width};
use crate::collision::{FeatureId, Manifold};
use crate::geometry::{ClosestConvex, Cuboid, closest_convex};
use crate::math::wide::{add, sub};
use crate::math::{Real, UnitVec3, Vec3};

/// Where two boxes touch, or are at most `margin` apart; `None` where they are farther. O(1).
///
/// The normal is the axis along which they overlap least, of the faces and of all pairs of edges
/// (Gottschalk, Lin and Manocha, *`OBBTree`*, 1996); those of faces come first where they are
/// nearly as good, A's before B's. Boxes may be sheared. Of boxes that are apart near corners only,
/// the separation is less than the distance.
///
/// The margin counts as in [`collide`](crate::collision::collide).
///
/// ```
/// use verlock::{Real, Vec3, real};
/// use verlock::collision::manifold_cuboid_cuboid;
/// use verlock::geometry::Cuboid;
///
/// let floor = Cuboid::upright(Vec3::ZERO, Vec3::ONE)?;
/// let crate_on_it = Cuboid::upright(Vec3::Y * real!("1.5"), Vec3::ONE * real!("0.5"))?;
/// let manifold = manifold_cuboid_cuboid(&floor, &crate_on_it, Real::ZERO).expect("they touch");
/// assert_eq!(manifold.contacts().len(), 4);
/// assert_eq!(manifold.separation(), Real::ZERO);
/// # Ok::<(), verlock::geometry::ShapeError>(())
/// ```
#[must_use]
pub fn manifold_cuboid_cuboid(a: &Cuboid, b: &Cuboid, margin: Real) -> Option<Manifold> {
    let pair = Pair::new(&a.bounds(), &b.bounds(), margin)?;
    if pair.is_narrow { manifold::<Narrow>(a, b, &pair) } else { manifold::<Wide>(a, b, &pair) }
}

fn manifold<W: Width>(a: &Cuboid, b: &Cuboid, pair: &Pair) -> Option<Manifold> {
    let (a, b) = (Posed::new(a, pair), Posed::new(b, pair));
    let way = sub(b.center, a.center);
    let of_a = a.best_face::<W>(&b, way, pair.margin)?;
    let of_b = b.best_face::<W>(&a, way, pair.margin)?;
    let best = of_a.separation.max(of_b.separation);
    match best_edges::<W>([&a, &b], way, to_beat(best), pair.margin) {
        Edges::Apart => None,
        Edges::Best(normal, [i, j]) => {
            let outlines = [a.facing::<W>(normal, i), b.facing::<W>(-normal, j)];
            patch::<W>(&pair.seam(normal), outlines.each_ref(), || closest(&a, &b))
        }
        Edges::Worse if of_b.separation > to_beat(of_a.separation) => {
            let outlines = [b.face(of_b.axis, of_b.is_against), a.facing::<W>(of_b.normal, 3)];
            let seam = pair.seam(-of_b.normal);
            Some(patch::<W>(&seam, outlines.each_ref(), || closest(&b, &a))?.flipped())
        }
        Edges::Worse => {
            let outlines = [a.face(of_a.axis, !of_a.is_against), b.facing::<W>(-of_a.normal, 3)];
            patch::<W>(&pair.seam(of_a.normal), outlines.each_ref(), || closest(&a, &b))
        }
    }
}

/// The nearest points of two boxes that are apart.
fn closest(a: &Posed, b: &Posed) -> Option<ClosestConvex> {
    let corners = |posed: &Posed| -> [Vec3; 8] {
        core::array::from_fn(|corner| Vec3::from_raw(posed.corner(corner)))
    };
    closest_convex(&corners(a), &corners(b), Vec3::ZERO, Real::ZERO)
}

/// A box, from the origin of the pair.
struct Posed {
    center: [i64; 3],
    /// Halves of them.
    edges: [[i64; 3]; 3],
    /// Each along its edge.
    normals: [UnitVec3; 3],
    /// Whether the edges are left-handed.
    is_mirrored: bool,
}

/// An axis of a face.
struct Face {
    separation: i64,
    axis: usize,
    /// Whether the normal points against the axis.
    is_against: bool,
    /// From A to B.
    normal: UnitVec3,
}

/// What the pairs of edges say.
enum Edges {
    /// There is an axis along which the boxes are farther apart than the margin.
    Apart,
    /// None is better than the faces.
    Worse,
    /// The best axis, from A to B, and the edges that it is at right angles to.
    Best(UnitVec3, [usize; 2]),
}

impl Posed {
    fn new(cuboid: &Cuboid, pair: &Pair) -> Self {
        Self {
            center: pair.local(cuboid.center()),
            edges: cuboid.half_edges().map(Vec3::raw),
            normals: cuboid.normals(),
            is_mirrored: cuboid.is_mirrored(),
        }
    }

    /// How far it reaches from its center.
    #[inline]
    fn reach<W: Width>(&self, direction: UnitVec3) -> W::Reach {
        let [x, y, z] = self.edges.map(|edge| magnitude(W::along(direction, edge)));
        x + y + z
    }

    /// The best of its faces' axes; none if one tells the boxes apart. `way` is from A to B.
    #[inline]
    fn best_face<W: Width>(&self, other: &Self, way: [i64; 3], margin: i64) -> Option<Face> {
        let mut best: Option<Face> = None;
        for (axis, &normal) in self.normals.iter().enumerate() {
            let along = W::along(normal, way);
            let reach = self.reach::<W>(normal) + other.reach::<W>(normal);
            let separation = W::round(magnitude(along) - reach);
            if separation > margin {
                return None;
            }
            if best.as_ref().is_none_or(|best| separation > best.separation) {
                let is_against = along < W::Reach::default();
                let normal = if is_against { -normal } else { normal };
                best = Some(Face { separation, axis, is_against, normal });
            }
        }
        best
    }

    /// The face at the farthest corner along `direction` that looks that way most; not the ends of
    /// edges `along` that axis.
    fn facing<W: Width>(&self, direction: UnitVec3, along: usize) -> Outline {
        let zero = W::Reach::default();
        let mut best: Option<(i64, usize, bool)> = None;
        for axis in (0..3).filter(|&axis| axis != along) {
            let is_against = W::along(direction, self.edges[axis]) < zero;
            let [n, m] = [self.normals[axis].raw(), direction.raw()];
            // Two unit vectors: at most 2^60 and a little.
            let cosine = n[0] * m[0] + n[1] * m[1] + n[2] * m[2];
            let cosine = if is_against { -cosine } else { cosine };
            if best.is_none_or(|(most, ..)| cosine > most) {
                best = Some((cosine, axis, !is_against));
            }
        }
        let (_, axis, is_along) = best.unwrap_or((0, 0, true));
        self.face(axis, is_along)
    }

    fn corner(&self, corner: usize) -> [i64; 3] {
        (0..3).fold(self.center, |at, k| {
            let edge = self.edges[k];
            if corner >> k & 1 == 1 { add(at, edge) } else { sub(at, edge) }
        })
    }

    /// The face at the end of an edge, or against it.
    fn face(&self, axis: usize, is_along: bool) -> Outline {
        let (u, v) = (NEXT[axis], LAST[axis]);
        let (u, v) = if is_along == self.is_mirrored { (v, u) } else { (u, v) };
        let end = usize::from(is_along);
        let corner = |[along_u, along_v]: [usize; 2], side: usize| {
            let corner = end << axis | along_u << u | along_v << v;
            // At most 8 corners and 3 axes.
            let (name, edge) = (corner as u32, box_edge(corner as u32, side as u32));
            Corner { at: self.corner(corner), name: FeatureId::vertex(name), edge }
        };
        let corners = [corner([0, 0], u), corner([1, 0], v), corner([1, 1], u), corner([0, 1], v)];
        let normal = if is_along { self.normals[axis] } else { -self.normals[axis] };
        Outline { face: FeatureId::face((2 * axis + end) as u32), normal, corners: corners.into() }
    }
}

/// The axis after another, and the one after that.
const NEXT: [usize; 3] = [1, 2, 0];
const LAST: [usize; 3] = [2, 0, 1];

fn magnitude<R: Ord + Copy + core::ops::Neg<Output = R>>(reach: R) -> R {
    reach.max(-reach)
}

/// The best axis at right angles to an edge of each that separates by more than `least`.
fn best_edges<W: Width>([a, b]: [&Posed; 2], way: [i64; 3], mut least: i64, margin: i64) -> Edges {
    let zero = W::Reach::default();
    let mut best = Edges::Worse;
    for i in 0..3 {
        for j in 0..if cfg!(planted) { 2 } else { 3 } {
            let cross = W::cross(a.edges[i], b.edges[j]);
            let axis = W::shorten(cross);
            let along = |d| W::along(axis, d);
            let way_along = along(way);
            let of_a = magnitude(along(a.edges[NEXT[i]])) + magnitude(along(a.edges[LAST[i]]));
            let of_b = magnitude(along(b.edges[NEXT[j]])) + magnitude(along(b.edges[LAST[j]]));
            // The separation times the length of the axis.
            let gap: i128 = (magnitude(way_along) - of_a - of_b).into();
            if gap <= product_max::<W>(least, axis) {
                continue;
            }
            let Some(normal) = W::normalize(cross) else { continue };
            let normal = if W::along(normal, way) < zero { -normal } else { normal };
            let reach = a.reach::<W>(normal) + b.reach::<W>(normal);
            let separation = W::round(W::along(normal, way) - reach);
            if separation > margin {
                return Edges::Apart;
            }
            if separation > least {
                least = separation;
                best = Edges::Best(normal, [i, j]);
            }
        }
    }
    best
}
