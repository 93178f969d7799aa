//! Times of impact: against roots in big integers, against sampling, and landing before them.

mod advance;
mod capsules;
mod exact;
mod golden;
mod laws;
mod meshes;
mod oracle;
mod sampling;

use verlock::Vec3;
use verlock::geometry::sweep::{Impact, Motion, Sweep};
use verlock::math::Pcg;

/// The corners of two features, each at the start and at the end: a vertex and those of a face, or
/// the ends of two edges.
type Corners = [[[i64; 3]; 2]; 4];

/// What is asked of random features.
fn sweep(sweep: &Sweep, corners: &Corners, is_face: bool) -> Option<Impact> {
    let [p, q, r, s] =
        corners.map(|[start, end]| Motion::new(Vec3::from_raw(start), Vec3::from_raw(end)));
    if is_face { sweep.vertex_face(p, [q, r, s]) } else { sweep.edge_edge([p, q], [r, s]) }
}

/// How random features move.
#[derive(Clone, Copy, Debug)]
enum Class {
    /// Every corner from anywhere to anywhere.
    Any,
    /// Each feature without turning.
    Rigid,
    /// By a fiftieth of their size.
    Slow,
    /// Between few places, so that much coincides.
    Few,
    /// In one plane.
    Flat,
    /// Towards a point that both have in common at some time, or narrowly not.
    Aimed,
    /// Along one another, or narrowly not.
    Sliding,
    /// Corners close to one another, far motions.
    Needles,
    /// Onto a point that both have in common, its time and weights of few bits: between boxes.
    Struck,
}

const CLASSES: [Class; 9] = [
    Class::Any,
    Class::Rigid,
    Class::Slow,
    Class::Few,
    Class::Flat,
    Class::Aimed,
    Class::Sliding,
    Class::Needles,
    Class::Struck,
];

impl Class {
    /// Corners within about `size` of one another.
    fn corners(self, rng: &mut Pcg, size: i64) -> Corners {
        let mut near = |size: i64| [(); 3].map(|()| number(rng, size));
        let moved = |p: [i64; 3], by: [i64; 3]| [p, [0, 1, 2].map(|k| p[k] + by[k])];
        match self {
            Self::Any => [(); 4].map(|()| [near(size), near(size)]),
            Self::Rigid => {
                let [one, other] = [near(size), near(size)];
                [one, other, other, other].map(|by| moved(near(size), by))
            }
            Self::Slow => [(); 4].map(|()| moved(near(size), near(size / 50 + 1))),
            Self::Few => [(); 4].map(|()| [near(1), near(1)].map(|p| p.map(|c| c * size))),
            Self::Flat => [(); 4].map(|()| [near(size), near(size)].map(|[x, y, _]| [x, y, x - y])),
            Self::Aimed => {
                // At half time all is within a line through 0, or a plane, but for a step or two.
                let target = near(size);
                let mut corners = [(); 4].map(|()| [near(size), near(size)]);
                let weight = [2, 1, 1, 0];
                for (corner, weight) in corners.iter_mut().zip(weight) {
                    let nudge = near(1);
                    for k in 0..3 {
                        corner[1][k] = 2 * weight * target[k] + nudge[k] - corner[0][k];
                    }
                }
                corners
            }
            Self::Sliding => {
                let [along, across, by] = [near(size), near(size), near(size)];
                [0, 1, 2, 3].map(|corner| {
                    let nudge = near(1);
                    let at = |k: usize| {
                        nudge[k] + if corner % 2 == 0 { along[k] } else { across[k] * corner / 2 }
                    };
                    moved([at(0), at(1), at(2)], if corner == 0 { by } else { near(1) })
                })
            }
            Self::Needles => {
                let places = [(); 4].map(|()| near(3));
                let by = [near(size), near(size)];
                [0, 1, 2, 3].map(|k| moved(places[k], by[usize::from(k > 1)]))
            }
            Self::Struck => {
                let [time, weight, share] = near(4).map(i64::abs);
                let places = [(); 4].map(|()| near(1).map(|c| 8 * c));
                let places = struck(places, weight, share, near(1)[0]);
                places.map(|place| {
                    // Some come from far away.
                    let far = if near(1)[0] < 0 { size / 64 + 1 } else { 1 };
                    let by = near(far);
                    [time, time - 4].map(|ago| [0, 1, 2].map(|k| place[k] - ago * by[k]))
                })
            }
        }
    }
}

/// Features that share a point: the first corner lies on an edge of the face of the others, or
/// within that face, or the first edge crosses or reaches the second. Places are multiples of 8.
fn struck(places: [[i64; 3]; 4], weight: i64, share: i64, way: i64) -> [[i64; 3]; 4] {
    let [p, q, r, s] = places;
    let between = |a: [i64; 3], b: [i64; 3], weight: i64| {
        [0, 1, 2].map(|k| (a[k] * (4 - weight) + b[k] * weight) / 4)
    };
    let place = between(r, s, weight);
    match (way, share) {
        (0, 1..) => [p, [0, 1, 2].map(|k| p[k] + share * (place[k] - p[k])), r, s],
        (-1, 1) => [place, s, q, r],
        (-1, 2) => [place, r, s, q],
        (-1, 3) => [between(place, q, 2), q, r, s],
        _ => [place, q, r, s],
    }
}

/// From `-most` to `most`.
fn number(rng: &mut Pcg, most: i64) -> i64 {
    (rng.next_u64() % (2 * most.unsigned_abs() + 1)).cast_signed() - most
}
