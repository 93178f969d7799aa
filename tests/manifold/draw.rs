//! Random shapes and poses.

use verlock::Vec3;
use verlock::geometry::Cuboid;
use verlock::math::Pcg;

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
    Twin { vertices, faces: faces.collect(), edges: edges.collect(), radius: 0.0 }
}
