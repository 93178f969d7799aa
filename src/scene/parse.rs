//! Text to description: what a scene file says, checked, with nothing made of it yet.

use alloc::vec::Vec;

use ron::Options;
use serde::Deserialize;

use super::Scene;
use super::cloth::Sheet;
use super::cloud::Cloud;
use super::config::ConfigFields;
use super::distance::DistanceEntry;
use super::error::{Place, SceneError, try_each};
use super::face::FaceEntry;
use super::half_space::HalfSpaceEntry;
use super::list::{LIST_MAX, list};
use super::net::Net;
use super::number::{present, shift, vector};
use super::particle::ParticleEntry;
use super::rope::Rope;
use super::shape::Shape;
use super::storm::Storm;
use super::timeline::Entry;
use super::volume::VolumeEntry;
use crate::body::FACES_MAX;
use crate::constraint::{DISTANCES_MAX, HALF_SPACES_MAX, VOLUMES_MAX};
use crate::math::Vec3;
use crate::particle::PARTICLES_MAX;
use crate::world::WorldConfig;

/// The struct that a scene file is. All positions are moved by the origin, the timeline is in
/// order of ticks.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename = "Scene", deny_unknown_fields)]
pub(super) struct Description {
    #[serde(rename = "version")]
    _version: Version,
    #[serde(default, with = "ConfigFields")]
    pub(super) config: WorldConfig,
    #[serde(default)]
    pub(super) seed: u64,
    #[serde(default = "default_ticks")]
    pub(super) ticks: u64,
    #[serde(default, deserialize_with = "vector")]
    origin: Vec3,
    #[serde(default, deserialize_with = "list::<_, _, PARTICLES_MAX>")]
    pub(super) particles: Vec<ParticleEntry>,
    #[serde(default, deserialize_with = "list::<_, _, LIST_MAX>")]
    pub(super) ropes: Vec<Rope>,
    #[serde(default, deserialize_with = "list::<_, _, LIST_MAX>")]
    pub(super) nets: Vec<Net>,
    #[serde(default, deserialize_with = "list::<_, _, LIST_MAX>")]
    pub(super) clouds: Vec<Cloud>,
    #[serde(default, deserialize_with = "list::<_, _, LIST_MAX>")]
    pub(super) cloths: Vec<Sheet>,
    #[serde(default, deserialize_with = "list::<_, _, LIST_MAX>")]
    pub(super) plants: Vec<Sheet>,
    #[serde(default, deserialize_with = "list::<_, _, DISTANCES_MAX>")]
    pub(super) distances: Vec<DistanceEntry>,
    #[serde(default, deserialize_with = "list::<_, _, HALF_SPACES_MAX>")]
    pub(super) half_spaces: Vec<HalfSpaceEntry>,
    #[serde(default, deserialize_with = "list::<_, _, VOLUMES_MAX>")]
    pub(super) volumes: Vec<VolumeEntry>,
    #[serde(default, deserialize_with = "list::<_, _, FACES_MAX>")]
    pub(super) faces: Vec<FaceEntry>,
    #[serde(default, deserialize_with = "list::<_, _, LIST_MAX>")]
    pub(super) timeline: Vec<Entry>,
    #[serde(default, deserialize_with = "present")]
    pub(super) storm: Option<Storm>,
}

/// The version of the format. Being the first field, it is refused before what it would explain.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(try_from = "u32")]
struct Version;

/// Structs in a scene are nested six deep at most; RON counts some of them twice.
const NESTING_MAX: usize = 32;

/// What some editors write before a text.
const BYTE_ORDER_MARK: char = '\u{feff}';

fn default_ticks() -> u64 {
    600
}

impl Description {
    /// Reads a scene and checks all that can be checked without making its objects.
    pub(super) fn parse(text: &str) -> Result<Self, SceneError> {
        if text.len() > Scene::TEXT_MAX {
            return Err(SceneError::TooLong);
        }
        let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
        let options = Options::default().with_recursion_limit(NESTING_MAX);
        let mut description: Self = options.from_str(text)?;
        description.shift()?;
        description.validate()?;
        (0u32..).zip(&mut description.timeline).for_each(|(index, entry)| entry.index = index);
        description.timeline.sort_by_key(|entry| entry.tick); // stable
        Ok(description)
    }

    /// Moves every position by the origin.
    fn shift(&mut self) -> Result<(), SceneError> {
        fn shapes<S: Shape>(shapes: &mut [S], origin: Vec3) -> Result<(), SceneError> {
            try_each(S::SECTION, shapes, |shape| shape.shift(origin))
        }
        let origin = self.origin;
        try_each("particles", &mut self.particles, |ParticleEntry(spec)| {
            shift(&mut spec.position, origin, "position")
        })?;
        shapes(&mut self.ropes, origin)?;
        shapes(&mut self.nets, origin)?;
        shapes(&mut self.clouds, origin)?;
        try_each("cloths", &mut self.cloths, |cloth| cloth.shift(origin))?;
        try_each("plants", &mut self.plants, |plant| plant.shift(origin))?;
        try_each("half_spaces", &mut self.half_spaces, |HalfSpaceEntry(half_space)| {
            shift(&mut half_space.point, origin, "point")
        })?;
        try_each("timeline", &mut self.timeline, |entry| entry.shift(origin))?;
        let storm = self.storm.as_mut().map_or(Ok(()), |storm| storm.shift(origin));
        storm.map_err(|why| Place::of("storm").refuses(why))
    }

    fn validate(&self) -> Result<(), SceneError> {
        fn sum(counts: impl Iterator<Item = [u64; 3]>) -> [u64; 3] {
            counts.fold([0; 3], |a, b| [0, 1, 2].map(|k| a[k].saturating_add(b[k])))
        }
        fn shapes<S: Shape>(shapes: &[S]) -> Result<[u64; 3], SceneError> {
            try_each(S::SECTION, shapes, Shape::validate)?;
            Ok(sum(shapes.iter().map(Shape::count).map(|[particles, links]| [particles, links, 0])))
        }
        self.config.validate().map_err(|why| Place::of("config").refuses(why))?;
        let sheets = sum(self.cloths.iter().chain(&self.plants).map(Sheet::count));
        let made = [shapes(&self.ropes)?, shapes(&self.nets)?, shapes(&self.clouds)?, sheets];
        let listed = [self.particles.len(), self.distances.len(), self.faces.len()];
        let kinds =
            [("particles", PARTICLES_MAX), ("distances", DISTANCES_MAX), ("faces", FACES_MAX)];
        for (k, (kind, most)) in kinds.into_iter().enumerate() {
            let listed = listed[k] as u64; // usize to u64 is lossless
            let total = made.iter().fold(listed, |sum, count| sum.saturating_add(count[k]));
            if total > most as u64 {
                return Err(SceneError::TooMany { kind, most });
            }
        }
        let storm = self.storm.as_ref().map_or(Ok(()), Storm::validate);
        storm.map_err(|why| Place::of("storm").refuses(why))
    }
}

impl TryFrom<u32> for Version {
    type Error = &'static str;

    fn try_from(version: u32) -> Result<Self, Self::Error> {
        if version == 1 {
            Ok(Self)
        } else {
            Err("scenes of this version are not supported, only 1")
        }
    }
}
