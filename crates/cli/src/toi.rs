//! `verlock toi`: when a mesh that moves touches another.

use std::io::Write;
use std::path::PathBuf;

use serde_json::{Value, json};
use verlock::collision::{MeshMotion, MeshShape, TimeOfImpact};
use verlock::geometry::Sphere;
use verlock::geometry::sweep::Sweep;
use verlock::math::Unit;
use verlock::{Real, Vec3};

use crate::count::counted;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::input::Input;
use crate::mesh::{check_pairs, feature_name, mesh};
use crate::number::length;
use crate::render::point;

/// Tell when a mesh that moves first touches another
///
/// A moves, B does not. The time is a fraction of the motion, and never late: before it they do not
/// touch. It is the time of the first contact, rounded down to 2^-30 of the motion, but for
/// contacts too near to a miss to be told from one, which count, and where the search was cut short
/// after much work: that is said, and the time may be too early. Prints the time, then a line for
/// each pair that touches, up to 12: of A and of B, counted from 0 in the order of the files, edges
/// in the order of their vertices; or `none`. In JSON: "hit", "t" as an exact decimal in a text, or
/// null, all "features", and "cut". Returns 0 whether or not they touch.
#[derive(Debug, clap::Args)]
pub(crate) struct Toi {
    /// Mesh A, an OBJ file
    a: PathBuf,

    /// Mesh B, an OBJ file
    b: PathBuf,

    /// How far A moves, in metres
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    motion: Vec3,

    /// Touch when they come so near, in metres, up to 32768
    ///
    /// All pairs of faces within the gap up to the first contact are looked at, which takes long
    /// where it is as wide as many faces. Refused if at the start there are more than 100,000, and
    /// more than 32 for each face.
    #[arg(long, value_name = "METRES", value_parser = gap, default_value = "0")]
    gap: Real,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// No more pairs of faces may be within the gap at the start, as each may cost a search; or so many
/// for each face, if that is more.
const PAIRS_MAX: usize = 100_000;
const FACE_PAIRS_MAX: usize = 32;

/// How many pairs are listed for people: two flat sides touch in hundreds.
const LISTED: usize = 12;

impl Toi {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let inputs = Input::read_two(&self.a, &self.b, limit)?;
        let shapes = [MeshShape::new(mesh(&inputs[0])?), MeshShape::new(mesh(&inputs[1])?)];
        if self.gap > Real::ZERO {
            let faces: usize = shapes.iter().map(|shape| shape.mesh().faces().len()).sum();
            check_pairs(&shapes, "--gap", self.gap, PAIRS_MAX.max(FACE_PAIRS_MAX * faces))?;
        }
        let [a, b] = shapes;
        let ends: Option<Vec<_>> =
            a.vertices().iter().map(|vertex| vertex.checked_add(self.motion)).collect();
        let moving = ends.as_ref().and_then(|ends| MeshMotion::new(&a, ends).ok());
        let moving = moving.ok_or_else(|| Failure::usage("--motion: leads out of range"))?;
        let resting = MeshMotion::new(&b, b.vertices())
            .map_err(|error| Failure::usage(format!("{}: {error}", inputs[1].name())))?;
        let sweep = Sweep { gap: self.gap, ..Sweep::default() };
        let found = moving.time_of_impact(&resting, &sweep);
        let time = found.as_ref().map(|found| decimal(found.time));
        let features = found.iter().flat_map(|found| &found.features);
        let names = features.map(|features| features.map(feature_name));
        if self.json {
            let features: Vec<Value> = names.map(|names| json!(names)).collect();
            let is_cut = found.as_ref().is_some_and(|found| found.is_cut);
            let found = json!({
                "v": 1, "hit": found.is_some(), "t": time, "features": features, "cut": is_cut,
            });
            writeln!(out, "{found:#}")?;
        } else {
            let time = time.as_deref().unwrap_or("none");
            writeln!(out, "{time}{}", found.as_ref().map_or("", |found| remark(found, self.gap)))?;
            for [a, b] in names.take(LISTED) {
                writeln!(out, "{a}, {b}")?;
            }
            let touching = found.as_ref().map_or(0, |found| found.features.len());
            if touching > LISTED {
                writeln!(out, "and {}", counted((touching - LISTED) as u64, "more pair"))?;
            }
        }
        Ok(Exit::Fine)
    }
}

/// A length that a search can take.
fn gap(text: &str) -> Result<Real, String> {
    let gap = length(text)?;
    if gap > Sphere::RADIUS_MAX { Err("is above 32768".into()) } else { Ok(gap) }
}

/// What must be said of a time.
fn remark(found: &TimeOfImpact, gap: Real) -> &'static str {
    match found {
        TimeOfImpact { is_cut: true, .. } => " or later: the search was cut short",
        TimeOfImpact { time: Unit::ZERO, .. } if gap > Real::ZERO => {
            ": within the gap at the start"
        }
        TimeOfImpact { time: Unit::ZERO, .. } => ": they touch at the start",
        _ => "",
    }
}

/// The exact decimal of a number of 0 or more: at most 30 digits behind the point. The shortest one
/// that is read as the same number may be above it, and then it would be late.
fn decimal(number: Unit) -> String {
    let raw = i64::from(number.raw());
    let mask = i64::from(Unit::ONE.raw()) - 1;
    let mut digits = (raw >> Unit::FRACTION_BITS).to_string();
    let mut rest = raw & mask;
    if rest != 0 {
        digits.push('.');
    }
    while rest != 0 {
        rest *= 10;
        digits += &(rest >> Unit::FRACTION_BITS).to_string();
        rest &= mask;
    }
    digits
}
