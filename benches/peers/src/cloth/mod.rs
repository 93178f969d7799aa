//! Cloth beside an `f32` twin of the same loop.

mod scene;
mod twin;

use std::hint::black_box;
use std::time::Duration;

use rayon::{ThreadPool, ThreadPoolBuilder};
use verlock::constraint::DistanceForm;
use verlock::world::{Action, Command};
use verlock::{World, WorldConfig};

use crate::clock::{TICKS, shortest};

/// Prints all measurements.
pub fn run() {
    cloth100();
    threads();
    rollback();
}

fn step(world: &mut World) {
    world.step(&[]);
}

/// One thread, whatever the machine has.
fn alone() -> ThreadPool {
    pool(1)
}

fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(threads).build().expect("threads")
}

/// The relaxation against the same in `f32`, early (links within 1.4 lengths) and when the upper
/// links are stretched to many times their lengths.
fn cloth100() {
    let mesh = scene::Mesh::grid(100, 0.02);
    let links = mesh.links.len() as f64 * f64::from(scene::ITERATIONS);
    let per_link = |time: Duration| time.as_secs_f64() * 1e9 / links;
    println!("cloth100: {} links, {} iterations", mesh.links.len(), scene::ITERATIONS);
    let orders = [("f32, grid order", mesh.links.clone()), ("f32, coloured", mesh.coloured())];
    let twins = orders.map(|(name, links)| {
        let time = shortest(&twin::Cloth::new(&mesh, links), twin::Cloth::step);
        println!("{name:<24} {:>7.2} ns a link", per_link(time));
        (name, time)
    });
    let forms = [
        (DistanceForm::DivisionFree, 1),
        (DistanceForm::DivisionFree, 80),
        (DistanceForm::Exact, 1),
        (DistanceForm::RootFree, 1),
    ];
    for (form, ticks) in forms {
        let mut world = scene::world(&mesh, form);
        (0..ticks).for_each(|_| step(&mut world));
        let time = alone().install(|| shortest(&world, step));
        let label = format!("{form:?} from tick {ticks}");
        print!("{label:<24} {:>7.2} ns a link", per_link(time));
        for (name, twin) in twins {
            print!(", {name} * {:.2}", time.as_secs_f64() / twin.as_secs_f64());
        }
        println!();
    }
    residuals(&mesh);
}

/// How far from their lengths the links are after 100 ticks: root mean square.
fn residuals(mesh: &scene::Mesh) {
    let residual = |form| {
        let mut world = scene::world(mesh, form);
        (0..100).for_each(|_| step(&mut world));
        scene::residual(&world)
    };
    let exact = residual(DistanceForm::Exact);
    println!("residual after 100 ticks: exact form {exact:.4}");
    for form in [DistanceForm::DivisionFree, DistanceForm::RootFree] {
        let other = residual(form);
        println!("{form:?}: {other:.4}, exact * {:.3}", other / exact);
    }
}

/// One thread against two, with the same hash.
fn threads() {
    let mesh = scene::Mesh::grid(200, 0.02);
    let mut start = scene::world(&mesh, DistanceForm::DivisionFree);
    start.step(&[]);
    let [one, two] = [1, 2].map(|threads| {
        pool(threads).install(|| {
            let time = shortest(&start, step);
            let mut world = start.clone();
            (0..TICKS).for_each(|_| step(&mut world));
            (time, world.hash())
        })
    });
    assert_eq!(one.1, two.1, "threads change nothing");
    let gain = one.0.as_secs_f64() / two.0.as_secs_f64();
    println!("cloth200, {} links: 2 threads are {gain:.2} times as fast", mesh.links.len());
}

/// What a rollback game does besides stepping: the hash of a tick, and a saved world.
fn rollback() {
    let mesh = scene::Mesh::grid(100, 0.02);
    let mut world = scene::world(&mesh, DistanceForm::DivisionFree);
    let config = WorldConfig { substeps: 4, iterations: 1, ..*world.config() };
    let action = Action::Configure { config };
    world.step(&[Command { player: 0, sequence: 0, action }]);
    let tick = alone().install(|| shortest(&world, step));
    // Hashes of what changed since the last tick: all that moves.
    let hash = shortest(&world, |world| {
        black_box(world.hash());
    });
    let share = 100.0 * hash.as_secs_f64() / tick.as_secs_f64();
    println!("cloth100 at 4 x 1: a tick {tick:?}, its hash {hash:?}, {share:.1} %");
    let particles = world.particles();
    let bytes = size_of_val(particles.positions_raw()) + size_of_val(particles.displacements_raw());
    let (source, mut target) = (vec![1_u8; bytes], vec![0_u8; bytes]);
    let copy = shortest(&(), |()| {
        target.copy_from_slice(black_box(&source));
        black_box(&mut target);
    });
    let mut saved = world.clone();
    let save = shortest(&(), |()| saved.clone_from(black_box(&world)));
    let ratio = save.as_secs_f64() / copy.as_secs_f64();
    println!("clone_from {save:?}, a copy of the {bytes} bytes that move {copy:?}: {ratio:.2}");
}
