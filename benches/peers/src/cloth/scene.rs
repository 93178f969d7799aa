//! The scene: a square cloth, its top row pinned.

use verlock::constraint::{Distance, DistanceForm};
use verlock::particle::ParticleSpec;
use verlock::{Real, Vec3, World, WorldBuilder, WorldConfig};

/// Relaxations a tick; one substep.
pub const ITERATIONS: u32 = 8;

/// A square grid with structural links and both diagonals.
pub struct Mesh {
    /// Positions in metres.
    pub points: Vec<[f64; 3]>,
    /// Row 0.
    pub pinned: usize,
    /// Pairs of points in grid order.
    pub links: Vec<[usize; 2]>,
}

impl Mesh {
    pub fn grid(side: usize, spacing: f64) -> Self {
        let at = |index: usize| [index % side, index / side].map(|k| k as f64 * spacing);
        let points = (0..side * side).map(|index| {
            let [x, y] = at(index);
            [x, -y, 0.0]
        });
        let mut links = Vec::new();
        for index in 0..side * side {
            let (column, row) = (index % side, index / side);
            if column + 1 < side {
                links.push([index, index + 1]);
            }
            if row + 1 < side {
                links.push([index, index + side]);
            }
            if column + 1 < side && row + 1 < side {
                links.push([index, index + side + 1]);
                links.push([index + 1, index + side]);
            }
        }
        Self { points: points.collect(), pinned: side, links }
    }

    /// The same links, greedily coloured and sorted by colour.
    pub fn coloured(&self) -> Vec<[usize; 2]> {
        let mut taken = vec![0_u64; self.points.len()];
        let mut colours: Vec<_> = self
            .links
            .iter()
            .map(|&[a, b]| {
                let free = (taken[a] | taken[b]).trailing_ones();
                taken[a] |= 1 << free;
                taken[b] |= 1 << free;
                (free, [a, b])
            })
            .collect();
        colours.sort_by_key(|&(colour, _)| colour);
        colours.into_iter().map(|(_, link)| link).collect()
    }

    pub fn length(&self, [a, b]: [usize; 2]) -> f64 {
        let square = |k: usize| (self.points[a][k] - self.points[b][k]).powi(2);
        (square(0) + square(1) + square(2)).sqrt()
    }
}

/// The same cloth as a world.
pub fn world(mesh: &Mesh, form: DistanceForm) -> World {
    let config = WorldConfig { substeps: 1, iterations: ITERATIONS, ..WorldConfig::default() };
    let mut builder = WorldBuilder::new(config).expect("the configuration is valid");
    let real = |value: f64| Real::from_f64(value).expect("a small number");
    let mut ids = Vec::new();
    for (index, point) in mesh.points.iter().enumerate() {
        let [x, y, z] = point.map(real);
        let mut spec = ParticleSpec::at(Vec3::new(x, y, z));
        spec.particle.pinned = index < mesh.pinned;
        ids.push(builder.particle(&spec).expect("there is room"));
    }
    for link in &mesh.links {
        let [a, b] = link.map(|end| ids[end]);
        let rod = Distance::new(a, b, real(mesh.length(*link))).form(form);
        builder.distance(&rod).expect("there is room");
    }
    builder.build()
}

/// The root mean square of the strains of all links.
pub fn residual(world: &World) -> f64 {
    let strain = |distance: &Distance| {
        let [a, b] = [distance.a, distance.b].map(|end| world.position(end).expect("alive"));
        a.distance(b).to_f64() / distance.rest_length.to_f64() - 1.0
    };
    let squares: Vec<_> = world.distances().map(|(_, link)| strain(link).powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}
