//! What a world looks like, told to any renderer.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use super::World;
use crate::constraint::Distance;
use crate::math::{Factor, Real, UnitVec3, Vec3};
use crate::particle::{Particle, ParticleId};

/// What a drawn thing is: the renderer chooses the colour.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[non_exhaustive]
pub enum Shade {
    /// A particle that forces and constraints move.
    Particle,
    /// A particle that only commands move.
    Pinned,
    /// A distance constraint.
    Distance {
        /// How much longer than at rest it is, or shorter than its slack allows, then negative, as
        /// a share of the rest length; no more than the type holds.
        strain: Factor,
    },
    /// A triangle of a surface; in front of it, its corners run counter-clockwise.
    Face,
    /// The boundary of a half-space.
    HalfSpace,
    /// A triangle of a shape that others are tested against.
    Collider,
    /// Where shapes touch or intersect.
    Contact,
    /// Anything that takes no part.
    Disabled,
}

/// Takes what [`World::draw`] tells. What a renderer does not implement is not drawn.
///
/// ```
/// use verlock::world::{DrawOptions, DrawSink, Shade};
/// use verlock::{Vec3, WorldBuilder, WorldConfig};
///
/// #[derive(Default)]
/// struct Lines(Vec<[Vec3; 2]>);
///
/// impl DrawSink for Lines {
///     fn line(&mut self, ends: [Vec3; 2], _: Shade) {
///         self.0.push(ends);
///     }
/// }
///
/// let world = WorldBuilder::new(WorldConfig::default())?.build();
/// let mut lines = Lines::default();
/// world.draw(&mut lines, DrawOptions::default());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait DrawSink {
    /// A plane without bounds, of which the renderer shows what it likes; the normal points to
    /// where particles may be.
    fn plane(&mut self, point: Vec3, normal: UnitVec3, shade: Shade) {
        let _ = (point, normal, shade);
    }

    /// A triangle with two sides.
    fn triangle(&mut self, corners: [Vec3; 3], shade: Shade) {
        let _ = (corners, shade);
    }

    /// A line from one end to the other.
    fn line(&mut self, ends: [Vec3; 2], shade: Shade) {
        let _ = (ends, shade);
    }

    /// A point.
    fn point(&mut self, at: Vec3, shade: Shade) {
        let _ = (at, shade);
    }

    /// A short text beside a point.
    fn label(&mut self, at: Vec3, text: fmt::Arguments<'_>) {
        let _ = (at, text);
    }
}

/// What is drawn of a world. Enabled faces and all half-spaces always are.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct DrawOptions {
    /// Which distance constraints are lines. One with an end that is a corner of a face counts as
    /// covered: an edge, an attachment or a stake; so does a disabled one. Default
    /// [`Detail::Uncovered`].
    pub distances: Detail,
    /// Which particles are points. Corners of faces are covered, unless they are pinned. Default
    /// [`Detail::Uncovered`].
    pub particles: Detail,
    /// Whether particles are labelled with their slots. Default `false`.
    pub labels: bool,
}

/// How many of the objects of one kind are drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Detail {
    /// None of them.
    None,
    /// Those that no face covers.
    #[default]
    Uncovered,
    /// All of them.
    All,
}

impl Detail {
    fn includes(self, covered: bool) -> bool {
        match self {
            Self::None => false,
            Self::Uncovered => !covered,
            Self::All => true,
        }
    }
}

impl World {
    /// Tells a renderer what there is: half-spaces, faces, distances, particles, labels, each kind
    /// in order of its slots. It reads the world alone, and is a function of it. O(objects).
    pub fn draw(&self, sink: &mut (impl DrawSink + ?Sized), options: DrawOptions) {
        for (_, half_space) in self.half_spaces() {
            let shade = enabled_or(half_space.enabled, Shade::HalfSpace);
            sink.plane(half_space.point, half_space.normal, shade);
        }
        let covered = self.draw_faces(sink);
        for (_, distance) in self.distances() {
            let covered = [distance.a, distance.b].iter().any(|end| covered[end.0.slot()]);
            if options.distances.includes(covered || !distance.enabled)
                && let (Some(a), Some(b)) = (self.position(distance.a), self.position(distance.b))
            {
                let strain = Shade::Distance { strain: strain(distance, a.distance(b)) };
                sink.line([a, b], enabled_or(distance.enabled, strain));
            }
        }
        for (id, particle, position) in self.drawn_particles() {
            let covered = covered[id.0.slot()] && !particle.pinned;
            if options.particles.includes(covered) {
                let role = if particle.pinned { Shade::Pinned } else { Shade::Particle };
                sink.point(position, enabled_or(particle.enabled, role));
            }
        }
        if options.labels {
            for (id, _, position) in self.drawn_particles() {
                sink.label(position, format_args!("{}", id.0.index));
            }
        }
    }

    /// Draws the faces; returns which particle slots are corners of one.
    fn draw_faces(&self, sink: &mut (impl DrawSink + ?Sized)) -> Vec<bool> {
        let mut covered = vec![false; self.particles().positions_raw().len()];
        for corners in faces(self) {
            if let [Some(a), Some(b), Some(c)] = corners.map(|corner| self.position(corner)) {
                sink.triangle([a, b, c], Shade::Face);
                for corner in corners {
                    covered[corner.0.slot()] = true;
                }
            }
        }
        covered
    }

    fn drawn_particles(&self) -> impl Iterator<Item = (ParticleId, &Particle, Vec3)> {
        let particles = self.particles();
        particles.ids().filter_map(|id| Some((id, particles.particle(id)?, self.position(id)?)))
    }
}

/// The corners of all enabled faces in order of their slots.
fn faces(world: &World) -> impl Iterator<Item = [ParticleId; 3]> {
    world.faces().filter(|(_, face)| face.enabled).map(|(_, face)| face.corners)
}

fn enabled_or(enabled: bool, shade: Shade) -> Shade {
    if enabled { shade } else { Shade::Disabled }
}

/// `(length - rest) / rest`, the largest number there is where that does not fit; 0 while the slack
/// is being taken up, and counted from its end where it is used up.
fn strain(distance: &Distance, length: Real) -> Factor {
    let (rest, slack) = (distance.rest_length.raw(), distance.slack.raw());
    // Below 2^62, and slack <= rest.
    let excess = length.raw() - rest;
    let excess = if excess < 0 { (excess + slack).min(0) } else { excess };
    // At least -1, for a rest length above 0: only the upper end can be passed.
    Factor::from_ratio(excess, rest).unwrap_or(Factor::from_raw(i32::MAX))
}
