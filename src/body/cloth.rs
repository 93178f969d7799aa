//! Cloth from meshes.

use alloc::collections::BTreeSet;
use alloc::vec::Vec;

use super::tether::tethers;
use super::{Assembly, Face};
use crate::constraint::{Distance, DistanceForm};
use crate::geometry::{Adjacency, TriangleMesh};
use crate::math::{Factor, Real, Unit};
use crate::particle::{Particle, RangeError, check_in, check_not_negative};
use crate::real;

/// What a cloth is like. Vertices become particles, edges distances, faces faces.
///
/// ```
/// use verlock::body::Cloth;
/// use verlock::geometry::{Grid, TriangleMesh};
/// use verlock::{Vec3, WorldBuilder, WorldConfig};
///
/// let (columns, rows) = (20, 20);
/// let grid = Grid { corner: Vec3::ZERO, edge_u: Vec3::X, edge_v: -Vec3::Y, columns, rows };
/// let cloth = Cloth::default().of(&TriangleMesh::grid(&grid)?, |vertex| vertex < columns)?;
/// let mut builder = WorldBuilder::new(WorldConfig::default())?;
/// let ids = builder.assemble(&cloth)?;
/// let mut world = builder.build();
/// world.step(&[]);
/// assert!(world.position(ids[399]).is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Cloth {
    /// Of each particle, kilograms, 0.001 to 1,000,000. Default 0.01.
    pub mass: Real,
    /// Of the edges, 0 to 1. Default 1.
    pub stiffness: Unit,
    /// Stiffness of the distances across edges, from the tip of one face to that of the other: they
    /// resist folding, and shearing where two faces make a square. 0 to 1, 0 for none. Default 0.1.
    pub bending: Unit,
    /// Of all distances. Default [`DistanceForm::DivisionFree`].
    pub form: DistanceForm,
    /// Whether long-range attachments hold it to what is pinned: ropes from each particle to the
    /// nearest pinned one. Where 100 x 100 particles 0.02 m apart hang from their upper row (4
    /// substeps, 1 iteration), after 10 s the worst edge is 0.6 % too long with them and 180 %
    /// without. Not where it can tear: they would hold what is torn off. Default `true`.
    pub attachments: bool,
    /// Strain above which its distances take damage, 0 to 32,767; 0 for none. Default 0.
    pub tear_strain: Factor,
    /// Damage that they stand, 0 to 32,767. Default 0.
    pub toughness: Factor,
    /// Of the faces, newtons for every square metre and metre a second, 0 to 1,000. Default 0.
    pub drag: Factor,
}

impl Cloth {
    /// The cloth of a mesh, with the vertices pinned for which `pinned` says so. O(n log n).
    ///
    /// Edges without length make no distances, degenerate faces no faces.
    ///
    /// # Errors
    /// An edge is longer than [`Distance::REST_LENGTH_MAX`], or a number out of its range.
    pub fn of(
        &self,
        mesh: &TriangleMesh,
        pinned: impl Fn(u32) -> bool,
    ) -> Result<Assembly, RangeError> {
        self.validate()?;
        let adjacency = Adjacency::new(mesh);
        let mut cloth = Assembly {
            particles: Assembly::particles_at(mesh.vertices(), self.mass, pinned),
            ..Assembly::default()
        };
        for edge in adjacency.edges() {
            cloth.distances.extend(self.link(mesh, edge.ends, self.stiffness)?);
        }
        // Along the edges only: across them the way would be shorter than the cloth is.
        let tethers = if self.is_tethered() { tethers(&cloth) } else { Vec::new() };
        if self.bending > Unit::ZERO {
            for hinge in adjacency.hinges() {
                cloth.distances.extend(self.link(mesh, hinge.tips, self.bending)?);
            }
        }
        cloth.distances.extend(tethers);
        let flat: BTreeSet<u32> = mesh.degenerate_faces().collect();
        let faces = (0u32..).zip(mesh.faces()).filter(|(face, _)| !flat.contains(face));
        let face = |corners: &[u32; 3]| Face::new(corners.map(Assembly::id)).drag(self.drag);
        cloth.faces = faces.map(|(_, corners)| face(corners)).collect();
        Ok(cloth)
    }

    /// Checks every declared range.
    ///
    /// # Errors
    /// Names the first field that is out of its range.
    pub fn validate(&self) -> Result<(), RangeError> {
        let Self { mass, stiffness, bending, tear_strain, toughness, drag, .. } = *self;
        check_in(mass, Particle::MASS_MIN..=Particle::MASS_MAX, "mass")?;
        check_in(stiffness, Unit::ZERO..=Unit::ONE, "stiffness")?;
        check_in(bending, Unit::ZERO..=Unit::ONE, "bending")?;
        check_not_negative(tear_strain, "tear_strain")?;
        check_not_negative(toughness, "toughness")?;
        check_in(drag, Factor::ZERO..=Face::DRAG_MAX, "drag")
    }

    fn is_tethered(&self) -> bool {
        self.attachments && self.tear_strain == Factor::ZERO
    }

    /// A distance as placed; none between vertices that coincide.
    fn link(
        &self,
        mesh: &TriangleMesh,
        ends: [u32; 2],
        stiffness: Unit,
    ) -> Result<Option<Distance>, RangeError> {
        let [a, b] = ends.map(|end| mesh.vertices()[end as usize]);
        let length = a.distance(b);
        check_in(length, Real::ZERO..=Distance::REST_LENGTH_MAX, "rest_length")?;
        let [a, b] = ends.map(Assembly::id);
        let Self { tear_strain, toughness, form, .. } = *self;
        let link = Distance::new(a, b, length).form(form).stiffness(stiffness);
        Ok((length > Real::ZERO).then_some(Distance { tear_strain, toughness, ..link }))
    }
}

impl Default for Cloth {
    fn default() -> Self {
        Self {
            mass: real!("0.01"),
            stiffness: Unit::ONE,
            bending: Unit::from_raw(Unit::ONE.raw() / 10),
            form: DistanceForm::DivisionFree,
            attachments: true,
            tear_strain: Factor::ZERO,
            toughness: Factor::ZERO,
            drag: Factor::ZERO,
        }
    }
}
