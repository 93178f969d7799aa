//! What people write: positions in `f32`, square roots, no bounds checks worth mentioning.

use super::scene::{ITERATIONS, Mesh};

struct Link {
    ends: [u32; 2],
    rest: f32,
}

/// The cloth in flat arrays.
#[derive(Clone)]
pub struct Cloth {
    position: Vec<[f32; 3]>,
    previous: Vec<[f32; 3]>,
    /// 1 for particles that move, 0 for pinned ones.
    inverse_mass: Vec<f32>,
    links: std::rc::Rc<Vec<Link>>,
}

impl Cloth {
    pub fn new(mesh: &Mesh, links: Vec<[usize; 2]>) -> Self {
        let position: Vec<_> = mesh.points.iter().map(|point| point.map(|c| c as f32)).collect();
        let movable = |index| if index < mesh.pinned { 0.0 } else { 1.0 };
        let link = |ends: [usize; 2]| Link {
            ends: ends.map(|end| end as u32),
            rest: mesh.length(ends) as f32,
        };
        Self {
            previous: position.clone(),
            inverse_mass: (0..position.len()).map(movable).collect(),
            position,
            links: std::rc::Rc::new(links.into_iter().map(link).collect()),
        }
    }

    pub fn step(&mut self) {
        let h = 1.0 / 60.0_f32;
        let all = self.position.iter_mut().zip(&mut self.previous).zip(&self.inverse_mass);
        for ((position, previous), inverse_mass) in all {
            let now = *position;
            for k in 0..3 {
                position[k] += (now[k] - previous[k]) * inverse_mass;
            }
            position[1] -= 9.81 * h * h * inverse_mass;
            *previous = now;
        }
        for _ in 0..ITERATIONS {
            for link in self.links.iter() {
                relax(link, &mut self.position, &self.inverse_mass);
            }
        }
    }
}

fn relax(link: &Link, position: &mut [[f32; 3]], inverse_mass: &[f32]) {
    let [a, b] = link.ends.map(|end| end as usize);
    let (from, to) = (position[a], position[b]);
    let d = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
    let weight = inverse_mass[a] + inverse_mass[b];
    if weight == 0.0 || length == 0.0 {
        return;
    }
    let share = (length - link.rest) / (length * weight);
    for k in 0..3 {
        position[a][k] += d[k] * share * inverse_mass[a];
        position[b][k] -= d[k] * share * inverse_mass[b];
    }
}
