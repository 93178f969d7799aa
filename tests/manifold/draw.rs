//! Random shapes and poses.

use verlock::Vec3;
use verlock::collision::Shape;
use verlock::geometry::{Capsule, ConvexHull, Cuboid, HalfSpace, Sphere, Triangle};
use verlock::math::{Pcg, Real, UnitVec3};

use super::twin::{Twin, V, cross, dot, metres};

pub struct Draw(pub Pcg);

/// Raw units of a metre.
pub const METRE: f64 = (1 << 24) as f64;

pub fn raw(v: V) -> Vec3 {
    Vec3::from_raw(v.map(|c| (c * METRE).round() as i64))
}

impl Draw {
    pub fn new(seed: u64) -> Self {
        Self(Pcg::new(seed, 7))
    }

    pub fn below(&mut self, end: u32) -> u32 {
        self.0.below(end)
    }

    /// In -1..1.
    pub fn number(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// In a ball.
    pub fn vector(&mut self) -> V {
        loop {
            let v = [(); 3].map(|()| self.number());
            if dot(v, v) <= 1.0 {
                return v;
            }
        }
    }

    /// In a ball of that radius.
    pub fn within(&mut self, radius: f64) -> V {
        self.vector().map(|c| c * radius)
    }

    pub fn direction(&mut self) -> V {
        loop {
            let v = self.vector();
            let length = dot(v, v).sqrt();
            if length > 0.1 {
                return v.map(|c| c / length);
            }
        }
    }

    /// Three directions at right angles.
    pub fn frame(&mut self) -> [V; 3] {
        let x = self.direction();
        loop {
            let y = cross(x, self.direction());
            let length = dot(y, y).sqrt();
            if length > 0.1 {
                let y = y.map(|c| c / length);
                return [x, y, cross(x, y)];
            }
        }
    }

    /// A box of up to `size` metres to either side.
    pub fn cuboid(&mut self, center: V, size: f64) -> Cuboid {
        let mut frame = self.frame();
        match self.below(8) {
            0 => frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            1 => {
                // Sheared, and mirrored now and then.
                let way = self.vector();
                frame[0] = [0, 1, 2].map(|k| frame[0][k] + 0.5 * way[k]);
            }
            2 => frame.swap(0, 1),
            _ => {}
        }
        let edges = frame.map(|axis| {
            let half = size * (0.1 + 0.9 * self.number().abs());
            raw(axis.map(|c| c * half))
        });
        Cuboid::new(raw(center), edges).expect("a box")
    }
}

/// The shapes that are drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    HalfSpace,
    Sphere,
    Capsule,
    Cuboid,
    Hull,
    Triangle,
}

impl Kind {
    pub const ALL: [Self; 6] =
        [Self::HalfSpace, Self::Sphere, Self::Capsule, Self::Cuboid, Self::Hull, Self::Triangle];
}

impl Draw {
    /// A shape of up to `size` metres from its middle.
    pub fn shape(&mut self, kind: Kind, center: V, size: f64) -> Shape {
        let near = |draw: &mut Self| {
            let way = draw.within(size);
            raw([0, 1, 2].map(|k| center[k] + way[k]))
        };
        let radius = Real::from_raw((0.3 * size * METRE * self.number().abs()) as i64);
        match kind {
            Kind::HalfSpace => {
                let normal = UnitVec3::normalize(raw(self.direction())).expect("a direction");
                HalfSpace::new(near(self), normal).expect("in range").into()
            }
            Kind::Sphere => Sphere::new(raw(center), radius).expect("in range").into(),
            Kind::Capsule => {
                Capsule::new([near(self), near(self)], radius).expect("in range").into()
            }
            Kind::Cuboid => self.cuboid(center, 0.6 * size).into(),
            Kind::Hull => {
                let points = 4 + self.below(12);
                ConvexHull::around((0..points).map(|_| near(self))).expect("solid").into()
            }
            Kind::Triangle => {
                Triangle::new([near(self), near(self), near(self)]).expect("in range").into()
            }
        }
    }
}

/// The shape whose points are mapped, by a map that keeps lengths. A hull is made anew if it is
/// mirrored.
pub fn mapped(shape: &Shape, map: impl Fn(Vec3) -> Vec3) -> Shape {
    match shape {
        Shape::Sphere(sphere) => Sphere::new(map(sphere.center()), sphere.radius()).unwrap().into(),
        Shape::Capsule(capsule) => {
            Capsule::new(capsule.ends().map(map), capsule.radius()).unwrap().into()
        }
        Shape::Cuboid(cuboid) => {
            let center = map(cuboid.center());
            let edges = cuboid.half_edges().map(|edge| map(cuboid.center() + edge) - center);
            Cuboid::new(center, edges).unwrap().into()
        }
        Shape::ConvexHull(hull) => {
            let vertices: Vec<_> = hull.vertices().iter().map(|&vertex| map(vertex)).collect();
            let mut moved = hull.clone();
            match moved.moved_to(&vertices) {
                Ok(()) => moved.into(),
                Err(_) => ConvexHull::around(vertices).unwrap().into(),
            }
        }
        Shape::Triangle(triangle) => Triangle::new(triangle.corners().map(map)).unwrap().into(),
        Shape::HalfSpace(ground) => {
            let end = ground.point() + Vec3::from_raw(ground.normal().raw());
            let normal = (map(end) - map(ground.point())).raw().map(|c| c as i32);
            HalfSpace::new(map(ground.point()), UnitVec3::from_raw(normal)).unwrap().into()
        }
        _ => panic!("not convex"),
    }
}

/// A point of a shape.
pub fn anchor(shape: &Shape) -> Vec3 {
    match shape {
        Shape::HalfSpace(ground) => ground.point(),
        _ => shape.bounds().expect("has an end").min(),
    }
}

pub fn twin(shape: &Shape, origin: Vec3) -> Twin {
    let local = |point: Vec3| metres(point, origin);
    let length = |length: Real| length.raw() as f64 / METRE;
    match shape {
        Shape::HalfSpace(ground) => {
            let normal = super::float(ground.normal());
            Twin {
                ground: Some([local(ground.point()), normal]),
                ..Twin::bare(vec![], vec![], 0.0)
            }
        }
        Shape::Sphere(sphere) => {
            Twin::bare(vec![local(sphere.center())], vec![], length(sphere.radius()))
        }
        Shape::Capsule(capsule) => {
            Twin::bare(capsule.ends().map(local).to_vec(), vec![[0, 1]], length(capsule.radius()))
        }
        Shape::Cuboid(cuboid) => twin_of_cuboid(cuboid, origin),
        Shape::ConvexHull(hull) => {
            let vertices = hull.vertices().iter().map(|&vertex| local(vertex)).collect();
            let faces = hull.faces().map(|face| face.iter().map(|&k| k as usize).collect());
            let edges = hull.edges().iter().map(|edge| edge.ends.map(|end| end as usize));
            Twin { faces: faces.collect(), ..Twin::bare(vertices, edges.collect(), 0.0) }
        }
        Shape::Triangle(triangle) => {
            let vertices = triangle.corners().map(local).to_vec();
            let edges = vec![[0, 1], [1, 2], [2, 0]];
            Twin { faces: vec![vec![0, 1, 2]], ..Twin::bare(vertices, edges, 0.0) }
        }
        _ => panic!("not convex"),
    }
}

pub fn twin_of_cuboid(cuboid: &Cuboid, origin: Vec3) -> Twin {
    let corners = cuboid.corners();
    let vertices = corners.iter().map(|&corner| metres(corner, origin)).collect();
    let faces = (0..6).map(|face| {
        let (axis, end) = (face / 2, face % 2);
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        [0, 1 << u, 1 << u | 1 << v, 1 << v].map(|corner| end << axis | corner).to_vec()
    });
    let edges = (0..12).map(|edge| {
        let (axis, at) = (edge / 4, edge % 4);
        let corner = (at & 1) << ((axis + 1) % 3) | (at >> 1) << ((axis + 2) % 3);
        [corner, corner | 1 << axis]
    });
    let bare = Twin::bare(vertices, edges.collect(), 0.0);
    Twin { faces: faces.collect(), ..bare }
}
