//! Writes ten meshes, and a second gear, as OBJ files:
//! `cargo run --release --example meshes -- FOLDER [DETAIL]`.
//!
//! Detail 1 gives a few hundred faces each, detail 10 a hundred times as many.
#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    unreachable_pub,
    reason = "a program for the shell, whose shapes the tests use too"
)]

mod shapes;

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

use shapes::{PINION, SHAPES};
use verlock::scene::Obj;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args_os().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("which folder?")?);
    let detail = match arguments.next() {
        Some(detail) => {
            let detail = detail.to_str().and_then(|detail| detail.parse().ok());
            detail
                .filter(|detail| (1..=100).contains(detail))
                .ok_or("DETAIL is a number, 1 to 100")?
        }
        None => 3,
    };
    fs::create_dir_all(&folder)?;
    for (name, shape) in SHAPES.into_iter().chain([PINION]) {
        let mesh = shape(detail);
        println!("{name}: {} faces", mesh.faces().len());
        let text = format!("# {name}, detail {detail}\n{}", Obj::from(mesh));
        fs::write(folder.join(name).with_extension("obj"), text)?;
    }
    Ok(())
}
