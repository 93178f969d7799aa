//! Cylinders, cones, and the circles that they stand on.

use std::f64::consts::TAU;

use verlock::geometry::{ConvexHull, ShapeError, Sphere};
use verlock::math::trig::cos_sin;
use verlock::math::{Pcg, Unit};
use verlock::{Real, Vec3, real};

use super::measure::{length, metres, place, product, sub};

/// Cosines and sines are those of the processor, to half a unit and what the latter is wrong by.
#[test]
fn circles_are_round() {
    let mut rng = Pcg::new(8, 0);
    let small = (1..200).flat_map(|whole| (0..whole + 3).map(move |part| (part, whole)));
    let large = (0..20_000).map(|_| (rng.next_u32(), rng.next_u32().max(1))).collect::<Vec<_>>();
    for (part, whole) in small.chain(large) {
        let angle = f64::from(part % whole) / f64::from(whole) * TAU;
        let expected = [angle.cos(), angle.sin()].map(|c| c * f64::from(Unit::ONE.raw()));
        let found = cos_sin(part, whole).map(|c| f64::from(c.raw()));
        let error = [0, 1].map(|k| (expected[k] - found[k]).abs());
        assert!(error.iter().all(|&error| error < 0.501), "{part} / {whole}: {error:?}");
    }
}

/// Octants mirror one another to the bit.
#[test]
fn circles_are_symmetric() {
    for whole in [8, 24, 360, 1000, 1 << 20, u32::MAX / 8 * 8] {
        for part in [0, 1, 2, whole / 16, whole / 8 - 1, whole / 8] {
            let [cos, sin] = cos_sin(part, whole).map(Unit::raw);
            let quarter = whole / 4;
            let at = |part: u32| cos_sin(part, whole).map(Unit::raw);
            assert_eq!(at(quarter - part), [sin, cos]);
            assert_eq!(at(quarter + part), [-sin, cos]);
            assert_eq!(at(2 * quarter - part), [-cos, sin]);
            assert_eq!(at(2 * quarter + part), [-cos, -sin]);
            assert_eq!(at((4 * quarter - part) % whole), [cos, -sin]);
        }
    }
}

fn pose(rng: &mut Pcg, reach: Real) -> [Vec3; 2] {
    [(); 2].map(|()| Vec3::from_raw([(); 3].map(|()| rng.real(-reach, reach).raw())))
}

/// Corners are on their circles, in order, and faces are what a prism and a pyramid have.
#[test]
fn round_hulls_stand_on_circles() {
    let mut rng = Pcg::new(9, 0);
    for sides in [3, 4, 5, 8, 16, 64, 256] {
        for radius in [real!("0.004"), real!("1"), real!("30")] {
            for reach in [real!("0.5"), real!("20"), real!("30000")] {
                let ends = pose(&mut rng, reach);
                let prism = ConvexHull::cylinder(ends, radius, sides).expect("solid");
                let n = sides as usize;
                let counts = [prism.vertices().len(), prism.faces().len(), prism.edges().len()];
                assert_eq!(counts, [2 * n, n + 2, 3 * n]);
                are_on_circle(&prism.vertices()[..n], ends, radius);
                are_on_circle(
                    &prism.vertices()[n..],
                    [ends[1], ends[1] + ends[1] - ends[0]],
                    radius,
                );
                let pyramid = ConvexHull::cone(ends[0], ends[1], radius, sides).expect("solid");
                let counts = [pyramid.vertices().len(), pyramid.faces().len()];
                assert_eq!(counts, [n + 1, n + 1]);
                assert_eq!(pyramid.vertices()[..n], prism.vertices()[..n]);
                assert_eq!(pyramid.vertices()[n], ends[1]);
                for hull in [prism, pyramid] {
                    assert!(hull.vertices().iter().all(|&v| hull.contains(v)));
                }
            }
        }
    }
}

/// All corners are as far from the axis as they should be, across it, and each as far from the
/// next.
fn are_on_circle(corners: &[Vec3], axis: [Vec3; 2], radius: Real) {
    let way = sub(place(axis[1] - axis[0]), [0.0; 3]);
    let way = way.map(|c| c / length(way));
    let arms: Vec<_> = corners.iter().map(|&corner| place(corner - axis[0])).collect();
    let tolerance = metres(radius) * 2f64.powi(-26) + metres(Real::ULP);
    let side = 2.0 * metres(radius) * (TAU / 2.0 / arms.len() as f64).sin();
    for (k, &arm) in arms.iter().enumerate() {
        assert!((length(arm) - metres(radius)).abs() <= tolerance);
        assert!(product(arm, way).abs() <= tolerance);
        let next = arms[(k + 1) % arms.len()];
        assert!((length(sub(next, arm)) - side).abs() <= 2.0 * tolerance);
        let turn = [1, 2, 0].map(|k| arm[k] * next[(k + 1) % 3] - arm[(k + 1) % 3] * next[k]);
        let turn = [turn[0], turn[1], turn[2]];
        assert!(product(turn, way) > 0.0, "counter-clockwise about the axis");
    }
}

/// However flat, a round hull holds its corners, or there is none.
#[test]
fn flat_round_hulls_hold_their_corners() {
    let apex = Vec3::from_raw([2, -1, -2]);
    let cone = ConvexHull::cone(Vec3::ZERO, apex, Real::from_raw(169), 13);
    assert_eq!(cone.err(), Some(ShapeError::Flat));
    let mut rng = Pcg::new(1, 60);
    let mut made = 0;
    for _ in 0..4_000 {
        let most = [4, 16, 256, 1 << 12][rng.below(4) as usize];
        let end =
            Vec3::from_raw([(); 3].map(|()| i64::from(rng.below(most)) - i64::from(most / 2)));
        let sides = 3 + rng.below(14);
        let radius = Real::from_raw(i64::from(sides * sides + rng.below(most)));
        let cone = ConvexHull::cone(Vec3::ZERO, end, radius, sides);
        let prism = ConvexHull::cylinder([Vec3::ZERO, end], radius, sides);
        for hull in [cone, prism].into_iter().flatten() {
            assert!(hull.vertices().iter().all(|&v| hull.contains(v)), "{end:?} {radius} {sides}");
            made += 1;
        }
    }
    assert!(made > 4_000, "{made}");
}

/// Numbers out of range are named.
#[test]
fn bad_round_hulls_are_refused() {
    let ends = [Vec3::ZERO, Vec3::Y];
    let refused = |radius, sides| ConvexHull::cylinder(ends, radius, sides).err();
    let too_many = Some(ShapeError::WrongCount("sides"));
    assert_eq!(refused(Real::ONE, 2), too_many);
    assert_eq!(refused(Real::ONE, ConvexHull::SIDES_MAX + 1), too_many);
    assert_eq!(refused(Real::ONE, u32::MAX), too_many);
    assert_eq!(refused(Real::ZERO, 3), too_many);
    assert_eq!(refused(Real::from_raw(63), 8), too_many);
    assert_eq!(refused(Real::from_raw(64), 8), None);
    assert_eq!(refused(-Real::ONE, 8), Some(ShapeError::Negative("radius")));
    assert_eq!(refused(Sphere::RADIUS_MAX + Real::ULP, 8), Some(ShapeError::TooLarge("radius")));
    assert_eq!(refused(Sphere::RADIUS_MAX, 8), None);
    let between = |a, b| ConvexHull::cylinder([a, b], Real::ONE, 8).err();
    assert_eq!(between(Vec3::X, Vec3::X), Some(ShapeError::Flat));
    let far = Vec3::from_raw([0, (1 << 60) + 1, 0]);
    assert_eq!(between(Vec3::X, far), Some(ShapeError::OutOfRange("end 1")));
    assert_eq!(between(Vec3::X, -far), Some(ShapeError::OutOfRange("end 1")));
    let edge = Vec3::from_raw([1 << 60, 0, 0]);
    assert_eq!(between(edge, edge + Vec3::Y), Some(ShapeError::OutOfRange("vertices")));
    assert_eq!(between(-edge, edge), Some(ShapeError::TooLong));
    let long = Vec3::Z * Real::from_int(1 << 17);
    assert_eq!(between(Vec3::ZERO, long), Some(ShapeError::TooLong));
}
