//! Cloths and plants: meshes of which bodies are made.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::string::String;
use alloc::vec::Vec;

use serde::Deserialize;

use super::error::{Place, SceneError};
use super::number::{decimal, shift, vector};
use crate::body::{Assembly, Cloth, Plant};
use crate::constraint::DistanceForm;
use crate::geometry::{Grid, TriangleMesh};
use crate::math::{Factor, Real, Unit, Vec3};
use crate::particle::{Particle, RangeError, check};

/// The meshes of the files that a scene names.
pub(super) type Meshes = BTreeMap<String, TriangleMesh>;

/// Where a mesh comes from.
#[derive(Clone, Debug, Deserialize)]
pub(super) enum Source {
    /// An OBJ file.
    File(String),
    /// A parallelogram.
    Grid {
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
pub(super) enum Vertices {
    #[default]
    None,
    /// Those of the greatest y.
    Top,
    /// Those of the least y.
    Bottom,
    /// These, counted from 0.
    Places(Vec<u32>),
}

/// A body of a mesh as a scene file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sheet {
    mesh: Source,
    /// Is added to the vertices.
    #[serde(default, deserialize_with = "vector")]
    at: Vec3,
    #[serde(default)]
    pinned: Vertices,
    #[serde(default = "mass", deserialize_with = "decimal")]
    mass: Real,
    #[serde(default = "stiffness", deserialize_with = "decimal")]
    stiffness: Unit,
    #[serde(default = "bending", deserialize_with = "decimal")]
    bending: Unit,
    #[serde(default = "form")]
    form: DistanceForm,
    #[serde(default = "attachments")]
    attachments: bool,
    #[serde(default, deserialize_with = "decimal")]
    tear_strain: Factor,
    #[serde(default, deserialize_with = "decimal")]
    toughness: Factor,
    #[serde(default, deserialize_with = "decimal")]
    drag: Factor,
    /// Of a plant's stakes; for cloth nothing.
    #[serde(default = "compliance", deserialize_with = "decimal")]
    compliance: Unit,
    #[serde(default = "spread", deserialize_with = "decimal")]
    spread: Real,
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

fn attachments() -> bool {
    Cloth::default().attachments
}

fn compliance() -> Unit {
    Plant::default().compliance
}

fn spread() -> Real {
    Plant::default().spread
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
        let mesh = self.mesh(place, meshes)?;
        let pinned = self.pinned.of(&mesh);
        let made = self.body().and_then(|cloth| cloth.of(&mesh, pinned));
        made.map_err(|why| place.refuses(why))
    }

    /// The parts of the plant.
    pub(super) fn plant(&self, place: Place, meshes: &Meshes) -> Result<Assembly, SceneError> {
        let mesh = self.mesh(place, meshes)?;
        let rooted = self.pinned.of(&mesh);
        let Self { compliance, spread, .. } = *self;
        let made = self.body().and_then(|cloth| {
            let plant = Plant { cloth, compliance, spread };
            plant.of(&mesh, rooted)
        });
        made.map_err(|why| place.refuses(why))
    }

    fn body(&self) -> Result<Cloth, RangeError> {
        let Self { mass, stiffness, bending, form, attachments, .. } = *self;
        let Self { tear_strain, toughness, drag, .. } = *self;
        check((Particle::MASS_MIN..=Particle::MASS_MAX).contains(&mass), "mass")?;
        Ok(Cloth { mass, stiffness, bending, form, attachments, tear_strain, toughness, drag })
    }

    /// Its mesh, in its place.
    fn mesh(&self, place: Place, meshes: &Meshes) -> Result<TriangleMesh, SceneError> {
        let refused = |why| SceneError::Mesh { place, why };
        match &self.mesh {
            Source::Grid { edge_u, edge_v, columns, rows } => {
                let (edge_u, edge_v, columns, rows) = (*edge_u, *edge_v, *columns, *rows);
                let grid = Grid { corner: self.at, edge_u, edge_v, columns, rows };
                TriangleMesh::grid(&grid).map_err(refused)
            }
            Source::File(name) => {
                let mesh = meshes.get(name).ok_or(SceneError::NoMesh { place })?;
                let moved = mesh.vertices().iter().map(|vertex| {
                    let sum = [0, 1, 2].map(|k| vertex.raw()[k].saturating_add(self.at.raw()[k]));
                    Vec3::from_raw(sum)
                });
                TriangleMesh::new(moved, mesh.faces().iter().copied()).map_err(refused)
            }
        }
    }
}

impl Vertices {
    /// Whether a vertex is one of them.
    fn of(&self, mesh: &TriangleMesh) -> impl Fn(u32) -> bool {
        let heights = || mesh.vertices().iter().map(|vertex| vertex.y);
        let level = match self {
            Self::None | Self::Places(_) => None,
            Self::Top => heights().max(),
            Self::Bottom => heights().min(),
        };
        let places: BTreeSet<u32> = match self {
            Self::Places(places) => places.iter().copied().collect(),
            _ => BTreeSet::new(),
        };
        move |vertex| places.contains(&vertex) || level == Some(mesh.vertices()[vertex as usize].y)
    }
}
