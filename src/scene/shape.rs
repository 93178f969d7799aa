//! What ropes, nets and clouds have in common.

use crate::constraint::Distance;
use crate::math::Vec3;
use crate::particle::{ParticleSpec, RangeError};

/// Something that makes particles, and distances between them.
pub(super) trait Shape {
    /// The field of the scene that lists shapes of this kind.
    const SECTION: &'static str;

    /// What it calls a field of the objects that it makes.
    fn name_of(field: &'static str) -> &'static str;

    /// Moves it by the scene's origin.
    fn shift(&mut self, origin: Vec3) -> Result<(), RangeError>;

    /// Checks what the methods below rely on.
    fn validate(&self) -> Result<(), RangeError>;

    /// How many particles and how many links it makes.
    fn count(&self) -> [u64; 2];

    /// Its particles; `number` is its place among the shapes of its kind.
    fn particles(&self, number: u32) -> impl Iterator<Item = ParticleSpec>;

    /// The pairs of particles that it links, counted from its first.
    fn links(&self) -> impl Iterator<Item = [u32; 2]>;

    /// What its links are like.
    fn link(&self) -> Distance;
}
