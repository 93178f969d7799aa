//! Cloth beside an `f32` twin, in one run: ratios, residuals, threads, hash and save.
//!
//! The same as `cargo run --release cloth` in `benches/peers`; see there for what is measured.
#![allow(
    missing_docs,
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::float_arithmetic,
    clippy::print_stdout,
    unreachable_pub,
    reason = "a benchmark of floating point"
)]

#[path = "peers/src/clock.rs"]
mod clock;
#[path = "peers/src/cloth/mod.rs"]
mod cloth;

fn main() {
    cloth::run();
}
