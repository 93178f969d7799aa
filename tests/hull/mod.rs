//! Convex hulls, what is made of them, and what fits around points.

mod around;
mod fit;
mod golden;
mod measure;
mod moved;
mod oracle;
mod round;

use verlock::Vec3;
use verlock::geometry::ConvexHull;
use verlock::math::Pcg;

/// A point, raw.
type Point = [i64; 3];

fn vectors(points: &[Point]) -> impl Iterator<Item = Vec3> {
    points.iter().map(|&p| Vec3::from_raw(p))
}

fn hull(points: &[Point]) -> ConvexHull {
    ConvexHull::around(vectors(points)).expect("solid")
}

/// What random clouds of points are like.
#[derive(Clone, Copy, Debug)]
struct Cloud {
    points: u32,
    /// How many places there are along an axis: with few, many points share planes and lines.
    places: u32,
    /// From one to the next, raw.
    step: i64,
    origin: Point,
}

impl Cloud {
    fn draw(&self, rng: &mut Pcg) -> Vec<Point> {
        let mut along = |c: i64| c + i64::from(rng.below(self.places)) * self.step;
        (0..self.points).map(|_| self.origin.map(&mut along)).collect()
    }
}

/// Few places and many, small and as large as can be, near the origin and at the edge of the world.
fn clouds() -> Vec<Cloud> {
    let mut clouds = vec![];
    for (places, points) in [(2, 7), (3, 9), (3, 24), (4, 30), (6, 20), (1000, 12), (1000, 30)] {
        for step in [1, 1 << 20, ((1 << 41) - 1) / i64::from(places - 1)] {
            for origin in [[0; 3], [-(1 << 60), 0, (1 << 60) - (1 << 41)]] {
                clouds.push(Cloud { points, places, step, origin });
            }
        }
    }
    clouds
}

fn shuffle<T>(rng: &mut Pcg, items: &mut [T]) {
    for k in (1..items.len()).rev() {
        items.swap(k, rng.below(u32::try_from(k + 1).expect("few")) as usize);
    }
}
