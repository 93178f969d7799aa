//! Cloths and plants: meshes of which bodies are made.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::string::String;
use alloc::vec::Vec;

use serde::Deserialize;

use super::error::{Place, SceneError};
use super::number::{decimal, present, present_decimal, shift, vector};
use crate::body::{Assembly, Cloth, Plant};
use crate::constraint::DistanceForm;
use crate::geometry::{Grid, TriangleMesh};
use crate::math::{Factor, Real, Unit, Vec3};
use crate::particle::{RangeError, check_in};
use crate::store::slot_index;

/// The meshes of the files that a scene names.
pub(super) type Meshes = BTreeMap<String, TriangleMesh>;

/// Where a mesh comes from.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "Mesh", deny_unknown_fields)]
enum Source {
    /// An OBJ file.
    File(String),
    /// A parallelogram.
    Grid {
        #[serde(default, deserialize_with = "vector")]
        corner: Vec3,
        #[serde(deserialize_with = "vector")]
        edge_u: Vec3,
        #[serde(deserialize_with = "vector")]
        edge_v: Vec3,
        columns: u32,
        rows: u32,
    },
}

/// Which vertices are pinned.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(rename = "Pinned")]
enum Vertices {
    #[default]
    None,
    /// Those of the greatest y.
    Top,
    /// Those of the least y.
    Bottom,
    /// These, counted from 0.
    Places(Vec<u32>),
}

/// A body of a mesh, cloth or plant, as a scene file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "Body", deny_unknown_fields)]
pub(super) struct Sheet {
    mesh: Source,
    /// Is added to the vertices.
    #[serde(default, deserialize_with = "vector")]
    at: Vec3,
    #[serde(default)]
    pinned: Vertices,
    /// Of each particle.
    #[serde(default = "mass", deserialize_with = "decimal")]
    mass: Real,
    #[serde(default = "stiffness", deserialize_with = "decimal")]
    stiffness: Unit,
    #[serde(default = "bending", deserialize_with = "decimal")]
    bending: Unit,
    #[serde(default = "form")]
    form: DistanceForm,
    /// Of cloth only.
    #[serde(default, deserialize_with = "present")]
    attachments: Option<bool>,
    #[serde(default, deserialize_with = "decimal")]
    tear_strain: Factor,
    #[serde(default, deserialize_with = "decimal")]
    toughness: Factor,
    #[serde(default, deserialize_with = "decimal")]
    drag: Factor,
    /// Of a plant's stakes.
    #[serde(default, deserialize_with = "present_decimal")]
    compliance: Option<Unit>,
    #[serde(default, deserialize_with = "present_decimal")]
    spread: Option<Real>,
}

fn mass() -> Real {
    Cloth::default().mass
}

fn stiffness() -> Unit {
    Cloth::default().stiffness
}

fn bending() -> Unit {
    Cloth::default().bending
}

fn form() -> DistanceForm {
    Cloth::default().form
}

impl Sheet {
    /// The file that its mesh is in.
    pub(super) fn file(&self) -> Option<&str> {
        match &self.mesh {
            Source::File(name) => Some(name),
            Source::Grid { .. } => None,
        }
    }

    /// How many particles, distances along edges and faces a grid makes, unless it is flat; meshes
    /// of files are bounded by their texts.
    pub(super) fn count(&self) -> [u64; 3] {
        let Source::Grid { columns, rows, .. } = self.mesh else { return [0; 3] };
        let [columns, rows] = [columns, rows].map(u64::from);
        let [steps_u, steps_v] = [columns, rows].map(|n| n.saturating_sub(1));
        let cells = steps_u * steps_v; // as all products below 2^64: (2^32 - 1)^2
        let edges = (steps_u * rows).saturating_add(columns * steps_v).saturating_add(cells);
        [columns * rows, edges, cells.saturating_mul(2)]
    }

    /// Moves it by the scene's origin.
    pub(super) fn shift(&mut self, origin: Vec3) -> Result<(), RangeError> {
        shift(&mut self.at, origin, "at")
    }

    /// The parts of the cloth.
    pub(super) fn cloth(&self, place: Place, meshes: &Meshes) -> Result<Assembly, SceneError> {
        lacks(place, self.compliance.is_some(), "compliance")?;
        lacks(place, self.spread.is_some(), "spread")?;
        let mesh = self.mesh(place, meshes)?;
        let made = self.pinned.of(&mesh).and_then(|pinned| self.body().of(&mesh, pinned));
        made.map_err(|why| place.refuses_as(why, name_of))
    }

    /// The parts of the plant.
    pub(super) fn plant(&self, place: Place, meshes: &Meshes) -> Result<Assembly, SceneError> {
        lacks(place, self.attachments.is_some(), "attachments")?;
        let mesh = self.mesh(place, meshes)?;
        let usual = Plant::default();
        let plant = Plant {
            cloth: self.body(),
            compliance: self.compliance.unwrap_or(usual.compliance),
            spread: self.spread.unwrap_or(usual.spread),
        };
        let made = self.pinned.of(&mesh).and_then(|rooted| plant.of(&mesh, rooted));
        made.map_err(|why| place.refuses_as(why, name_of))
    }

    fn body(&self) -> Cloth {
        let Self { mass, stiffness, bending, form, tear_strain, toughness, drag, .. } = *self;
        let attachments = self.attachments.unwrap_or(Cloth::default().attachments);
        Cloth { mass, stiffness, bending, form, attachments, tear_strain, toughness, drag }
    }

    /// Its mesh, in its place.
    fn mesh(&self, place: Place, meshes: &Meshes) -> Result<TriangleMesh, SceneError> {
        let refused = |why| SceneError::Mesh { place, why };
        match &self.mesh {
            &Source::Grid { corner, edge_u, edge_v, columns, rows } => {
                let corner = moved(corner, self.at);
                let grid = Grid { corner, edge_u, edge_v, columns, rows };
                TriangleMesh::grid(&grid).map_err(refused)
            }
            Source::File(name) => {
                // `Scene::parse_with` has read it.
                let missing = || SceneError::NoMesh { place, why: name.clone() };
                let mesh = meshes.get(name).ok_or_else(missing)?;
                let vertices = mesh.vertices().iter().map(|&vertex| moved(vertex, self.at));
                TriangleMesh::new(vertices, mesh.faces().iter().copied()).map_err(refused)
            }
        }
    }
}

impl Vertices {
    /// Whether a vertex is one of them.
    fn of(&self, mesh: &TriangleMesh) -> Result<impl Fn(u32) -> bool, RangeError> {
        let vertices = mesh.vertices();
        let last = slot_index(vertices.len().saturating_sub(1));
        let heights = || vertices.iter().map(|vertex| vertex.y);
        let level = match self {
            Self::None | Self::Places(_) => None,
            Self::Top => heights().max(),
            Self::Bottom => heights().min(),
        };
        let places: BTreeSet<u32> = match self {
            Self::Places(places) => places.iter().copied().collect(),
            _ => BTreeSet::new(),
        };
        places.iter().try_for_each(|&place| check_in(place, 0..=last, "pinned"))?;
        Ok(move |vertex| places.contains(&vertex) || level == Some(vertices[vertex as usize].y))
    }
}

/// What a scene calls the fields of bodies and their parts.
fn name_of(field: &'static str) -> &'static str {
    match field {
        "rooted" => "pinned",
        "rest_length" => "mesh: a link",
        field => field,
    }
}

/// Refuses a field that is there, of a body that has no use for it.
fn lacks(place: Place, there: bool, field: &'static str) -> Result<(), SceneError> {
    if there { Err(SceneError::NoField { place, field }) } else { Ok(()) }
}

/// What leaves the range of the sum leaves the world, and is refused.
fn moved(position: Vec3, by: Vec3) -> Vec3 {
    Vec3::from_raw([0, 1, 2].map(|k| position.raw()[k].saturating_add(by.raw()[k])))
}
