//! A parallelogram of particles, linked along its rows, its columns and its diagonals.

use serde::Deserialize;

use super::number::{decimal, shift, step, vector};
use super::shape::Shape;
use crate::constraint::{Distance, DistanceForm};
use crate::math::{Real, Unit, Vec3};
use crate::particle::{ParticleSpec, RangeError, WORLD_LIMIT, check_in, check_within};

/// A net as a scene file describes it.
#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct Net {
    /// Where the first row and the first column begin.
    #[serde(deserialize_with = "vector")]
    corner: Vec3,
    /// From the corner to the end of the first row.
    #[serde(deserialize_with = "vector")]
    edge_u: Vec3,
    /// From the corner to the end of the first column.
    #[serde(deserialize_with = "vector")]
    edge_v: Vec3,
    /// Particles in a row, at least 2.
    columns: u32,
    /// Particles in a column, at least 2.
    rows: u32,
    /// Of each particle.
    #[serde(deserialize_with = "decimal")]
    mass: Real,
    pinned: Pinned,
    #[serde(deserialize_with = "decimal")]
    stiffness: Unit,
    form: DistanceForm,
    /// Whether both diagonals of every mesh are linked.
    diagonals: bool,
}

/// Which particles of a net are pinned.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
enum Pinned {
    #[default]
    None,
    /// The first row.
    Top,
    /// All four.
    Corners,
}

impl Net {
    /// Whether the particle of this column and row is pinned.
    fn pins(&self, column: u32, row: u32) -> bool {
        match self.pinned {
            Pinned::None => false,
            Pinned::Top => row == 0,
            Pinned::Corners => {
                [0, self.columns - 1].contains(&column) && [0, self.rows - 1].contains(&row)
            }
        }
    }
}

impl Shape for Net {
    const SECTION: &'static str = "nets";

    fn name_of(field: &'static str) -> &'static str {
        match field {
            "rest_length" => "edge_u or edge_v: a link",
            "position" => "corner, edge_u or edge_v: a position",
            field => field,
        }
    }

    fn shift(&mut self, origin: Vec3) -> Result<(), RangeError> {
        shift(&mut self.corner, origin, "corner")
    }

    fn validate(&self) -> Result<(), RangeError> {
        check_within(self.corner, WORLD_LIMIT, "corner")?;
        for (edge, field) in [(self.edge_u, "edge_u"), (self.edge_v, "edge_v")] {
            check_within(edge, WORLD_LIMIT, field)?;
            if edge == Vec3::ZERO {
                return Err(RangeError::coincident(field));
            }
        }
        check_in(self.columns, 2..=u32::MAX, "columns")?;
        check_in(self.rows, 2..=u32::MAX, "rows")
    }

    fn count(&self) -> [u64; 2] {
        let [columns, rows] = [self.columns, self.rows].map(u64::from);
        let [steps_u, steps_v] = [columns, rows].map(|n| n.saturating_sub(1));
        let diagonals = if self.diagonals { 2 } else { 0 };
        // Below 2^64: (2^32 - 1)^2. The links may be more, in a net that is too large anyway.
        let links = (steps_u * rows)
            .saturating_add(columns * steps_v)
            .saturating_add((steps_u * steps_v).saturating_mul(diagonals));
        [columns * rows, links]
    }

    fn particles(&self, _: u32) -> impl Iterator<Item = ParticleSpec> {
        let steps = [self.columns - 1, self.rows - 1];
        (0..self.rows).flat_map(move |row| {
            (0..self.columns).map(move |column| {
                // Three vectors within +-2^60.
                let position = self.corner
                    + step(self.edge_u, column, steps[0])
                    + step(self.edge_v, row, steps[1]);
                let mut spec = ParticleSpec::at(position).mass(self.mass);
                spec.particle.pinned = self.pins(column, row);
                spec
            })
        })
    }

    /// Rows, then columns, then diagonals, so that few colours hold many links each.
    fn links(&self) -> impl Iterator<Item = [u32; 2]> {
        let Self { columns, rows, .. } = *self;
        let at = move |column, row| row * columns + column; // below 2^22, see `count`
        let cells = move |columns, rows| {
            (0..rows).flat_map(move |row| (0..columns).map(move |column| (column, row)))
        };
        let along_rows = cells(columns - 1, rows).map(move |(u, v)| [at(u, v), at(u + 1, v)]);
        let along_columns = cells(columns, rows - 1).map(move |(u, v)| [at(u, v), at(u, v + 1)]);
        let meshes = if self.diagonals { (columns - 1, rows - 1) } else { (0, 0) };
        let falling = cells(meshes.0, meshes.1).map(move |(u, v)| [at(u, v), at(u + 1, v + 1)]);
        let rising = cells(meshes.0, meshes.1).map(move |(u, v)| [at(u, v + 1), at(u + 1, v)]);
        along_rows.chain(along_columns).chain(falling).chain(rising)
    }

    fn link(&self) -> Distance {
        Distance::default().stiffness(self.stiffness).form(self.form)
    }
}

impl Default for Net {
    fn default() -> Self {
        Self {
            corner: Vec3::ZERO,
            edge_u: Vec3::X,
            edge_v: -Vec3::Y,
            columns: 2,
            rows: 2,
            mass: Real::ONE,
            pinned: Pinned::default(),
            stiffness: Unit::ONE,
            form: DistanceForm::default(),
            diagonals: false,
        }
    }
}
