//! Closed meshes to collide: rings, and whatever can be built of cubes.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

use verlock::collision::MeshShape;
use verlock::geometry::TriangleMesh;
use verlock::math::Pcg;
use verlock::{Real, Vec3};

/// Vertices in metres, and faces.
#[derive(Clone, Debug)]
pub struct Solid {
    pub vertices: Vec<[f64; 3]>,
    pub faces: Vec<[u32; 3]>,
}

impl Solid {
    /// A ring of radius 1 m about y, 0.4 m thick, of `2 n^2` faces.
    pub fn ring(n: u32) -> Self {
        let vertices = (0..n * n).map(|k| {
            let [around, across] = [k / n, k % n].map(|c| TAU * f64::from(c) / f64::from(n));
            let radius = 1.0 + 0.4 * across.cos();
            [radius * around.cos(), 0.4 * across.sin(), radius * around.sin()]
        });
        let at = |i: u32, j: u32| i % n * n + j % n;
        let faces = (0..n * n).flat_map(|k| {
            let (i, j) = (k / n, k % n);
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, d, c], [a, c, b]]
        });
        Self { vertices: vertices.collect(), faces: faces.collect() }
    }

    /// A prism of 1 m about y, of which every other edge is 1 m from y and the others `inner`.
    pub fn star(tips: u32, inner: f64) -> Self {
        let n = 2 * tips;
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        for y in [-0.5, 0.5] {
            vertices.extend((0..n).map(|k| {
                let angle = TAU * f64::from(k) / f64::from(n);
                let radius = if k % 2 == 0 { 1.0 } else { inner };
                [radius * angle.cos(), y, radius * angle.sin()]
            }));
            vertices.push([0.0, y, 0.0]);
        }
        for k in 0..n {
            let next = (k + 1) % n;
            let [low, high] = [[k, next, n], [k, next, n].map(|vertex| vertex + n + 1)];
            faces.extend([[low[2], low[0], low[1]], [high[2], high[1], high[0]]]);
            faces.extend([[low[0], high[0], low[1]], [low[1], high[0], high[1]]]);
        }
        Self { vertices, faces }
    }

    /// A box with a corner that is the lowest along each axis, and the one that is the highest.
    pub fn cuboid(low: [f64; 3], high: [f64; 3]) -> Self {
        let mut solid = Self::cubes([1; 3], 1, |_| true);
        for vertex in &mut solid.vertices {
            *vertex = [0, 1, 2].map(|k| if vertex[k] > 0.5 { high[k] } else { low[k] });
        }
        solid
    }

    /// A cube of 20 m about 0, with a pit 0.4 m wide from its top down to 0.
    pub fn pit() -> Self {
        let square = |half: f64, y: f64| {
            [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
                .map(|[x, z]| [half * x, y, half * z])
        };
        let squares = [square(10.0, -10.0), square(10.0, 10.0), square(0.2, 10.0), [[0.0; 3]; 4]];
        let vertices = squares.concat().into_iter().take(13).collect();
        let mut faces = vec![[0, 1, 2], [0, 2, 3]];
        for k in 0..4 {
            let next = (k + 1) % 4;
            faces.extend([[k, 4 + k, next], [next, 4 + k, 4 + next]]);
            faces.extend([[4 + k, 8 + k, 4 + next], [4 + next, 8 + k, 8 + next]]);
            faces.push([8 + k, 12, 8 + next]);
        }
        Self { vertices, faces }
    }

    /// Both together, as they are.
    pub fn and(mut self, other: Self) -> Self {
        let first = self.vertices.len() as u32;
        self.vertices.extend(other.vertices);
        self.faces.extend(other.faces.iter().map(|face| face.map(|vertex| first + vertex)));
        self
    }

    /// Inside out.
    pub fn turned(mut self) -> Self {
        self.faces.iter_mut().for_each(|face| face.reverse());
        self
    }

    /// All unit cubes of which `is_full` says so, within 0..size, each side cut `cuts` times along
    /// both edges. Cubes must not touch along an edge or at a corner only.
    pub fn cubes(size: [i32; 3], cuts: i32, is_full: impl Fn([i32; 3]) -> bool) -> Self {
        let within = |c: [i32; 3]| (0..3).all(|k| (0..size[k]).contains(&c[k]));
        let is_full = |c: [i32; 3]| within(c) && is_full(c);
        let mut places = BTreeMap::new();
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        let all = (0..size[0])
            .flat_map(|x| (0..size[1]).flat_map(move |y| (0..size[2]).map(move |z| [x, y, z])));
        for cube in all.filter(|&c| is_full(c)) {
            for side in 0..6 {
                let (axis, end) = (side / 2, (side % 2) as i32);
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut next = cube;
                next[axis] += 2 * end - 1;
                if is_full(next) {
                    continue;
                }
                for part in 0..cuts * cuts {
                    let mut corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[i, j]| {
                        let mut at = cube.map(|c| c * cuts);
                        at[axis] += end * cuts;
                        at[u] += part % cuts + i;
                        at[v] += part / cuts + j;
                        *places.entry(at).or_insert_with(|| {
                            vertices.push(at.map(|c| f64::from(c) / f64::from(cuts)));
                            vertices.len() as u32 - 1
                        })
                    });
                    if end == 0 {
                        corners.reverse();
                    }
                    let [a, b, c, d] = corners;
                    faces.extend([[a, b, c], [a, c, d]]);
                }
            }
        }
        Self { vertices, faces }
    }

    /// Moves every vertex inward by so much along each axis on which a face of it looks.
    pub fn shrunk(mut self, by: f64) -> Self {
        let mut looks = vec![[0.0_f64; 3]; self.vertices.len()];
        for face in &self.faces {
            let [a, b, c] = face.map(|vertex| self.vertices[vertex as usize]);
            let normal = cross(sub(b, a), sub(c, a));
            for vertex in face {
                let look = &mut looks[*vertex as usize];
                *look = [0, 1, 2].map(|k| look[k] + normal[k]);
            }
        }
        for (vertex, look) in self.vertices.iter_mut().zip(looks) {
            for k in 0..3 {
                if look[k].abs() > 1e-9 {
                    vertex[k] -= by * look[k].signum();
                }
            }
        }
        self
    }

    pub fn placed(&self, place: &Place) -> Vec<Vec3> {
        self.vertices.iter().map(|&p| fixed(place.of(p))).collect()
    }

    pub fn shape(&self) -> MeshShape {
        let vertices = self.vertices.iter().map(|&p| fixed(p));
        let mesh = TriangleMesh::new(vertices, self.faces.iter().copied()).expect("a mesh");
        let shape = MeshShape::new(Arc::new(mesh));
        assert!(shape.is_closed());
        shape
    }
}

/// A turn about an axis through 0, then a way.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub axis: [f64; 3],
    pub angle: f64,
    pub way: [f64; 3],
}

impl Place {
    pub fn of(&self, p: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = self.angle.sin_cos();
        let across = cross(self.axis, p);
        let along = dot(self.axis, p) * (1.0 - cos);
        [0, 1, 2].map(|k| p[k] * cos + across[k] * sin + self.axis[k] * along + self.way[k])
    }

    pub fn back(&self, p: [f64; 3]) -> [f64; 3] {
        let turn = Self { angle: -self.angle, way: [0.0; 3], ..*self };
        turn.of(sub(p, self.way))
    }
}

/// Between -1 and 1.
pub fn number(rng: &mut Pcg) -> f64 {
    f64::from(rng.next_u32()) / 2_147_483_648.0 - 1.0
}

pub fn direction(rng: &mut Pcg) -> [f64; 3] {
    loop {
        let v = [(); 3].map(|()| number(rng));
        let length = dot(v, v).sqrt();
        if (0.1..1.0).contains(&length) {
            return v.map(|c| c / length);
        }
    }
}

pub fn fixed(p: [f64; 3]) -> Vec3 {
    let [x, y, z] = p.map(|c| Real::from_f64(c).expect("in range"));
    Vec3::new(x, y, z)
}

pub fn float(p: Vec3) -> [f64; 3] {
    p.raw().map(|c| c as f64 / 16_777_216.0)
}

pub fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
