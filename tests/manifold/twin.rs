//! Convex shapes in `f64`: what a core of vertices and a radius have between them, by brute force.

pub type V = [f64; 3];

/// Metres of a raw unit.
const UNIT: f64 = 1.0 / (1 << 24) as f64;

/// A convex polyhedron, segment or point, and a radius around it. In metres, from some origin.
#[derive(Clone, Debug)]
pub struct Twin {
    pub vertices: Vec<V>,
    /// Counter-clockwise or not.
    pub faces: Vec<Vec<usize>>,
    pub edges: Vec<[usize; 2]>,
    pub radius: f64,
    /// Of a half-space: a point of it and its normal; then there are no vertices.
    pub ground: Option<[V; 2]>,
}

pub fn metres(point: verlock::Vec3, origin: verlock::Vec3) -> V {
    (point - origin).raw().map(|c| c as f64 * UNIT)
}

pub fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + b * s`.
pub fn plus(a: V, b: V, s: f64) -> V {
    [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s]
}

pub fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: V) -> Option<V> {
    let length = length(a);
    (length > 1e-12).then(|| a.map(|c| c / length))
}

impl Twin {
    /// The core of some vertices and edges, without faces.
    pub fn bare(vertices: Vec<V>, edges: Vec<[usize; 2]>, radius: f64) -> Self {
        Self { vertices, faces: vec![], edges, radius, ground: None }
    }

    pub fn moved(&self, way: V, s: f64) -> Self {
        let vertices = self.vertices.iter().map(|&v| plus(v, way, s)).collect();
        let ground = self.ground.map(|[point, normal]| [plus(point, way, s), normal]);
        Self { vertices, ground, ..self.clone() }
    }

    fn normals(&self) -> Vec<V> {
        let normal = |face: &Vec<usize>| {
            let [a, b, c] = [0, 1, 2].map(|k| self.vertices[face[k]]);
            unit(cross(sub(b, a), sub(c, a)))
        };
        self.faces.iter().filter_map(normal).collect()
    }

    fn directions(&self) -> Vec<V> {
        let way = |&[a, b]: &[usize; 2]| unit(sub(self.vertices[b], self.vertices[a]));
        self.edges.iter().filter_map(way).collect()
    }

    pub fn reach(&self, n: V) -> f64 {
        self.vertices.iter().map(|&v| dot(n, v)).fold(f64::MIN, f64::max) + self.radius
    }

    fn triangles(&self) -> impl Iterator<Item = [V; 3]> + '_ {
        self.faces.iter().flat_map(move |face| {
            (1..face.len() - 1).map(move |k| [0, k, k + 1].map(|i| self.vertices[face[i]]))
        })
    }

    fn segments(&self) -> impl Iterator<Item = [V; 2]> + '_ {
        self.edges.iter().map(|edge| edge.map(|k| self.vertices[k]))
    }
}

/// How far `b` is beyond `a` along a direction.
pub fn gap_along(n: V, a: &Twin, b: &Twin) -> f64 {
    if let Some([point, normal]) = a.ground {
        let off = length(sub(n, normal));
        return if off < 1e-7 { -b.reach(n.map(|c| -c)) - dot(n, point) } else { f64::MIN };
    }
    if b.ground.is_some() {
        return gap_along(n.map(|c| -c), b, a);
    }
    -b.reach(n.map(|c| -c)) - a.reach(n)
}

/// How far two shapes are apart; if they overlap, minus the length of the least translation that
/// parts them.
pub fn gap(a: &Twin, b: &Twin) -> f64 {
    if let Some([_, normal]) = a.ground {
        return gap_along(normal, a, b);
    }
    if b.ground.is_some() {
        return gap(b, a);
    }
    let radii = a.radius + b.radius;
    let overlap = core_overlap(a, b);
    if overlap <= 0.0 { overlap - radii } else { core_distance(a, b) - radii }
}

/// The greatest gap between the cores along any axis that can be the best.
fn core_overlap(a: &Twin, b: &Twin) -> f64 {
    let (of_a, of_b) = (a.directions(), b.directions());
    let crosses = of_a.iter().flat_map(|&u| of_b.iter().filter_map(move |&v| unit(cross(u, v))));
    let axes = a.normals().into_iter().chain(b.normals()).chain(crosses);
    let bare = |n: V| gap_along(n, a, b).max(gap_along(n.map(|c| -c), a, b)) + a.radius + b.radius;
    let best = axes.map(bare).fold(f64::MIN, f64::max);
    // Without volume there may be no axis: then they are apart unless they coincide.
    if best == f64::MIN { core_distance(a, b) } else { best }
}

fn core_distance(a: &Twin, b: &Twin) -> f64 {
    let mut least = f64::MAX;
    for &p in &a.vertices {
        for &q in &b.vertices {
            least = least.min(length(sub(p, q)));
        }
    }
    for (one, other) in [(a, b), (b, a)] {
        for &p in &one.vertices {
            for triangle in other.triangles() {
                least = least.min(to_triangle(p, triangle));
            }
            for segment in other.segments() {
                least = least.min(to_segment(p, segment));
            }
        }
    }
    for s in a.segments() {
        for t in b.segments() {
            least = least.min(between_segments(s, t));
        }
    }
    least
}

fn to_segment(p: V, [a, b]: [V; 2]) -> f64 {
    let way = sub(b, a);
    let s = (dot(sub(p, a), way) / dot(way, way).max(1e-300)).clamp(0.0, 1.0);
    length(sub(p, plus(a, way, s)))
}

/// Infinite where the foot is outside: then an edge is nearer.
fn to_triangle(p: V, [a, b, c]: [V; 3]) -> f64 {
    let Some(n) = unit(cross(sub(b, a), sub(c, a))) else { return f64::MAX };
    let inside =
        [[a, b], [b, c], [c, a]].iter().all(|&[u, v]| dot(cross(sub(v, u), sub(p, u)), n) >= 0.0);
    if inside { dot(sub(p, a), n).abs() } else { f64::MAX }
}

/// Infinite where an end is nearest.
fn between_segments([a, b]: [V; 2], [c, d]: [V; 2]) -> f64 {
    let (u, v, w) = (sub(b, a), sub(d, c), sub(c, a));
    let (uu, uv, vv) = (dot(u, u), dot(u, v), dot(v, v));
    let whole = uu * vv - uv * uv;
    let s = (dot(w, u) * vv - dot(w, v) * uv) / whole;
    let t = (dot(w, u) * uv - dot(w, v) * uu) / whole;
    let inside = |x: f64| (0.0..=1.0).contains(&x);
    if inside(s) && inside(t) { length(sub(plus(a, u, s), plus(c, v, t))) } else { f64::MAX }
}
