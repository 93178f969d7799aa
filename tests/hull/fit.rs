//! What fits around hulls: contains them, deviates as it says, and is hardly larger than it must
//! be.

use verlock::geometry::{
    ConvexHull, Fit, ShapeError, fit_capsule, fit_cuboid, fit_hull, fit_sphere,
};
use verlock::math::{Pcg, Unit};
use verlock::{Real, Vec3, real};

use super::measure::{self, Place, direction, length, metres, place, product, sub};
use super::{Cloud, Point, hull};

/// Metres to raw places.
fn raw(p: Place) -> Point {
    p.map(|c| (c * 16_777_216.0).round() as i64)
}

/// Points on a ball, on a rod, in a box, in flat boxes, and cylinders and cones.
fn shapes() -> Vec<ConvexHull> {
    let mut rng = Pcg::new(11, 0);
    let mut ball = |count: u32, stretch: Place, shift: Place| -> ConvexHull {
        let point = |p: Place| raw([0, 1, 2].map(|k| p[k] * stretch[k] + shift[k]));
        hull(&(0..count).map(|_| point(direction(&mut rng))).collect::<Vec<_>>())
    };
    let mut shapes = vec![
        ball(60, [1.0; 3], [0.0; 3]),
        ball(30, [0.2, 1.0, 3.0], [1000.0, -7.0, 0.3]),
        ball(40, [40.0, 40.0, 2.0], [0.0; 3]),
        ball(12, [0.01, 0.02, 0.02], [3e7, 0.0, 1.0]),
        hull(&[[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]].map(|p| p.map(|c| c << 24))),
    ];
    let ends = [Vec3::ZERO, Vec3::from_ints(1, 2, 3)];
    shapes.push(ConvexHull::cylinder(ends, real!("0.5"), 24).expect("solid"));
    shapes.push(ConvexHull::cone(ends[0], ends[1], real!("1.5"), 16).expect("solid"));
    let mut rng = Pcg::new(12, 0);
    for (places, step) in [(2, 1 << 24), (9, 1), (5, 1 << 22), (1000, 1 << 29)] {
        shapes.push(hull(&Cloud { points: 40, places, step, origin: [-9; 3] }.draw(&mut rng)));
    }
    shapes
}

/// The tolerance of a deviation: what is promised, and what floats and their descent lose.
fn tolerance(hull: &ConvexHull) -> f64 {
    let size = length(sub(place(hull.bounds().max()), place(hull.bounds().min())));
    let from = hull.vertices().iter().map(|&p| length(place(p))).fold(0.0, f64::max);
    size * 1e-6 + 3.0 * metres(Real::ULP) + from * 2f64.powi(-48)
}

/// The vertices from the first one: floats hold them.
fn local(hull: &ConvexHull) -> (Vec3, Vec<Place>) {
    let origin = hull.vertices()[0];
    (origin, hull.vertices().iter().map(|&p| place(p - origin)).collect())
}

/// Every fit contains every vertex, in integers of any size.
#[test]
fn fits_contain_the_hull() {
    for hull in shapes() {
        let contains = |inside: &dyn Fn(Vec3) -> bool| hull.vertices().iter().all(|&p| inside(p));
        match fit_sphere(&hull) {
            Ok(fit) => assert!(contains(&|p| measure::sphere_contains(&fit.shape, p))),
            Err(error) => assert_eq!(error, ShapeError::TooLarge("radius")),
        }
        match fit_capsule(&hull) {
            Ok(fit) => assert!(contains(&|p| measure::capsule_contains(&fit.shape, p))),
            Err(error) => assert_eq!(error, ShapeError::TooLarge("radius")),
        }
        let fit = fit_cuboid(&hull).expect("in range");
        assert!(contains(&|p| measure::cuboid_contains(&fit.shape, p)));
        for vertices_max in [4, 5, 8, 13, 32] {
            let fit = fit_hull(&hull, vertices_max).expect("in range");
            assert!(fit.shape.vertices().len() <= vertices_max as usize);
            // A hull that is its own fit may be a moved one, with faces that are not quite flat.
            let is_own = fit.shape == hull;
            assert!(is_own || contains(&|p| measure::hull_contains(&fit.shape, p)));
        }
    }
}

/// The greatest distance from the hull of some points of the shape is the deviation, up to how
/// densely they lie; none is farther.
fn check(hull: &ConvexHull, deviation: Real, samples: &[Place], density: f64) {
    let (_, points) = local(hull);
    let distances = samples.iter().map(|&p| measure::distance(&points, p));
    let greatest = distances.fold(0.0, f64::max);
    let (said, tolerance) = (metres(deviation), tolerance(hull));
    assert!(greatest <= said + tolerance, "{greatest} m, not {said} m");
    assert!(greatest >= said - density - tolerance, "only {greatest} m, not {said} m");
}

/// Deviations are what sampling finds.
#[test]
fn deviations_are_those_of_samples() {
    let mut rng = Pcg::new(13, 0);
    for hull in shapes() {
        let (origin, points) = local(&hull);
        let corners = |corners: &[Vec3]| -> Vec<Place> {
            corners.iter().map(|&corner| place(corner - origin)).collect()
        };
        let fit = fit_cuboid(&hull).expect("in range");
        check(&hull, fit.deviation, &corners(&fit.shape.corners()), 0.0);
        for vertices_max in [4, 9, 20] {
            let fit = fit_hull(&hull, vertices_max).expect("in range");
            check(&hull, fit.deviation, &corners(fit.shape.vertices()), 0.0);
        }
        // Of something round the farthest point is where the hull reaches least beyond its middle.
        let round = |ends: &[Vec3], radius: Real, deviation: Real, rng: &mut Pcg| {
            let mut greatest = f64::NEG_INFINITY;
            for _ in 0..4000 {
                let way = direction(rng);
                for end in corners(ends) {
                    let beyond = product(end, way) + metres(radius);
                    greatest = greatest.max(beyond - measure::support(&points, way));
                }
            }
            let (said, tolerance) = (metres(deviation), tolerance(&hull));
            assert!(greatest <= said + tolerance, "{greatest} m, not {said} m");
            let size = metres(radius) + length(points[0]);
            assert!(greatest >= said - 0.1 * size - tolerance, "only {greatest} m, not {said} m");
        };
        if let Ok(Fit { shape, deviation }) = fit_sphere(&hull) {
            round(&[shape.center()], shape.radius(), deviation, &mut rng);
        }
        if let Ok(Fit { shape, deviation }) = fit_capsule(&hull) {
            round(&shape.ends(), shape.radius(), deviation, &mut rng);
        }
    }
}

/// The smallest ball by walking towards the farthest point by ever smaller steps.
fn smallest_radius(points: &[Place]) -> f64 {
    let mut center = points[0];
    let farthest = |center: Place| {
        let far = |p: &&Place| length(sub(**p, center));
        *points.iter().max_by(|a, b| far(a).total_cmp(&far(b))).expect("points")
    };
    for round in 1..20_000 {
        center = measure::along(center, farthest(center), 1.0 / f64::from(round + 1));
    }
    length(sub(farthest(center), center))
}

/// Balls are the smallest ones, to a thousandth, which is what the walk is good for, and better.
#[test]
fn spheres_are_the_smallest() {
    for hull in shapes() {
        let Ok(fit) = fit_sphere(&hull) else { continue };
        let (_, points) = local(&hull);
        let (radius, smallest) = (metres(fit.shape.radius()), smallest_radius(&points));
        let more = radius - smallest;
        assert!(more <= smallest * 1e-6 + tolerance(&hull), "{radius} m, not {smallest} m");
    }
}

/// A frame of three directions at right angles.
fn frame(rng: &mut Pcg) -> [Place; 3] {
    let cross = |a: Place, b: Place| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let (x, y) = (direction(rng), direction(rng));
    let z = cross(x, y);
    let z = z.map(|c| c / length(z));
    [x, cross(z, x), z]
}

/// No box in any of many directions is smaller by more than a hundredth.
#[test]
fn cuboids_are_small() {
    let mut rng = Pcg::new(14, 0);
    for hull in shapes() {
        let (_, points) = local(&hull);
        let extent = |way: Place| {
            measure::support(&points, way) + measure::support(&points, way.map(|c| -c))
        };
        let fit = fit_cuboid(&hull).expect("in range");
        let sides = fit.shape.half_edges().map(|half| 2.0 * length(place(half)));
        let volume: f64 = sides.iter().product();
        let slack =
            sides.map(|side| (side + 4.0 * tolerance(&hull)) / side).iter().product::<f64>();
        for _ in 0..3000 {
            let other: f64 = frame(&mut rng).map(extent).iter().product();
            assert!(volume <= other * 1.01 * slack, "{volume} m3, not {other} m3");
        }
    }
}

/// Around any of many axes through the middle of the fit no capsule is smaller by more than a
/// twentieth; and those of rods are the rods.
#[test]
fn capsules_are_small() {
    let mut rng = Pcg::new(15, 0);
    for hull in shapes() {
        let Ok(fit) = fit_capsule(&hull) else { continue };
        let (origin, points) = local(&hull);
        let [a, b] = fit.shape.ends().map(|end| place(end - origin));
        let volume = |radius: f64, long: f64| radius * radius * (4.0 * radius + 3.0 * long);
        let own = volume(metres(fit.shape.radius()), length(sub(b, a)));
        let slack = 1.0 + 8.0 * tolerance(&hull) / metres(fit.shape.radius());
        let middle = measure::along(a, b, 0.5);
        for _ in 0..3000 {
            let axis = direction(&mut rng);
            let parts = points.iter().map(|&p| {
                let way = sub(p, middle);
                let t = product(way, axis);
                (t, product(way, way) - t * t)
            });
            let parts: Vec<_> = parts.collect();
            let radius_sq = parts.iter().map(|part| part.1).fold(0.0, f64::max);
            let reach = |part: &(f64, f64)| (radius_sq - part.1).max(0.0).sqrt();
            let low = parts.iter().map(|part| part.0 + reach(part)).fold(f64::INFINITY, f64::min);
            let high = parts.iter().map(|part| part.0 - reach(part)).fold(-f64::INFINITY, f64::max);
            let other = volume(radius_sq.sqrt(), (high - low).max(0.0));
            assert!(own <= other * 1.05 * slack, "{own}, not {other}");
        }
    }
    let ends = [Vec3::ZERO, Vec3::from_ints(4, -3, 12)];
    let rod = ConvexHull::cylinder(ends, real!("0.25"), 32).expect("solid");
    let fit = fit_capsule(&rod).expect("in range").shape;
    assert!(fit.radius() < real!("0.2501"), "{:?}", fit.radius());
    assert!(fit.ends()[0].distance(fit.ends()[1]) < real!("13.01"));
}

/// What fits a hull fits it elsewhere as well, to the bit.
#[test]
fn fits_move_with_the_hull() {
    let way = Vec3::from_raw([12_345_678_901, -(1 << 58), 1]);
    let low = |hull: &ConvexHull| hull.bounds().max() < Vec3::ONE * real!("9999");
    for here in shapes().into_iter().filter(low) {
        let here = ConvexHull::around(here.vertices().iter().copied()).expect("solid");
        let there = ConvexHull::around(here.vertices().iter().map(|&p| p + way)).expect("in range");
        if let (Ok(a), Ok(b)) = (fit_sphere(&here), fit_sphere(&there)) {
            let same = (a.shape.center() + way, a.shape.radius(), a.deviation);
            assert_eq!(same, (b.shape.center(), b.shape.radius(), b.deviation));
        }
        if let (Ok(a), Ok(b)) = (fit_capsule(&here), fit_capsule(&there)) {
            let same = (a.shape.ends().map(|end| end + way), a.shape.radius(), a.deviation);
            assert_eq!(same, (b.shape.ends(), b.shape.radius(), b.deviation));
        }
        let (a, b) = (fit_cuboid(&here).expect("fits"), fit_cuboid(&there).expect("fits"));
        let same = (a.shape.center() + way, a.shape.half_edges(), a.deviation);
        assert_eq!(same, (b.shape.center(), b.shape.half_edges(), b.deviation));
        let (a, b) = (fit_hull(&here, 9).expect("fits"), fit_hull(&there, 9).expect("fits"));
        assert_eq!(a.deviation, b.deviation);
        assert_eq!(a.shape.topology(), b.shape.topology());
        let shifted = a.shape.vertices().iter().map(|&p| p + way);
        assert!(shifted.eq(b.shape.vertices().iter().copied()));
    }
}

/// Hulls of few vertices are their own fits, fewer than four are none; what is round or in a box is
/// fitted as well as it should be.
#[test]
fn fewer_vertices_deviate_little() {
    let ends = [Vec3::ZERO, Vec3::from_ints(1, 2, 3)];
    let cylinder = ConvexHull::cylinder(ends, real!("0.5"), 64).expect("solid");
    assert_eq!(
        fit_hull(&cylinder, 128),
        Ok(Fit { shape: cylinder.clone(), deviation: Real::ZERO })
    );
    assert_eq!(fit_hull(&cylinder, 3), Err(ShapeError::WrongCount("vertices")));
    // Deviations that are usual, of a radius of 0.5 m.
    for (vertices_max, most) in [(64, "0.006"), (32, "0.03"), (16, "0.11"), (8, "0.7")] {
        let fit = fit_hull(&cylinder, vertices_max).expect("fits");
        let most = Real::parse(most).expect("a number");
        assert!(fit.deviation < most, "{vertices_max}: {} m", metres(fit.deviation));
    }
    let cube =
        hull(&[0, 1, 2, 3, 4, 5, 6, 7].map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|c| c << 24)));
    assert_eq!(fit_hull(&cube, 8).expect("fits").shape, cube);
    assert_eq!(fit_hull(&cube, 7).expect("fits").shape.vertices().len(), 4);
    let unit = fit_cuboid(&cube).expect("fits");
    assert!(unit.deviation <= Real::from_raw(4), "{:?}", unit.deviation);
    assert_eq!(Unit::ONE.raw(), 1 << 30);
}
