//! Whatever overlaps has a manifold, the same both ways round, which leads apart.

use std::sync::Arc;

use verlock::collision::{Manifold, MeshShape, Shape, collide, overlap};
use verlock::geometry::{ConvexHull, Cuboid, HeightField, Surface, Triangle, TriangleMesh};
use verlock::math::Pcg;
use verlock::{Real, Vec3, real};

use super::solids::{Place, Solid, direction, fixed, float, number};

/// Of contacts that are as deep, up to this, a manifold keeps the one of the lowest features.
const TIE: Real = real!("0.00004");

/// What is put somewhere.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Kind {
    Cuboid,
    Hull,
    Cube,
    Ring,
    Field,
    Sheet,
    Triangle,
}

const KINDS: [Kind; 7] =
    [Kind::Cuboid, Kind::Hull, Kind::Cube, Kind::Ring, Kind::Field, Kind::Sheet, Kind::Triangle];

impl Kind {
    fn is_surface(self) -> bool {
        !matches!(self, Self::Cuboid | Self::Hull | Self::Triangle)
    }

    /// Of which no part is behind another one.
    fn is_convex(self) -> bool {
        matches!(self, Self::Cuboid | Self::Hull | Self::Cube | Self::Triangle)
    }

    fn has_inside(self) -> bool {
        !matches!(self, Self::Field | Self::Sheet | Self::Triangle)
    }

    /// The shape, so much larger than 1 m, at a place; fields stay upright.
    fn shape(self, place: &Place, size: f64) -> Shape {
        let at = |p: [f64; 3]| fixed(place.of(p.map(|c| size * c)));
        let placed = |solid: &Solid| solid.vertices.iter().map(|&p| at(p)).collect::<Vec<_>>();
        let mesh = |solid: Solid| {
            let mut mesh = solid.shape();
            mesh.move_to(&placed(&solid)).expect("in range");
            mesh
        };
        let centred = |p: [f64; 3]| at(p.map(|c| c - 0.5));
        match self {
            Self::Cuboid => {
                let edge = |k: usize| {
                    let turn = Place { way: [0.0; 3], ..*place };
                    let mut edge = [0.0; 3];
                    edge[k] = size * [0.5, 0.35, 0.6][k];
                    fixed(turn.of(edge))
                };
                Cuboid::new(at([0.0; 3]), [0, 1, 2].map(edge)).expect("legal").into()
            }
            Self::Hull => {
                let corner = |k: u32| {
                    let angle = f64::from(k) * 1.3;
                    at([0.5 * angle.cos(), f64::from(k % 3) * 0.3 - 0.3, 0.6 * angle.sin()])
                };
                ConvexHull::around((0..12).map(corner)).expect("solid").into()
            }
            Self::Cube => {
                let mut cube = Solid::cubes([1, 1, 1], 3, |_| true);
                cube.vertices = cube.vertices.iter().map(|p| p.map(|c| c - 0.5)).collect();
                mesh(cube).into()
            }
            Self::Ring => mesh(Solid::ring(8)).into(),
            Self::Field => {
                let heights =
                    (0..64_i32).map(|k| fixed([0.1 * size * f64::from(k * k % 7) / 7.0; 3]).x);
                let step = fixed([size * 0.3; 3]).x;
                let origin = fixed([0, 1, 2].map(|k| place.way[k] - size * [1.0, 0.0, 1.0][k]));
                HeightField::new(origin, [step; 2], 8, heights.collect::<Vec<_>>())
                    .expect("legal")
                    .into()
            }
            Self::Sheet => {
                let vertices =
                    (0..16).map(|k| centred([k % 4, 2, k / 4].map(|c| f64::from(c) / 3.0)));
                let faces = (0..9).flat_map(|k| {
                    let first = k / 3 * 4 + k % 3;
                    [[first, first + 4, first + 5], [first, first + 5, first + 1]]
                });
                let mesh = TriangleMesh::new(vertices, faces).expect("legal");
                MeshShape::new(Arc::new(mesh)).two_sided().into()
            }
            Self::Triangle => {
                let corners = [[0.6, 0.0, 0.1], [-0.5, 0.0, 0.4], [0.1, 0.0, -0.7]];
                Triangle::new(corners.map(at)).expect("legal").into()
            }
        }
    }
}

/// What came of the poses of a pair.
#[derive(Debug, Default)]
struct Tally {
    overlapping: u32,
    contained: u32,
    /// One way out, and how often that was true.
    led: u32,
    apart: u32,
}

fn manifolds(a: &Shape, b: &Shape) -> Vec<Manifold> {
    let mut manifolds = Vec::new();
    collide(a, b, real!("0.001"), &mut manifolds);
    manifolds
}

/// Whether a point of what is not solid to `overlap` is in a mesh.
fn is_within(outer: &Shape, inner: &Shape) -> bool {
    let Shape::MeshShape(outer) = outer else { return false };
    let point = match inner {
        Shape::Cuboid(inner) => inner.corners()[0],
        Shape::ConvexHull(inner) => inner.vertices()[0],
        Shape::MeshShape(inner) => inner.vertices()[0],
        Shape::HeightField(inner) => inner.mesh().expect("legal").vertices()[0],
        Shape::Triangle(inner) => inner.corners()[0],
        _ => return false,
    };
    outer.is_closed() && !outer.is_two_sided() && outer.contains(point)
}

/// A pose of each: about as near to one another as to overlap, deep, or inside.
fn poses(rng: &mut Pcg) -> [(Place, f64); 2] {
    let distance = [1.5, 0.6, 0.2][rng.below(3) as usize];
    let sizes = [[1.0, 1.0], [1.0, 1.0], [4.0, 0.5], [0.5, 4.0]][rng.below(4) as usize];
    let mut place = |reach: f64| Place {
        axis: direction(rng),
        angle: 3.0 * number(rng),
        way: [(); 3].map(|()| reach * number(rng)),
    };
    [(place(0.0), sizes[0]), (place(distance), sizes[1])]
}

fn check(kinds: [Kind; 2], poses: [(Place, f64); 2], tally: &mut Tally) {
    let [a, b] = [0, 1].map(|k| kinds[k].shape(&poses[k].0, poses[k].1));
    let is_contained = is_within(&a, &b) || is_within(&b, &a);
    let (found, back) = (manifolds(&a, &b), manifolds(&b, &a));
    let least = |found: &[Manifold]| found.iter().map(Manifold::separation).min();
    if !overlap(&a, &b) && !is_contained {
        // What is close behind an open surface has passed through it.
        let least = least(&found).filter(|_| !kinds.contains(&Kind::Field));
        assert!(least.is_none_or(|least| least >= -TIE), "{kinds:?} {poses:?} {found:?}");
        return;
    }
    let deepest = least(&found);
    assert!(deepest.is_some_and(|least| least <= TIE), "{kinds:?} {poses:?}: {found:?}");
    let off = least(&back).map(|back| (back.raw() - deepest.unwrap_or(back).raw()).abs());
    assert!(off.is_some_and(|off| off <= TIE.raw()), "{kinds:?} {poses:?}: {found:?} {back:?}");
    tally.overlapping += 1;
    tally.contained += u32::from(is_contained);
    let [manifold] = found.as_slice() else { return };
    let out = float(Vec3::X * manifold.separation())[0] - 2e-4;
    let normal = manifold.normal.raw().map(|c| c as f64 / f64::from(1 << 30));
    let way = [0, 1, 2].map(|k| poses[1].0.way[k] - out * normal[k]);
    let moved = kinds[1].shape(&Place { way, ..poses[1].0 }, poses[1].1);
    let is_apart = !overlap(&a, &moved) && !is_within(&a, &moved) && !is_within(&moved, &a);
    tally.led += 1;
    tally.apart += u32::from(is_apart);
    let is_convex = kinds.iter().all(|kind| kind.is_convex());
    let is_known = is_convex && kinds.iter().all(|kind| kind.has_inside());
    assert!(is_apart || !is_known, "{kinds:?} {poses:?}: {found:?}");
}

#[test]
fn what_overlaps_has_a_way_out() {
    let mut rng = Pcg::new(21, 0);
    for a in KINDS {
        for b in KINDS {
            if !a.is_surface() && !b.is_surface() {
                continue;
            }
            let mut tally = Tally::default();
            for _ in 0..200 {
                check([a, b], poses(&mut rng), &mut tally);
            }
            println!("{a:?} {b:?} {tally:?}");
            assert!(tally.apart * 10 >= tally.led * 8, "{a:?} {b:?} {tally:?}");
            assert!(tally.overlapping > 10, "{a:?} {b:?} {tally:?}");
        }
    }
}
