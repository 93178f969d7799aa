//! Description to world.

use alloc::vec::Vec;

use super::cloth::Meshes;
use super::distance::{DistanceEntry, as_placed};
use super::error::{Place, SceneError};
use super::face::FaceEntry;
use super::half_space::HalfSpaceEntry;
use super::parse::Description;
use super::particle::ParticleEntry;
use super::shape::Shape;
use super::volume::{self, VolumeEntry};
use crate::body::Assembly;
use crate::constraint::Distance;
use crate::math::{Real, Vec3};
use crate::particle::{ParticleId, ParticleSpec, RangeError};
use crate::world::{World, WorldBuilder};

/// A world that is being filled.
struct Build {
    world: WorldBuilder,
    /// The particles made so far, in order.
    particles: Vec<(ParticleId, Vec3)>,
    /// The distances of shapes; made after those of the file.
    links: Vec<(Place, Distance, Rename)>,
}

/// What a scene calls a field of an object.
type Rename = fn(&'static str) -> &'static str;

/// Makes the objects of a scene in the order that the floor's documentation states.
pub(super) fn build(description: &Description, meshes: &Meshes) -> Result<World, SceneError> {
    let mut world =
        WorldBuilder::new(description.config).map_err(|why| Place::of("config").refuses(why))?;
    world.seed(description.seed);
    let mut build = Build { world, particles: Vec::new(), links: Vec::new() };
    for (index, ParticleEntry(spec)) in (0u32..).zip(&description.particles) {
        build.particle(Place::at("particles", index), spec, as_is)?;
    }
    build.shapes(&description.ropes)?;
    build.shapes(&description.nets)?;
    build.shapes(&description.clouds)?;
    for (index, cloth) in (0u32..).zip(&description.cloths) {
        let place = Place::at("cloths", index);
        build.assemble(place, &cloth.cloth(place, meshes)?)?;
    }
    for (index, plant) in (0u32..).zip(&description.plants) {
        let place = Place::at("plants", index);
        build.assemble(place, &plant.plant(place, meshes)?)?;
    }
    for (index, DistanceEntry(distance)) in (0u32..).zip(&description.distances) {
        build.distance(Place::at("distances", index), distance, as_is)?;
    }
    for (place, distance, rename) in core::mem::take(&mut build.links) {
        build.distance(place, &distance, rename)?;
    }
    for (index, HalfSpaceEntry(half_space)) in (0u32..).zip(&description.half_spaces) {
        let made = build.world.half_space(half_space);
        made.map_err(|why| Place::at("half_spaces", index).refuses(why))?;
    }
    for (index, VolumeEntry(volume)) in (0u32..).zip(&description.volumes) {
        let placed = volume::as_placed(volume, |id| build.position(id));
        let made = build.world.volume(&placed);
        made.map_err(|why| Place::at("volumes", index).refuses(why))?;
    }
    for (index, FaceEntry(face)) in (0u32..).zip(&description.faces) {
        let made = build.world.face(face);
        made.map_err(|why| Place::at("faces", index).refuses(why))?;
    }
    Ok(build.world.build())
}

impl Build {
    fn particle(
        &mut self,
        place: Place,
        spec: &ParticleSpec,
        rename: Rename,
    ) -> Result<(), SceneError> {
        let id = self.world.particle(spec).map_err(|why| place.refuses_as(why, rename))?;
        self.particles.push((id, spec.position));
        Ok(())
    }

    fn assemble(&mut self, place: Place, assembly: &Assembly) -> Result<(), SceneError> {
        let ids = self.world.assemble(assembly).map_err(|why| place.refuses(why))?;
        let positions = assembly.particles.iter().map(|spec| spec.position);
        self.particles.extend(ids.into_iter().zip(positions));
        Ok(())
    }

    fn shapes<S: Shape>(&mut self, shapes: &[S]) -> Result<(), SceneError> {
        for (number, shape) in (0u32..).zip(shapes) {
            let place = Place::at(S::SECTION, number);
            let first = self.particles.len();
            for spec in shape.particles(number) {
                self.particle(place, &spec, S::name_of)?;
            }
            let made = &self.particles[first..];
            self.links.extend(shape.links().map(|ends| {
                let [a, b] = ends.map(|end| made[end as usize].0);
                (place, Distance { a, b, ..shape.link() }, S::name_of as Rename)
            }));
        }
        Ok(())
    }

    /// Where a particle was placed. A new world has no gaps: slots are places in the list.
    fn position(&self, id: ParticleId) -> Option<Vec3> {
        self.particles.get(id.0.slot()).map(|&(_, position)| position)
    }

    fn distance(
        &mut self,
        place: Place,
        distance: &Distance,
        rename: Rename,
    ) -> Result<(), SceneError> {
        let placed = as_placed(distance, |id| self.position(id));
        if placed.rest_length == Real::ZERO && placed.a != placed.b {
            return Err(place.refuses_as(RangeError::coincident("rest_length"), rename));
        }
        self.world.distance(&placed).map_err(|why| place.refuses_as(why, rename))?;
        Ok(())
    }
}

fn as_is(field: &'static str) -> &'static str {
    field
}
