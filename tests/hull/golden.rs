//! Hulls and fits as they were accepted: the same on every machine.

use verlock::Hash;
use verlock::geometry::{ConvexHull, fit_capsule, fit_cuboid, fit_hull, fit_sphere};
use verlock::math::Pcg;

use super::{Cloud, vectors};

/// Numbers to be hashed.
#[derive(Default)]
struct Bytes(Vec<u8>);

impl Bytes {
    fn add(&mut self, numbers: impl IntoIterator<Item = i64>) {
        self.0.extend(numbers.into_iter().flat_map(i64::to_le_bytes));
    }

    fn hull(&mut self, hull: &ConvexHull) {
        self.0.extend(hull.topology().content_hash().to_bytes());
        self.add(hull.vertices().iter().flat_map(|p| p.raw()));
        self.add(hull.normals().iter().flat_map(|n| n.raw()));
        self.add(hull.anchors().iter().copied().map(i64::from));
    }
}

/// Hulls with all that they are made of, cylinders and cones, and everything that is fitted.
#[test]
fn hulls_and_fits_are_as_accepted() {
    let mut rng = Pcg::new(2026, 0);
    let (mut hulls, mut fits) = (Bytes::default(), Bytes::default());
    for round in 0..24 {
        let step = [1, 1 << 20, 1 << 26, 1 << 35][round % 4];
        let places = [3, 8, 8][round % 3];
        let points = Cloud { points: 24, places, step, origin: [7 << 50, 0, -5] }.draw(&mut rng);
        let hull = ConvexHull::around(vectors(&points)).expect("solid");
        hulls.hull(&hull);
        let [a, b] = [hull.bounds().min(), hull.bounds().max()];
        if let Ok(prism) = ConvexHull::cylinder([a, b], a.distance(b), 8) {
            hulls.hull(&prism);
        }
        if let Ok(pyramid) = ConvexHull::cone(a, b, a.distance(b), 7) {
            hulls.hull(&pyramid);
        }
        if let Ok(fit) = fit_sphere(&hull) {
            fits.add(fit.shape.center().raw());
            fits.add([fit.shape.radius().raw(), fit.deviation.raw()]);
        }
        if let Ok(fit) = fit_capsule(&hull) {
            fits.add(fit.shape.ends().into_iter().flat_map(|end| end.raw()));
            fits.add([fit.shape.radius().raw(), fit.deviation.raw()]);
        }
        let fit = fit_cuboid(&hull).expect("in range");
        fits.add(fit.shape.corners().into_iter().flat_map(|corner| corner.raw()));
        fits.add([fit.deviation.raw()]);
        let fit = fit_hull(&hull, 8).expect("in range");
        fits.hull(&fit.shape);
        fits.add([fit.deviation.raw()]);
    }
    let hashes = [hulls, fits].map(|bytes| Hash::of(&bytes.0).to_string());
    let accepted = ["f332f848213d57f6f6840a5ad7906afa", "f6a84d266a2165cce898404592052ed8"];
    assert_eq!(hashes, accepted);
}
