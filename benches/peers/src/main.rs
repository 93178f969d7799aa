//! Ratios of one run: verlock beside what people would write or use instead.
//!
//! `cargo run --release [NAME...]` here; without names, everything. The machine's speed cancels
//! out; take the smallest of several runs.

mod boxes;
mod clock;
mod cloth;
mod guigue;
mod manifolds;
mod meshes;
mod surfaces;
mod toi;
mod triangles;

/// What is measured, by name.
const ALL: [(&str, fn()); 7] = [
    ("boxes", boxes::run),
    ("cloth", cloth::run),
    ("manifolds", manifolds::run),
    ("meshes", meshes::run),
    ("surfaces", surfaces::run),
    ("toi", toi::run),
    ("triangles", triangles::run),
];

fn main() {
    let names: Vec<_> = std::env::args().skip(1).filter(|name| !name.starts_with('-')).collect();
    for (name, run) in ALL {
        if names.is_empty() || names.iter().any(|wanted| wanted == name) {
            println!("== {name}");
            run();
        }
    }
}
