//! Any two convex shapes: whether and where they touch.

use verlock::collision::{Manifold, Shape, manifold_convex_convex, overlap};
use verlock::geometry::{Aabb, Capsule, ConvexHull, Cuboid, HalfSpace, Sphere, Triangle};
use verlock::math::{Real, UnitVec3, Vec3};

use super::draw::Draw;

/// A tenth of a millimetre, raw: what a manifold may be wrong by.
const TOLERANCE: i64 = 1_677;

/// Shapes that overlap have a manifold, and only those have a depth; moved as far as it says they
/// do not overlap; and moved together they have the same one. True if they touch.
pub fn manifold(bytes: &[u8]) -> bool {
    let mut draw = Draw::new(bytes);
    let unit = [1 << 20, 1, 1 << 14, 1 << 24][draw.below(4)];
    let grid = [4, 1, 100, 1_000][draw.below(4)];
    let mut point = |draw: &mut Draw<'_>| {
        Vec3::from_raw([(); 3].map(|()| unit * (i64::from(draw.any::<i16>()) % (grid + 1))))
    };
    let [a, b] = [(); 2].map(|()| shape(&mut draw, &mut point));
    let (Some(a), Some(b)) = (a, b) else { return false };
    let margin = Real::from_raw([0, unit, 1 << 17][draw.below(3)]);
    let found = manifold_convex_convex(&a, &b, margin);
    if matches!((&a, &b), (Shape::HalfSpace(_), Shape::HalfSpace(_))) {
        assert_eq!(found, None);
        return false;
    }
    if overlap(&a, &b) {
        let wide = || manifold_convex_convex(&a, &b, margin.max(Real::ZERO) + rounding(&a, &b));
        let found = found.or_else(wide).expect("what overlaps touches");
        assert!(found.separation().raw() < TOLERANCE, "{a:?} {b:?}: {found:?}");
    }
    let Some(found) = found else { return false };
    let is_deep = found.separation().raw() < -TOLERANCE;
    assert!(!is_deep || overlap(&a, &b), "{a:?} {b:?} are apart: {found:?}");
    parts(&a, &b, &found);
    let way = Vec3::from_raw([(); 3].map(|()| draw.any::<i64>() >> 5));
    let [p, q] = [&a, &b].map(|shape| moved(shape, way));
    let there = manifold_convex_convex(&p, &q, margin).expect("they touch elsewhere too");
    let same = found.contacts().iter().zip(there.contacts()).all(|(here, there)| {
        let on = [here.on_a + way, here.on_b + way] == [there.on_a, there.on_b];
        on && (here.features, here.separation) == (there.features, there.separation)
    });
    assert!(same && found.normal == there.normal, "{a:?} {b:?}: {found:?} moves to {there:?}");
    true
}

/// What axes are wrong by at most: a unit, and 2^-29 of what both shapes span.
fn rounding(a: &Shape, b: &Shape) -> Real {
    let bounds = [a, b].into_iter().filter_map(Shape::bounds).reduce(Aabb::union);
    Real::from_raw(1 + bounds.map_or(0, |bounds| (bounds.span() >> 29) as i64))
}

/// Moved along the normal by the depth and a little, B no longer overlaps A.
fn parts(a: &Shape, b: &Shape, found: &Manifold) {
    let depth = i128::from(TOLERANCE - found.separation().raw().min(0));
    let way = found.normal.raw().map(|n| ((i128::from(n) * depth) >> 30) as i64);
    let left = moved(b, Vec3::from_raw(way));
    assert!(!overlap(a, &left), "{a:?} {b:?} still overlap: {found:?}");
}

/// A shape; none of what is not one.
fn shape(draw: &mut Draw<'_>, point: &mut impl FnMut(&mut Draw<'_>) -> Vec3) -> Option<Shape> {
    let radius = |draw: &mut Draw<'_>, p: Vec3| if draw.any() { p.x.max(-p.x) } else { Real::ZERO };
    Some(match draw.below(6) {
        0 => Cuboid::new(point(draw), [point(draw), point(draw), point(draw)]).ok()?.into(),
        1 => {
            let points = 4 + draw.below(8);
            ConvexHull::around((0..points).map(|_| point(draw))).ok()?.into()
        }
        2 => {
            let [ends, size] = [[point(draw), point(draw)], [point(draw); 2]];
            Capsule::new(ends, radius(draw, size[0])).ok()?.into()
        }
        3 => {
            let [center, size] = [point(draw), point(draw)];
            Sphere::new(center, radius(draw, size)).ok()?.into()
        }
        4 => Triangle::new([point(draw), point(draw), point(draw)]).ok()?.into(),
        _ => HalfSpace::new(point(draw), UnitVec3::normalize(point(draw))?).ok()?.into(),
    })
}

/// The shape elsewhere, which is in range.
fn moved(shape: &Shape, way: Vec3) -> Shape {
    let moved = |point: Vec3| point + way;
    let shape: Option<Shape> = match shape {
        Shape::Sphere(it) => Sphere::new(moved(it.center()), it.radius()).ok().map(Shape::from),
        Shape::Capsule(it) => Capsule::new(it.ends().map(moved), it.radius()).ok().map(Shape::from),
        Shape::Cuboid(it) => Cuboid::new(moved(it.center()), it.half_edges()).ok().map(Shape::from),
        Shape::Triangle(it) => Triangle::new(it.corners().map(moved)).ok().map(Shape::from),
        Shape::HalfSpace(it) => {
            HalfSpace::new(moved(it.point()), it.normal()).ok().map(Shape::from)
        }
        Shape::ConvexHull(it) => {
            let vertices: Vec<_> = it.vertices().iter().map(|&vertex| moved(vertex)).collect();
            let mut hull = it.clone();
            hull.moved_to(&vertices).ok().map(|()| hull.into())
        }
        _ => None,
    };
    shape.expect("in range")
}
