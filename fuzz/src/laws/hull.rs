//! Points wrapped, moved and fitted.

use std::collections::BTreeSet;

use verlock::Vec3;
use verlock::geometry::{ConvexHull, ShapeError, fit_capsule, fit_cuboid, fit_hull, fit_sphere};

use super::draw::Draw;
use super::planes::{Plane, is_corner, planes};

type Point = [i64; 3];

/// Every plane through three of them is looked at.
const POINTS_MAX: usize = 16;

/// A hull has the corners and faces that all planes give, contains what is behind them, follows an
/// integer matrix exactly, and is inside whatever fits around it. True if the points are not flat.
pub fn hull(bytes: &[u8]) -> bool {
    let mut draw = Draw::new(bytes);
    let step = [1, 2, 1 << 12, 1 << 20, 1 << 36][draw.below(5)];
    let places = 2 + draw.below(15) as i64;
    let count = 1 + draw.below(POINTS_MAX);
    let mut point = || [(); 3].map(|()| (draw.below(places as usize) as i64 - places / 2) * step);
    let points: Vec<Point> = (0..count).map(|_| point()).collect();
    let others: Vec<Point> = (0..4).map(|_| point().map(|c| c + step / 2)).collect();
    let distinct: Vec<Point> = BTreeSet::from_iter(points.iter().copied()).into_iter().collect();
    let planes = planes(&distinct.iter().map(|p| p.map(i128::from)).collect::<Vec<_>>());
    let hull = match ConvexHull::around(vectors(&points)) {
        Ok(hull) => hull,
        Err(error) => {
            assert_eq!((error, planes.len()), (ShapeError::Flat, 0), "{points:?}");
            return false;
        }
    };
    has_faces(&hull, &distinct, &planes);
    for point in points.iter().chain(&others) {
        let inside = planes.iter().all(|plane| plane.is_before(&point.map(i128::from)));
        assert_eq!(hull.contains(Vec3::from_raw(*point)), inside, "{point:?} of {points:?}");
    }
    let matrix = [(); 3].map(|()| [(); 3].map(|()| draw.below(5) as i64 - 2));
    follows(&hull, &matrix, &others);
    is_inside_of_fits(&hull, 4 + draw.below(8));
    true
}

fn vectors(points: &[Point]) -> impl Iterator<Item = Vec3> {
    points.iter().map(|&p| Vec3::from_raw(p))
}

fn has_faces(hull: &ConvexHull, points: &[Point], planes: &[Plane<i128>]) {
    let corners = (0..points.len()).filter(|&k| is_corner(planes, k)).map(|k| points[k]);
    let corners: BTreeSet<Point> = corners.collect();
    let found: Vec<Point> = hull.vertices().iter().map(|p| p.raw()).collect();
    assert!(corners.iter().eq(&BTreeSet::from_iter(found.iter().copied())), "{points:?}");
    let face = |plane: &Plane<i128>| -> BTreeSet<Point> {
        plane.points.iter().map(|&k| points[k]).filter(|p| corners.contains(p)).collect()
    };
    let faces: BTreeSet<_> = planes.iter().map(face).collect();
    let of_hull = hull.faces().map(|face| face.iter().map(|&k| found[k as usize]).collect());
    assert_eq!(of_hull.collect::<BTreeSet<BTreeSet<Point>>>(), faces, "{points:?}");
    let euler = found.len() + faces.len() - hull.edges().len();
    assert_eq!(euler, 2, "{points:?}");
}

/// Where a matrix moves a hull, the same points are inside.
fn follows(hull: &ConvexHull, matrix: &[Point; 3], points: &[Point]) {
    let times = |p: Point| matrix.map(|row| (0..3).map(|k| row[k] * p[k]).sum::<i64>());
    let places: Vec<Vec3> =
        hull.vertices().iter().map(|p| Vec3::from_raw(times(p.raw()))).collect();
    let [a, b, c] = matrix.map(|row| row.map(i128::from));
    let determinant = super::oracle::dot(&super::oracle::cross(&a, &b), &c);
    let mut moved = hull.clone();
    let expected = match determinant {
        1.. => Ok(()),
        0 => Err(ShapeError::Flat),
        ..0 => Err(ShapeError::Mirrored),
    };
    let result = moved.moved_to(&places);
    if result == Err(ShapeError::TooLong) {
        return;
    }
    assert_eq!(result, expected, "{hull:?} by {matrix:?}");
    for &point in points {
        let there = moved.contains(Vec3::from_raw(times(point)));
        let here = hull.contains(Vec3::from_raw(point));
        assert!(result.is_err() || here == there, "{point:?} by {matrix:?} of {hull:?}");
    }
}

fn is_inside_of_fits(hull: &ConvexHull, vertices_max: usize) {
    if let Ok(fit) = fit_sphere(hull) {
        let center = fit.shape.center();
        let far = hull.vertices().iter().map(|&p| (p - center).length_sq_wide()).max();
        let radius = u128::from(fit.shape.radius().raw().unsigned_abs());
        assert!(far <= Some(radius * radius), "{fit:?} of {hull:?}");
    }
    if let Ok(fit) = fit_cuboid(hull) {
        // The hull of rounded corners is the box itself.
        let cuboid = ConvexHull::around(fit.shape.corners()).expect("solid");
        assert!(hull.vertices().iter().all(|&p| cuboid.contains(p)), "{fit:?} of {hull:?}");
    }
    if let Ok(fit) = fit_capsule(hull) {
        assert!(fit.deviation <= fit.shape.radius() + fit.shape.radius(), "{fit:?} of {hull:?}");
    }
    if let Ok(fit) = fit_hull(hull, vertices_max as u32) {
        assert!(fit.shape.vertices().len() <= vertices_max, "{fit:?} of {hull:?}");
        assert!(hull.vertices().iter().all(|&p| fit.shape.contains(p)), "{fit:?} of {hull:?}");
    }
}
