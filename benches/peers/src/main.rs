//! Ratios of one run: verlock beside an `f32` twin of the same loop.
//!
//! `cargo run --release` here. The machine's speed cancels out; take the smallest of several runs.

mod cloth;
mod twin;

use std::hint::black_box;
use std::time::{Duration, Instant};

const TICKS: u32 = 20;
const ROUNDS: u32 = 15;

/// The shortest time of a tick over all rounds; every round starts from the same state.
fn shortest<S: Clone>(start: &S, mut tick: impl FnMut(&mut S)) -> Duration {
    let round = |_| {
        let mut state = start.clone();
        let clock = Instant::now();
        (0..TICKS).for_each(|_| tick(&mut state));
        let time = clock.elapsed() / TICKS;
        black_box(state);
        time
    };
    (0..ROUNDS).map(round).min().unwrap_or_default()
}

fn main() {
    let mesh = cloth::Mesh::grid(100, 0.02);
    let world = cloth::world(&mesh);
    let ours = shortest(&world, |world| {
        world.step(&[]);
    });
    let per_link = |time: Duration| {
        time.as_secs_f64() * 1e9 / (mesh.links.len() as f64 * f64::from(cloth::ITERATIONS))
    };
    println!("cloth100: {} links, {} iterations", mesh.links.len(), cloth::ITERATIONS);
    println!("{:<24} {:>7.2} ns a link", "verlock", per_link(ours));
    let orders = [("f32, grid order", mesh.links.clone()), ("f32, coloured", mesh.coloured())];
    for (name, links) in orders {
        let start = twin::Cloth::new(&mesh, links);
        let time = shortest(&start, twin::Cloth::step);
        let ratio = ours.as_secs_f64() / time.as_secs_f64();
        println!("{name:<24} {:>7.2} ns a link, verlock / it = {ratio:.2}", per_link(time));
    }
}
