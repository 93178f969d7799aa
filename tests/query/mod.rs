//! How far apart shapes are, what a moving one touches, what is where: against twins in floats.

mod cast;
mod distance;
mod golden;
mod limits;
mod set;
mod table;
mod touching;
mod twin;

use std::sync::Arc;

use verlock::Vec3;
use verlock::collision::{MeshShape, Shape};
use verlock::geometry::{
    Capsule, ConvexHull, Cuboid, HalfSpace, HeightField, Sphere, Triangle, TriangleMesh,
};
use verlock::math::{Pcg, Real, UnitVec3};

/// Every kind of shape.
pub const KINDS: [&str; 8] =
    ["half-space", "sphere", "capsule", "box", "hull", "mesh", "height field", "triangle"];

/// What random shapes are made of.
pub struct Draw {
    pub rng: Pcg,
    /// Coordinates are multiples of this, raw.
    pub unit: i64,
    /// Of which a shape spans so many.
    pub most: i64,
}

impl Draw {
    /// A number from 0 to `most`.
    pub fn below(&mut self, most: i64) -> i64 {
        (self.rng.next_u64() % (most.unsigned_abs() + 1)).cast_signed()
    }

    /// A way of up to `reach` units a component.
    pub fn way(&mut self, reach: i64) -> Vec3 {
        Vec3::from_raw([(); 3].map(|()| (self.below(2 * reach) - reach) * self.unit))
    }

    fn radius(&mut self) -> Real {
        Real::from_raw(self.below(self.most / 2) * self.unit)
    }

    /// A shape near a point; `None` if what was drawn is none, as it is flat.
    pub fn shape(&mut self, kind: usize, at: Vec3) -> Option<Shape> {
        let half = (self.most / 2).max(1);
        let corner = |draw: &mut Self| at + draw.way(half);
        Some(match KINDS[kind] {
            "half-space" => {
                HalfSpace::new(at, UnitVec3::normalize(self.way(self.most))?).ok()?.into()
            }
            "sphere" => Sphere::new(at, self.radius()).ok()?.into(),
            "capsule" => Capsule::new([corner(self), corner(self)], self.radius()).ok()?.into(),
            "box" => {
                let quarter = (half / 2).max(1);
                Cuboid::new(at, [(); 3].map(|()| self.way(quarter))).ok()?.into()
            }
            "hull" => {
                let points: Vec<_> = (0..4 + self.below(6)).map(|_| corner(self)).collect();
                ConvexHull::around(points).ok()?.into()
            }
            "mesh" => {
                let vertices: Vec<_> = (0..8).map(|_| corner(self)).collect();
                let face = |k: u32| [k, k + 1, k + 2];
                let mesh = TriangleMesh::new(vertices, (0..6).map(face)).ok()?;
                MeshShape::new(Arc::new(mesh)).into()
            }
            "height field" => {
                let step = Real::from_raw(self.unit * (half / 2).max(1));
                let heights: Vec<_> = (0..9)
                    .map(|_| Real::from_raw((self.below(2 * half) - half) * self.unit))
                    .collect();
                let corner = at - Vec3::new(step, Real::ZERO, step);
                HeightField::new(corner, [step; 2], 3, heights).ok()?.into()
            }
            _ => Triangle::new([(); 3].map(|()| corner(self))).ok()?.into(),
        })
    }

    /// Two shapes of these kinds, somewhere between one in the other and apart.
    pub fn pair(&mut self, kinds: [usize; 2]) -> [Shape; 2] {
        let base = Vec3::from_raw([(); 3].map(|()| self.below(1 << 50) - (1 << 49)));
        loop {
            let away = base + self.way(self.most);
            if let (Some(a), Some(b)) = (self.shape(kinds[0], base), self.shape(kinds[1], away)) {
                return [a, b];
            }
        }
    }
}

/// Small grids, where shapes often touch; then a few metres, and the limits of both widths.
pub const CLASSES: [(i64, i64); 5] =
    [(1, 4), (1, 12), (1 << 12, 1 << 12), (1, 1 << 28), (1 << 10, 1 << 29)];

/// Every two kinds.
pub fn kinds() -> impl Iterator<Item = [usize; 2]> {
    (0..KINDS.len()).flat_map(|a| (0..KINDS.len()).map(move |b| [a, b]))
}

/// The same shape elsewhere.
pub fn moved(shape: &Shape, by: Vec3) -> Shape {
    match shape {
        Shape::HalfSpace(s) => HalfSpace::new(s.point() + by, s.normal()).expect("in range").into(),
        Shape::Sphere(s) => Sphere::new(s.center() + by, s.radius()).expect("in range").into(),
        Shape::Capsule(s) => {
            Capsule::new(s.ends().map(|end| end + by), s.radius()).expect("in range").into()
        }
        Shape::Cuboid(s) => Cuboid::new(s.center() + by, s.half_edges()).expect("in range").into(),
        Shape::ConvexHull(s) => {
            let mut hull = s.clone();
            let vertices: Vec<_> = s.vertices().iter().map(|&v| v + by).collect();
            hull.moved_to(&vertices).expect("in range");
            hull.into()
        }
        Shape::MeshShape(s) => {
            let mut mesh = s.clone();
            let vertices: Vec<_> = s.vertices().iter().map(|&v| v + by).collect();
            mesh.move_to(&vertices).expect("in range");
            mesh.into()
        }
        Shape::HeightField(s) => {
            let [columns, _] = s.size();
            let heights = s.heights().to_vec();
            HeightField::new(s.origin() + by, s.steps(), columns, heights).expect("in range").into()
        }
        Shape::Triangle(s) => Triangle::new(s.corners().map(|c| c + by)).expect("in range").into(),
        _ => unreachable!("a kind that is not listed"),
    }
}
