//! The kinds of what stands in for a mesh.

use std::sync::Arc;

use clap::ValueEnum;
use serde_json::{Value, json};
use verlock::geometry::{
    ConvexHull, Fit, ShapeError, TriangleMesh, fit_capsule, fit_cuboid, fit_hull, fit_sphere,
};
use verlock::{Real, Vec3};

use super::look::{Look, of_box, of_hull, round};
use crate::count::counted;
use crate::failure::{Failure, tell};
use crate::input::Input;
use crate::number::count_from;

/// What is wanted.
#[derive(Clone, Copy, Debug, clap::Args)]
#[group(required = true, multiple = false)]
pub(super) struct Wanted {
    /// A mesh of so many triangles, or as few as it can have
    #[arg(long, value_name = "N", value_parser = count_from::<1>)]
    triangles: Option<u32>,

    /// A convex hull around it with so many vertices
    #[arg(long, value_name = "N", value_parser = count_from::<4>)]
    hull: Option<u32>,

    /// A simple shape around it
    #[arg(long, value_enum)]
    fit: Option<Simple>,
}

/// Shapes that a few numbers describe.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Simple {
    Capsule,
    Sphere,
    Box,
}

/// What stands in for a mesh.
#[derive(Debug)]
pub(super) struct Proxy {
    pub(super) kind: &'static str,
    pub(super) look: Look,
    /// Of a shape around the mesh: how far it reaches beyond the mesh's hull, and its numbers.
    pub(super) around: Option<(Real, Value)>,
}

impl Wanted {
    /// What stands in for the mesh of a file.
    pub(super) fn of(self, original: &TriangleMesh, input: &Input) -> Result<Proxy, Failure> {
        let Self { triangles, hull, fit } = self;
        if let Some(triangles) = triangles {
            return fewer(original, triangles as usize, input);
        }
        let refused = |error: ShapeError| match error {
            ShapeError::Flat => input.refused("all vertices lie in one plane"),
            _ => input.refused(error),
        };
        let around = ConvexHull::around(original.vertices().iter().copied()).map_err(refused)?;
        let too_far = |_| input.refused("the shape around it reaches beyond 2^36 m");
        match (hull, fit) {
            (Some(vertices), _) => {
                fit_hull(&around, vertices).map(|fit| hull_proxy(&fit)).map_err(refused)
            }
            (None, Some(Simple::Capsule)) => {
                let Fit { shape, deviation } = fit_capsule(&around).map_err(refused)?;
                let (ends, radius) = (shape.ends(), shape.radius());
                if ends[0] == ends[1] {
                    tell("the smallest capsule around it is a sphere");
                }
                let numbers = json!({ "ends": ends.map(text), "radius": number(radius) });
                let look = round(ends, radius).map_err(too_far)?;
                Ok(proxy("capsule", look, deviation, numbers))
            }
            (None, Some(Simple::Box)) => {
                let Fit { shape, deviation } = fit_cuboid(&around).map_err(refused)?;
                let half_edges = shape.half_edges().map(text);
                let numbers = json!({ "center": text(shape.center()), "half_edges": half_edges });
                Ok(proxy("box", of_box(&shape), deviation, numbers))
            }
            (None, Some(Simple::Sphere) | None) => {
                let Fit { shape, deviation } = fit_sphere(&around).map_err(refused)?;
                let (center, radius) = (shape.center(), shape.radius());
                let numbers = json!({ "center": text(center), "radius": number(radius) });
                let look = round([center; 2], radius).map_err(too_far)?;
                Ok(proxy("sphere", look, deviation, numbers))
            }
        }
    }
}

/// The mesh with fewer faces.
fn fewer(original: &TriangleMesh, triangles: usize, input: &Input) -> Result<Proxy, Failure> {
    let mesh = original.decimated(triangles).map_err(|error| input.refused(error))?;
    if original.faces().len() <= triangles {
        let count = counted(original.faces().len() as u64, "triangle");
        tell(format_args!("{}: has {count} already", input.name()));
    }
    if mesh.faces().len() > triangles {
        let least = counted(mesh.faces().len() as u64, "triangle");
        tell(format_args!("{least}: with fewer, parts or holes would be lost"));
    }
    let look = Look { mesh: Arc::new(mesh), rough: Real::ZERO };
    Ok(Proxy { kind: "triangles", look, around: None })
}

fn hull_proxy(Fit { shape, deviation }: &Fit<ConvexHull>) -> Proxy {
    let numbers = json!({ "faces": shape.faces().len(), "vertices": shape.vertices().len() });
    proxy("hull", of_hull(shape), *deviation, numbers)
}

fn proxy(kind: &'static str, look: Look, beyond: Real, numbers: Value) -> Proxy {
    Proxy { kind, look, around: Some((beyond, numbers)) }
}

fn number(number: Real) -> String {
    number.to_string()
}

/// A point as options take it.
pub(super) fn text(Vec3 { x, y, z }: Vec3) -> String {
    format!("{x},{y},{z}")
}
