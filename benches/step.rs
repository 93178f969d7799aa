//! Ten ticks of fixture scenes, and what a tick costs besides: hash, save, load, rollback copy.
//!
//! Every measurement asserts the accepted hash, so a benchmark is a determinism test too.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a benchmark")]

use std::hint::black_box;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use verlock::scene::Scene;
use verlock::{Hash, World};

/// Where measuring starts.
const FROM: u64 = 60;
/// Where it ends; the golden files have a line for this tick.
const TO: u64 = 70;

fn fixture(path: &str) -> String {
    let root = env!("CARGO_MANIFEST_DIR");
    std::fs::read_to_string(format!("{root}/fixtures/{path}")).unwrap()
}

/// The accepted hash of a scene at tick [`TO`].
fn accepted(name: &str) -> Hash {
    let golden = fixture(&format!("golden/{name}.hashes"));
    let line = golden.lines().find_map(|line| line.strip_prefix(&format!("{TO} "))).unwrap();
    line.split(' ').next().unwrap().parse().unwrap()
}

fn advance(world: &mut World, scene: &Scene, to: u64) {
    while world.tick() < to {
        let commands = scene.commands(world);
        world.step(&commands);
    }
}

fn bench(criterion: &mut Criterion) {
    for name in ["rope", "storm", "net", "cloud"] {
        let scene = Scene::parse(&fixture(&format!("scenes/{name}.scene.ron"))).unwrap();
        let mut start = scene.build().unwrap();
        advance(&mut start, &scene, FROM);
        let expected = accepted(name);
        let mut group = criterion.benchmark_group(name);
        group.sample_size(20);
        group.bench_function("ten ticks", |bencher| {
            let steps = |world: &mut World| {
                advance(world, &scene, TO);
                assert_eq!(world.hash(), expected, "{name}");
            };
            bencher.iter_batched_ref(|| start.clone(), steps, BatchSize::LargeInput);
        });
        group.bench_function("hash", |bencher| bencher.iter(|| black_box(&start).hash()));
        let mut copy = scene.build().unwrap();
        group.bench_function("clone_from", |bencher| {
            bencher.iter(|| copy.clone_from(black_box(&start)));
        });
        assert_eq!(copy.hash(), start.hash(), "{name}");
        let mut saved = Vec::new();
        group.bench_function("save", |bencher| {
            bencher.iter(|| {
                saved.clear();
                start.save_into(&mut saved);
            });
        });
        group.bench_function("load", |bencher| bencher.iter(|| World::load(&saved).unwrap()));
        assert_eq!(World::load(&saved).unwrap().hash(), start.hash(), "{name}");
        group.finish();
    }
}

criterion_group!(benches, bench);
criterion_main!(benches);
