//! The whole step in floating point, naively, from the formulas alone.
//!
//! ```text
//! integrate   x' = x + d (1 - k h) + a h^2,  started with d = v h - a h^2 / 2     (Verlet 1967)
//! exact       x_a -= w_a / W (L - |x|) / |x| x                                    (Jakobsen 2003)
//! SHAKE       x_a -= w_a / W (L^2 - x.x) / (2 x.r) r, r from the start of the substep
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
use verlock::constraint::{Distance, DistanceForm, HalfSpace};
use verlock::particle::{Particle, ParticleSpec};

use super::blueprint::Blueprint;
use super::float::{add_scaled, dot, length, sub};

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
    planes: Vec<Plane>,
}

struct Point {
    x: V,
    /// Displacement of the last substep.
    d: V,
    acceleration: V,
    movable: bool,
}

struct Link {
    ends: [usize; 2],
    /// Share of the error that each end takes.
    gains: [f64; 2],
    rest: f64,
    form: DistanceForm,
}

struct Plane {
    point: V,
    normal: V,
    friction: f64,
    restitution: f64,
}

impl Twin {
    pub fn new(blueprint: &Blueprint) -> Self {
        let Blueprint { config, particles, distances, half_spaces, script: _ } = blueprint;
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
            links: coloured(distances.iter().map(|row| Link::new(row, particles)).collect()),
            planes: half_spaces.iter().map(Plane::new).collect(),
        }
    }

    pub fn position(&self, index: usize) -> V {
        self.points[index].x
    }

    pub fn step(&mut self) {
        for _ in 0..self.substeps {
            self.substep();
        }
    }

    fn substep(&mut self) {
        let Self { h, damping, gravity, iterations, .. } = *self;
        let Self { points, links, planes, .. } = self;
        let start: Vec<V> = points.iter().map(|point| point.x).collect();
        for point in points.iter_mut().filter(|point| point.movable) {
            let coasted = add_scaled(point.x, point.d, 1.0 - damping * h);
            point.x = add_scaled(coasted, point.acceleration, h * h);
        }
        // The fastest approach of each point to each plane that pushed it.
        let mut touches: Vec<Vec<Option<f64>>> = vec![vec![None; planes.len()]; points.len()];
        for _ in 0..iterations {
            for link in links.iter() {
                link.project(points, &start);
            }
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
        Self { x: position.to_f64(), d, acceleration, movable }
    }
}

impl Link {
    fn new(distance: &Distance, particles: &[ParticleSpec]) -> Self {
        let Distance { a, b, rest_length, stiffness, form, .. } = *distance;
        let ends = [a, b].map(|id| id.0.slot());
        let inverse = ends.map(|end| {
            let particle = particles[end].particle;
            if particle.pinned { 0.0 } else { 1.0 / particle.mass.to_f64() }
        });
        let share = stiffness.to_f64() / (inverse[0] + inverse[1]);
        Self { ends, gains: inverse.map(|w| w * share), rest: rest_length.to_f64(), form }
    }

    fn project(&self, points: &mut [Point], start: &[V]) {
        let [a, b] = self.ends;
        let x = sub(points[b].x, points[a].x);
        let r = sub(start[b], start[a]);
        let (rest_sq, along) = (self.rest * self.rest, dot(x, r));
        let error = rest_sq - dot(x, x);
        let sound = along > 11.0 / 16.0 * rest_sq
            && error.abs() < 5.0 / 16.0 * rest_sq
            && dot(r, r) < 2.0 * rest_sq;
        let (arm, share) = if sound && self.form == DistanceForm::StartOfStep {
            (r, error / (2.0 * along))
        } else {
            (x, (self.rest - length(x)) / length(x))
        };
        points[a].x = add_scaled(points[a].x, arm, -share * self.gains[0]);
        points[b].x = add_scaled(points[b].x, arm, share * self.gains[1]);
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
