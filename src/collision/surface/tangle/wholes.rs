//! What the parts of an overlap belong to.

use alloc::vec::Vec;

use super::view::View;
use super::way::reach;
use crate::collision::surface::shell::Shell;
use crate::geometry::Surface;
use crate::math::{UnitVec3, Vec3};

/// The shells of a surface that have been asked for, each found once.
pub(super) struct Wholes<'a, S> {
    surface: View<'a, S>,
    found: Vec<Whole>,
    /// The number of each face's shell, [`UNKNOWN`] before it is found.
    numbers: Vec<u32>,
}

/// The vertices of a shell.
struct Whole {
    vertices: Vec<Vec3>,
    /// Those that are farthest along the axes, and against them.
    extremes: [Vec3; 6],
}

const UNKNOWN: u32 = u32::MAX;

impl<'a, S: Surface> Wholes<'a, S> {
    pub(super) const fn new(surface: View<'a, S>) -> Self {
        Self { surface, found: Vec::new(), numbers: Vec::new() }
    }

    /// The numbers of the shells of some faces, sorted. O(k log k) for k faces, and O(n) for n
    /// faces that hang together with them for the first time.
    pub(super) fn of(&mut self, faces: &[u32]) -> Vec<u32> {
        let mut shells: Vec<_> = faces.iter().map(|&face| self.number(face)).collect();
        shells.sort_unstable();
        shells.dedup();
        shells
    }

    fn number(&mut self, face: u32) -> u32 {
        let known = self.numbers.get(face as usize).copied().unwrap_or(UNKNOWN);
        if known != UNKNOWN {
            return known;
        }
        let shell = Shell::of(&self.surface, &[face]);
        let number = self.found.len() as u32; // at most one for each of fewer than 2^32 faces
        let highest = shell.faces.iter().copied().max().unwrap_or(face) as usize;
        self.numbers.resize(self.numbers.len().max(highest + 1), UNKNOWN);
        for face in shell.faces {
            self.numbers[face as usize] = number;
        }
        let vertices: Vec<_> = shell.vertices.into_iter().map(|(_, point)| point).collect();
        let first = vertices.first().copied().unwrap_or(Vec3::ZERO);
        let extreme = |(axis, sign): (usize, i64)| {
            let along = |point: &&Vec3| sign * point.raw()[axis];
            vertices.iter().max_by_key(along).copied().unwrap_or(first)
        };
        let extremes = [(0, 1), (0, -1), (1, 1), (1, -1), (2, 1), (2, -1)].map(extreme);
        self.found.push(Whole { vertices, extremes });
        number
    }

    /// How far some shells reach along a direction, from a point. O(n) for n vertices.
    pub(super) fn reach(&self, shells: &[u32], normal: UnitVec3, origin: Vec3) -> i128 {
        let points = shells.iter().flat_map(|&shell| &self.found[shell as usize].vertices);
        points.map(|&point| reach(normal, point, origin)).max().unwrap_or(0)
    }

    /// How far they reach at least: that far along an axis. O(1) for each.
    pub(super) fn reach_at_least(&self, shells: &[u32], normal: UnitVec3, origin: Vec3) -> i128 {
        let points = shells.iter().flat_map(|&shell| &self.found[shell as usize].extremes);
        points.map(|&point| reach(normal, point, origin)).max().unwrap_or(0)
    }
}
