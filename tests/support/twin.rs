//! The whole step in floating point, naively, from the formulas alone.
//!
//! ```text
//! integrate   x' = x + d (1 - k h) + a h^2,  started with d = v h - a h^2 / 2     (Verlet 1967)
//! exact       x_a -= w_a / W (L - |x|) / |x| x                                    (Jakobsen 2003)
//! SHAKE       x_a -= w_a / W (L^2 - x.x) / (2 x.r) r, r from the start of the substep
//! root-free   x_a -= w_a / W (L^2 - x.x) / (L^2 + x.x) x
//! compliant   as exact, by (L - |x| - give taken) / (1 + give), give = alpha / (h^2 W), and taken
//!             what it moved before in the same substep                      (Macklin et al. 2016)
//! volume      x_i -= w_i C g_i / sum w_j |g_j|^2, C = e1.(e2 x e3) - 6 V     (Mueller et al. 2007)
//! wind        F = drag A (u.n) n, once a tick, a third on each corner
//! half-space  out by its depth; the slip s loses min(|s|, friction depth)
//! bounce      normal speed out = restitution * normal speed in, if that is not slow
//! ```

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "the twin is not meant to be the same everywhere, only close"
)]

use verlock::WorldConfig;
use verlock::body::Face;
use verlock::constraint::{Distance, DistanceForm, HalfSpace, Volume};
use verlock::particle::{Particle, ParticleSpec};

use super::blueprint::Blueprint;
use super::float::{add_scaled, cross, dot, length, sub};

type V = [f64; 3];

pub struct Twin {
    substeps: u32,
    iterations: u32,
    /// Seconds of a substep.
    h: f64,
    damping: f64,
    gravity: V,
    points: Vec<Point>,
    /// Sorted by colour.
    links: Vec<Link>,
    volumes: Vec<Tetrahedron>,
    planes: Vec<Plane>,
    faces: Vec<Face>,
    wind: V,
}

struct Point {
    mass: f64,
    x: V,
    /// Displacement of the last substep.
    d: V,
    acceleration: V,
    /// What the wind moves it in every substep of this tick.
    gust: V,
    movable: bool,
}

struct Link {
    ends: [usize; 2],
    /// Share of the error that each end takes.
    gains: [f64; 2],
    shortest: f64,
    longest: f64,
    give: f64,
    form: DistanceForm,
}

struct Tetrahedron {
    corners: [usize; 4],
    inverse: [f64; 4],
    /// Six times the volume.
    rest: f64,
    stiffness: f64,
}

struct Plane {
    point: V,
    normal: V,
    friction: f64,
    restitution: f64,
}

impl Twin {
    pub fn new(blueprint: &Blueprint) -> Self {
        let Blueprint { config, particles, distances, half_spaces, volumes, faces, script: _ } =
            blueprint;
        let WorldConfig { substeps, iterations, gravity, damping, .. } = *config;
        let h = 1.0 / f64::from(config.tick_rate * substeps);
        let gravity = gravity.to_f64();
        Self {
            substeps,
            iterations,
            h,
            damping: damping.to_f64(),
            gravity,
            points: particles.iter().map(|spec| Point::new(spec, gravity, h)).collect(),
            links: coloured(distances.iter().map(|row| Link::new(row, particles, h)).collect()),
            volumes: volumes.iter().map(|row| Tetrahedron::new(row, particles)).collect(),
            planes: half_spaces.iter().map(Plane::new).collect(),
            faces: faces.clone(),
            wind: config.wind.to_f64(),
        }
    }

    pub fn position(&self, index: usize) -> V {
        self.points[index].x
    }

    pub fn step(&mut self) {
        self.blow();
        for _ in 0..self.substeps {
            self.substep();
        }
    }

    fn blow(&mut self) {
        let Self { h, wind, faces, points, .. } = self;
        points.iter_mut().for_each(|point| point.gust = [0.0; 3]);
        for face in faces {
            let corners = face.corners.map(|id| id.0.slot());
            let [a, b, c] = corners.map(|corner| points[corner].x);
            let normal = cross(sub(b, a), sub(c, a));
            let flow = corners
                .iter()
                .fold(*wind, |flow, &corner| add_scaled(flow, points[corner].d, -1.0 / (3.0 * *h)));
            let force = face.drag.to_f64() * dot(flow, normal) / (2.0 * length(normal));
            for corner in corners {
                let point = &mut points[corner];
                let share = force * h.powi(2) / (3.0 * point.mass);
                point.gust = add_scaled(point.gust, normal, share);
            }
        }
    }

    fn substep(&mut self) {
        let Self { h, damping, gravity, iterations, .. } = *self;
        let Self { points, links, volumes, planes, .. } = self;
        let start: Vec<V> = points.iter().map(|point| point.x).collect();
        for point in points.iter_mut().filter(|point| point.movable) {
            let coasted = add_scaled(point.x, point.d, 1.0 - damping * h);
            point.x = add_scaled(add_scaled(coasted, point.acceleration, h * h), point.gust, 1.0);
        }
        // The fastest approach of each point to each plane that pushed it.
        let mut touches: Vec<Vec<Option<f64>>> = vec![vec![None; planes.len()]; points.len()];
        let mut taken = vec![0.0; links.len()];
        for _ in 0..iterations {
            for (link, taken) in links.iter().zip(&mut taken) {
                link.project(points, &start, taken);
            }
            volumes.iter().for_each(|volume| volume.project(points));
            let movable = points.iter_mut().zip(&start).zip(&mut touches);
            for ((point, start), touches) in movable.filter(|((point, _), _)| point.movable) {
                for (plane, touch) in planes.iter().zip(touches) {
                    if let Some(approach) = plane.project(&mut point.x, *start) {
                        *touch = Some(touch.map_or(approach, |fastest| fastest.min(approach)));
                    }
                }
            }
        }
        for ((point, start), touches) in points.iter_mut().zip(&start).zip(&touches) {
            point.d = sub(point.x, *start);
            for (plane, approach) in planes.iter().zip(touches) {
                // Slow is what gravity makes in two ticks.
                let slow =
                    2.0 * dot(plane.normal, gravity).abs() * h * h * f64::from(self.substeps);
                if let Some(approach) = *approach {
                    plane.settle(&mut point.d, approach, slow);
                }
            }
        }
    }
}

impl Point {
    fn new(spec: &ParticleSpec, gravity: V, h: f64) -> Self {
        let ParticleSpec { position, velocity, particle } = spec;
        let Particle { gravity_scale, acceleration, .. } = particle;
        let acceleration = add_scaled(acceleration.to_f64(), gravity, gravity_scale.to_f64());
        let movable = particle.enabled && !particle.pinned;
        let start = velocity.to_f64().map(|v| v * h);
        let d = if movable { add_scaled(start, acceleration, -0.5 * h * h) } else { [0.0; 3] };
        let (x, mass) = (position.to_f64(), particle.mass.to_f64());
        Self { mass, x, d, acceleration, gust: [0.0; 3], movable }
    }
}

/// 0 for what is pinned.
fn inverse_mass(spec: &ParticleSpec) -> f64 {
    if spec.particle.pinned { 0.0 } else { 1.0 / spec.particle.mass.to_f64() }
}

impl Link {
    fn new(distance: &Distance, particles: &[ParticleSpec], h: f64) -> Self {
        let Distance { a, b, rest_length, slack, stiffness, compliance, form, .. } = *distance;
        let ends = [a, b].map(|id| id.0.slot());
        let inverse = ends.map(|end| inverse_mass(&particles[end]));
        let sum = inverse[0] + inverse[1];
        let share = stiffness.to_f64() / sum;
        let longest = rest_length.to_f64();
        let shortest = longest - slack.to_f64();
        let give = compliance.to_f64() / (h * h * sum);
        Self { ends, gains: inverse.map(|w| w * share), shortest, longest, give, form }
    }

    fn project(&self, points: &mut [Point], start: &[V], taken: &mut f64) {
        let [a, b] = self.ends;
        let x = sub(points[b].x, points[a].x);
        let r = sub(start[b], start[a]);
        let rest = length(x).clamp(self.shortest, self.longest);
        let (rest_sq, along) = (rest * rest, dot(x, r));
        let error = rest_sq - dot(x, x);
        let sound = along > 11.0 / 16.0 * rest_sq
            && error.abs() < 5.0 / 16.0 * rest_sq
            && dot(r, r) < 2.0 * rest_sq;
        let (arm, share) = match self.form {
            _ if self.give > 0.0 => {
                let moved = (rest - length(x) - self.give * *taken) / (1.0 + self.give);
                *taken += moved;
                (x, moved / length(x))
            }
            DistanceForm::StartOfStep if sound => (r, error / (2.0 * along)),
            DistanceForm::RootFree => (x, error / (rest_sq + dot(x, x))),
            _ => (x, (rest - length(x)) / length(x)),
        };
        points[a].x = add_scaled(points[a].x, arm, -share * self.gains[0]);
        points[b].x = add_scaled(points[b].x, arm, share * self.gains[1]);
    }
}

impl Tetrahedron {
    fn new(volume: &Volume, particles: &[ParticleSpec]) -> Self {
        let corners = volume.corners.map(|id| id.0.slot());
        let inverse = corners.map(|corner| inverse_mass(&particles[corner]));
        // Litres are thousandths of a cubic metre.
        let rest = volume.rest_volume.to_f64() * 6.0 / 1000.0;
        Self { corners, inverse, rest, stiffness: volume.stiffness.to_f64() }
    }

    fn project(&self, points: &mut [Point]) {
        let [x0, x1, x2, x3] = self.corners.map(|corner| points[corner].x);
        let [e1, e2, e3] = [x1, x2, x3].map(|x| sub(x, x0));
        let (g1, g2, g3) = (cross(e2, e3), cross(e3, e1), cross(e1, e2));
        let gradients = [[0, 1, 2].map(|k| -g1[k] - g2[k] - g3[k]), g1, g2, g3];
        let weighed = self.inverse.iter().zip(&gradients).map(|(w, &g)| w * dot(g, g));
        let share = self.stiffness * (dot(e1, g1) - self.rest) / weighed.sum::<f64>();
        for ((corner, inverse), gradient) in self.corners.iter().zip(self.inverse).zip(gradients) {
            points[*corner].x = add_scaled(points[*corner].x, gradient, -share * inverse);
        }
    }
}

/// Sorts by colour, then by index: each link has the lowest colour that no earlier one has at an
/// end that can move.
fn coloured(links: Vec<Link>) -> Vec<Link> {
    let meet = |a: &Link, b: &Link| {
        let moving = |link: &Link| [0, 1].map(|k| (link.gains[k] > 0.0).then_some(link.ends[k]));
        moving(a).iter().flatten().any(|end| moving(b).contains(&Some(*end)))
    };
    let mut colours: Vec<usize> = vec![];
    for (index, link) in links.iter().enumerate() {
        let free =
            |colour: &usize| (0..index).all(|k| colours[k] != *colour || !meet(link, &links[k]));
        let colour = (0..=index).find(free).expect("more colours than links");
        colours.push(colour);
    }
    let mut sorted: Vec<_> = colours.into_iter().zip(links).collect();
    sorted.sort_by_key(|(colour, _)| *colour);
    sorted.into_iter().map(|(_, link)| link).collect()
}

impl Plane {
    fn new(shape: &HalfSpace) -> Self {
        let HalfSpace { point, normal, friction, restitution, .. } = *shape;
        let (friction, restitution) = (friction.to_f64(), restitution.to_f64());
        Self { point: point.to_f64(), normal: normal.to_f64(), friction, restitution }
    }

    /// Puts a point back in front; returns its normal motion before that, if it was behind.
    fn project(&self, x: &mut V, start: V) -> Option<f64> {
        let depth = dot(self.normal, sub(self.point, *x));
        if depth <= 0.0 {
            return None;
        }
        let approach = dot(self.normal, sub(*x, start));
        *x = add_scaled(*x, self.normal, depth);
        let motion = sub(*x, start);
        let slip = add_scaled(motion, self.normal, -dot(self.normal, motion));
        let stopped = length(slip).min(self.friction * depth);
        if stopped > 0.0 {
            *x = add_scaled(*x, slip, -stopped / length(slip));
        }
        Some(approach)
    }

    fn settle(&self, d: &mut V, approach: f64, slow: f64) {
        let speed = dot(self.normal, *d);
        let bounces = approach < -slow && self.restitution > 0.0;
        let target =
            if bounces { -approach * self.restitution } else { speed.min(approach.max(0.0)) };
        *d = add_scaled(*d, self.normal, target - speed);
    }
}
