//! Asks public queries of continuous collision detection, whose answers are known:
//! `cargo run --release --example queries -- FILE.csv...`.
//!
//! Files are those of Wang et al., *A Large-scale Benchmark and an Inclusion-based Algorithm for
//! Continuous Collision Detection* (ACM TOG 40(5), 2021). Each query is eight lines of
//! `x,X,y,Y,z,Z,r`: the point (x/X, y/Y, z/Z), and 1 or 0, whether they touch. First the four
//! points at the start, then at the end of the step: a vertex and the corners of a face, or the
//! ends of two edges. Which of both is told by the path, that has `vertex-face` or `edge-edge` in
//! it.
//!
//! Exits with 1 if any that touch were missed.
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::print_stdout,
    unreachable_pub,
    reason = "a program for the shell, which takes the time"
)]

mod query;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;
use std::{env, fs};

use query::{Kind, Query};

/// Answers, and what they cost.
#[derive(Default)]
struct Tally {
    hits: usize,
    /// They touch, and were said not to.
    missed: usize,
    /// They do not touch, and were said to.
    wrong: usize,
    /// Of these, searches that ended before they were certain.
    cut: usize,
    /// Points were rounded.
    rounded: usize,
    nanoseconds: Vec<u128>,
}

impl Tally {
    fn ask(&mut self, query: &Query) {
        let begun = Instant::now();
        let impact = query.impact();
        self.nanoseconds.push(begun.elapsed().as_nanos());
        self.hits += usize::from(query.touches);
        self.missed += usize::from(query.touches && impact.is_none());
        self.rounded += usize::from(query.is_rounded);
        if let Some(impact) = impact.filter(|_| !query.touches) {
            self.wrong += 1;
            self.cut += usize::from(impact.is_cut);
        }
    }

    fn report(&mut self, path: &Path) {
        let Self { hits, missed, wrong, cut, rounded, nanoseconds } = self;
        nanoseconds.sort_unstable();
        let count = nanoseconds.len();
        let at = |percent: usize| nanoseconds.get(count * percent / 100).copied().unwrap_or(0);
        let [median, most] = [at(50), at(99)];
        let path = path.display();
        println!("{path}: {count} queries ({rounded} rounded), {hits} touch: {missed} missed");
        println!("  {wrong} wrongly said to touch, {cut} of them cut; {median} ns, 99 % {most} ns");
    }
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let paths: Vec<_> = env::args_os().skip(1).collect();
    if paths.is_empty() {
        return Err("which files?".into());
    }
    let mut missed = 0;
    for path in &paths {
        let path = Path::new(path);
        let name = path.display();
        let kind = Kind::of_path(path).ok_or(format!("{name}: vertex-face or edge-edge?"))?;
        let text = fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?;
        let queries = query::parse(&text, kind).map_err(|error| format!("{name}: {error}"))?;
        let mut tally = Tally::default();
        for query in &queries {
            tally.ask(query);
        }
        tally.report(path);
        missed += tally.missed;
    }
    Ok(ExitCode::from(u8::from(missed > 0)))
}
